"""The site of cases/site_response: its motions, its transfer function, and wave theory of damped layers."""
import json
from dataclasses import dataclass

import numpy as np
import yaml

PERIODS = np.geomspace(0.05, 4.0, 120)  # [s]
DAMPING = 0.05  # of the oscillators


class Motions:
    """Displacements of a run at its depths, as evenly spaced rows."""

    def __init__(self, run):
        self.name = run.name
        self.time = run.histories["time_s"]
        self.scene = yaml.safe_load((run.folder / "scene.yaml").read_text())
        places = self.scene["continuum"]["histories"]
        self.depth = np.array([-place["at"]["y"] for place in places])
        self.displacement = np.array([run.histories[f"{place['name']}_ux_m"] for place in places])

    @property
    def step(self):
        return (self.time[-1] - self.time[0]) / (len(self.time) - 1)

    def acceleration(self, depth=None):
        """Second differences at the rows' times; of all depths, or of one."""
        u = self.displacement if depth is None else self.displacement[self.depth == depth][0]
        return np.gradient(np.gradient(u, self.step, axis=-1), self.step, axis=-1)

    def strain_profile(self):
        """(depth, largest |shear strain|) between neighbouring places."""
        strain = np.diff(self.displacement, axis=0) / np.diff(self.depth)[:, None]
        return (self.depth[1:] + self.depth[:-1]) / 2, np.abs(strain).max(axis=1)


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
    undamped half-space of the lowest layer."""
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


def measured_transfer(outcrop, site, band=0.1):
    """(frequency, amplitude) of the surface over the outcrop, from the spectra of both averaged over a band [Hz]."""
    rock, soil = outcrop.acceleration(40), site.acceleration(0)
    count = 2 * len(rock)
    frequency = np.fft.rfftfreq(count, site.step)
    cross = np.fft.rfft(soil, count) * np.conj(np.fft.rfft(rock, count))
    power = np.abs(np.fft.rfft(rock, count)) ** 2
    width = max(1, round(band / frequency[1]))
    window = np.hanning(width + 2)[1:-1]
    ratio = np.convolve(cross, window, "same") / np.convolve(power, window, "same")
    return frequency, np.abs(ratio)


def response_spectrum(acceleration, step):
    """Pseudo-accelerations over PERIODS: exact steps of the oscillator for straight lines (Nigam and Jennings 1969)."""
    w = 2 * np.pi / PERIODS
    root = np.sqrt(1 - DAMPING**2)
    decay, c, s = np.exp(-DAMPING * w * step), np.cos(root * w * step), np.sin(root * w * step)
    u, v, peak = np.zeros_like(w), np.zeros_like(w), np.zeros_like(w)
    for before, after in zip(acceleration[:-1], acceleration[1:]):
        slope = (after - before) / step
        # u'' + 2 z w u' + w^2 u = -(before + slope t): particular solution a + b t
        b = -slope / w**2
        a = (-before - 2 * DAMPING * w * b) / w**2
        first, second = u - a, (v - b + DAMPING * w * (u - a)) / (root * w)
        u_free, v_free = decay * (first * c + second * s), decay * (
            -DAMPING * w * (first * c + second * s) + root * w * (second * c - first * s))
        u, v = u_free + a + b * step, v_free + b
        peak = np.maximum(peak, np.abs(u))
    return w**2 * peak


@dataclass
class Findings:
    frequency: np.ndarray
    measured: np.ndarray
    theory: np.ndarray
    error: float  # largest, relative to the peak, in the band of the picture
    resonance: tuple  # (frequency, amplification) measured, and of theory
    peaks: dict  # of the acceleration [m/s^2]
    strain: dict  # largest

    def lines(self):
        (f, a), (ft, at) = self.resonance
        yield f"first resonance    {f:.2f} Hz, amplification {a:.2f} (wave theory {ft:.2f} Hz, {at:.2f})"
        yield f"transfer function  within {100 * self.error:.2f} % of the peak from 0.5 to 15 Hz"
        yield "peak acceleration  " + ", ".join(f"{name} {value:.2f} m/s²" for name, value in self.peaks.items())
        yield "largest strain     " + ", ".join(f"{name} {100 * value:.3f} %" for name, value in self.strain.items())

    def write(self, path):
        (f, a), (ft, at) = self.resonance
        path.write_text(json.dumps({
            "first_resonance_Hz": f, "first_amplification": a, "theory_first_resonance_Hz": ft,
            "theory_first_amplification": at, "transfer_error_of_peak": self.error,
            **{f"{name}_peak_acceleration_m_per_s2": value for name, value in self.peaks.items()},
            **{f"{name}_largest_strain": value for name, value in self.strain.items()}}, indent=2) + "\n")


def compare(outcrop, linear, hysteretic):
    frequency, measured = measured_transfer(outcrop, linear)
    band = (frequency >= 0.5) & (frequency <= 15)
    frequency, measured = frequency[band], measured[band]
    theory = np.abs(transfer(linear.scene, frequency) / transfer(outcrop.scene, frequency))
    top, top_theory = np.argmax(measured), np.argmax(theory)
    surfaces = {"linear": linear, "hysteretic": hysteretic}
    return Findings(
        frequency, measured, theory, np.max(np.abs(measured - theory)) / theory[top_theory],
        ((frequency[top], measured[top]), (frequency[top_theory], theory[top_theory])),
        {"outcrop": np.abs(outcrop.acceleration(40)).max(),
         **{name: np.abs(run.acceleration(0)).max() for name, run in surfaces.items()}},
        {name: run.strain_profile()[1].max() for name, run in surfaces.items()})
