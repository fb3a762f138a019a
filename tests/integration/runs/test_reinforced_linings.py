"""A column of reinforced concrete, pushed until it fails, follows a hand calculation by strain compatibility."""

import unittest

import numpy as np

from programs import ProgramTest

from adit import Run

HEIGHT, BEAM, THICKNESS, COVER, DIAMETER, SPACING = 3.0, 0.25, 0.5, 0.04, 0.02, 0.1
LOAD = 2e6  # of compression, per metre
# Ground that carries nothing holds the grid points of the column, a beam to a zone.
SCENE = f"""\
plane: plane_stress
material: {{young_modulus: 1 kPa, poisson_ratio: 0, density: 10 kg/m^3}}
time: {{duration: 1.2 s, dt: 0.1 ms}}
continuum:
  block: {{x_min: -0.5 m, x_max: 0.5 m, y_min: 0 m, y_max: {HEIGHT} m, zones_x: 2, zones_y: {round(HEIGHT / BEAM)}}}
  linings:
    - name: column
      along: {{line: {{points: [{{x: 0, y: 0}}, {{x: 0, y: {HEIGHT} m}}]}}}}
      first_end_fixed: true
      section:
        thickness: {THICKNESS} m
        cover: {COVER} m
        concrete: {{class: C30/37, tension_stiffening: false}}
        steel: {{class: B500B}}
        inner: {{diameter: {DIAMETER} m, spacing: {SPACING} m}}
        outer: {{diameter: {DIAMETER} m, spacing: {SPACING} m}}
  motions:
    - {{where: {{y_max: 0 m}}, velocity: {{x: 0, y: 0}}}}
    - where: {{x_min: -0.01 m, x_max: 0.01 m, y_min: {HEIGHT} m}}
      velocity: {{x: 0.1 m/s}}
      time: {{table: {{time: [0, 0.2 s, 0.3 s, 2 s], value: [0, 0, 1, 1]}}}}
  point_loads:
    - where: {{x_min: -0.01 m, x_max: 0.01 m, y_min: {HEIGHT} m}}
      force: {{y: {-LOAD} N}}
      time: {{table: {{time: [0, 0.2 s, 2 s], value: [0, 1, 1]}}}}
  histories:
    - {{name: base, quantity: moment, at: {{x: 0, y: 0}}, lining: column}}
    - {{name: base, quantity: thrust, at: {{x: 0, y: 0}}, lining: column}}
    - {{name: base, quantity: shear_force, at: {{x: 0, y: 0}}, lining: column}}
    - {{name: base, quantity: utilisation, at: {{x: 0, y: 0}}, lining: column}}
    - {{name: base, quantity: curvature, at: {{x: 0, y: 0}}, lining: column}}
    - {{name: tip, quantity: displacement_x, at: {{x: 0, y: {HEIGHT} m}}}}
output: {{history_interval: 1 ms}}
"""


class Section:
    """Mean values of C30/37 and B500B: EN 1992-1-1, eq. 3.14 without tension, bars with their hardening."""
    strength, peak, modulus = 38e6, 0.7e-3 * 38**0.31, 1.05 * 22e9 * 3.8**0.3
    steel, yield_stress = 200e9, 550e6
    hardening = 0.08 * 550e6 / (0.05 - 550e6 / 200e9) / 200e9

    def __init__(self):
        edges = np.linspace(-THICKNESS / 2, THICKNESS / 2, 4001)
        self.depths = (edges[1:] + edges[:-1]) / 2
        self.bars = np.array([-1, 1]) * (THICKNESS / 2 - COVER - DIAMETER / 2)
        self.area = np.pi / 4 * DIAMETER**2 / SPACING

    def concrete(self, strain):
        eta, k = -strain / self.peak, self.modulus * self.peak / self.strength
        stress = -self.strength * (k * eta - eta**2) / (1 + (k - 2) * eta)
        return np.where((eta > 0) & (eta < k), stress, 0)

    def bar(self, strain):
        limit = self.yield_stress / self.steel
        beyond = self.yield_stress + self.hardening * self.steel * (abs(strain) - limit)
        return np.where(abs(strain) < limit, self.steel * strain, np.sign(strain) * beyond)

    def forces(self, strain, curvature):
        concrete = self.concrete(strain + curvature * self.depths) * THICKNESS / len(self.depths)
        local = strain + curvature * self.bars
        bars = self.area * (self.bar(local) - self.concrete(local))
        return concrete.sum() + bars.sum(), (concrete * self.depths).sum() + (bars * self.bars).sum()

    def moment(self, curvature):
        """Under the column's load, on the branch that begins without curvature."""
        low, high = -2e-3 - 0.1 * curvature * THICKNESS, curvature * THICKNESS / 2
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if self.forces(middle, curvature)[0] < -LOAD else (low, middle)
        return self.forces(low, curvature)[1]


