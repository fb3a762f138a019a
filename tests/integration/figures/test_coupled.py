"""Of a bar that is half zones and half particles: energies, weights, momentum, peaks and constraint follow from the fields of both."""

import unittest

import numpy as np

from figures.bars import DENSITY, HEIGHT, POISSON, RADIUS, STEP, YOUNG, bar, discs, kinetic_energy, masses_of_discs, masses_of_points, overlap
from figures.computed import ComputedTest
from figures.discs import near, point

BEGIN, FINISH = 4.0, 6.0  # of the overlap
END = 1.5e-3  # before the wave has reached the other end
FORCE, FREQUENCY = 5e3, 500.0
SIDE = HEIGHT * np.arange(5) / 4  # of the points of the side that is loaded
LAME = YOUNG * POISSON / (1 - POISSON**2)  # in plane stress
SHEAR = YOUNG / 2 / (1 + POISSON)
NORMAL_STIFFNESS, SHEAR_STIFFNESS = 2 / np.sqrt(3) * (SHEAR + LAME), 2 / np.sqrt(3) * (SHEAR - LAME)
PROBED = (5.0, HEIGHT / 2)  # a grid point within the overlap; a particle is near
MOTION = {"displacement": "u{}_m", "velocity": "v{}_m_per_s", "acceleration": "a{}_m_per_s2"}


def histories(name):
    return [{"name": name, "quantity": f"{what}_{axis}", "at": point(PROBED)} for what in MOTION for axis in "xy"]


