"""Particles that wait (`particles.begin`): while a region is linear it is as if its cells were computed; they begin where something comes
near its strength, with their energy, and crack as they would have; in any number of steps, threads and pieces of a run."""

import copy
import json
import unittest

import numpy as np

from figures.computed import ComputedTest
from programs import coupler

from adit import Run

STRONG = {"tensile_strength": 3e5, "fracture_energy": 60.0, "compressive_strength": 6e6, "friction_angle": 0.6}
MATERIAL = {"young_modulus": 2e9, "poisson_ratio": 0.25, "density": 2200.0, "fracture": STRONG}
WEIGHT = [{"acceleration": {"y": -9.81}}]
WAVE = 3.0  # m/s^2, by which nothing comes near its strength; twenty times as much cracks the region
CELL = 0.4  # m


def scene(wave=WAVE, demand=0.8, substeps=1, size=CELL, **particles):
    """Ground under its weight with a region of cells, sheared from below. Waves are eight times as long as the region is wide."""
    begin = {} if demand is None else {"begin": {"demand": demand}}
    return {
        "material": MATERIAL, "time": {"duration": 0.1, "dt_factor": 0.8, "substeps": substeps}, "statics": {"unbalanced_ratio": 1e-6},
        "initial_stress": {"yy_per_metre": 21582, "xx_per_metre": 12000},
        "continuum": {
            "block": {"x_min": -12, "x_max": 12, "y_min": -16, "y_max": 0, "zones_x": 24, "zones_y": 16}, "body_loads": WEIGHT,
            "free_field": {"left": True, "right": True},
            "base": {"kind": "compliant", "acceleration": {"ricker": {"frequency": 10, "time": 0.06}, "peak": wave}},
            "histories": [{"name": "surface", "quantity": "velocity_x", "at": {"x": 6, "y": 0}}]},
        "particles": {
            "cells": {"x_min": -4, "x_max": 4, "y_min": -11, "y_max": -3, "size": size}, "body_loads": WEIGHT, **begin,
            "sections": [{"name": "cut", "from": {"x": 0, "y": -8}, "to": {"x": 0, "y": -6}}],
            "histories": [{"name": "middle", "quantity": quantity, "at": {"x": 0, "y": -7}} for quantity in ("displacement_x", "velocity_x")]
            + [{"name": "middle", "quantity": "stress_xy", "at": {"x": 0, "y": -7}, "radius": 1.5},
               {"name": "cut", "quantity": "shear_force", "section": "cut"}], **particles},
        "interface": {"overlap": {"around": {"box": {"x_min": -2, "x_max": 2, "y_min": -9, "y_max": -5}}, "width": 2}, "solve": "split"},
        "output": {"history_interval": 1e-3, "peaks": {"highest_frequency": 50}}}


def spalling_bar(begin):
    """The end of a bar of concrete, tied on one side, that a pulse shorter than it is long tears where it meets its reflection."""
    return {
        "material": {"young_modulus": 30e9, "poisson_ratio": 0.2, "density": 2500.0,
                     "fracture": {"tensile_strength": 3e6, "fracture_energy": 100.0, "compressive_strength": 40e6}},
        "time": {"duration": 3e-3, "substeps": 4},
        "continuum": {"block": {"x_min": 0, "x_max": 6, "y_min": 0, "y_max": 1, "zones_x": 60, "zones_y": 10},
                      "edge_loads": [{"where": {"x_max": 0}, "force": {"x": 5e6}, "time": {"sine": {"frequency": 2000, "end": 2.5e-4}}}]},
        "particles": {"cells": {"x_min": 3, "x_max": 6, "y_min": 0, "y_max": 1, "size": 0.1}, **({"begin": {"demand": 0.8}} if begin else {})},
        "interface": {"overlap": {"particles_begin": {"x": 3, "y": 0}, "continuum_ends": {"x": 3.5, "y": 0}}, "solve": "split"},
        "output": {"history_interval": 3e-4}}


