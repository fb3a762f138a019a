"""Measures of intensity as other programs name them."""
from dataclasses import dataclass

G = 9.80665  # [m/s^2]


def unit_of(measure):
    """(name, what one of it is in SI) of an intensity as engineers write it; measures as a study states them."""
    return ("g", G) if measure in ("pga", "sa") else ("m/s", 1.0)


@dataclass(frozen=True)
class Measure:
    """`openquake`, `pelicun`: names, to which the period of a spectral acceleration is added; None where a program has none. `per_si`: what
    one unit of SI is in the unit of the program."""
    openquake: str
    openquake_per_si: float
    pelicun: str
    pelicun_unit: str
    pelicun_per_si: float


# OpenQuake: openquake/hazardlib/imt.py; pelicun: EDP_to_demand_type of pelicun/base.py and pelicun/settings/default_units.json.
MEASURES = {
    "PGA": Measure("PGA", 1 / G, "Peak Ground Acceleration", "g", 1 / G),
    "PGV": Measure("PGV", 100, "Peak Ground Velocity", "mps", 1),
    "ARIAS": Measure("IA", 1, None, None, None),
    "SA": Measure("SA", 1 / G, "Spectral Acceleration", "g", 1 / G),
}