class Coupled(ComputedTest):
    def setUp(self):
        super().setUp()
        side = [{"name": f"side{i}", "quantity": f"velocity_{axis}", "at": point((0, y))} for i, y in enumerate(SIDE) for axis in "xy"]
        text = bar(END, particles=discs(0, 10, histories=histories("disc")), interface=overlap(BEGIN, FINISH), continuum={
            "edge_loads": [{"where": {"x_max": 0}, "force": {"x": FORCE, "y": FORCE / 2}, "time": {"sine": {"frequency": FREQUENCY}}}],
            "histories": side + histories("zone")})
        text["output"] |= {"peaks": {}}
        self.computed(text)
        self.before, self.after = (self.run.fields(time) for time in (END - STEP, END))
        self.last = {name: values[-1] for name, values in self.run.histories.items()}

    def test_weights(self):
        """They fall linearly from one side of the overlap to the other and add up to one."""
        grid, bonds, particles = (self.after[kind] for kind in ("grid", "bonds", "particles"))
        centres, middles = grid.points[grid.cells].mean(axis=1), bonds.points[bonds.cells].mean(axis=1)
        share = lambda x: np.clip((FINISH - x) / (FINISH - BEGIN), 0, 1)  # noqa: E731
        floor = 1e-3
        np.testing.assert_allclose(grid["weight"], np.maximum(share(centres[:, 0]), floor), atol=1e-9)
        np.testing.assert_allclose(bonds["weight"], np.maximum(1 - share(middles[:, 0]), floor), atol=1e-9)
        sums, count = np.zeros(len(particles.points)), np.zeros(len(particles.points))
        np.add.at(sums, bonds.cells, bonds["weight"][:, None])
        np.add.at(count, bonds.cells, 1)
        np.testing.assert_allclose(particles["weight"], sums / count, atol=1e-9)

    def test_energies_and_momentum(self):
        grid, particles, bonds = (self.after[kind] for kind in ("grid", "particles", "bonds"))
        force = np.array([1, 0.5]) * FORCE * np.sin(2 * np.pi * FREQUENCY * self.time)[:, None]
        momentum, forced, kinetic = 0, 0, {}
        for model, kind, masses in (("continuum", "grid", masses_of_points(grid)), ("particles", "particles", masses_of_discs(particles))):
            old, new = self.before[kind], self.after[kind]
            kinetic[model] = kinetic_energy(masses, old, new)
            self.assertAlmostEqual(self.last[f"{model}_kinetic_J"], kinetic[model], delta=1e-9 * abs(kinetic[model]), msg=model)
            momentum = momentum + masses @ new["velocity_m_per_s"][:, :2]
            inertia = masses[:, None] * (new["velocity_m_per_s"] - old["velocity_m_per_s"]) / STEP
            forced -= np.sum(new["displacement_m"] * inertia) / 2
        np.testing.assert_allclose(momentum, STEP * (force.sum(axis=0) - force[0] / 2), rtol=1e-6)
        self.assertGreater(np.abs(particles["spin_rad_per_s"]).max(), 0)
        stored = np.sum(bonds["weight"] * (bonds["normal_force_N"]**2 / NORMAL_STIFFNESS + bonds["shear_force_N"]**2 / SHEAR_STIFFNESS)) / 2
        self.assertAlmostEqual(self.last["particles_strain_J"], stored, delta=1e-9 * stored)
        # All internal forces together do what inertia and the load leave of them; elastic ones store half their work over the displacement.
        share = np.array([1, 2, 2, 2, 1]) / 8  # of the side's length
        loaded = [int(np.argmin(np.hypot(*(grid.points - (0, y)).T))) for y in SIDE]
        forced += share @ grid["displacement_m"][loaded, :2] @ force[-1] / 2
        self.assertAlmostEqual(self.last["continuum_strain_J"] + self.last["particles_strain_J"], forced, delta=1e-4 * forced)
        speed = np.stack([share @ [self.run.histories[f"side{i}_v{axis}_m_per_s"] for i in range(5)] for axis in "xy"], axis=1)
        work = np.sum((force[1:] + force[:-1]) / 2 * speed[1:]) * STEP
        self.assertAlmostEqual(self.last["continuum_external_work_J"], work, delta=1e-9 * work)
        self.assertEqual(self.last["particles_external_work_J"], 0)
        # What leaves the zones through the interface is what the particles have.
        given = kinetic["particles"] + stored
        self.assertAlmostEqual(self.last["particles_multiplier_work_J"], given, delta=1e-6 * given)
        self.assertAlmostEqual(self.last["continuum_multiplier_work_J"], -given, delta=1e-6 * given)
        self.assertLess(abs(self.run.summary["multiplier_work_J"]), 1e-9 * given)
        self.assertLess(self.run.summary["max_energy_drift"], 1e-6)
        self.assertAlmostEqual(self.run.summary["energy_kept"], 1, delta=1e-6)

    def test_motions_and_their_peaks(self):
        """Within the overlap, too, velocities are corrected ones, accelerations those of the step before, and peaks theirs."""
        for name, kind in (("zone", "grid"), ("disc", "particles")):
            of = {what: np.array([self.run.histories[f"{name}_{column.format(axis)}"] for axis in "xy"]) for what, column in MOTION.items()}
            np.testing.assert_allclose(np.diff(of["displacement"]), STEP * of["velocity"][:, 1:], atol=1e-9 * STEP * np.abs(of["velocity"]).max())
            size = np.abs(of["acceleration"]).max()
            np.testing.assert_allclose(of["acceleration"][:, 2:], np.diff(of["velocity"])[:, 1:] / STEP, atol=1e-6 * size)
            piece = self.after[kind]
            at = int(np.argmin(np.hypot(*(piece.points - PROBED).T)))
            for what, field in (("displacement", "peak_displacement_m"), ("velocity", "peak_velocity_m_per_s")):
                self.assertAlmostEqual(piece[field][at], np.hypot(*of[what]).max(), delta=1e-9 * piece[field][at], msg=f"{name} {what}")
            reached = piece["velocity_m_per_s"][at, :2]  # half a step after the last row, which peaks of acceleration know
            accelerations = np.hypot(*np.column_stack([of["acceleration"], (reached - of["velocity"][:, -1]) / STEP]))
            self.assertAlmostEqual(piece["peak_acceleration_m_per_s2"][at], accelerations.max(), delta=1e-6 * size, msg=name)

    def test_the_constraint(self):
        """Particles in the overlap move as the zones at their places."""
        grid, particles = self.after["grid"], self.after["particles"]
        inside = (particles.points[:, 0] > BEGIN) & (particles.points[:, 0] < FINISH)
        summary = self.run.summary
        self.assertEqual(summary["coupling_points"], inside.sum())
        self.assertEqual((summary["solve"], summary["overlap_particles_begin_x_m"], summary["overlap_particles_begin_y_m"],
                          summary["overlap_continuum_ends_x_m"], summary["overlap_continuum_ends_y_m"]), ("consistent", BEGIN, 0, FINISH, 0))
        self.assertLess(summary["max_constraint_residual"], 1e-9)
        self.assertEqual((summary["particles"], summary["bonds"], summary["zones"], summary["grid_points"]),
                         (len(particles.cells), len(self.after["bonds"].cells), len(grid.cells), len(grid.points)))
        for field in ("displacement_m", "velocity_m_per_s"):
            size = np.abs(grid[field]).max()
            for place, found in zip(particles.points[inside], particles[field][inside]):
                self.assertLess(np.abs(self.at(grid, place, field) - found).max(), 1e-9 * size, field)

    @staticmethod
    def at(grid, place, field):
        """A field of the grid's points, linear in both directions within a zone."""
        for corners in grid.cells:
            low, high = grid.points[corners].min(axis=0), grid.points[corners].max(axis=0)
            if np.all(low - 1e-9 <= place) and np.all(place <= high + 1e-9):
                near = 1 - np.abs(grid.points[corners] - place) / (high - low)
                return near.prod(axis=1) @ grid[field][corners]
        raise AssertionError(f"no zone at {place}")