def two_regions(strength=(1.0, 2.0), waits=(True, True), **changes):
    """The same ground, wider, with two such regions: `west` and `east`, of so many times the strength."""
    whole = scene(**changes)
    middle, interface = whole.pop("particles"), whole.pop("interface")
    whole["continuum"]["block"].update(x_min=-24, x_max=24, zones_x=48)
    whole["regions"], whole["interfaces"] = [], []
    for name, x, times, wait in zip(("west", "east"), (-10, 10), strength, waits):
        region = copy.deepcopy(middle)
        region["cells"].update(x_min=x - 4, x_max=x + 4)
        strong = {key: STRONG[key] * times for key in ("tensile_strength", "fracture_energy", "compressive_strength")}
        region["material"] = {**MATERIAL, "fracture": {**STRONG, **strong}}
        region["sections"] = [{"name": name, "from": {"x": x, "y": -8}, "to": {"x": x, "y": -6}}]
        region["histories"] = [{**history, "name": name, **({"section": name} if "section" in history else {"at": {"x": x, "y": -7}})}
                               for history in region["histories"]]
        if not wait:
            region.pop("begin", None)
        whole["regions"].append({"name": name, "particles": region})
        around = {"x_min": x - 2, "x_max": x + 2, "y_min": -9, "y_max": -5}
        whole["interfaces"].append({**interface, "inner": name, "overlap": {"around": {"box": around}, "width": 2}})
    return whole