class Column(ProgramTest):
    def test_column_follows_the_hand_calculation_until_it_fails(self):
        run = Run(self.run_scene(self.scene(SCENE)))
        rows = run.histories
        # The column leans to its right, which compresses that side.
        moment, tip = -rows["base_moment_Nm"], rows["tip_ux_m"]
        section = Section()
        curvatures = np.linspace(0, 0.06, 241)
        moments = np.array([section.moment(curvature) for curvature in curvatures])
        top = moments.argmax()
        # The section nearest to the base is Gauss's point of its beam.
        near, far = BEAM / 2 * (1 - 1 / np.sqrt(3)), BEAM / 2 * (1 + 1 / np.sqrt(3))
        measured = moment.max() * (1 - near / HEIGHT)
        self.assertAlmostEqual(measured / moments[top], 1, delta=0.02)
        # Drift on the way there: curvatures of all sections by the same diagram, and shear.
        places = np.concatenate([BEAM * k + np.array([near, far]) for k in range(round(HEIGHT / BEAM))])
        shear_stiffness = 5 / 6 * THICKNESS * 22e9 * 3.8**0.3 / 2.4
        peak_row = moment.argmax()
        for share in (0.4, 0.7, 0.9):
            force = share * measured / (HEIGHT - near)
            bent = np.interp(force * (HEIGHT - places), moments[:top + 1], curvatures[:top + 1])
            drift = (BEAM / 2 * bent * (HEIGHT - places)).sum() + force * HEIGHT / shear_stiffness
            found = np.interp(force * HEIGHT, moment[:peak_row + 1], tip[:peak_row + 1])
            self.assertAlmostEqual(found / drift, 1, delta=0.04, msg=str(share))
        # It fails: its concrete crushes.
        self.assertLess(moment[-1], 0.8 * moment.max())
        summary = run.summary
        self.assertLess(summary["max_energy_drift"], 1e-9)
        self.assertGreater(summary["dissipated_energy_J"] if "dissipated_energy_J" in summary else 1, 0)
        self.assertAlmostEqual(summary["lining_column_largest_utilisation"], rows["base_utilisation"].max(), delta=0.02)
        self.assertEqual((summary["lining_column_largest_utilisation_x_m"], summary["lining_column_largest_utilisation_y_m"]), (0, 0))
        with self.subTest("plastic hinge"):
            self.tells_its_hinge(run)
        with self.subTest("capacities"):
            self.lies_within_its_capacity(run)

    def tells_its_hinge(self, run):
        """What the tip moves beyond yield is the rotation of the hinge at the base times the height above its middle."""
        rows, rotation = run.histories, run.summary["lining_column_largest_hinge_rotation_rad"]
        self.assertLess(rotation, 0)  # the inner side is stretched
        # At the end the column is unloaded to a fraction of its peak, at which it bends elastically by as much as on its way there.
        moment, top = -rows["base_moment_Nm"], rows["base_moment_Nm"].argmin()
        elastic = np.interp(moment[-1], moment[:top], rows["tip_ux_m"][:top])
        self.assertLess(abs(-rotation * (HEIGHT - BEAM / 4) / (rows["tip_ux_m"][-1] - elastic) - 1), 0.1)

    def lies_within_its_capacity(self, run):
        """Utilisation is the distance from the origin over that of the polygon of capacities.csv."""
        thrust, moment = run.capacities["lining", "column"].T
        rows = run.histories
        some = np.abs(rows["base_moment_Nm"]) > 1e4
        n, m, used = rows["base_thrust_N"][some], rows["base_moment_Nm"][some], rows["base_utilisation"][some]
        scale = np.array([np.ptp(thrust), np.ptp(moment)])
        corners = np.column_stack((thrust, moment)) / scale
        sides = np.roll(corners, -1, axis=0) - corners
        for point, utilisation in list(zip(np.column_stack((n, m)) / scale, used))[::20]:
            # corner + t side = point / u
            with np.errstate(divide="ignore", invalid="ignore"):  # of sides in its direction
                t = (point[0] * corners[:, 1] - point[1] * corners[:, 0]) / (point[1] * sides[:, 0] - point[0] * sides[:, 1])
            t = np.where(np.isfinite(t), t, -1)
            meets = corners + t[:, None] * sides
            ahead = (t >= 0) & (t <= 1) & ((meets * point).sum(axis=1) > 0)
            reach = np.linalg.norm(meets[ahead], axis=1).min()
            self.assertAlmostEqual(np.linalg.norm(point) / reach, utilisation, delta=1e-3)


class Elastic(ProgramTest):
    def test_moments_beyond_the_capacity_tell_the_state_of_damage(self):
        """An elastic column bends as 3 E I / H^2; its moment over the capacity passes the ratios of the states of damage."""
        scene = SCENE.replace("      section:\n", "      section:\n        elastic: true\n        damage_states: [0.5, 1, 2]\n").replace(f"{-LOAD} N", "-1 N")
        run = Run(self.run_scene(self.scene(scene)))
        rows, summary = run.histories, run.summary
        concrete, bars = 22e9 * 3.8**0.3, np.pi / 4 * DIAMETER**2 / SPACING
        arm = THICKNESS / 2 - COVER - DIAMETER / 2
        stiffness = concrete * THICKNESS**3 / 12 + 2 * (Section.steel - concrete) * bars * arm**2
        shear = 5 / 6 * THICKNESS * concrete / 2.4
        moment = rows["tip_ux_m"] / (HEIGHT**2 / (3 * stiffness) + 1 / shear)
        moved = rows["tip_ux_m"] > 1e-2
        self.assertLess(abs(-rows["base_moment_Nm"][moved] / moment[moved] - 1).max(), 0.02)
        thrust, limit = run.capacities["lining", "column"].T
        ultimate = np.interp(0, np.sort(thrust[limit < 0]), limit[limit < 0][thrust[limit < 0].argsort()])
        ratio = (rows["base_moment_Nm"] / ultimate).max()
        self.assertGreater(ratio, 2)
        self.assertAlmostEqual(summary["lining_column_largest_moment_ratio"], ratio, delta=0.01 * ratio)
        self.assertEqual(summary["lining_column_damage_state"], 3)
        self.assertNotIn("lining_column_largest_hinge_rotation_rad", summary)


if __name__ == "__main__":
    unittest.main()
