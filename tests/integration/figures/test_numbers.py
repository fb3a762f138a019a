"""Every number that a run of the coupler writes is what mechanics says: its unit, sign, time, place and owner."""

import unittest

import numpy as np

from figures.computed import Run, told_report
from figures.told import COST, ORIGIN, Told
from programs import ProgramTest

G, POISSON, DENSITY = 0.4e9, 0.25, 2000.0  # λ = G where Poisson's ratio is a quarter
STEP, END, ROWS = 1e-4, 0.02, 1e-3
HEAD = f"""
material: {{young_modulus: 1 GPa, poisson_ratio: {POISSON}, density: {DENSITY} kg/m^3}}
time: {{duration: {END}, dt: {STEP}}}
output: {{field_times: [0, 20 ms], history_interval: {ROWS}, OUTPUT}}
"""
ACCELERATION = np.array([3.0, -1.0])
FALLING = HEAD.replace("OUTPUT", "peaks: {}, spectra: [{history: p, shortest_period: 20 ms, longest_period: 40 ms}]") + """
continuum:
  block: {x_min: 0 m, x_max: 4 m, y_min: 0 m, y_max: 2 m, zones_x: 4, zones_y: 2}
  body_loads: [{acceleration: {x: 3 m/s^2, y: -1 m/s^2}}]
  histories:
""" + "".join(f"    - {{name: p, quantity: {what}_{axis}, at: {{x: 4 m, y: 2 m}}}}\n"
              for what in ("displacement", "velocity", "acceleration") for axis in "xy")

# The corners of one zone of 2 m by 1 m move so that u_x = 0.01 x + 0.03 y, u_y = -0.004 y in a second.
STRAINS = {"exx": 0.01, "eyy": -0.004, "gxy": 0.03}  # in a second
STRAINED = HEAD.replace("OUTPUT", "peaks: {}") + """
continuum:
  block: {x_min: 0 m, x_max: 2 m, y_min: 0 m, y_max: 1 m, zones_x: 1, zones_y: 1}
  motions:
    - {where: {x_max: 1 m, y_max: 0.5 m}, velocity: {x: 0, y: 0}}
    - {where: {x_min: 1 m, y_max: 0.5 m}, velocity: {x: 0.02 m/s, y: 0}}
    - {where: {x_max: 1 m, y_min: 0.5 m}, velocity: {x: 0.03 m/s, y: -0.004 m/s}}
    - {where: {x_min: 1 m, y_min: 0.5 m}, velocity: {x: 0.05 m/s, y: -0.004 m/s}}
  histories:
""" + "".join(f"    - {{name: m, quantity: {what}, at: {{x: 1 m, y: 0.5 m}}}}\n" for what in (
    "stress_xx", "stress_yy", "stress_zz", "stress_xy", "strain_xx", "strain_yy", "shear_strain_xy"))

# Two discs at rest and drawn apart by 1 m/s: the bond between them breaks at 1.05 MN, a stretch of 10.5 mm.
SPEED, STIFFNESS, STRENGTH, RADIUS = 1.0, 100e6, 1.05e6, 0.5
LAST_WHOLE, BROKEN = 0.0105, 0.0106  # times: of the largest force that it bears, and a step later
DRAWN = HEAD.replace("OUTPUT", "") + f"""
particles:
  placed: {{path: pair.csv}}
  bonds: {{normal_stiffness: {STIFFNESS}, shear_stiffness: 50 MN/m, tensile_strength: {STRENGTH * (1 + 1e-9)}}}
  motions:
    - {{where: {{x_max: 10}}, velocity: {{x: 0, y: 0}}, spin: 0}}
    - {{where: {{x_min: 10}}, velocity: {{x: {0.8 * SPEED}, y: {0.6 * SPEED}}}, spin: 0}}
  histories:
    - {{name: p, quantity: displacement_x, at: {{x: 10.4 m, y: 3.3 m}}}}
    - {{name: p, quantity: velocity_y, at: {{x: 10.4 m, y: 3.3 m}}}}
"""
FIRST, SECOND = np.array([9.6, 2.7]), np.array([10.4, 3.3])  # centres, a metre apart
MASS = DENSITY * np.pi * RADIUS**2  # of a disc, per metre

