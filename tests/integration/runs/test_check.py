"""`coupler check` tells what the run that follows will be, and writes nothing but the undeformed model where it is asked to."""

import json
import math
import pathlib
import re
import subprocess
import unittest

from programs import ADIT, CASE, ProgramTest, Server, counts_resources, coupler

from adit.plots.setup.checked import Checked

from runs import test_begin as begin


def seconds(told):
    """Of a time such as `3.4 h`."""
    number, unit = told.split()
    return float(number) * {"s": 1, "min": 60, "h": 3600}[unit]


SHORT = ("--set", "time.duration=5 ms", "--set", "output.field_times=[2 ms]")

MATERIAL = "{young_modulus: 100 MPa, poisson_ratio: 0.25, density: 2000 kg/m^3}"

# A stiff inclusion in a grid, a lining on its upper side, a bolt below, two stages of excavation.
GROUND = f"""\
material: {MATERIAL}
time: {{duration: 50 ms}}
statics: {{}}
continuum:
  block: {{x_min: 0 m, x_max: 8 m, y_min: 0 m, y_max: 6 m, zones_x: 8, zones_y: 6}}
  materials:
    - where: {{x_min: 5 m, x_max: 7 m, y_min: 2 m, y_max: 3 m}}
      material: {{young_modulus: 20 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}}
  linings:
    - name: slab
      along: {{line: {{points: [{{x: 0 m, y: 6 m}}, {{x: 4 m, y: 6 m}}]}}}}
      thickness: 10 cm
      young_modulus: 1 GPa
  bolts: [{{from: {{x: 1 m, y: 1 m}}, to: {{x: 3 m, y: 1 m}}, area: 1 cm^2, young_modulus: 1 GPa}}]
  excavations:
    - {{where: {{x_max: 1 m, y_min: 4 m, y_max: 5 m}}, stage: 1}}
    - {{where: {{x_max: 1 m, y_min: 3 m, y_max: 4 m}}, stage: 2}}
  body_loads: [{{acceleration: {{y: -10 m/s^2}}}}]
  motions: [{{where: {{y_max: 0 m}}, velocity: {{x: 0 m/s, y: 0 m/s}}}}]
"""

# Bonds of two strengths: a core of strong material that cannot break inside.
PARTICLES = f"""\
material: {MATERIAL}
time: {{duration: 20 ms}}
particles:
  packing: {{x_min: 0 m, x_max: 4 m, y_min: 0 m, y_max: 2 m, radius: 5 cm}}
  bonds: {{tensile_strength: 5 kN, shear_strength: 5 kN}}
  contacts: {{friction: 0.5}}
  groups:
    - name: core
      where: {{x_min: 3 m, y_max: 1 m}}
      material: {{young_modulus: 10 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}}
      bonds: {{}}
  springs: [{{from: {{x: 1 m, y: 0.5 m}}, to: {{x: 2 m, y: 0.5 m}}, stiffness: 1 MN/m}}]
  histories: [{{name: end, quantity: velocity_x, at: {{x: 3.9 m, y: 1 m}}}}]
"""


class Report:
    """What `check` printed: tables by their first column, and lines by their label."""

    def __init__(self, text):
        self.rows, self.lines, head = {}, {}, None
        for line in text.splitlines():
            first, *cells = re.split(r"\s{2,}", line)
            if first.endswith(" of"):
                head = cells
            elif len(cells) > 1 or (head and first in ("particles", "continuum") and len(cells) == len(head)):
                self.rows.setdefault(first, {}).update(zip(head, cells))
            elif cells:
                self.lines.setdefault(first, []).append(cells[0])
        self.last = text.splitlines()[-1]

    def count(self, row, column):
        return int(self.rows[row][column].replace(",", ""))

    def total(self, column):
        return sum(self.count(row, column) for row in self.rows if column in self.rows[row])

    def line(self, label):
        return self.lines[label][0]

    def warnings(self):
        return self.lines.get("warning", [])