class Losses(ComputedTest):
    def test_of_multipliers_that_filter(self):
        """What is lost is the work of the multipliers on both models, and the gap of the balance."""
        self.computed(bar(2 * END, particles=discs(0, 10), interface=overlap(BEGIN, FINISH, solve="lumped"), continuum={
            "edge_loads": [{"where": {"x_max": 0}, "force": {"x": FORCE}, "time": {"sine": {"frequency": 4 * FREQUENCY, "end": END / 3}}}]}))
        table, summary = self.run.histories, self.run.summary
        of = lambda what: sum(table[f"{model}_{what}_J"] for model in ("continuum", "particles"))  # noqa: E731
        stored, work, multipliers = of("kinetic") + of("strain"), of("external_work"), of("multiplier_work")
        size = stored.max()
        self.assertLess(multipliers[-1], -1e-4 * size)
        np.testing.assert_allclose(stored - work, multipliers, atol=1e-6 * size)
        np.testing.assert_allclose(table["energy_drift"] * np.maximum.accumulate(stored), stored - work, atol=1e-9 * size)
        self.assertEqual(summary["solve"], "lumped")
        self.assertAlmostEqual(summary["multiplier_work_J"], multipliers[-1], delta=1e-9 * size)
        self.assertAlmostEqual(summary["energy_kept"], stored[-1] / work[-1], delta=1e-9)
        self.assertAlmostEqual(summary["max_energy_drift"], np.abs(stored - work).max() / size, delta=1e-12)


class Shares(ComputedTest):
    def test_of_a_bar_that_a_foundation_holds(self):
        """It is pushed aside as one body, so that each model has the part of every energy that it has of the mass."""
        push, stiffness = 3.0, 4e8
        acts = {"body_loads": [{"acceleration": {"x": push, "y": 0}}], "foundations": [{"x": {"stiffness": stiffness}}]}
        probe = [{"name": "p", "quantity": "displacement_x", "at": point((1, HEIGHT / 2))}]
        self.computed(bar(END, particles=discs(0, 10, engine="general", **acts), interface=overlap(BEGIN, FINISH), continuum=acts | {"histories": probe}))
        t, omega = self.time, np.sqrt(stiffness / DENSITY)
        moved = push / omega**2 * (1 - np.cos(omega * t))
        self.told_histories({"p_ux_m": moved}, tolerance=1e-4)
        fields = self.run.fields()
        masses = {"continuum": masses_of_points(fields["grid"]).sum(), "particles": masses_of_discs(fields["particles"]).sum()}
        for model, mass in masses.items():
            work, stored = mass * push * moved, mass / DENSITY * stiffness * moved**2 / 2
            for column, values in (("external_work", work), ("strain", stored), ("kinetic", work - stored), ("multiplier_work", 0 * work)):
                np.testing.assert_allclose(self.run.histories[f"{model}_{column}_J"], values, atol=2e-4 * work.max(), err_msg=f"{model} {column}")
        self.told_energies(size=work.max(), tolerance=2e-4, body_loads=work, foundations=stored)


class Sections(ComputedTest):
    def test_in_the_overlap(self):
        """A bar at rest under a pull has one thrust everywhere, whichever model tells it: what the whole ground bears."""
        cut = lambda x: {"from": point((x, 0)), "to": point((x, HEIGHT))}  # noqa: E731
        in_zones, in_particles = {"zones_alone": 3, "zones_within": 5}, {"discs_within": 5, "discs_alone": 8.01}
        asked = lambda cuts: {"sections": [{"name": name, **cut(x)} for name, x in cuts.items()],  # noqa: E731
                              "histories": [{"name": name, "section": name, "quantity": "thrust"} for name in cuts]}
        held = {"x_min": 10 - 2.1 * RADIUS}
        self.computed(bar(
            10 * STEP, statics={"unbalanced_ratio": 1e-6}, interface=overlap(BEGIN, FINISH),
            continuum={"edge_loads": [{"where": {"x_max": 0}, "force": {"x": -FORCE}}], **asked(in_zones)},
            particles=discs(0, 10, **asked(in_particles), motions=[{"where": held, "velocity": {"x": 0}},
                                                                  {"where": near((10 - RADIUS, RADIUS)), "velocity": {"y": 0}}])))
        for name in in_zones | in_particles:
            np.testing.assert_allclose(self.run.histories[f"{name}_thrust_N"], FORCE, rtol=0.01, err_msg=name)


if __name__ == "__main__":
    unittest.main()
