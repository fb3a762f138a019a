"""The program `simplified`: results, refusals, and boundary motions for detailed models."""

import csv
import subprocess
import unittest

from programs import BUILD, PATIENCE_S, ProgramTest, coupler

SCENE = """\
time: {duration: 2 s, dt: 10 ms}
simplified:
  model: beam
  tunnel:
    sections:
      - {from: 0 m, to: 100 m, width: 7 m, height: 7 m, area: 9.5 m^2, lateral_inertia: 48 m^4,
         vertical_inertia: 48 m^4, young_modulus: 35 GPa, mass: 50 t/m, element_length: 5 m}
      - {from: 100 m, to: 200 m, width: 7 m, height: 7 m, area: 9.5 m^2, lateral_inertia: 48 m^4,
         vertical_inertia: 48 m^4, young_modulus: 35 GPa, mass: 50 t/m, element_length: 5 m}
    joints:
      - name: ring
        from: 25 m
        to: 175 m
        spacing: 25 m
        gasket: {compression: [0 mm, 10 mm, 20 mm], force: [0 MN, 20 MN, 60 MN], installed_force: 20 MN}
        lateral_keys: {stiffness: 20 GN/m}
        vertical_keys: {stiffness: 20 GN/m}
    axis: [{chainage: 0 m, depth: 12 m}]
  ground:
    profiles:
      - {chainage: 0 m, layers: [{thickness: 30 m, shear_velocity: 180 m/s, density: 1.9 t/m^3}]}
      - {chainage: 200 m, layers: [{thickness: 20 m, shear_velocity: 180 m/s, density: 1.9 t/m^3}]}
  soil_springs: {wavelength: 200 m, dashpot_time: 10 ms}
  excitation:
    motion: {ricker: {frequency: 2 Hz, time: 0.8 s}, peak: 0.2 g}
    axial: 0.7
    lateral: 0.7
    incidence: {apparent_velocity: 500 m/s}
    through_ground: true
  stations: [{name: middle, chainage: 100 m}]
  zoom: {width: 40 m}
"""


def simplified(*arguments):
    return subprocess.run([BUILD / "simplified" / "simplified", *map(str, arguments)], capture_output=True, text=True,
                          timeout=PATIENCE_S)


def edges(fragment):
    """The chainages between which a zoomed scene lies."""
    begin, end = fragment.read_text().split("from ")[1].split(" m,")[0].split(" to ")
    return float(begin), float(end)


def local_scene(fragment, begin, end, place):
    """The lining alone in plan, driven by the fragment's motions."""
    return f"""\
extends: {fragment}
name: local
plane: plane_stress
material: {{young_modulus: 35 GPa, poisson_ratio: 0.2, density: 2.5 t/m^3}}
output: {{history_interval: 1 ms}}
continuum:
  block: {{x_min: {begin} m, x_max: {end} m, y_min: -3.5 m, y_max: 3.5 m, zones_x: 20, zones_y: 4}}
  histories: [{{name: middle, quantity: displacement_y, at: {{x: {place} m, y: 0 m}}}}]
"""


def read_rows(table):
    with open(table, newline="", encoding="utf-8") as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


