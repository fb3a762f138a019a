"""Forces of linings, bolts and sections of zones are those of mechanics: sign, place, time and owner."""

import unittest

import numpy as np

from figures.computed import ComputedTest, told_report
from figures.discs import near, point
from figures.told import Told

YOUNG, POISSON, DENSITY = 1e9, 0.25, 2000.0
STEP, END = 1e-4, 0.02
GROUND = {"material": {"young_modulus": YOUNG, "poisson_ratio": POISSON, "density": DENSITY}}
LINING = {"young_modulus": 30e9, "poisson_ratio": 0.2, "thickness": 0.3}
AXIAL = 30e9 / (1 - 0.2**2) * 0.3  # N a metre
CORNERS = np.array([(0, 0), (4, 0), (5, 2), (1, 2)])  # of a parallelogram of two by two zones
STRAIN = np.array([(0.01, 0.03), (0, -0.004)])  # gradient of the displacement in a second; what lies along x does not turn
FORCES = "thrust", "moment", "shear"
UNITS = {"thrust": "N", "moment": "Nm", "shear": "N"}


def histories(names, **where):
    return [{"name": name, "quantity": {"shear": "shear_force"}.get(what, what), **place} for name, place in names.items() for what in FORCES]


class Structures(ComputedTest):
    def test_of_ground_that_is_strained(self):
        edge, up = CORNERS[1] - CORNERS[0], CORNERS[3] - CORNERS[0]
        points = [edge * i / 2 + up * j / 2 for i in range(3) for j in range(3)]
        cuts = {"along": (up / 2, up / 2 + edge), "back": (up / 2 + edge, up / 2), "across": (edge / 2, edge / 2 + up)}
        bolts = [{"from": point(up), "to": point((0, 0)), "area": 1e-3, "spacing": 2.0},
                 {"from": point(edge), "to": point(edge + up), "area": 1e-3, "spacing": 0.5, "yield_force": 6e3}]
        self.computed(GROUND | {
            "time": {"duration": END, "dt": STEP},
            "continuum": {
                "blocks": [{"quadrilateral": {"corners": [point(c) for c in CORNERS]}, "along": {"zones": 2}, "across": {"zones": 2}}],
                "motions": [{"where": near(p), "velocity": point(STRAIN @ p)} for p in points],
                "linings": [{"name": "floor", "along": {"line": {"points": [point((0, 0)), point(edge)]}}, **LINING}],
                "bolts": bolts,
                "sections": [{"name": name, "from": point(a), "to": point(b)} for name, (a, b) in cuts.items()],
                "histories": histories({name: {"section": name} for name in cuts} | {"floor": {"lining": "floor", "at": point(edge / 2)}}),
            },
            "output": {"history_interval": 1e-3}})
        t, symmetric = self.time, (STRAIN + STRAIN.T) / 2
        shear_modulus = YOUNG / 2 / (1 + POISSON)
        stress = 2 * shear_modulus * symmetric + shear_modulus * np.trace(symmetric) * np.eye(2)  # in a second; lambda = G
        expected = {"floor_thrust_N": AXIAL * STRAIN[0, 0] * t, "floor_moment_Nm": 0 * t, "floor_shear_N": 0 * t}
        for name, (a, b) in cuts.items():
            length = np.linalg.norm(b - a)
            along = (b - a) / length
            outwards = np.array([along[1], -along[0]])  # of what lies on the left
            pull = stress @ outwards * length
            expected |= {f"{name}_thrust_N": pull @ outwards * t, f"{name}_shear_N": pull @ along * t, f"{name}_moment_Nm": 0 * t}
        self.told_histories(expected, size=1e5)
        self.told_piece("linings", {
            "displacement_m": [(*(STRAIN @ p * END), 0) for p in (0 * edge, edge / 2, edge)], "thrust_N": AXIAL * STRAIN[0, 0] * END,
            "moment_Nm": 0, "shear_N": 0, "peak_largest_thrust_N": AXIAL * STRAIN[0, 0] * END, "peak_least_thrust_N": 0,
            "peak_largest_moment_Nm": 0, "peak_least_moment_Nm": 0, "peak_largest_shear_N": 0, "peak_least_shear_N": 0,
            "thrust_at_peak_largest_moment_N": 0, "thrust_at_peak_least_moment_N": 0, "lining": 0}, size=1e5)
        stretch = up @ symmetric @ up / (up @ up)  # of either bolt, in a second
        thrust = 210e9 * 1e-3 * stretch * END  # of one bolt, whatever their spacing
        self.assertGreater(thrust, 6e3)
        bars = self.told_piece("bolts", {
            "displacement_m": [(*(STRAIN @ p * END), 0) for p in (up, up / 2, 0 * up, edge, edge + up / 2, edge + up)],
            "thrust_N": [thrust, thrust, 6e3, 6e3]}, size=1e4)
        np.testing.assert_allclose(bars.points, [up, up / 2, 0 * up, edge, edge + up / 2, edge + up], atol=1e-12)

    def test_of_a_beam_on_two_supports(self):
        """In the middle a load pushes it down, at its end another one pulls. The ground on it is too soft to help."""
        load, pull, length, zones = 10e3, 4e3, 8.0, 8
        places = {f"n{i}": {"lining": "beam", "at": point((i, 0))} for i in range(zones + 1)}
        self.computed({
            "material": {"young_modulus": 1e5, "poisson_ratio": POISSON, "density": DENSITY},
            "time": {"duration": 1e-3},
            "statics": {"unbalanced_ratio": 1e-4},
            "continuum": {
                "block": {"x_min": 0, "x_max": length, "y_min": 0, "y_max": 0.2, "zones_x": zones, "zones_y": 1},
                "motions": [{"where": near((0, 0)), "velocity": {"x": 0, "y": 0}}, {"where": near((length, 0)), "velocity": {"y": 0}}],
                "point_loads": [{"where": near((length / 2, 0)), "force": {"y": -load}}, {"where": near((length, 0)), "force": {"x": pull}}],
                "linings": [{"name": "beam", "along": {"line": {"points": [point((0, 0)), point((length, 0))]}}, **LINING}],
                "histories": histories(places),
            }})
        x = np.arange(zones + 1.0)
        moment = load / 2 * np.minimum(x, length - x)  # which stretches the side on the right of the path, below
        shear = load / 2 * np.sign(x - length / 2)  # on what lies before, to the left of the path
        expected = {}
        for i, name in enumerate(places):
            for what, force in zip(FORCES, (pull, moment[i], shear[i])):
                expected[f"{name}_{what}_{UNITS[what]}"] = force + 0 * self.time
        self.told_histories(expected, size=load, tolerance=1e-4)

    def test_of_a_cantilever_that_is_cut(self):
        """What holds left of the cut is what loads right of it pull."""
        across, along, height = -3e3, 5e3, 2.0
        cuts = {"cut": {"from": point((1, 0)), "to": point((1, height))}, "back": {"from": point((1, height)), "to": point((1, 0))}}
        self.computed(GROUND | {
            "time": {"duration": 1e-3},
            "statics": {"unbalanced_ratio": 1e-10},
            "continuum": {
                "block": {"x_min": 0, "x_max": 4, "y_min": 0, "y_max": height, "zones_x": 4, "zones_y": 2},
                "motions": [{"where": {"x_max": 0}, "velocity": {"x": 0, "y": 0}}],
                "point_loads": [{"where": near((4, height)), "force": {"x": along, "y": across}}],
                "sections": [{"name": name, **ends} for name, ends in cuts.items()],
                "histories": histories({name: {"section": name} for name in cuts}),
            }})
        turning = -across * 3 + along * height / 2  # stretches the upper end
        self.told_histories({name: value + 0 * self.time for name, value in {
            "cut_thrust_N": along, "cut_shear_N": across, "cut_moment_Nm": turning,
            "back_thrust_N": along, "back_shear_N": across, "back_moment_Nm": -turning}.items()}, size=along, tolerance=1e-7)

    def test_of_the_peaks_of_a_lining(self):
        """They are those of the histories of all its nodes, with the time and place; thrusts follow from displacements."""
        zones, names = 4, [f"n{i}" for i in range(5)]
        walls = {"roof": 1.0, "floor": 0.0}
        places = {f"{wall}_{name}": {"lining": wall, "at": point((i, y))} for wall, y in walls.items() for i, name in enumerate(names)}
        self.computed(GROUND | {
            "time": {"duration": 0.05},
            "continuum": {
                "block": {"x_min": 0, "x_max": zones, "y_min": 0, "y_max": 1, "zones_x": zones, "zones_y": 1},
                "motions": [{"where": {"x_max": 0}, "velocity": {"x": 0, "y": 0}}],
                "body_loads": [{"acceleration": {"x": 5, "y": -10}, "time": {"sine": {"frequency": 30}}}],
                "linings": [{"name": wall, "along": {"line": {"points": [point((0, y)), point((zones, y))]}}, **LINING} for wall, y in walls.items()],
                "histories": histories(places),
            },
            "output": {"history_interval": 1e-9}})
        rows = {what: np.array([self.run.histories[f"{place}_{what}_{UNITS[what]}"] for place in places]) for what in FORCES}  # of a node each
        self.assertGreater(np.abs(rows["moment"]).max(), 10)
        lining = self.run.fields()["linings"]
        told = Told(self, "linings", lining.point_fields, {"displacement_m"})
        nodes = np.arange(len(places))
        for what, unit in UNITS.items():
            told.equal({f"{what}_{unit}": rows[what][:, -1], f"peak_largest_{what}_{unit}": rows[what].max(axis=1),
                        f"peak_least_{what}_{unit}": rows[what].min(axis=1)})
        told.equal({"thrust_at_peak_largest_moment_N": rows["thrust"][nodes, rows["moment"].argmax(axis=1)],
                    "thrust_at_peak_least_moment_N": rows["thrust"][nodes, rows["moment"].argmin(axis=1)]})
        told.all_told()
        np.testing.assert_array_equal(lining["lining"], np.repeat([0, 1], zones))
        for wall in range(2):
            moved = lining["displacement_m"][wall * len(names):][:len(names), 0]
            beams = AXIAL * np.diff(moved)
            thrust = np.concatenate([beams[:1], (beams[1:] + beams[:-1]) / 2, beams[-1:]])
            np.testing.assert_allclose(lining["thrust_N"][wall * len(names):][:len(names)], thrust, atol=1e-9 * np.abs(thrust).max())
        self.extremes(walls, rows, lining.points, len(names))

    def extremes(self, walls, rows, points, nodes):
        keys = {key for key in self.run.summary if key.startswith("lining_")}
        told = Told(self, "summary.json", {key: self.run.summary[key] for key in keys})
        for number, wall in enumerate(walls):
            mine = slice(number * nodes, (number + 1) * nodes)
            own = {what: values[mine] for what, values in rows.items()}
            size = np.abs(own["moment"])
            for which, of, other, at in (("largest_thrust", "thrust", "moment", own["thrust"].argmax()),
                                         ("least_thrust", "thrust", "moment", own["thrust"].argmin()),
                                         ("largest_moment", "moment", "thrust", size.argmax())):
                node, row = np.unravel_index(at, size.shape)
                x, y = points[mine][node]
                told.equal({f"lining_{wall}_{which}_{UNITS[of]}": own[of][node, row], f"lining_{wall}_{which}_time_s": self.time[row],
                            f"lining_{wall}_{which}_x_m": x, f"lining_{wall}_{which}_y_m": y,
                            f"lining_{wall}_{other}_at_{which}_{UNITS[other]}": own[other][node, row]})
        told.all_told()
        _, shown = told_report(self, self.run)
        self.assertEqual({key for key in shown if key.startswith("lining_")}, {
            f"lining_{wall}_{what}" for wall in walls for what in (
                "least_thrust_N", "moment_at_least_thrust_Nm", "largest_thrust_N", "moment_at_largest_thrust_Nm", "largest_moment_Nm",
                "thrust_at_largest_moment_N", "largest_moment_time_s", "largest_moment_x_m", "largest_moment_y_m")})


if __name__ == "__main__":
    unittest.main()
