"""Forces of contacts, walls and smooth joints are those of their springs, friction and dashpots, with sign, place and owner."""

import unittest

import numpy as np

from figures.computed import ComputedTest
from figures.discs import DENSITY, NORMAL, RADIUS, SHEAR, driven, point, scene, table

STEP, END = 1e-4, 0.01
MASS = DENSITY * np.pi * RADIUS**2


class Contacts(ComputedTest):
    def test_of_two_discs_that_slide(self):
        """The second disc is pressed on the first by 1 mm/s and moved along it by 4 mm/s: it slides from the first step on."""
        friction, press, slide = 0.5, 1e-3, 4e-3
        first, second = (0, 0), (0, 1)
        particles = {"motions": [driven(first), driven(second, (slide, -press))]}
        text = scene(END, STEP, **particles)
        text["particles"]["contacts"]["friction"] = friction
        self.computed(text, discs=table([first, second]))
        t = self.time
        normal = -NORMAL * press * t
        shear = friction * normal  # of the first: along the left normal of its line to the second, against x
        size = NORMAL * press * END
        self.told_histories({"max_bond_force_N": -normal}, size=size, tolerance=1e-3)
        self.told_piece("contacts", {"displacement_m": [(0, 0, 0), (slide * END, -press * END, 0)], "normal_force_N": normal[-1],
                                     "shear_force_N": shear[-1]}, tolerance=1e-3, size=size)
        particles = self.run.fields()["particles"]
        np.testing.assert_array_equal(particles["coordination"], [1, 1])
        cell = np.pi * RADIUS**2  # each bears the force at its rim
        stress = np.array([0, normal[-1] * RADIUS, shear[-1] * -RADIUS / 2]) / cell
        np.testing.assert_allclose(particles["stress_Pa"], [stress, stress], atol=2e-3 * np.abs(stress).max())
        slip = slide * t
        stored = normal**2 / 2 / NORMAL + shear**2 / 2 / SHEAR
        lost = friction * NORMAL * press * (slide - friction * NORMAL * press / SHEAR) * t**2 / 2
        kinetic = MASS / 2 * (press**2 + slide**2)
        work = -normal * press * t / 2 - shear * slip / 2
        self.told_energies(size=work[-1], tolerance=1e-3, contacts=stored, friction=lost, motions=work + np.where(t > 0, kinetic, 0))

    def test_of_a_wall(self):
        """A wall moves up into a disc that is held, another wall is at rest below a disc that moves along it and down."""
        still, moving = (0, 0.5), (5, 0.5)
        rise, along, down = 0.1, 0.05, 0.1
        self.computed(scene(
            END, STEP, motions=[driven(still), driven(moving, (along, -down))],
            walls=[{"name": "lift", "from": point((-1, 0)), "to": point((1, 0)), "velocity": {"x": 0, "y": rise}},
                   {"name": "floor", "from": point((4, 0)), "to": point((7, 0)),
                    "contacts": {"normal_stiffness": 2 * NORMAL, "shear_stiffness": SHEAR, "friction": 0.3}}],
            histories=[{"name": wall, "wall": wall, "quantity": f"force_{axis}"} for wall in ("lift", "floor") for axis in "xy"]),
            discs=table([still, moving]))
        t = self.time
        lift, floor, drag = NORMAL * rise * t, 2 * NORMAL * down * t, SHEAR * along * t  # pressed, and sheared without sliding
        self.assertLess(drag[-1], 0.3 * floor[-1])
        self.told_histories({"lift_fx_N": 0 * t, "lift_fy_N": -lift, "floor_fx_N": drag, "floor_fy_N": -floor}, size=floor[-1], tolerance=1e-6)
        stored = lift**2 / 2 / NORMAL + floor**2 / 4 / NORMAL + drag**2 / 2 / SHEAR
        kinetic = MASS / 2 * (along**2 + down**2)
        self.told_energies(size=stored[-1], tolerance=1e-6, contacts=stored, walls=lift * rise * t / 2,
                           motions=(floor * down + drag * along) * t / 2 + np.where(t > 0, kinetic, 0))
        np.testing.assert_array_equal(self.run.fields()["particles"]["coordination"], [0, 0])
        cell, upper, lower = np.pi * RADIUS**2, RADIUS - rise * END, RADIUS - down * END
        expected = np.array([(0, -lift[-1] * upper, 0), (0, -floor[-1] * lower, drag[-1] * lower / 2)]) / cell
        np.testing.assert_allclose(self.run.fields()["particles"]["stress_Pa"], expected, atol=1e-6 * np.abs(expected).max())

    def test_of_dashpots(self):
        """What a disc that falls on a wall has lost when it flies up again is what its dashpot took."""
        text = scene(0.09, STEP, body_loads=[{"acceleration": {"x": 0, "y": -10}}],
                     walls=[{"name": "floor", "from": point((-1, 0)), "to": point((1, 0))}],
                     histories=[{"name": "p", "quantity": what, "at": point((0, 0.52))} for what in ("displacement_y", "velocity_y")])
        text["particles"]["contacts"]["normal_damping"] = 0.2
        self.computed(text, discs=table([(0, 0.52)]))
        moved, velocity = self.run.histories["p_uy_m"], self.run.histories["p_vy_m_per_s"]
        flies = (moved > -0.02) & (self.time > 0.07)
        self.assertTrue(flies[-1] and velocity[-1] > 0.1)
        mean = (velocity[1:] * velocity[:-1])  # of half a step before and after: what the scheme keeps
        kinetic = MASS / 2 * np.append(mean, velocity[-1] * (velocity[-1] - 10 * STEP))
        kinetic[0] = self.run.histories["particles_kinetic_J"][0]
        fell = -MASS * 10 * moved
        lost = self.run.table("energies.csv")["particles_contact_dashpots_J"]
        np.testing.assert_allclose(lost[flies], (fell - kinetic)[flies], rtol=1e-3)
        restitution = np.exp(-np.pi * 0.2 / np.sqrt(1 - 0.2**2))
        upwards = velocity[np.argmax(flies)] / np.sqrt(2 * 10 * 0.02)
        self.assertAlmostEqual(upwards, restitution, delta=0.02)

    def test_of_a_smooth_joint(self):
        """Two discs on either side of a fault that rises by 30 degrees: the upper one is pressed on it and moved along it."""
        normal_stiffness, shear_stiffness, friction, press, slide = 50e6, 20e6, 0.4, 2e-3, 3e-3
        along = np.array([np.cos(np.pi / 6), np.sin(np.pi / 6)])
        across = np.array([-along[1], along[0]])
        first, second = (0, 0), (0, 1)
        self.computed(scene(
            END, STEP, bonds={}, motions=[driven(first), driven(second, slide * along - press * across)],
            joints=[{"from": point(np.array([0, 0.5]) - 2 * along), "to": point(np.array([0, 0.5]) + 2 * along),
                     "smooth": {"normal_stiffness": normal_stiffness, "shear_stiffness": shear_stiffness, "friction": friction}}]),
            discs=table([first, second]))
        t, length = self.time, 2 * RADIUS
        normal = -normal_stiffness * length * press * t
        slip = slide * t  # of the second, against the left normal of the normal
        shear = -np.minimum(shear_stiffness * length * slip, -friction * normal)
        moved = (slide * along - press * across) * END
        self.told_piece("joints", {"displacement_m": [(0, 0, 0), (*moved, 0)], "normal_force_N": normal[-1], "shear_force_N": shear[-1],
                                   "slip_m": -slip[-1], "opening_m": -press * END, "peak_slip_m": slip[-1], "peak_opening_m": 0},
                        tolerance=1e-9, size=1e3)
        stored = normal**2 / 2 / normal_stiffness / length + shear**2 / 2 / shear_stiffness / length
        work = (-normal * press - shear * slide) * t / 2
        kinetic = MASS / 2 * (press**2 + slide**2)
        self.told_energies(size=work[-1], tolerance=1e-6, joints=stored, friction=work - stored, motions=work + np.where(t > 0, kinetic, 0))


if __name__ == "__main__":
    unittest.main()
