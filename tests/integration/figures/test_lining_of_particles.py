"""Sections, joints and rings of particles tell what the forces and motions of their particles say, where and when."""

import unittest

import numpy as np

from figures.computed import ComputedTest, told_report
from figures.discs import RADIUS, driven, point, scene, table
from figures.told import Told

STEP, END = 1e-4, 0.01
UNITS = {"thrust": "N", "moment": "Nm", "shear": "N"}


class Lining(ComputedTest):
    def test_of_a_section(self):
        """It cuts a parallel bond that is stretched, sheared and bent while all of it turns by a right angle in 100 s."""
        stiffness, shear_stiffness = 100e6, 40e6
        stretch, shift, spin = 1e-3, -2e-3, 5e-3
        first, second = (3, 1), (4, 1)
        histories = [{"name": "cut", "section": "cut", "quantity": {"shear": "shear_force"}.get(what, what)} for what in UNITS]
        self.computed(scene(
            END, STEP, bonds={"parallel": {"normal_stiffness": stiffness, "shear_stiffness": shear_stiffness}},
            motions=[driven(first), driven(second, (stretch, shift), spin)],
            sections=[{"name": "cut", "from": point((3.5, 0)), "to": point((3.5, 2))}], histories=histories), discs=table([first, second]))
        t, width = self.time, 2 * RADIUS
        normal = stiffness * width * stretch * t
        shear = shear_stiffness * width * (shift - RADIUS * spin) * t  # where the two meet, halfway
        bent = stiffness / 12 * width**3 * spin * t  # it stretches the lower side, which is the inner one
        forces = {"thrust": normal, "moment": -bent, "shear": shear}
        self.told_histories({f"cut_{what}_{UNITS[what]}": values for what, values in forces.items()} | {"max_bond_force_N": normal},
                            size=normal[-1], tolerance=1e-4)
        moved = np.array([(0, 0, 0), (stretch * END, shift * END, 0)])
        self.told_piece("bonds", {"displacement_m": moved, "normal_force_N": normal[-1], "shear_force_N": shear[-1], "moment_Nm": bent[-1],
                                  "state": 0, "weight": 1}, size=normal[-1], tolerance=1e-4)
        particles = self.run.fields()["particles"]
        np.testing.assert_array_equal(particles["spin_rad_per_s"], [0, spin])
        np.testing.assert_array_equal(particles["velocity_m_per_s"], [(0, 0, 0), (stretch, shift, 0)])
        extremes = {"largest_thrust_N": normal[-1], "smallest_thrust_N": 0, "largest_moment_Nm": 0, "smallest_moment_Nm": -bent[-1],
                    "largest_shear_N": 0, "smallest_shear_N": shear[-1]}
        at_end = {f"{what}_{UNITS[what]}": values[-1] for what, values in forces.items()}
        piece = self.told_piece("sections", extremes | at_end | {"displacement_m": moved.mean(axis=0)}, size=normal[-1], tolerance=1e-4)
        np.testing.assert_allclose(piece.points, [(3.5, 1)], atol=1e-12)
        told = Told(self, "summary.json", {key: value for key, value in self.run.summary.items() if key.startswith("sections_")})
        told.equal({f"sections_{name}": value for name, value in extremes.items()}, size=normal[-1], tolerance=1e-4)
        for name, value in extremes.items():
            which = name.rpartition("_")[0]
            told.equal({f"sections_{which}_time_s": END if value else 0, f"sections_{which}_x_m": 3.5, f"sections_{which}_y_m": 1})
        told.all_told()
        _, shown = told_report(self, self.run)
        self.assertLessEqual({f"sections_{which}_{what}" for which in ("largest", "smallest") for what in ("thrust_N", "moment_Nm")}, shown.keys())
        stored = (normal**2 / stiffness + shear**2 / shear_stiffness) / width / 2 + bent**2 / 2 / (stiffness / 12 * width**3)
        mass = 2000 * np.pi * RADIUS**2
        kinetic = mass / 2 * (stretch**2 + shift**2 + RADIUS**2 / 2 * spin**2)
        self.told_energies(size=stored[-1], tolerance=1e-4, parallel_bonds=stored, motions=stored + np.where(t > 0, kinetic, 0))

    def test_of_what_statics_have_moved(self):
        """Displacements count from time 0: a section that statics have moved has moved by nothing then."""
        first, second = (3, 1), (4, 1)
        text = scene(END, STEP, bonds={"parallel": {"normal_stiffness": 1e8, "shear_stiffness": 1e8}}, motions=[driven(first)],
                     body_loads=[{"acceleration": {"x": 1000, "y": 0}}],
                     sections=[{"name": "cut", "from": point((3.5, 0)), "to": point((3.5, 2))}],
                     histories=[{"name": "cut", "section": "cut", "quantity": "thrust"}])
        self.computed(text | {"statics": {"unbalanced_ratio": 1e-9}}, discs=table([first, second]))
        weight = 1000 * 2000 * np.pi * RADIUS**2
        self.told_histories({"cut_thrust_N": weight + 0 * self.time}, tolerance=1e-6)
        sunk = weight / 1e8
        for piece in ("particles", "bonds", "sections"):
            moved = self.run.fields()[piece]["displacement_m"]
            self.assertLess(np.abs(moved).max(), 1e-4 * sunk, piece)

    def test_of_a_joint(self):
        """Its far face moves away, along it and turns, as a rigid body about a place of its own."""
        opening, offset, turning = 1e-3, -2e-3, 0.5e-3  # in a second
        near_face, far_face = [(0, 0), (1, 0)], [(0, 1), (1, 1)]
        middle = np.array([0.5, 0.5])  # the line runs from right to left, so that what lies below is on its left
        speed = np.array([-offset, -opening])
        motions = [driven(p, (0.3, 0.2)) for p in far_face]  # the face that lies on the right
        for p in near_face:
            arm = np.array(p) - middle
            motions.append(driven(p, np.array([0.3, 0.2]) + speed + turning * np.array([-arm[1], arm[0]]), turning))
        self.computed(scene(
            END, STEP, bonds={"parallel": {"normal_stiffness": 1e8, "shear_stiffness": 1e8}}, motions=motions,
            joints=[{"name": "j", "from": point((2, 0.5)), "to": point((-1, 0.5)), "open": True}],
            histories=[{"name": "j", "joint": "j", "quantity": what} for what in ("opening", "offset", "rotation")]),
            discs=table([*near_face, *far_face]))
        t = self.time
        self.told_histories({"j_opening_m": opening * t, "j_offset_m": offset * t, "j_rotation_rad": turning * t}, tolerance=1e-6)

    def test_of_a_ring(self):
        """It is moved, turned and made an oval whose longest diameter lies at 30 degrees from x."""
        centre, count, radius = np.array([4.0, -2.0]), 8, 2.0
        angles = 2 * np.pi * (np.arange(count) + 0.5) / count
        mean, oval, longest, drift, turn = -2e-3, 3e-3, np.pi / 6, (0.2, -0.1), 0.05
        radial = mean + oval * np.cos(2 * (angles - longest))
        outwards = np.column_stack([np.cos(angles), np.sin(angles)])
        around = np.column_stack([-outwards[:, 1], outwards[:, 0]])
        velocities = radial[:, None] * outwards + radius * turn * around + drift
        places = centre + radius * outwards
        self.computed(scene(
            END, STEP, motions=[driven(p, v) for p, v in zip(places, velocities)],
            ovals=[{"name": "ring", "annulus": {"centre": point(centre), "inner_radius": 1.8, "outer_radius": 2.2}}],
            histories=[{"name": "ring", "oval": "ring", "quantity": what} for what in (
                "largest_diameter_change", "smallest_diameter_change", "largest_diameter_direction")]), discs=table(places, radius=0.4))
        t = self.time
        moves = t > 0
        most, least = 2 * (mean + oval) * t, 2 * (mean - oval) * t
        # The drift is the middle one of all motions, and the turning moves no particle along the radius.
        direction = self.run.histories["ring_largest_diameter_direction_rad"]
        self.told_histories({"ring_largest_diameter_change_m": most, "ring_smallest_diameter_change_m": least,
                             "ring_largest_diameter_direction_rad": np.where(moves, longest, direction)}, tolerance=1e-6)
        told = Told(self, "summary.json", {key: value for key, value in self.run.summary.items() if key.startswith("ovals_")})
        for which, value, direction in (("largest", most[-1], longest), ("smallest", least[-1], longest - np.pi / 2)):
            told.equal({f"ovals_{which}_diameter_change_m": value, f"ovals_{which}_diameter_change_time_s": END,
                        f"ovals_{which}_diameter_change_x_m": centre[0], f"ovals_{which}_diameter_change_y_m": centre[1],
                        f"ovals_{which}_diameter_change_direction_rad": direction}, tolerance=1e-6)
        told.all_told()


if __name__ == "__main__":
    unittest.main()
