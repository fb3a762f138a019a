"""Where a run has several regions, each number belongs to its own: ledger, cracks, figures, fields; and particles that take several steps
in one of the zones tell their own times."""

import unittest

import numpy as np

from figures.bars import HEIGHT, STEP, bar, discs, kinetic_energy, masses_of_discs, masses_of_points, overlap
from figures.computed import ComputedTest
from figures.discs import point

END, STRENGTH = 1.2e-3, 2e6


class Regions(ComputedTest):
    def test_of_a_bar_between_two_regions(self):
        """Both are pulled at their ends, the right one so that it tears; sections stand in both."""
        section = lambda x: [{"name": "cut", "from": point((x, 0)), "to": point((x, HEIGHT))}]  # noqa: E731
        history = [{"name": "cut", "section": "cut", "quantity": "thrust"}]
        left = discs(0, 4, sections=section(1), histories=[history[0] | {"name": "at_1"}],
                     loads=[{"where": {"x_max": 0.1}, "force": {"x": -1e5}, "time": {"sine": {"frequency": 500}}}])
        right = discs(6, 10, sections=section(9), histories=[history[0] | {"name": "at_9"}], bonds={"tensile_strength": STRENGTH},
                      loads=[{"where": {"x_min": 9.9}, "force": {"x": 12e6}, "time": {"sine": {"frequency": 500}}}])
        self.computed(bar(
            END, regions=[{"name": "left", "particles": left}, {"name": "right", "particles": right}],
            interfaces=[overlap(3.5, 1.5, inner="left"), overlap(6.5, 8.5, inner="right")]))
        old, new = self.pieces(-2), self.pieces(-1)
        last = {name: values[-1] for name, values in self.run.histories.items()}
        owners = {"continuum": ("grid", masses_of_points), "left": ("left_particles", masses_of_discs), "right": ("right_particles", masses_of_discs)}
        for model, (piece, masses) in owners.items():
            energy = kinetic_energy(masses(new[piece]), old[piece], new[piece])
            self.assertAlmostEqual(last[f"{model}_kinetic_J"], energy, delta=1e-9 * abs(energy), msg=model)
        self.assertEqual((last["left_released_J"], last["continuum_released_J"], last["continuum_external_work_J"]), (0, 0, 0))
        self.assertGreater(last["right_released_J"], 0)
        self.torn(new["right_bonds"], new["right_particles"])
        summary = self.run.summary
        for region, x in (("left", 1), ("right", 9)):
            thrust = self.run.histories[f"at_{x}_thrust_N"]
            for which, row in (("largest", thrust.argmax()), ("smallest", thrust.argmin())):
                name = f"{region}_sections_{which}_thrust"
                self.assertAlmostEqual(summary[f"{name}_N"], thrust[row], delta=1e-9 * np.abs(thrust).max(), msg=name)
                self.assertEqual((summary[f"{name}_x_m"], summary[f"{name}_y_m"]), (x, HEIGHT / 2))
                if thrust[row]:
                    self.assertAlmostEqual(summary[f"{name}_time_s"], self.time[row], delta=1e-12, msg=name)
        within = sum(np.sum(np.abs(new[f"{region}_particles"].points[:, 0] - middle) < 1) for region, middle in (("left", 2.5), ("right", 7.5)))
        self.assertEqual(summary["coupling_points"], within)

    def torn(self, bonds, particles):
        """The broken bonds of the fields are those of cracks.csv and of the summary."""
        cracks, summary = self.run.cracks, self.run.summary
        broken = bonds["state"] > 0
        self.assertEqual((summary["crack_count"], len(cracks["time_s"]), summary["debonded_count"]), (broken.sum(), broken.sum(), 0))
        self.assertGreater(broken.sum(), 0)
        self.assertEqual(set(cracks["region"]), {"right"})
        places = bonds.points[bonds.cells[broken]].mean(axis=1)
        told = np.column_stack([cracks["x_m"], cracks["y_m"]])
        np.testing.assert_allclose(told[np.lexsort(told.T)], places[np.lexsort(places.T)], atol=1e-12)
        place = {number: where for number, where in zip(particles["id"], particles.points)}
        for a, b, where in zip(cracks["parent_a"], cracks["parent_b"], told):
            np.testing.assert_allclose((place[a] + place[b]) / 2, where, atol=1e-12)
        force = self.run.histories["max_bond_force_N"]
        self.assertEqual(summary["peak_bond_force_N"], force.max())
        self.assertAlmostEqual(summary["peak_bond_force_time_s"], self.time[force.argmax()], delta=1e-12)
        self.assertLessEqual(summary["peak_bond_force_N"], STRENGTH)
        self.assertEqual((summary["first_crack_time_s"], summary["first_crack_x_m"], summary["first_crack_y_m"]), (cracks["time_s"][0], *told[0]))

    def test_of_particles_that_take_four_steps_in_one(self):
        """Their cracks and their largest force happen at times of their own steps."""
        steps = 4
        text = bar(END, particles=discs(4, 10, bonds={"tensile_strength": STRENGTH},
                                        loads=[{"where": {"x_min": 9.8}, "force": {"x": 12e6}, "time": {"sine": {"frequency": 500}}}]),
                   interface=overlap(4.5, 6.5))
        text["time"] |= {"substeps": steps}
        self.computed(text)
        summary, cracks = self.run.summary, self.run.cracks
        self.assertEqual((summary["substeps"], summary["dt_s"]), (steps, steps * STEP))
        np.testing.assert_allclose(cracks["time_s"], cracks["step"] * STEP, rtol=1e-12)
        at = summary["peak_bond_force_time_s"] / STEP
        self.assertAlmostEqual(at, round(at), delta=1e-6)
        row = int(np.ceil(at / steps - 1e-6))  # that follows
        force = self.run.histories["max_bond_force_N"]
        self.assertLessEqual(force.max(), summary["peak_bond_force_N"])
        self.assertGreater(max(force[row - 1:row + 1]), 0.8 * summary["peak_bond_force_N"])
        self.assertEqual(summary["particle_updates"], summary["particles"] * steps * summary["steps"])
        # As with one step in one: the first crack at the same place, and at the same time within a few steps.
        text["time"].pop("substeps")
        self.run_alone(text, summary)

    def run_alone(self, text, summary):
        (self.folder / "alone").mkdir()
        self.folder = self.folder / "alone"
        alone = self.computed(text).summary
        for axis in "xy":
            self.assertAlmostEqual(summary[f"first_crack_{axis}_m"], alone[f"first_crack_{axis}_m"], delta=1e-9)
        self.assertAlmostEqual(summary["first_crack_time_s"], alone["first_crack_time_s"], delta=2 * STEP)
        self.assertAlmostEqual(summary["peak_bond_force_N"], alone["peak_bond_force_N"], delta=0.01 * STRENGTH)


if __name__ == "__main__":
    unittest.main()
