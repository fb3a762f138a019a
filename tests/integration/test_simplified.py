"""The program `simplified`: results, refusals, and the way from global to local."""

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


class Runs(ProgramTest):
    def run_model(self, model):
        result = simplified("run", self.scene(SCENE), "--set", f"simplified.model={model}", "--out",
                            self.folder / model)
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
                for table in (*tables, "histories", "soil_profile"):
                    with open(folder / f"{table}.csv", newline="", encoding="utf-8") as file:
                        self.assertGreater(len(list(csv.reader(file))), 2, table)

    def test_the_same_scene_gives_the_same_bits(self):
        first = (self.run_model("beam") / "histories.csv").read_bytes()
        self.assertEqual(first, (self.run_model("beam") / "histories.csv").read_bytes())

    def test_zoom_gives_the_coupled_model_its_boundary(self):
        fragment = self.run_model("beam") / "zoom" / "opening.yaml"
        with open(fragment.with_suffix(".csv"), newline="", encoding="utf-8") as file:
            self.assertEqual(next(csv.reader(file))[0], "time_s")
        begin, end = (float(word) for word in fragment.read_text().split("from ")[1].split(" m,")[0].split(" to "))
        local = self.scene(f"""\
base: {fragment}
name: local
plane: plane_stress
material: {{young_modulus: 35 GPa, poisson_ratio: 0.2, density: 2.5 t/m^3}}
continuum:
  block: {{x_min: {begin} m, x_max: {end} m, y_min: -3.5 m, y_max: 3.5 m, zones_x: 20, zones_y: 4}}
""", "local.yaml")
        result = coupler("check", local)
        self.assertEqual(result.returncode, 0, result.stderr)

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
