"""The models, and the variants of each: one thing changed at a time about the middle, then some together.

A variant is a list of settings, each the text of a `--set` of the coupler.
"""
from dataclasses import dataclass, field
from pathlib import Path

SCENES = Path(__file__).parent / "scenes"


@dataclass
class Model:
    name: str
    axis: str  # direction of the displacements that are compared: x or y
    force_window: tuple  # times [s] between which the strongest bond lies where every variant has particles
    repeats: int  # number of repeated runs for measuring the cost
    families: dict  # {family: {variant: settings}}
    alone: dict = field(default_factory=dict)  # variants of the full particle model

    def full(self):
        return SCENES / f"{self.name}_full.yaml"

    def coupled(self):
        return SCENES / f"{self.name}_coupled.yaml"


def overlap(begin, width):
    """Particles from `begin` [m] to the fixed end, of which the first `width` [m] are the overlap."""
    return [f"interface.overlap.particles_begin.x={begin}", f"interface.overlap.continuum_ends.x={begin + width:g}"]


def zones(along, across):
    return [f"continuum.block.zones_x={along}", f"continuum.block.zones_y={across}"]


def solve(name):
    return [f"interface.solve={name}"]


def substeps(count):
    return [f"time.substeps={count}"]


def dt_factor(value):
    return [f"time.dt_factor={value}"]


def continuum_modulus(value):
    return [f"continuum.material={{young_modulus: {value}, poisson_ratio: 0.2, density: 2500 kg/m^3}}"]


STEPS = {
    "substeps": {"2 substeps": substeps(2), "4 substeps": substeps(4), "substeps chosen": substeps(0)},
    "time step": {f"dt factor {f}": dt_factor(f) for f in (0.2, 0.9)},
}
ALONE = {f"particles only, dt factor {f}": dt_factor(f) for f in (0.5, 0.9)}

# The 9 rows of the lattice are 7.5 % softer in bending than the beam that they model.
SOFTENED = continuum_modulus("23.26 GPa")

CANTILEVER = Model(
    "cantilever", "y", (20e-3, 38e-3), repeats=5, alone=ALONE,
    families={
        "middle": {"middle": []},
        "overlap": {f"overlap {w} m": overlap(4, w) for w in (0.5, 1, 3)},
        "zones": {"zones 1 m": zones(10, 2), "zones 0.5 x 0.5 m": zones(20, 2), "zones 0.25 m": zones(40, 4),
                  "zones 0.125 m": zones(80, 8)},
        "particle share": {f"particles in {share} m, overlap 1 m": overlap(10 - share, 1) for share in (2, 3, 4, 8)},
        "solve": {f"{name}, overlap {w} m": solve(name) + overlap(4, w)
                  for name in ("lumped", "split") for w in (0.5, 1, 2)},
        **STEPS,
        "together": {
            "split, overlap 0.5 m, dt factor 0.9": solve("split") + overlap(4, 0.5) + dt_factor(0.9),
            "split, overlap 0.5 m, zones 0.5 x 0.5 m, dt factor 0.9":
                solve("split") + overlap(4, 0.5) + zones(20, 2) + dt_factor(0.9),
            "particles in 8 m, split, overlap 0.5 m, dt factor 0.9":
                solve("split") + overlap(2, 0.5) + dt_factor(0.9),
            "particles in 3 m, split, overlap 0.5 m, dt factor 0.9":
                solve("split") + overlap(7, 0.5) + dt_factor(0.9)},
        "softened continuum": {
            "softened": SOFTENED, "softened, overlap 0.5 m": SOFTENED + overlap(4, 0.5),
            "softened, particles in 3 m": SOFTENED + overlap(7, 1)},
    })

BAR = Model(
    "bar", "x", (6.3e-3, 7e-3), repeats=1, alone=ALONE,
    families={
        "middle": {"middle": []},
        "overlap": {f"overlap {w} m": overlap(12, w) for w in (0.125, 0.25, 0.5, 2)},
        "zones": {"zones 0.5 m": zones(40, 2), "zones 0.25 m": zones(80, 4), "zones 0.125 m": zones(160, 8),
                  "zones 0.04167 m": zones(480, 24), "zones 0.03125 m": zones(640, 32)},
        "particle share": {f"particles in {share} m": overlap(20 - share, 1) for share in (4, 12, 14)},
        "solve": {f"{name}, overlap {w} m": solve(name) + overlap(12, w)
                  for name in ("lumped", "split") for w in (0.25, 1)},
        **STEPS,
        "together": {
            "4 m, overlap 0.25 m, dt factor 0.9": overlap(16, 0.25) + dt_factor(0.9),
            "4 m, overlap 0.25 m, zones 0.03125 m, dt factor 0.9":
                overlap(16, 0.25) + zones(640, 32) + dt_factor(0.9),
            "4 m, overlap 0.25 m, zones 0.125 m, substeps chosen, dt factor 0.9":
                overlap(16, 0.25) + zones(160, 8) + substeps(0) + dt_factor(0.9),
            "12 m, overlap 0.25 m, zones 0.03125 m, dt factor 0.9":
                overlap(8, 0.25) + zones(640, 32) + dt_factor(0.9)},
    })

TINY = Model(
    "tiny", "x", (6.3e-3, 7e-3), repeats=1, alone={"particles only, dt factor 0.5": dt_factor(0.5)},
    families={
        "zones": {"zones 1 m": zones(20, 2), "zones 0.5 m": zones(40, 2), "zones 0.25 m": zones(80, 4)},
        "solve": {"lumped": solve("lumped")}})

MODELS = {model.name: model for model in (CANTILEVER, BAR)}
