"""Energies by cause of discs that move by themselves: work of loads, losses of damping, what foundations store and take."""

import unittest

import numpy as np

from figures.computed import ComputedTest
from figures.discs import DENSITY, POISSON, RADIUS, YOUNG, near, point, scene, table

MASS, AREA = DENSITY * np.pi * RADIUS**2, np.pi * RADIUS**2
STEP, END = 1e-4, 0.1
FORCE = 5e3


def histories(places):
    return [{"name": name, "quantity": f"{what}_x", "at": point(place)} for name, place in places.items() for what in ("displacement", "velocity")]


class FreeDiscs(ComputedTest):
    def kinetic(self, names):
        """By the velocities half a step before and after each row but the last."""
        return sum(MASS / 2 * v[:-1] * v[1:] for v in (self.run.histories[f"{name}_vx_m_per_s"] for name in names))

    def told_motion(self, name, moved, tolerance=1e-3):
        np.testing.assert_allclose(self.run.histories[f"{name}_ux_m"], moved, atol=tolerance * np.abs(moved).max(), err_msg=name)

    def test_drag(self):
        """A load pushes two discs; viscous damping brakes both, and a quiet edge the second."""
        places, rate = {"free": (0, 0), "edge": (5, 0)}, 30.0
        self.computed(scene(
            END, STEP, damping={"viscous": rate}, quiet=[{"where": near(places["edge"]), "side": "right"}],
            loads=[{"where": near(place), "force": {"x": FORCE}} for place in places.values()], histories=histories(places)),
            discs=table(places.values()))
        t = self.time
        modulus = YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))
        edge = 2 * RADIUS * np.sqrt(DENSITY * modulus) / MASS  # density times the speed of P waves, over the disc's width
        work, viscous, edges = 0 * t, 0 * t, 0 * t
        for name, drag in (("free", 0), ("edge", edge)):
            sum_of_rates = rate + drag
            decay = np.exp(-sum_of_rates * t)
            fastest = FORCE / MASS / sum_of_rates
            moved = fastest * (t - (1 - decay) / sum_of_rates)
            square = fastest**2 * (t - 2 * (1 - decay) / sum_of_rates + (1 - decay**2) / 2 / sum_of_rates)  # of the velocity, over time
            self.told_motion(name, moved)
            work, viscous, edges = work + FORCE * moved, viscous + MASS * rate * square, edges + MASS * drag * square
        self.told_energies(size=work[-1], tolerance=1e-3, loads=work, viscous_damping=viscous, quiet_edges=edges)
        np.testing.assert_allclose(self.run.histories["particles_kinetic_J"][1:-1], self.kinetic(places)[1:], rtol=1e-9)

    def test_local_damping(self):
        """It takes a share of what pulls, be it a load or a weight."""
        places, share, weight = {"pushed": (0, 0), "heavy": (5, 0)}, 0.3, 4.0
        self.computed(scene(
            END, STEP, damping={"local": share}, loads=[{"where": near(places["pushed"]), "force": {"x": FORCE}}],
            body_loads=[{"where": near(places["heavy"]), "acceleration": {"x": weight}}], histories=histories(places)), discs=table(places.values()))
        t = self.time
        work = {}
        for name, force in (("pushed", FORCE), ("heavy", MASS * weight)):
            moved = (1 - share) * force / MASS * t**2 / 2
            self.told_motion(name, moved)
            work[name] = force * moved
        total = sum(work.values())
        self.told_energies(size=total[-1], tolerance=2e-3, loads=work["pushed"], body_loads=work["heavy"], local_damping=share * total)

    def test_a_foundation(self):
        """Ground that moves steadily pulls a disc along by a spring and a dashpot, against a load; another disc slips in ground at rest."""
        places = {"held": (0, 0), "slips": (5, 0)}
        stiffness, dashpot, speed, slip = 2e6, 5e4, 0.05, 4e3
        foundations = [{"where": near(places["held"]), "x": {"stiffness": stiffness, "dashpot": dashpot}, "ground": {"path": "ground.csv"}},
                       {"where": near(places["slips"]), "x": {"stiffness": stiffness, "slip_stress": slip, "hardening": 0.25}}]
        motions = [{"where": near(places["slips"]), "velocity": {"x": speed, "y": 0}, "spin": 0}]
        self.computed(scene(
            END, STEP, foundations=foundations, motions=motions, loads=[{"where": near(places["held"]), "force": {"x": -FORCE}}],
            histories=histories(places)), discs=table(places.values()),
            ground="time_s,x_m,vx_m_per_s,vy_m_per_s\n" + "".join(f"{at},0,{speed},0\n" for at in (0, 1)))
        t = self.time
        # The elongation w of the spring: m w'' + A c w' + A k w = F, from rest while the ground moves.
        K, C = AREA * stiffness, AREA * dashpot
        delta = C / 2 / MASS
        omega = np.sqrt(K / MASS - delta**2)
        end = FORCE / K
        w = end + np.exp(-delta * t) * (-end * np.cos(omega * t) + (speed - delta * end) / omega * np.sin(omega * t))
        moved = speed * t - w
        self.told_motion("held", moved)
        rate = np.gradient(w, t, edge_order=2)
        pull = K * w + C * rate
        over_time = lambda power: np.concatenate([[0], np.cumsum((power[1:] + power[:-1]) / 2 * np.diff(t))])  # noqa: E731
        # The other: a spring of a quarter of the stiffness beside one that slips at three quarters of the stress.
        way = speed * t
        elastic = 0.25 * AREA * stiffness * way
        slider = np.minimum(0.75 * AREA * stiffness * way, 0.75 * AREA * slip)
        stored = K * w**2 / 2 + elastic * way / 2 + slider**2 / 2 / (0.75 * AREA * stiffness)
        lost = over_time(C * rate**2) + over_time(slider * speed) - slider**2 / 2 / (0.75 * AREA * stiffness)
        ground = over_time(pull * speed)
        kinetic = MASS / 2 * speed**2
        self.told_energies(size=ground[-1], tolerance=3e-3, foundations=stored, foundation_losses=lost, ground=ground, loads=-FORCE * moved,
                           motions=over_time((elastic + slider) * speed) + np.where(t > 0, kinetic, 0))


if __name__ == "__main__":
    unittest.main()
