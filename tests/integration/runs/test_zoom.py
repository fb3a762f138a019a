"""`adit zoom`: particles exactly where a continuum comes near its strength; the scene that it writes runs, and agrees with the run it
came from as long as nothing breaks. Demand: its history, field, peak and figures tell the same."""

import json
import subprocess
import unittest

import numpy as np

from figures.computed import ComputedTest
from programs import ADIT, SOURCE, coupler

from adit import Run
from adit.cases.tunnels import lined_tunnel, ring_ovaling

SIZE, BASE, SHAKEN = 10.0, -6.0, 0.02  # m, m, m/s

STRONG = {"tensile_strength": 3e6, "fracture_energy": 5e3, "compressive_strength": 30e6}


def ground(young=2e9, **law):
    return {"young_modulus": young, "poisson_ratio": 0.25, "density": 2200, **law}


def scene(material, harder=None, speed=SHAKEN, peaks=True, **continuum):
    """Ground around an opening, sheared by waves from its base; the lower right corner of the opening may be of a harder material."""
    others = [] if harder is None else [{"where": {"x_min": 0, "x_max": 2, "y_min": -4, "y_max": -2}, "material": harder}]
    return {
        "material": material, "time": {"duration": 0.06, "dt_factor": 0.8},
        "continuum": {
            "block": {"x_min": -SIZE, "x_max": SIZE, "y_min": BASE, "y_max": 6, "zones_x": 40, "zones_y": 24}, "materials": others,
            "excavations": [{"where": {"x_min": -1, "x_max": 1, "y_min": -1, "y_max": 1}}],
            "base": {"kind": "compliant", "velocity": {"amplitude": speed, "time": {"sine": {"frequency": 40, "end": 0.025}}}},
            "quiet": [{"where": {"x_max": -SIZE}}, {"where": {"x_min": SIZE}}],
            "histories": [{"name": "surface", "quantity": "displacement_x", "at": {"x": 2, "y": 6}},
                          {"name": "wall", "quantity": "displacement_x", "at": {"x": 1, "y": 0.25}},
                          {"name": "beside", "quantity": "stress_xy", "at": {"x": 2.2, "y": -0.1}}, *continuum.pop("histories", [])], **continuum},
        "output": {"history_interval": 5e-4} | ({"peaks": {}} if peaks else {})}


class ZoomTest(ComputedTest):
    def zoom(self, *options, run=None):
        return subprocess.run([*ADIT, "zoom", run or self.run.folder, *map(str, options)], capture_output=True, text=True, timeout=120)

    def written(self, *options):
        """The scene that is written, computed."""
        told = self.zoom("--out", self.folder / "zoom.yaml", *options)
        self.assertEqual(told.returncode, 0, told.stderr)
        self.told = told.stdout
        return Run(self.run_scene(self.folder / "zoom.yaml", out="zoomed"))

    def refusal(self, *options):
        told = self.zoom(*options)
        self.assertEqual(told.returncode, 2, told.stdout)
        self.assert_one_line(told.stderr)
        return told.stderr

    def differ(self, zoomed, name):
        one = self.run.histories[name]
        other = np.interp(self.run.histories["time_s"], zoomed.histories["time_s"], zoomed.histories[name])
        return np.abs(other - one).max() / np.abs(one).max()


