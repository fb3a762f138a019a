"""The site of cases/site_response: its motions, its transfer function, and wave theory of damped layers."""
from dataclasses import dataclass

import numpy as np

LOOPS = ("clay", "sand")  # histories of stress and strain
LOWEST = 0.5  # lowest frequency that is compared [Hz]
WEAK = 0.02  # frequencies are compared up to the last with this share of the outcrop's largest Fourier amplitude


class Site:
    """The motion at the surface and the ground below it, from the results of a run."""

    def __init__(self, run):
        self.name, self.scene, self.histories = run.name, run.scene, run.histories
        surface = run.spectra["surface_ax"]
        motion, response = surface["motion"], surface["response"]
        self.time, self.acceleration = motion["time_s"], motion["acceleration_m_per_s2"]
        self.period, self.spectrum = response["period_s"], response["psa_5pct_m_per_s2"]
        grid = run.fields()["grid"]
        self.peak_acceleration = _over_depth(grid.points[:, 1], grid.field("peak_acceleration_m_per_s2"))
        self.peak_strain = _over_depth(grid.points[grid.cells, 1].mean(axis=1), grid.field("peak_shear_strain"))

    @property
    def peak(self):
        return np.abs(self.acceleration).max()

    def fourier(self, frequency):
        """Time step of the recorded acceleration [s]."""
        return np.array([self.acceleration @ np.exp(-2j * np.pi * f * self.time) for f in frequency]) * self.time[1]

    def loop(self, name):
        """(strain, stress [Pa]) over time."""
        return self.histories[f"{name}_gxy"], self.histories[f"{name}_sxy_Pa"]


def _over_depth(height, values):
    """(depth, values), from the surface down."""
    order = np.argsort(-height, kind="stable")
    return -height[order], values[order]


def layers(scene):
    """(thickness, shear velocity, density) from the surface down, as the scene's blocks and materials state them."""
    rock = scene["material"]
    own = {area["where"]["group"]: area["material"] for area in scene["continuum"].get("materials", [])}
    result = []
    for block in scene["continuum"]["blocks"]:
        material, box = own.get(block["name"], rock), block["rectangle"]
        modulus = material["young_modulus"] / (2 * (1 + material["poisson_ratio"]))
        result.append((box["y_max"] - box["y_min"], np.sqrt(modulus / material["density"]), material["density"]))
    return result


def transfer(scene, frequency):
    """Surface over outcrop: u and the stress through layers of rho* = rho (1 - i a/w), G* = G (1 + i w b), down to an
    undamped half-space of the lowest layer; as in tests/verification/boundaries/shear_column.hpp."""
    ratio, low, high = (scene["continuum"]["damping"]["rayleigh"][name]
                        for name in ("ratio", "low_frequency", "high_frequency"))
    low, high, w = 2 * np.pi * low, 2 * np.pi * high, 2 * np.pi * frequency
    mass, stiffness = 2 * ratio * low * high / (low + high), 2 * ratio / (low + high)
    u, tau = np.ones_like(w, complex), np.zeros_like(w, complex)
    for thickness, velocity, density in layers(scene):
        modulus = density * velocity**2 * (1 + 1j * w * stiffness)
        k = w * np.sqrt(density * (1 - 1j * mass / w) / modulus)
        u, tau = (u * np.cos(k * thickness) + tau * np.sin(k * thickness) / (k * modulus),
                  tau * np.cos(k * thickness) - u * k * modulus * np.sin(k * thickness))
    _, velocity, density = layers(scene)[-1]
    return 1 / (u + tau / (1j * w * density * velocity))


@dataclass
class Findings:
    frequency: np.ndarray
    measured: np.ndarray  # amplification, surface over outcrop
    theory: np.ndarray
    doubling: float  # peak of the computed outcrop motion, relative to that of the scene's motion

    @property
    def error(self):
        """Largest error of the amplification at any frequency."""
        return np.abs(self.measured / self.theory - 1).max()

    def peaks(self):
        """Rows of the resonances: (frequency, amplification) as measured and by theory."""
        def tops(curve):
            inner = np.flatnonzero((curve[1:-1] > curve[:-2]) & (curve[1:-1] > curve[2:])) + 1
            return [(self.frequency[i], curve[i]) for i in inner]
        return [(min(tops(self.measured), key=lambda top: abs(top[0] - known[0])), known) for known in tops(self.theory)]

    def lines(self):
        yield f"outcrop            {100 * (self.doubling - 1):+.2f} % of the stated peak"
        for number, ((f, a), (known_f, known_a)) in enumerate(self.peaks(), 1):
            yield f"resonance {number}        {f:.2f} Hz, amplification {a:.3f} (wave theory {known_f:.2f} Hz, {known_a:.3f})"
        yield f"transfer function  within {100 * self.error:.2f} % from {LOWEST} to {self.frequency[-1]:.1f} Hz"


def compare(outcrop, linear):
    frequency = np.arange(LOWEST, 1 / (20 * outcrop.time[1]), 0.02)
    rock = outcrop.fourier(frequency)
    strong = np.abs(rock) >= WEAK * np.abs(rock).max()
    frequency, rock = frequency[: 1 + np.flatnonzero(strong)[-1]], rock[: 1 + np.flatnonzero(strong)[-1]]
    return Findings(frequency, np.abs(linear.fourier(frequency) / rock), np.abs(transfer(linear.scene, frequency)),
                    outcrop.peak / outcrop.scene["continuum"]["base"]["acceleration"]["peak"])


def table(sites):
    """Rows of a table with the sites' effect on the motion."""
    yield f"{'':12}{'PGA [m/s²]':>12}{'largest strain [%]':>20}"
    for site in sites:
        yield f"{site.name:12}{site.peak:12.2f}{100 * site.peak_strain[1].max():20.3f}"