class Begin(ComputedTest):
    def runs(self, **changes):
        """The run of a scene whose region waits, and that of the same scene in which it does not."""
        return self.run_of("waiting", **changes), self.run_of("computed", **{**changes, "demand": None})

    def run_of(self, name, **changes):
        return Run(self.run_scene(self.scene(json.dumps(scene(**changes))), out=name))

    def differ(self, one, other, column, rows=slice(None)):
        a, b = one.histories[column], other.histories[column]
        return np.abs(a - b)[rows].max() / np.abs(b - b[0]).max()

    def assert_alike(self, one, other, rows=slice(None), **tolerances):
        for column, tolerance in tolerances.items():
            self.assertLess(self.differ(one, other, column, rows), tolerance, column)

    def test_a_region_that_waits_moves_as_its_cells_do(self):
        for substeps in (1, 4):
            with self.subTest(substeps=substeps):
                waiting, computed = self.runs(substeps=substeps)
                self.assertNotIn("particles_began_s", waiting.summary)
                self.assertGreater(waiting.summary["particles_waited_demand"], 0.05)
                self.assertLess(waiting.summary["particles_waited_demand"], 0.8)
                self.assert_alike(waiting, computed, surface_vx_m_per_s=2e-3, middle_ux_m=1e-3, middle_sxy_Pa=5e-3, cut_shear_N=1e-2)
                self.assert_alike(waiting, computed, middle_vx_m_per_s=2e-2)  # they have no own oscillations
                self.assertLess(np.abs(waiting.histories["energy_drift"]).max(), 1e-12)
                for key in ("sections_smallest_thrust_N", "sections_largest_moment_Nm"):
                    self.assertAlmostEqual(waiting.summary[key], computed.summary[key], delta=2e-2 * abs(computed.summary[key]), msg=key)
                for column in ("kinetic_J", "strain_J", "multiplier_work_J"):
                    self.assert_alike(waiting, computed, **{f"particles_{column}": 3e-2})

    def test_cells_begin_before_they_crack_and_crack_as_they_would_have(self):
        for substeps in (1, 4):
            with self.subTest(substeps=substeps):
                began, computed = self.runs(wave=20 * WAVE, substeps=substeps)
                first, expected = began.table("cracks.csv"), computed.table("cracks.csv")
                self.assertGreater(len(expected["time_s"]), 100)
                self.assertLess(began.summary["particles_began_s"], first["time_s"][0])
                self.assertGreaterEqual(began.summary["particles_began_demand"], 0.8)
                self.assertLess(began.summary["particles_began_demand"], 0.9)
                self.assertAlmostEqual(first["time_s"][0], expected["time_s"][0], delta=1e-3)
                self.assertAlmostEqual(len(first["time_s"]) / len(expected["time_s"]), 1, delta=0.1)  # with another number of substeps they differ as much
                self.assertLess(abs(began.summary["particles_began_energy_change"]), 2e-3)
                before = began.histories["time_s"] < began.summary["particles_began_s"]
                self.assertLess(np.abs(began.histories["energy_drift"][before]).max(), 1e-12)

    def test_bolts_wait_as_long_as_they_are_linear(self):
        """A stiff bolt is in the stiffness of the region; where it becomes slack, the region begins."""
        bolt = {"name": "bolt", "from": {"x": -1, "y": -7.5}, "to": {"x": 1, "y": -6.5}, "stiffness": 2e8}
        history = {"name": "bolt", "quantity": "spring_force", "spring": "bolt"}
        for pretension, slack in ((3e4, False), (1e3, True)):
            given = scene()
            given["particles"]["springs"] = [{**bolt, "pretension": pretension}]
            given["particles"]["histories"].append(history)
            waiting = Run(self.run_scene(self.scene(json.dumps(given)), out=f"bolt_{slack}"))
            del given["particles"]["begin"]
            computed = Run(self.run_scene(self.scene(json.dumps(given)), out=f"bolt_{slack}_computed"))
            self.assert_alike(waiting, computed, middle_ux_m=1e-3, bolt_force_N=1e-2)
            if slack:
                force, time = computed.histories["bolt_force_N"], computed.histories["time_s"]
                self.assertAlmostEqual(waiting.summary["particles_began_s"], time[force <= 0][0], delta=2e-3)
                self.assertEqual(waiting.summary["particles_began_demand"], 1)
            else:
                self.assertNotIn("particles_began_s", waiting.summary)

    def test_the_demand_is_looked_at_whatever_results_are_wanted(self):
        given = scene(wave=20 * WAVE)
        given["output"] = {"history_interval": 0.1}
        del given["particles"]["histories"]
        began = Run(self.run_scene(self.scene(json.dumps(given)), out="two_rows"))
        self.assertLess(began.summary["particles_began_s"], began.summary["first_crack_time_s"])
        self.assertLess(began.summary["particles_began_demand"], 0.95)

    def test_what_waves_shorter_than_the_region_break_breaks(self):
        """What waits does not oscillate by itself: it begins where that matters, and says so."""
        began, computed = (Run(self.run_scene(self.scene(json.dumps(spalling_bar(begin))), out=f"bar_{begin}")) for begin in (True, False))
        self.assertEqual(began.summary["particles_began_demand"], 1)
        self.assertTrue(any("the waves are short beside the region" in warning for warning in began.summary["warnings"]))
        self.assertAlmostEqual(began.summary["first_crack_time_s"], computed.summary["first_crack_time_s"], delta=0.02e-3)
        self.assertAlmostEqual(began.summary["first_crack_x_m"], computed.summary["first_crack_x_m"], delta=0.1)
        self.assertAlmostEqual(began.summary["crack_count"] / computed.summary["crack_count"], 1, delta=0.2)

    def test_cracks_of_all_regions_stand_in_the_order_of_time(self):
        cracked = self.of_two("order", strength=(1.0, 1.2), wave=20 * WAVE, substeps=4, demand=None)
        cracks = cracked.table("cracks.csv")
        self.assertEqual(len(set(np.sign(cracks["x_m"]))), 2)
        self.assertTrue((np.diff(cracks["time_s"]) >= 0).all())
        self.assertEqual(cracked.summary["first_crack_time_s"], cracks["time_s"][0])

    def test_what_is_near_its_strength_at_rest_begins_at_once(self):
        began, computed = self.runs(demand=0.01)
        self.assertEqual(began.summary["particles_began_s"], 0)
        self.assertIn("at rest", began.summary["particles_began_because"])
        self.assert_alike(began, computed, middle_ux_m=1e-4, middle_vx_m_per_s=1e-3)

    def test_threads_and_resumed_runs_change_no_bit(self):
        """Checkpoints of before and after the beginning. The end of a run enters its peaks, and at it cells are put where they are."""
        self.assert_goes_on(scene(wave=20 * WAVE, substeps=4), "particles")

    def test_of_two_regions_no_bit_changes_while_one_waits(self):
        self.assert_goes_on(two_regions(wave=20 * WAVE, substeps=4), "west")

    def assert_goes_on(self, given, region):
        del given["output"]["peaks"]
        path = self.scene(json.dumps(given))
        whole = self.run_scene(path, "--dem-threads", 2, out="whole")
        began = json.loads((whole / "summary.json").read_text())[f"{region}_began_s"]
        for duration in (round(began / 2, 3), round(began + 0.005, 3)):
            with self.subTest(duration=duration):
                part = copy.deepcopy(given)
                part["time"]["duration"] = duration
                part["output"]["checkpoint"] = {}
                run = self.run_scene(self.scene(json.dumps(part)), "--dem-threads", 1, out=f"to_{duration}")
                resumed = coupler("resume", run, "--until", "100 ms", "--dem-threads", 1)
                self.assertEqual(resumed.returncode, 0, resumed.stderr)
                for name in ("histories.csv", "cracks.csv", "energies.csv"):
                    self.assertEqual((run / name).read_bytes(), (whole / name).read_bytes(), name)

    def of_two(self, name, **changes):
        return Run(self.run_scene(self.scene(json.dumps(two_regions(**changes))), out=name))

    def test_regions_begin_one_after_another(self):
        """The weak one cracks; the strong one waits on, or begins later. Both answer as they do if both are computed: until they
        crack, since cracks scatter: 361 of them with one step of the cells, 407 with four."""
        for substeps in (1, 4):
            for strong in (2.0, 50.0):
                with self.subTest(substeps=substeps, strong=strong):
                    began = self.of_two(f"two_{substeps}_{strong}", strength=(1.0, strong), wave=20 * WAVE, substeps=substeps)
                    computed = self.of_two(f"both_{substeps}_{strong}", strength=(1.0, strong), wave=20 * WAVE, substeps=substeps, demand=None)
                    summary, cracks, expected = began.summary, began.table("cracks.csv"), computed.table("cracks.csv")
                    self.assertLess(summary["west_began_s"], cracks["time_s"][0])
                    self.assertAlmostEqual(cracks["time_s"][0], expected["time_s"][0], delta=1e-3)
                    self.assertEqual("east_began_s" in summary, strong < 50)
                    if strong < 50:
                        self.assertLess(summary["west_began_s"], summary["east_began_s"])
                        first, first_expected = (min(table["time_s"][table["x_m"] > 0]) for table in (cracks, expected))
                        self.assertLess(summary["east_began_s"], first)
                        self.assertAlmostEqual(first, first_expected, delta=1e-3)
                    before = began.histories["time_s"] < cracks["time_s"][0]
                    self.assert_alike(began, computed, before, east_ux_m=1e-3, west_ux_m=1e-3, surface_vx_m_per_s=2e-3)
                    self.assertAlmostEqual(len(cracks["time_s"]) / len(expected["time_s"]), 1, delta=0.15)
                    self.assertLess(abs(summary["particles_began_energy_change"]), 2e-3)

    def test_a_region_waits_beside_one_that_does_not(self):
        for substeps in (1, 4):
            with self.subTest(substeps=substeps):
                mixed = self.of_two(f"mixed_{substeps}", waits=(True, False), substeps=substeps)
                computed = self.of_two(f"none_waits_{substeps}", demand=None, substeps=substeps)
                self.assertNotIn("west_began_s", mixed.summary)
                self.assertGreater(mixed.summary["particles_followed"], 10)
                self.assert_alike(mixed, computed, surface_vx_m_per_s=2e-3, west_ux_m=1e-3, east_ux_m=1e-3, west_sxy_Pa=5e-3)
                for column in ("kinetic_J", "strain_J", "multiplier_work_J"):
                    self.assert_alike(mixed, computed, **{f"west_{column}": 3e-2, f"east_{column}": 3e-2})
                # The solve `split` takes energy where cells are computed, and nothing else does.
                self.assertLess(np.abs(mixed.histories["energy_drift"]).max(), np.abs(computed.histories["energy_drift"]).max())

    def test_a_recording_replays(self):
        recording = self.folder / "run.rec"
        self.run_scene(self.scene(json.dumps(scene(wave=20 * WAVE))), "--record", recording, out="recorded")
        replayed = coupler("replay", recording)
        self.assertEqual(replayed.returncode, 0, replayed.stdout + replayed.stderr)

    def refusal(self, drop=None, **particles):
        given = scene(**particles)
        given["particles"].pop(drop, None)
        told = coupler("run", self.scene(json.dumps(given)), "--out", self.folder / "refused")
        self.assertEqual(told.returncode, 2, told.stderr)
        self.assert_one_line(told.stderr)
        return told.stderr

    def test_what_cannot_wait_is_refused(self):
        discs = {"packing": {"x_min": -4, "x_max": 4, "y_min": -11, "y_max": -3, "radius": 0.2}}
        self.assertIn("pack `cells`", self.refusal(packing=discs["packing"], drop="cells"))
        self.assertIn("`fracture`", self.refusal(material={key: value for key, value in MATERIAL.items() if key != "fracture"}))
        self.assertIn("loads that change with time",
                      self.refusal(body_loads=[{"acceleration": {"x": 1.0}, "time": {"sine": {"frequency": 10, "end": 0.1}}}]))


if __name__ == "__main__":
    unittest.main()