class Zoom(ZoomTest):
    # As long as nothing breaks, the coupled scene moves as the continuum does, within 2 %: outside of the particles, and where they are.
    def test_elastic_answer_is_that_of_the_run_it_came_from(self):
        self.computed(scene(ground(fracture=STRONG), ground(4e9, fracture=STRONG)))
        largest = self.run.summary["largest_demand"]
        zoomed = self.written("--demand", 0.9 * largest, "--size", 0.2)
        self.assertFalse(len(zoomed.cracks["time_s"]))
        self.assertGreater(zoomed.summary["particles"], 100)
        self.assertIn("particles", zoomed.scene)
        for name in ("surface_ux_m", "wall_ux_m"):
            self.assertLess(self.differ(zoomed, name), 0.02, name)
        self.assertLess(self.differ(zoomed, "beside_sxy_Pa"), 0.1)

    # Two places apart become two regions, which nothing but the ground joins.
    def test_places_apart_become_regions(self):
        weak = ground(fracture=STRONG | {"tensile_strength": 1e6})
        given = scene(ground(fracture=STRONG | {"tensile_strength": 9e6, "fracture_energy": 4e4, "compressive_strength": 90e6}))
        given["continuum"]["materials"] = [{"where": {"x_min": x, "x_max": x + 1, "y_min": -1, "y_max": 0}, "material": weak} for x in (-5, 4)]
        self.computed(given)
        demand = self.run.fields()["grid"]["peak_demand"]
        zoomed = self.written("--demand", np.sort(demand)[-8])
        self.assertEqual([region["name"] for region in zoomed.scene["regions"]], ["place_1", "place_2"])
        self.assertLess(self.differ(zoomed, "surface_ux_m"), 0.02)

    # The case: the layer and three places of the linings, in a scene that can be computed.
    def test_case(self):
        self.run = Run(self.run_scene(SOURCE / "cases" / "zoom" / "tunnels.yaml"))
        told = self.zoom("--out", self.folder / "zoom.yaml")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertEqual(told.stdout.count("particles  "), 4, told.stdout)
        self.assertIn("(15.5, -31.5) m", told.stdout)
        checked = coupler("check", self.folder / "zoom.yaml")
        self.assertEqual(checked.returncode, 0, checked.stderr)
        self.assertNotIn("warning", checked.stdout)

    def test_no_particles_are_needed(self):
        self.computed(scene(ground(fracture=STRONG)))
        summary = self.run.summary
        told = self.zoom()
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertEqual(told.stdout, "No particles are needed: the largest demand is {:.3g} at ({:.4g}, {:.4g}) m at t = {:.4g} s.\n".format(
            *(summary[f"largest_demand{key}"] for key in ("", "_x_m", "_y_m", "_time_s"))))
        self.assertFalse((self.run.folder / "zoom.yaml").exists())

    # The history of every step, the peak of its zone and the summary are one.
    def test_demand_is_the_same_everywhere(self):
        yielding = ground(50e6, mohr_coulomb={"cohesion": 20e3, "friction_angle": 0.5})
        self.computed(scene(yielding, ground(50e6, fracture=STRONG), speed=0.2,
                            histories=[{"name": "corner", "quantity": "demand", "at": {"x": 1.1, "y": -1.1}}]))
        grid, demand = self.run.fields()["grid"], self.run.histories["corner_demand"]
        centres = grid.points[grid.cells].mean(axis=1)
        zone = np.hypot(*(centres - [1.25, -1.25]).T).argmin()
        self.assertAlmostEqual(demand.max(), grid["peak_demand"][zone], delta=0.01)
        self.assertAlmostEqual(demand[-1], grid["demand"][zone], delta=1e-9)
        self.assertAlmostEqual(grid["peak_demand"].max(), self.run.summary["largest_demand"], delta=1e-12)
        # where zones yielded, and only there, the demand has been 1
        yielded = grid["yield_state"].astype(int) & (1 | 2 | 4 | 8) > 0
        self.assertGreater(yielded.sum(), 10)
        np.testing.assert_allclose(grid["peak_demand"][yielded], 1, atol=1e-6)
        self.assertTrue((grid["peak_demand"][~yielded] < 1).all())

    # A stretched strip of cells at rest, one half of it twice as strong: facets across the stress use it all, other ones less.
    def test_demand_of_cells(self):
        stress, cells = 1e6, {"x_min": 0, "x_max": 4, "y_min": 0, "y_max": 2, "size": 0.1}
        strip = {"material": ground(fracture=STRONG), "time": {"duration": 1e-3}, "initial_stress": {"xx": stress},
                 "particles": {
                     "cells": cells, "groups": [{"name": "strong", "where": {"x_min": 2}, "material": ground(fracture=STRONG | {"tensile_strength": 6e6})}],
                     "motions": [{"where": area, "velocity": {"x": 0, "y": 0}} for area in ({"x_max": 0.2}, {"x_min": 3.8})],
                     "histories": [{"name": name, "quantity": "demand", "group": name} for name in ("particles", "strong")]}}
        histories = self.computed(strip).histories
        for name, strength in (("particles", 3e6), ("strong", 6e6)):
            self.assertAlmostEqual(histories[f"{name}_demand"][0], stress / strength, delta=0.01 * stress / strength)
        strip["initial_stress"]["xx"] = 4e6
        histories = self.computed(strip).histories
        self.assertEqual(histories["particles_demand"][-1], 1)
        self.assertLess(histories["strong_demand"][-1], 1)
        for group, material, message in (("weak", ground(fracture=STRONG), "histories[0].group: is `weak`"),
                                         ("particles", ground(), "histories[0].quantity: is demand, but nothing between the particles of group `particles` can break")):
            refused = {**strip, "material": material, "particles": {"cells": cells, "histories": [{"name": "a", "quantity": "demand", "group": group}]}}
            told = coupler("check", self.scene(json.dumps(refused)))
            self.assertEqual(told.returncode, 2)
            self.assertIn(message, told.stderr)

    def test_refusals(self):
        strong = ground(fracture=STRONG)
        for given, options, message in (
                (scene(strong, peaks=False), (), "kept no peaks; add `output: {peaks: {}}` to the scene and run it again."),
                (scene(ground()), (), "no material states a strength to compare with; give `mohr_coulomb`, `weak_plane`, `fracture` or a class of"),
                (scene(ground(mohr_coulomb={"cohesion": 1e6})), ("--demand", 0.01), "material says when its zones fail, but not how cells of it break; give it `fracture` too"),
                (scene(strong), ("--demand", 0), "--demand 0 is no share of a strength; give more than 0, such as 0.8."),
                (scene(strong), ("--size", -1), "--size -1 is no size of a cell; give metres above 0.")):
            with self.subTest(message=message):
                self.computed(given)
                self.assertIn(message, self.refusal(*options))

    def test_places_with_structures(self):
        wall = {"name": "wall", "along": {"line": {"points": [{"x": 1, "y": -1}, {"x": 1, "y": 1}]}}, "thickness": 0.2, "young_modulus": 30e9}
        self.computed(scene(ground(fracture=STRONG), linings=[wall]))
        self.assertIn("linings of the continuum stand at", self.refusal("--demand", 0.9 * self.run.summary["largest_demand"]))

    def test_zones_excavated_in_stages(self):
        given = scene(ground(fracture=STRONG)) | {"statics": {}}
        given["continuum"]["excavations"][0]["stage"] = 1
        self.computed(given)
        self.assertIn("zones are excavated in stages, which particles in their place would not be", self.refusal())

    def test_places_at_an_edge(self):
        given = scene(ground(fracture=STRONG), ground(0.5e9, fracture=STRONG | {"tensile_strength": 1e5, "fracture_energy": 50, "compressive_strength": 1e6}))
        given["continuum"]["materials"][0]["where"] = {"x_min": 0, "x_max": 2, "y_max": -5}
        self.computed(given)
        self.assertIn("all lie where the grid is held, loaded or absorbs waves", self.refusal("--demand", 0.9 * self.run.summary["largest_demand"]))

    def test_a_run_with_particles_already(self):
        self.computed(scene(ground(fracture=STRONG)))
        zoomed = self.written("--demand", 0.9 * self.run.summary["largest_demand"])
        told = self.zoom(run=zoomed.folder)
        self.assertEqual(told.returncode, 2)
        self.assertIn("is no run of a continuum alone; zoom says where such a run needs particles.", told.stderr)

    def test_demand_on_what_has_no_strength(self):
        given = scene(ground(), histories=[{"name": "a", "quantity": "demand", "at": {"x": 3, "y": 3}}])
        told = coupler("check", self.scene(json.dumps(given)))
        self.assertEqual(told.returncode, 2)
        self.assertIn("continuum.histories[3].quantity: is demand, but the material there states no strength to compare with; give it", told.stderr)