class Runs(ProgramTest):
    def run_model(self, model, *changes):
        sets = [word for change in (f"simplified.model={model}", *changes) for word in ("--set", change)]
        result = simplified("run", self.scene(SCENE), *sets, "--out", self.folder / model)
        self.assertEqual(result.returncode, 0, result.stderr)
        return self.folder / model

    def test_every_model_leaves_its_results(self):
        for model, tables in (("beam", ("envelopes", "joints", "time_distance")),
                              ("chain", ("envelopes", "joints", "time_distance")), ("column", ("envelopes",))):
            with self.subTest(model):
                folder = self.run_model(model)
                summary = self.summary(folder)
                self.assertEqual(summary["model"], model)
                self.assertGreater(summary["real_time_factor"], 0)
                for table in (*tables, "histories", "soil_profile", "motion"):
                    with open(folder / f"{table}.csv", newline="", encoding="utf-8") as file:
                        self.assertGreater(len(list(csv.reader(file))), 2, table)

    def test_the_same_scene_gives_the_same_bits(self):
        first = (self.run_model("beam") / "histories.csv").read_bytes()
        self.assertEqual(first, (self.run_model("beam") / "histories.csv").read_bytes())

    def test_zoom_gives_the_coupled_model_its_boundary(self):
        fragment = self.run_model("beam") / "zoom" / "opening.yaml"
        with open(fragment.with_name("opening_begin.csv"), newline="", encoding="utf-8") as file:
            self.assertEqual(next(csv.reader(file)), ["time_s", "vx_m_per_s", "vy_m_per_s", "spin_rad_per_s"])
        local = self.scene(local_scene(fragment, *edges(fragment), edges(fragment)[0]), "local.yaml")
        result = coupler("check", local)
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_the_middle_of_a_zoomed_window_moves_as_the_whole_tunnel_does(self):
        """Edges that did not turn would leave the middle the mean of both: (q L)^2/8 less than a wave of q there, 0.8 %
        for the wavelet's q = 2 pi 2 Hz / 1000 m/s and L = 20 m."""
        folder = self.run_model("beam", "simplified.zoom.width=20 m",
                                "simplified.excitation.incidence.apparent_velocity=1000 m/s")
        fragment = folder / "zoom" / "moment.yaml"
        begin, end = edges(fragment)
        rows = read_rows(folder / "time_distance.csv")
        place = min({row["chainage_m"] for row in rows}, key=lambda x: abs(x - (begin + end) / 2))
        whole = [row for row in rows if row["chainage_m"] == place]

        run = self.run_scene(self.scene(local_scene(fragment, begin, end, place), "local.yaml"), out="local")
        local = read_rows(run / "histories.csv")
        displacement, largest, difference = 0, 0, 0
        for before, now in zip(whole, whole[1:]):
            displacement += ((now["time_s"] - before["time_s"]) *
                             (before["lateral_velocity_m_per_s"] + now["lateral_velocity_m_per_s"]) / 2)
            nearest = min(local, key=lambda row: abs(row["time_s"] - now["time_s"]))
            self.assertAlmostEqual(nearest["time_s"], now["time_s"], delta=1e-3)
            largest = max(largest, abs(displacement))
            difference = max(difference, abs(nearest["middle_uy_m"] - displacement))
        self.assertGreater(largest, 0)
        self.assertLess(difference, 0.005 * largest)

    def test_check_computes_nothing(self):
        result = simplified("check", self.scene(SCENE))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertFalse((self.folder / "run").exists())


class UserErrors(ProgramTest):
    """Exit code 2 and one sentence with file, line and what was expected."""

    def refused(self, old, new, *texts):
        self.assertIn(old, SCENE)
        path = self.scene(SCENE.replace(old, new, 1))
        line = 1 + SCENE[:SCENE.index(old)].count("\n")
        result = simplified("run", path, "--out", self.folder / "run")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertFalse((self.folder / "run").exists())
        for text in (f"{path}:{line}:", *texts):
            self.assertIn(text, result.stderr)

    def test_gap_in_chainage(self):
        self.refused("from: 100 m", "from: 110 m", "tunnel.sections[1].from", "a gap of 10 m")

    def test_layer_of_zero_thickness(self):
        self.refused("thickness: 20 m", "thickness: 0 m", "profiles[1].layers[0].thickness", "above 0 m")

    def test_motion_shorter_than_asked(self):
        (self.folder / "short.csv").write_text("time_s,acceleration_m/s^2\n" +
                                               "".join(f"{i / 100},{i % 3}\n" for i in range(101)))
        self.refused("ricker: {frequency: 2 Hz, time: 0.8 s}", "file: {path: short.csv}", "motion.file.path", "short.csv",
                     "2 s")

    def test_joint_curve_not_monotone(self):
        self.refused("[0 MN, 20 MN, 60 MN]", "[0 MN, 20 MN, 10 MN]", "joints[0].gasket.force[2]")

    def test_station_outside_the_tunnel(self):
        self.refused("chainage: 100 m}]", "chainage: 300 m}]", "stations[0].chainage", "from 0 to 200 m")

    def test_coupler_names_the_program_for_it(self):
        result = coupler("check", self.scene(SCENE))
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("program `simplified`", result.stderr)


if __name__ == "__main__":
    unittest.main()