NO_PARTICLES = {"particles": 0, "bonds": 0, "coupling_points": 0, "peak_bond_force_N": None, "peak_bond_force_time_s": None,
                "peak_bond_force_x_m": None, "peak_bond_force_y_m": None, "crack_count": 0, "first_crack_time_s": None,
                "first_crack_x_m": None, "first_crack_y_m": None, "particle_updates": 0}
OF_EVERY_RUN = {"plane": "plane_strain", "duration_s": END, "dt_s": STEP, "substeps": 1, "completed": True, "cracks_in_statics": {},
                "debonded_count": 0, "first_debonding_time_s": None, "first_debonding_x_m": None, "first_debonding_y_m": None,
                "debonded_in_statics": {},
                "multiplier_work_J": 0, "max_constraint_residual": None, "steps": round(END / STEP)}


class Figures(ProgramTest):
    def computed(self, text):
        (self.folder / "pair.csv").write_text("x_m,y_m,radius_m\n" + "".join(f"{x},{y},{RADIUS}\n" for x, y in (FIRST, SECOND)))
        self.run = Run(self.run_scene(self.scene(text)))
        self.time = np.arange(round(END / ROWS) + 1) * ROWS
        return self.run

    def histories(self, model, expected, **energies):
        """`energies`: those of the model that are not 0. The kinetic energy is that of the velocities half a step before and after, 0 where
        these are opposite."""
        told = Told(self, "histories.csv", self.run.histories)
        told.equal({"time_s": self.time} | expected)
        size = max(np.max(np.abs(values)) for values in energies.values())
        told.equal({f"{model}_{kind}_J": energies.get(kind, 0 * self.time) for kind in (
            "kinetic", "strain", "released", "external_work", "multiplier_work", "dissipated")}, size=size)
        told.equal({"energy_drift": 0 * self.time}, size=1e-3)
        told.all_told()

    def summary(self, expected):
        told = Told(self, "summary.json", self.run.summary, ORIGIN | COST)
        told.equal(OF_EVERY_RUN | expected)
        told.equal({"max_energy_drift": 0, "energy_kept": 1}, size=1e-3)
        low, high = self.stable
        self.assertTrue(low <= self.run.summary["critical_dt_s"] <= high, self.run.summary["critical_dt_s"])
        self.assertEqual(self.run.summary["stated"], [])  # all of it acts
        told.left -= {"critical_dt_s", "stated"}
        told.all_told()

    def piece(self, name, expected, size=None, **sizes):
        piece = self.run.fields()[name]
        told = Told(self, name, {**piece.point_fields, **piece.cell_fields})
        for field, values in expected.items():
            shape = piece[field].shape
            told.equal({field: np.broadcast_to(np.asarray(values, float), shape)}, size=sizes.get(field))
        told.all_told()
        return piece

    def test_a_body_that_falls_freely(self):
        self.computed(FALLING)
        t, a = self.time, ACCELERATION
        mass, square = DENSITY * 8, a @ a
        half = np.where(t > 0, t - STEP / 2, 0)  # velocities are those of half a step before
        self.histories("continuum", {f"p_{what}{axis}_{unit}": a[k] * factor for k, axis in enumerate("xy") for what, unit, factor in (
            ("u", "m", t**2 / 2), ("v", "m_per_s", half), ("a", "m_per_s2", np.ones_like(t)))},
            kinetic=mass / 2 * square * np.where(t > 0, t**2 - STEP**2 / 4, 0), external_work=mass / 2 * square * t**2)
        self.piece("grid", {
            "displacement_m": [*(a * END**2 / 2), 0], "velocity_m_per_s": [*(a * (END + STEP / 2)), 0], "stress_Pa": 0, "weight": 1,
            "material": 0, "group": 0, "peak_displacement_m": np.sqrt(square) * END**2 / 2,
            "peak_velocity_m_per_s": np.sqrt(square) * (END - STEP / 2),
            "peak_acceleration_m_per_s2": np.sqrt(square), "peak_shear_strain": 0, "peak_largest_principal_stress_Pa": 0,
            "peak_smallest_principal_stress_Pa": 0}, stress_Pa=1e5, peak_largest_principal_stress_Pa=1e5, peak_smallest_principal_stress_Pa=1e5)
        self.stable = 1 / np.sqrt(1.2e9 / DENSITY) / np.sqrt(2), 1 / np.sqrt(G / DENSITY)
        measures = {}
        for k, axis in enumerate("xy"):
            measures |= {f"p_a{axis}_{name}": each for name, each in self.measures_of(abs(a[k])).items()}
            self.spectra(f"p_a{axis}", a[k])
        self.summary(NO_PARTICLES | measures | {"zones": 8, "grid_points": 15, "zone_updates": 8 * 200, "spectra_sampling_interval_s": ROWS})

    @staticmethod
    def measures_of(a):
        """Of a constant acceleration."""
        return {"pga_m_per_s2": a, "pgv_m_per_s": a * END, "pgd_m": a * END**2 / 2, "arias_m_per_s": np.pi / (2 * 9.80665) * a**2 * END,
                "cav_m_per_s": a * END, "significant_duration_s": 0.9 * END}

    def spectra(self, name, a):
        tables, t = self.run.spectra[name], self.time
        told = Told(self, f"{name}_motion", tables["motion"])
        told.equal({"time_s": t, "acceleration_m_per_s2": a + 0 * t, "velocity_m_per_s": a * t, "displacement_m": a * t**2 / 2,
                    "arias_share": t / END})
        told.all_told()
        fourier = tables["fourier"]
        told = Told(self, f"{name}_fourier", fourier, {"frequency_Hz"})
        told.equal({"amplitude_m_per_s": [ROWS * abs(np.sum(a * np.exp(-2j * np.pi * f * t))) for f in fourier["frequency_Hz"]]})
        told.all_told()
        self.response(name, a, tables["response"])

    def response(self, name, a, table):
        """Of an oscillator under a constant acceleration from rest: its closed form."""
        fine, damping = np.linspace(0, END, 20001), 0.05
        omega = 2 * np.pi / table["period_s"][:, None]
        damped = omega * np.sqrt(1 - damping**2)
        decay = np.exp(-damping * omega * fine)
        moved = a / omega**2 * (1 - decay * (np.cos(damped * fine) + damping * omega / damped * np.sin(damped * fine)))
        speed = a / damped * decay * np.sin(damped * fine)
        absolute = omega**2 * moved + 2 * damping * omega * speed
        told, omega = Told(self, f"{name}_response", table, {"period_s"}), omega[:, 0]
        told.equal({f"{what}_5pct_{unit}": np.abs(values).max(axis=1) for what, unit, values in (
            ("sd", "m", moved), ("sv", "m_per_s", speed), ("sa", "m_per_s2", absolute))}, tolerance=3e-3)  # samples are ROWS apart
        told.equal({"psv_5pct_m_per_s": omega * table["sd_5pct_m"], "psa_5pct_m_per_s2": omega**2 * table["sd_5pct_m"]})
        told.all_told()

    def test_a_zone_that_is_strained(self):
        self.computed(STRAINED)
        t, e = self.time, STRAINS
        volume = e["exx"] + e["eyy"]
        stress = {"sxx": G * volume + 2 * G * e["exx"], "syy": G * volume + 2 * G * e["eyy"], "szz": G * volume, "sxy": G * e["gxy"]}
        power = stress["sxx"] * e["exx"] + stress["syy"] * e["eyy"] + stress["sxy"] * e["gxy"]
        corners = np.array([(0, 0), (0.02, 0), (0.03, -0.004), (0.05, -0.004)])
        kinetic = DENSITY * 2 / 4 / 2 * np.sum(corners**2)
        strain = power * t**2 / 2 * 2  # in 2 m²
        self.histories("continuum", {f"m_{name}_Pa": each * t for name, each in stress.items()} | {f"m_{name}": each * t for name, each in e.items()},
                       kinetic=np.where(t > 0, kinetic, 0), strain=strain, external_work=strain + np.where(t > 0, kinetic, 0))
        grid = self.run.fields()["grid"]
        moved = np.column_stack([0.01 * grid.points[:, 0] + 0.03 * grid.points[:, 1], -0.004 * grid.points[:, 1], 0 * grid.points[:, 0]])
        length = np.hypot(*moved[:, :2].T)
        middle, radius = (stress["sxx"] + stress["syy"]) / 2, np.hypot((stress["sxx"] - stress["syy"]) / 2, stress["sxy"])
        self.piece("grid", {
            "displacement_m": moved * END, "velocity_m_per_s": moved, "stress_Pa": np.array([stress["sxx"], stress["syy"], stress["sxy"]]) * END,
            "weight": 1, "material": 0, "group": 0, "peak_displacement_m": length * END, "peak_velocity_m_per_s": length,
            "peak_acceleration_m_per_s2": 2 * length / STEP,  # from rest within half a step
            "peak_shear_strain": np.hypot(e["exx"] - e["eyy"], e["gxy"]) * END,
            "peak_largest_principal_stress_Pa": (middle + radius) * END, "peak_smallest_principal_stress_Pa": (middle - radius) * END})
        self.stable = STEP, np.inf
        self.summary(NO_PARTICLES | {"zones": 1, "grid_points": 4, "zone_updates": 200})

    def test_a_bond_that_is_torn(self):
        self.computed(DRAWN)
        t = self.time
        whole = t < BROKEN - STEP / 2
        force = np.where(whole, STIFFNESS * SPEED * t, 0)
        kinetic, released = MASS / 2 * SPEED**2, STRENGTH * BROKEN * SPEED / 2  # the last step's work is that of the mean force
        self.histories("particles", {"p_ux_m": 0.8 * SPEED * t, "p_vy_m_per_s": np.where(t > 0, 0.6 * SPEED, 0), "max_bond_force_N": force},
                       kinetic=np.where(t > 0, kinetic, 0), strain=force**2 / (2 * STIFFNESS), released=np.where(whole, 0, released),
                       external_work=np.where(t > 0, kinetic, 0) + np.where(whole, force**2 / (2 * STIFFNESS), released))
        middle = (FIRST + SECOND) / 2
        told = Told(self, "cracks.csv", self.run.cracks)
        self.assertEqual((list(self.run.cracks["mode"]), list(self.run.cracks["group"])), (["tensile"], ["particles"]))
        told.left -= {"mode", "group"}
        told.equal({"time_s": [BROKEN], "step": [106], "x_m": [middle[0]], "y_m": [middle[1]], "length_m": [2 * RADIUS / np.sqrt(3)],
                    "parent_a": [0], "parent_b": [1], "stage": [0]})
        told.equal({"orientation_rad": [np.arctan2(-0.8, 0.6)]})  # of the crack, which has no beginning: within a quarter turn
        told.all_told()
        self.stable = STEP, np.sqrt(4 * MASS / (2 * STIFFNESS))
        self.summary({"particles": 2, "bonds": 1, "zones": 0, "grid_points": 0, "coupling_points": 0, "zone_updates": 0, "particle_updates": 400,
                      "peak_bond_force_N": STRENGTH, "peak_bond_force_time_s": LAST_WHOLE, "peak_bond_force_x_m": middle[0],
                      "peak_bond_force_y_m": middle[1], "crack_count": 1, "first_crack_time_s": BROKEN, "first_crack_x_m": middle[0],
                      "first_crack_y_m": middle[1], "particles_engine": self.run.summary["particles_engine"]})
        moved = np.array([(0, 0, 0), (0.8, 0.6, 0)]) * SPEED
        self.piece("particles", {"displacement_m": moved * END, "velocity_m_per_s": moved, "spin_rad_per_s": 0, "radius_m": RADIUS, "weight": 1,
                                 "id": [0, 1], "group": 0, "stress_Pa": 0, "coordination": 0, "fragment": [0, 1]}, stress_Pa=1e6)
        self.piece("bonds", {"displacement_m": moved * END, "normal_force_N": 0, "shear_force_N": 0, "moment_Nm": 0, "state": 1, "weight": 1},
                   normal_force_N=STRENGTH, shear_force_N=STRENGTH, moment_Nm=STRENGTH)
        self.reported()

    def reported(self):
        """The page says the same as the summary, and in the sentence about cracks."""
        text, _ = told_report(self, self.run)
        self.assertRegex(text, r"The only crack inside one body broke at 10\.6 ms, x = 10 m, y = 3 m")


if __name__ == "__main__":
    unittest.main()