RADIUS, THICKNESS, DEPTH = 2.0, 0.4, 12.0  # m
SOIL = {"young_modulus": 300e6, "poisson_ratio": 0.3, "density": 2000}
C30 = {"thickness": THICKNESS, "material": {"concrete": "C30/37"}}
BARS = {"diameter": 0.02, "spacing": 0.1}
REINFORCED = {"section": {"thickness": THICKNESS, "cover": 0.04, "concrete": {"class": "C30/37"}, "steel": {"class": "B500B"}, "inner": BARS, "outer": BARS}}


def tunnel(name, x, lining, **others):
    return {"name": name, "centre": {"x": x, "y": -DEPTH}, "circle": {"radius": RADIUS}, "stage": 1, "released": 0.5, "sections": 24,
            "lining": {"as": "beam", **lining}, **others}


def lined(*tunnels, duration=0.34, **continuum):
    """Tunnels excavated and lined in stages, and shaken."""
    return {
        "material": SOIL, "time": {"duration": duration, "dt_factor": 0.8}, "statics": {"unbalanced_ratio": 3e-4},
        "initial_stress": {"layers": [{"bottom": -24, "density": 2000, "k0": 0.6}]}, "tunnels": list(tunnels),
        "continuum": {"block": {"x_min": -20, "x_max": 20, "y_min": -24, "y_max": 0, "zones_x": 40, "zones_y": 24},
                      "body_loads": [{"acceleration": {"y": -9.81}}], "free_field": {"left": True, "right": True},
                      "base": {"kind": "compliant", "acceleration": {"ricker": {"frequency": 5, "time": 0.2}, "peak": 9}}, **continuum},
        "output": {"field_times": [], "history_interval": 2e-3, "peaks": {"highest_frequency": 50}}}


