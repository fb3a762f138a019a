"""A wave packet as its source sends it, and the case of a study that it belongs to."""
import math
from dataclasses import dataclass

import numpy as np

# Every model of the study: particles of diameter 1 in a lattice, density 1, P waves of speed 1.
SPACING = 1.0
ROW = math.sqrt(3) / 2  # height of a row of particles
POISSON_RATIO = 0.2
MATERIAL_2D = {"young_modulus": 1 - POISSON_RATIO**2, "poisson_ratio": POISSON_RATIO, "density": 1}
SPEED = {"P": 1.0, "S": math.sqrt((1 - POISSON_RATIO) / 2)}
AMPLITUDE = 1e-6  # velocity of the source, so that displacements stay small compared with the particles


@dataclass(frozen=True)
class Case:
    """One packet on its way through one overlap: a row of the table."""
    model: str  # bar, strip, patch
    solve: str
    lambda_over_h: float
    h_over_a: int = 10
    overlap_over_h: int = 5
    dt_factor: float = 0.5
    angle_deg: int = 0
    side: str = "particles"  # the side on which the source is
    wave: str = "P"
    substeps: int = 1

    @property
    def zone(self):
        return self.h_over_a * SPACING

    @property
    def overlap(self):
        return self.overlap_over_h * self.zone

    @property
    def wavelength(self):
        return self.lambda_over_h * self.zone

    @property
    def name(self):
        return (f"{self.model}_{self.wave}_{self.solve}_h{self.h_over_a}_overlap{self.overlap_over_h}"
                f"_lambda{self.lambda_over_h}_dt{self.dt_factor}_angle{self.angle_deg}_{self.side}_m{self.substeps}")

    def scene(self, duration):
        """The part that the scenes of all models have in common."""
        return {"plane": "plane_stress", "material": MATERIAL_2D,
                "time": {"duration": duration, "dt_factor": self.dt_factor, "substeps": self.substeps},
                "output": {"history_interval": duration}}


@dataclass(frozen=True)
class Packet:
    """A carrier under a Gaussian envelope of the displacement. `spacing`: of the lattice of masses that sets
    the dispersion, particles or grid points. `periods`: standard deviation of the envelope; it ends after
    `cut` of these on either side."""
    wavelength: float
    speed: float = 1.0
    spacing: float = SPACING
    periods: float = 1.0
    cut: float = 5.0

    @property
    def omega(self):
        return 2 * self.speed / self.spacing * math.sin(math.pi * self.spacing / self.wavelength)

    @property
    def group_velocity(self):
        return self.speed * math.cos(math.pi * self.spacing / self.wavelength)

    @property
    def period(self):
        return 2 * math.pi / self.omega

    @property
    def width(self):
        return self.periods * self.period

    @property
    def duration(self):
        return 2 * self.cut * self.width

    def displacement(self, t):
        s = (t - self.duration / 2) / self.width
        return np.exp(-s * s / 2) * np.sin(self.omega * (t - self.duration / 2)) / self.omega

    def velocity(self, t):
        s = (t - self.duration / 2) / self.width
        phase = self.omega * (t - self.duration / 2)
        return np.exp(-s * s / 2) * (np.cos(phase) - s / (self.omega * self.width) * np.sin(phase))

    def table(self, function, points_a_period, delay=0.0):
        """A scene's table of a function of the time, 0 before and after the packet."""
        count = round(self.duration / self.period * points_a_period)
        t = np.linspace(0, self.duration, count + 1)
        values = function(t)
        values[0] = values[-1] = 0
        return {"table": {"time": (t + delay).tolist(), "value": values.tolist()}}
