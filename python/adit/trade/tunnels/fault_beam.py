"""An infinite elastic beam in elastic ground that a fault cuts: its forces after the fault has slipped.

Ground in plane strain of the width d resists a load along the beam that varies as a sine of the wave number q, across the beam
or along it, with k = kappa q, kappa = 8 G (1 - nu) / (3 - 4 nu) d per metre (cases/longxi/README.md; with q = 2 pi / L the spring
of St John and Zahrah). A step s of the ground, spread over the width w in which the fault crosses the beam, moves the beam by

    u(x) = s / pi int_0^inf sin(q x) / q  sin(q w / 2) / (q w / 2)  1 / (1 + (l q)^n) dq

where n = 1, l = EA / kappa along the axis, and n = 3, l^3 = EI / kappa across it. Thrust is EA u', the moment EI u''.
"""
from dataclasses import dataclass

import numpy as np

FINEST, COUNT = 400.0, 40_000  # the integrals end at FINEST / l, where their terms are below 1e-5 of the largest


@dataclass
class Beam:
    axial: float  # EA [N]
    bending: float  # EI [N m^2]
    kappa: float  # of the ground, for the width of the beam [N/m]
    spread: float  # width w over which the step is spread [m]

    def thrust(self, x, step):
        """At distances from the fault [m], of a step along the axis [m]; tension where the step is positive."""
        return self.axial * step / np.pi * self._integral(x, self.axial / self.kappa, 1, lambda q: np.cos(q * x))

    def moment(self, x, step):
        """The same of a step across the axis."""
        length = np.cbrt(self.bending / self.kappa)
        return -self.bending * step / np.pi * self._integral(x, length, 3, lambda q: q * np.sin(q * x))

    def _integral(self, x, length, power, wave):
        step = FINEST / length / COUNT
        q = step * (np.arange(COUNT) + 0.5)
        return step * np.sum(wave(q) * np.sinc(q * self.spread / (2 * np.pi)) / (1 + (length * q) ** power))