class Tunnels(ZoomTest):
    def mean_thrust(self, run, name):
        return -ring_ovaling.around(run, "thrust_N", name)[1][0].mean()

    # The lining without bars cracks, and only it becomes particles: those bear, at rest, what closed forms say of an annulus (within 4 %)
    # and of a ring on its axis (within 2 %), which differ by 9 %; the other tunnel and its beams stay what they were.
    def test_a_lining_of_beams_that_cracks_becomes_particles(self):
        self.computed(lined(tunnel("west", -9, C30), tunnel("east", 9, REINFORCED)))
        zoomed = self.written("--size", 0.19)
        told = self.told.splitlines()
        self.assertIn("`east` stays as it is", told[0])
        self.assertIn("`west` becomes particles: its lining reaches ", told[1])
        self.assertEqual([each["name"] for each in zoomed.scene["continuum"]["linings"]], ["east"])
        self.assertIn("west", [group["name"] for group in zoomed.scene["particles"]["groups"]])
        self.assertGreater(zoomed.summary["crack_count"], 0)
        mean, concrete = 0.8 * DEPTH * 2000 * 9.81, (zoomed.scene["particles"]["groups"][0]["material"]["young_modulus"], 0.2)
        elastic = {"young_modulus": concrete[0], "poisson_ratio": 0.2, "thickness": THICKNESS}
        ring = lined_tunnel.excavation_forces(lined_tunnel.Tunnel.ring(SOIL, elastic, RADIUS + THICKNESS / 2), mean, 0)[0] / 2
        annulus = ring_ovaling.excavated_annulus(concrete, (300e6, 0.3), RADIUS, RADIUS + THICKNESS, mean, 0)[0] / 2
        self.assertAlmostEqual(self.mean_thrust(self.run, "west") / ring, 1, delta=0.02)
        self.assertAlmostEqual(self.mean_thrust(zoomed, "west") / annulus, 1, delta=0.04)
        self.assertAlmostEqual(self.mean_thrust(zoomed, "east") / self.mean_thrust(self.run, "east"), 1, delta=0.01)

    # Linings of zones, one with bars, and a history beside one of them; nothing but the check of the scene that is written.
    def test_linings_of_zones_in_stages(self):
        history = {"name": "beside", "quantity": "velocity_x", "at": {"x": -9, "y": -9}}
        given = lined(tunnel("west", -9, C30, zones={"across": 2}), tunnel("east", 9, REINFORCED), histories=[history])
        for each in given["tunnels"]:
            each["lining"]["as"] = "zones"
        self.computed(given)
        told = self.zoom("--demand", 0.3)
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertEqual(told.stdout.count("becomes particles"), 2, told.stdout)
        self.assertIn("note: the history `beside` of velocity_x is left out", told.stdout)
        checked = coupler("check", self.run.folder / "zoom.yaml")
        self.assertEqual(checked.returncode, 0, checked.stderr)

    def test_no_tunnel_needs_particles(self):
        self.computed(lined(tunnel("west", -9, C30), tunnel("east", 9, REINFORCED), duration=0.01))
        self.assertRegex(self.zoom("--demand", 0.9).stdout, r"^No particles are needed: the lining of `west` reaches 0\.\d+ of its strength at \(.+\) m, "
                         r"others less; the ground states no strength\.\n$")

    # A weak body of ground away from the tunnel: a region beside it, but where the tunnel is excavated in a stage.
    def test_ground_elsewhere(self):
        weak = {"tensile_strength": 1e3, "fracture_energy": 50, "compressive_strength": 5e3, "friction_angle": 0.1}
        body = {"where": {"x_min": 7, "x_max": 9, "y_min": -13, "y_max": -11}, "material": SOIL | {"fracture": weak}}
        given = lined(tunnel("west", -9, C30), duration=0.01, materials=[body])
        self.computed(given)
        self.assertRegex(self.zoom().stdout, r"^No particles are written: the lining of `west` reaches 0\.\d+ of its strength at .+; 4 zones near their strength, "
                         r"the worst at \([78]\.5, -1[12]\.5\) m, stay zones: the scene has stages, in which only tunnels become particles\.\n$")
        self.assertFalse((self.run.folder / "zoom.yaml").exists())
        for key in ("stage", "released"):
            del given["tunnels"][0][key]
        self.run = Run(self.run_scene(self.scene(json.dumps(given)), out="without_stages"))
        told = self.zoom("--demand", 0.1)
        self.assertIn("`west` becomes particles", told.stdout, told.stderr)
        self.assertIn("zones around (", told.stdout)
        checked = coupler("check", self.run.folder / "zoom.yaml")
        self.assertEqual(checked.returncode, 0, checked.stderr)

    def test_what_tunnels_of_particles_do_not_have(self):
        shotcrete = {"name": "shotcrete", "thickness": 0.2, "material": {"concrete": "C20/25"}}
        for lining, message in (
                (C30 | {"interface": {"friction_angle": 0.3}}, "it has tunnels[0].lining.interface, which particles do not; leave it out"),
                ({"layers": [shotcrete, C30 | {"name": "inner"}]}, "it has tunnels[0].lining.layers, which particles do not"),
                ({"thickness": 0.4, "material": ground(30e9)}, "tunnels[0].lining.material states no strength to compare with; give it a class")):
            with self.subTest(message=message):
                self.computed(lined(tunnel("west", -9, lining), duration=0.01))
                self.assertIn(message, self.refusal("--demand", 0.01))

    def test_peaks_of_linings(self):
        given = lined(tunnel("west", -9, C30), duration=0.01)
        del given["output"]["peaks"]
        self.computed(given)
        self.assertIn("kept no peaks; add `output: {peaks: {}}` to the scene and run it again.", self.refusal())

    def test_a_tunnel_near_the_edge(self):
        self.computed(lined(tunnel("west", -13, C30), duration=0.01))
        self.assertIn("needs particles in 4 m of ground around it, four zones, but at (-20, -12) m, within five, is ", self.refusal("--demand", 0.01))

    def test_the_scene_has_changed(self):
        self.run = Run(self.run_scene(self.scene(json.dumps(lined(tunnel("west", -9, C30)))), "--set", "time.duration=10 ms"))
        self.assertIn("becomes particles", self.zoom("--demand", 0.01).stdout)
        self.scene(json.dumps(lined(tunnel("west", -8, C30))))
        self.assertIn("or what it extends has changed since; run it again.", self.refusal())
        (self.folder / "scene.yaml").unlink()
        self.assertIn("is gone, and only it states the class of concrete of the linings; bring it back.", self.refusal())


if __name__ == "__main__":
    unittest.main()