class Check(ProgramTest):
    def check(self, scene, *arguments):
        result = coupler("check", scene, *arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return Report(result.stdout)

    def critical(self, report):
        found = re.search(r" critical one of the (\S+): (.*) at \((\S+), (\S+)\) m", report.line("time step"))
        self.assertTrue(found, report.line("time step"))
        return found[1], found[2], float(found[3]), float(found[4])

    def test_counts_and_steps_are_those_of_the_run(self):
        for name, scene, options in (("coupled", CASE / "coupled.yaml", SHORT),
                                     ("substeps", CASE / "coupled.yaml", (*SHORT, "--set", "time.substeps=2")),
                                     ("ground", self.scene(GROUND, "ground.yaml"), ()),
                                     ("particles", self.scene(PARTICLES, "particles.yaml"), ())):
            with self.subTest(name):
                report = self.check(scene, *options)
                run = self.run_scene(scene, *options, out=name)
                summary = self.summary(run)
                for column, key in (("particles", "particles"), ("bonds", "bonds"), ("zones", "zones"),
                                    ("grid points", "grid_points"), ("coupling points", "coupling_points")):
                    self.assertEqual(report.total(column), summary[key], column)
                self.assertEqual(int(report.line("steps").split(" ")[0].replace(",", "")), summary["steps"])
                step, share = re.match(r"(\S+) s, (\S+) of the critical", report.line("time step")).groups()
                own = summary["dt_s"] / summary["substeps"]
                self.assertAlmostEqual(float(step) / own, 1, delta=1e-5)
                self.assertAlmostEqual(float(share) / (summary["dt_s"] / summary["critical_dt_s"]), 1, delta=1e-2)
                rows, columns = map(int, re.search(r"in (\d+) rows of (\d+) columns", report.line("results")).groups())
                header, *lines = (run / "histories.csv").read_text().splitlines()
                self.assertEqual((rows, columns), (len(lines), len(header.split(","))))
                times = int(re.search(r"fields at (\d+) times", report.line("results"))[1])
                self.assertEqual(times, (run / "fields" / "fields.pvd").read_text().count("timestep") /
                                 len({p.name.rpartition("_")[0] for p in (run / "fields").glob("*_*.vt?")}))
                self.assertTrue(report.last.endswith(" can be computed"))

    def test_the_size_of_the_results_is_about_that_on_disk(self):
        report = self.check(CASE / "coupled.yaml", *SHORT)
        run = self.run_scene(CASE / "coupled.yaml", *SHORT)
        kilobytes = sum(file.stat().st_size for file in run.rglob("*") if file.is_file()) / 1e3
        size, unit = re.match(r"(\S+) (kB|MB)", report.line("results")).groups()
        told = float(size) * {"kB": 1, "MB": 1e3}[unit]
        self.assertLess(abs(told / kilobytes - 1), 0.2)

    @counts_resources
    def test_memory_is_what_the_run_will_hold_within_15_percent(self):
        for name, more in (("lattice", ""), ("general", "  bonds: {}\n  contacts: {friction: 0.5}\n")):
            with self.subTest(name):
                scene = self.scene(f"material: {MATERIAL}\ntime: {{duration: 1 ms}}\nparticles:\n  packing: {{x_min: 0 m, "
                                   f"x_max: 20 m, y_min: 0 m, y_max: 15 m, radius: 5 cm}}\n{more}", f"{name}.yaml")
                size = re.search(r"(\S+) MB for the particles, (\S+) MB for the coupler", self.check(scene).line("memory"))
                with Server("dem_server") as server:
                    self.run_scene(scene, "--dem", server.address, out=name)
                    held = re.search(r"VmHWM:\s+(\d+) kB", pathlib.Path(f"/proc/{server.process.pid}/status").read_text())
                self.assertAlmostEqual(float(size[1]) * 1e3 / int(held[1]), 1, delta=0.15)
                self.assertGreater(float(size[2]), 5)

    def test_bonds_of_a_later_stage_can_break(self):
        later = PARTICLES.replace("particles:\n", "statics: {}\nparticles:\n").replace(
            "{tensile_strength: 5 kN, shear_strength: 5 kN}", "{}").replace(
            "      bonds: {}", "      stage: 1\n      bonds: {tensile_strength: 5 kN, shear_strength: 5 kN}")
        self.assertGreater(self.check(self.scene(later)).count("particles", "breakable"), 100)

    def test_breakable_bonds_are_those_with_a_strength(self):
        report = self.check(self.scene(PARTICLES))
        self.assertGreater(report.count("particles", "breakable"), 0)
        self.assertLess(report.count("particles", "breakable"), report.count("particles", "bonds"))
        whole = self.check(self.scene(PARTICLES.replace("{tensile_strength: 5 kN, shear_strength: 5 kN}", "{}"), "whole.yaml"))
        self.assertEqual(whole.count("particles", "breakable"), 0)
        beam = self.check(CASE / "coupled.yaml", *SHORT)
        self.assertEqual(beam.count("particles", "breakable"), beam.count("particles", "bonds"))

    def test_what_the_scene_holds_is_told(self):
        ground = self.check(self.scene(GROUND, "ground.yaml"))
        self.assertEqual([ground.count("continuum", column) for column in ("linings", "bolts", "stages")], [1, 1, 2])
        later = self.scene(GROUND.replace("thickness: 10 cm", "thickness: 10 cm\n      stage: 4"), "later.yaml")
        self.assertEqual(self.check(later).count("continuum", "stages"), 3)  # that of the lining is one
        particles = self.check(self.scene(PARTICLES, "particles.yaml"))
        self.assertEqual((particles.rows["particles"]["contacts"], particles.count("particles", "springs")), ("friction 0.5", 1))
        self.assertIn("particles: general: ", particles.line("engine"))
        for report, model in ((ground, "continuum"), (particles, "particles")):
            size, unit = re.match(rf"(\S+) (MB|GB) for the {model}", report.line("memory")).groups()
            self.assertTrue(1 <= float(size) <= 1000 and unit == "MB", report.line("memory"))

    def test_the_element_that_governs_the_time_step_is_named_with_its_place(self):
        model, element, x, y = self.critical(self.check(self.scene(GROUND, "ground.yaml")))
        self.assertEqual((model, element), ("continuum", "zone"))
        self.assertTrue(5 < x < 7 and 2 < y < 3, (x, y))
        stiff = GROUND.replace("      young_modulus: 1 GPa", "      young_modulus: 30 TPa")
        self.assertEqual(self.critical(self.check(self.scene(stiff, "stiff.yaml")))[1], "zone")
        local = self.scene(stiff + "  damping: {local: {alpha: 0.1}}\n", "local.yaml")  # with which a lining needs its own step
        model, element, x, y = self.critical(self.check(local))
        self.assertEqual((model, element, y), ("continuum", "beam", 6))
        rayleigh = "  damping: {rayleigh: {ratio: 0.05, low_frequency: 1 Hz, high_frequency: 10 Hz}}\n"
        damped = self.scene(GROUND + rayleigh, "damped.yaml")
        self.assertEqual(self.critical(self.check(damped))[1], "zone with Rayleigh damping")
        model, element, x, y = self.critical(self.check(self.scene(PARTICLES, "particles.yaml")))
        self.assertEqual((model, element), ("particles", "contact"))  # of a particle of the core, should one form
        self.assertTrue(x >= 2.9 and y <= 1.1, (x, y))
        spring = self.scene(PARTICLES.replace("stiffness: 1 MN/m}]", "stiffness: 1 TN/m}]"), "spring.yaml")
        model, element, x, y = self.critical(self.check(spring))
        self.assertEqual((model, element), ("particles", "spring"))
        self.assertTrue(abs(x - 1.5) <= 0.1 and abs(y - 0.5) <= 0.1, (x, y))
        self.assertEqual(self.critical(self.check(CASE / "coupled.yaml", *SHORT))[:2], ("particles", "bond"))

    def test_warnings_say_what_is_likely_to_go_wrong(self):
        self.assertEqual(self.check(self.scene(GROUND, "ground.yaml")).warnings(), [])
        at_once = re.sub("stage: [12]", "stage: 0", GROUND.replace("statics: {}\n", ""))
        hanging = self.check(self.scene(at_once, "hanging.yaml")).warnings()
        self.assertEqual(len(hanging), 1, hanging)
        self.assertIn("gravity acts on the continuum without `statics`", hanging[0])
        scene = self.scene(PARTICLES, "particles.yaml")
        self.assertEqual(self.check(scene).warnings(), [])
        fast = self.check(scene, "--set", "time.dt_factor=1").warnings()
        self.assertEqual(len(fast), 1, fast)
        self.assertIn("a time.dt_factor of at most 0.9", fast[0])

    def test_a_run_warns_of_all_that_check_warns_of(self):
        """In its log before time begins, and in its summary."""
        hanging = re.sub("stage: [12]", "stage: 0", GROUND.replace("statics: {}\n", ""))
        stressed = hanging + "initial_stress: {yy: -10 kPa}\n"
        for name, scene, options in (("hanging", hanging, ()), ("stressed", stressed, ()),
                                     ("fast", PARTICLES, ("--set", "time.dt_factor=1")),
                                     ("early", PARTICLES, ("--set", "output.field_times=[1 ns]"))):
            with self.subTest(name):
                scene = self.scene(scene, f"{name}.yaml")
                warned = self.check(scene, *options).warnings()
                self.assertTrue(warned)
                result = coupler("run", scene, "--out", self.folder / name, *options)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertLessEqual(set(warned), set(self.summary(self.folder / name)["warnings"]))
                for warning in warned:
                    self.assertIn(f"warning: {warning}\n", result.stderr)

    def test_a_peak_that_the_run_does_not_meet_is_warned_of(self):
        """With the largest acceleration that acts until then, in the words of the summary, which lists both."""
        scene = self.scene(f"""\
material: {MATERIAL}
time: {{duration: 0.3 s}}
continuum:
  block: {{x_min: 0 m, x_max: 2 m, y_min: 0 m, y_max: 2 m, zones_x: 2, zones_y: 2}}
  base: {{kind: rigid, acceleration: {{ricker: {{frequency: 2 Hz, time: 0.5 s}}, peak: 1 m/s^2}}}}
""")
        warned = self.check(scene).warnings()
        self.assertEqual(len(warned), 1, warned)
        self.assertRegex(warned[0], r"^`continuum\.base\.acceleration\.peak` is stated as 1 m/s\^2, but 0\.\d+ m/s\^2 acts: "
                                    "the run takes a part of the motion$")
        summary = self.summary(self.run_scene(scene))
        self.assertEqual(summary["warnings"], warned)
        told, = summary["stated"]
        self.assertEqual((told["key"], told["stated"], told["unit"]), ("continuum.base.acceleration.peak", 1, "m/s^2"))
        w = (math.pi * 2 * 0.2)**2  # at the end, just before the trough of the pulse
        self.assertAlmostEqual(told["acted"], (2 * w - 1) * math.exp(-w), delta=1e-3)
        self.assertEqual(self.check(scene, "--set", "time.duration=1 s").warnings(), [])

    def test_what_statics_leave_out_is_noted(self):
        pulled = GROUND.replace("velocity: {x: 0 m/s, y: 0 m/s}", "velocity: {x: 0.1 m/s, y: 0 m/s}")
        loads = "  edge_loads: [{where: {y_min: 6 m}, force: {y: -1 kN}, time: {table: {time: [0 s, 1 s], value: [0, 1]}}}]\n"
        notes = self.check(self.scene(pulled + loads, "pulled.yaml")).lines["note"]
        self.assertTrue(any("continuum.motions[0]: statics hold these points" in note for note in notes), notes)
        self.assertTrue(any("continuum.edge_loads[0]: statics bear 0 times this load" in note for note in notes), notes)
        self.assertNotIn("note", self.check(self.scene(GROUND, "ground.yaml")).lines)

    def test_the_time_to_expect_names_its_parts(self):
        self.assertRegex(self.check(self.scene(GROUND, "ground.yaml")).line("time to expect"),
                         r"^\S+ \S+: [\d,]+ steps of \S+ ms, \S+ \S+ for set-up and results; "
                         r"before that \S+ s for every 1,000 steps of statics$")

    def test_what_would_make_a_long_run_shorter_is_told(self):
        """An eighth of the stepping for a model half as fine; less for cells that wait, where they may; nothing for a run of seconds."""
        given = begin.scene(demand=None, size=0.15, substeps=8) | {"output": {"history_interval": 0.1}}
        short = self.check(self.scene(json.dumps(given), "short.json"))
        self.assertNotIn("shorter", short.lines)
        given["time"]["duration"] = 1000
        long = self.check(self.scene(json.dumps(given), "long.json"))
        half, waiting = long.lines["shorter"]
        expected = seconds(long.line("time to expect").split(":")[0])
        self.assertAlmostEqual(seconds(half.split(" with ")[0]) / expected, 1 / 8, delta=0.03)
        self.assertIn("particles", waiting)
        self.assertLess(seconds(waiting.split(" while ")[0]), 0.7 * expected)
        given["particles"]["begin"] = {"demand": 0.8}
        waits = self.check(self.scene(json.dumps(given), "waits.json"))
        self.assertEqual(len(waits.lines["shorter"]), 1)
        self.assertIn("ms while particles wait, if they can", waits.line("time to expect"))

    def test_the_undeformed_model_is_written_where_it_is_asked_for(self):
        ground, particles = self.scene(GROUND, "ground.yaml"), self.scene(PARTICLES, "particles.yaml")
        self.check(ground)
        self.assertEqual({p.name for p in self.folder.iterdir()}, {"ground.yaml", "particles.yaml"})
        for scene, piece, field, numbers in ((ground, "grid", "material", {0, 1}), (particles, "particles", "group", {0, 1})):
            out = self.folder / piece
            self.check(scene, "--out", out)
            self.assertEqual({p.name for p in out.iterdir()}, {".lock", "fields", "scene.yaml"})
            shown = Checked(out).pieces()[piece]
            self.assertEqual(set(shown.field(field)), numbers)
            self.assertEqual(abs(shown.field("displacement_m", 0 * shown.points)).max(), 0)

    def test_the_results_of_a_run_are_kept(self):
        scene = self.scene(GROUND, "ground.yaml")
        run = self.run_scene(scene, "--set", "statics.unbalanced_ratio=0.1")
        result = coupler("check", scene, "--out", run)
        self.assertEqual(result.returncode, 2)
        self.assertIn("holds the results of a run", result.stderr)
        self.assertTrue((run / "histories.csv").exists())

    def test_the_model_is_drawn(self):
        out = self.folder / "model"
        self.check(self.scene(GROUND), "--out", out)
        done = subprocess.run([*ADIT, "plot", "--model", out], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([p.name for p in (out / "pictures").iterdir()], ["model.png"])


if __name__ == "__main__":
    unittest.main()
