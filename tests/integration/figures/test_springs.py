"""What histories, fields, energies and the summary say of springs between particles follows from the motion of their ends."""

import unittest

import numpy as np

from figures.computed import ComputedTest
from figures.discs import RADIUS, driven, point, scene, table
from figures.told import Told

STEP, END = 1e-4, 0.02
BOLT, TORN, KEY, GASKET = range(4)
FIRST = np.array([(0, 0), (0, 5), (0, 10), (0, 15)], float)
SECOND = FIRST + [(2, 1), (2, 0), (1.2, 0), (1.2, 0)]
VELOCITY = np.array([(0.3, -0.4), (0.5, 0), (0.2, -0.6), (-0.4, 0)])  # of the second ends
STIFFNESS = np.array([20e6, 10e6, 5e6])
PRETENSION, CLEARANCE, STRENGTH = 50e3, 2e-3, 40.25e3
OPENINGS, FORCES = [-10e-3, -5e-3, 0], [-90e3, -20e3, -5e3]  # of the gasket
SPRINGS = [{"name": "bolt", "stiffness": STIFFNESS[BOLT], "pretension": PRETENSION},
           {"name": "torn", "stiffness": STIFFNESS[TORN], "strength": STRENGTH},
           {"name": "key", "stiffness": STIFFNESS[KEY], "clearance": CLEARANCE, "direction": point((0, 1)), "tension_only": False},
           {"name": "gasket", "curve": {"opening": OPENINGS, "force": FORCES}}]


class Springs(ComputedTest):
    def setUp(self):
        super().setUp()
        self.computed(scene(
            END, STEP, motions=[driven(p) for p in FIRST] + [driven(p, v) for p, v in zip(SECOND, VELOCITY)],
            springs=[{"from": point(a), "to": point(b), **spring} for a, b, spring in zip(FIRST, SECOND, SPRINGS)],
            histories=[{"name": spring["name"], "quantity": "spring_force", "spring": spring["name"]} for spring in SPRINGS]),
            discs=table([*FIRST, *SECOND]))
        moved = self.time[:, None, None] * VELOCITY  # of a time, a spring, a component
        apart = SECOND - FIRST
        self.opening = np.linalg.norm(apart + moved, axis=2) - np.linalg.norm(apart, axis=1)
        self.opening[:, KEY] = moved[:, KEY, 1]
        key = np.sign(self.opening[:, KEY]) * np.maximum(np.abs(self.opening[:, KEY]) - CLEARANCE, 0)
        self.force = np.column_stack([PRETENSION + STIFFNESS[BOLT] * self.opening[:, BOLT], STIFFNESS[TORN] * self.opening[:, TORN],
                                      STIFFNESS[KEY] * key, np.interp(self.opening[:, GASKET], OPENINGS, FORCES)])
        self.bears = self.force[:, TORN] <= STRENGTH
        self.breaks = np.argmin(self.bears)
        last = self.force[self.breaks - 1:self.breaks + 1, TORN]
        self.released = last.prod() / 2 / STIFFNESS[TORN]  # the last step's work is that of the mean force
        self.force[:, TORN] *= self.bears
        self.opening[self.breaks:, TORN] = self.opening[self.breaks, TORN]  # it is not followed any more

    def test_forces(self):
        self.told_histories({f"{spring['name']}_force_N": self.force[:, k] for k, spring in enumerate(SPRINGS)})
        moved = np.concatenate([0 * VELOCITY, VELOCITY * END])
        self.told_piece("springs", {"displacement_m": np.column_stack([moved, 0 * moved[:, 0]]), "force_N": self.force[-1],
                                    "opening_m": self.opening[-1], "broken": [0, 1, 0, 0]})

    def test_energies(self):
        free = -FORCES[-1] * (OPENINGS[-1] - OPENINGS[-2]) / (FORCES[-1] - FORCES[-2])  # opening at which the gasket would bear nothing
        pressed = -FORCES[-1] * free / 2
        gasket = [pressed + x * np.interp((np.arange(1000) + 0.5) / 1000 * x, OPENINGS, FORCES).mean() for x in self.opening[:, GASKET]]
        stored = np.sum(self.force[:, :3]**2 / 2 / STIFFNESS, axis=1) + gasket
        # Motions do the work of the mean force of each step against the springs, and set the discs in motion.
        way = np.diff(self.opening, axis=0)
        work = np.concatenate([[0], np.cumsum(np.sum((self.force[1:] + self.force[:-1]) / 2 * way, axis=1))])
        kinetic = 2000 * np.pi * RADIUS**2 / 2 * np.sum(VELOCITY**2)
        self.told_energies(size=kinetic, tolerance=1e-4, springs=stored, motions=work + np.where(self.time > 0, kinetic, 0))
        released = np.where(self.bears, 0, self.released)
        np.testing.assert_allclose(self.run.histories["particles_released_J"], released, rtol=1e-9, atol=1e-9)

    def test_the_summary(self):
        middle = (FIRST[TORN] + SECOND[TORN]) / 2
        told = Told(self, "summary.json", {key: value for key, value in self.run.summary.items() if "spring" in key})
        told.equal({"springs_broken": 1, "first_broken_spring_time_s": self.time[self.breaks], "first_broken_spring_x_m": middle[0],
                    "first_broken_spring_y_m": middle[1]})
        told.all_told()


if __name__ == "__main__":
    unittest.main()
