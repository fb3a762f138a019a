"""Damage states of the literature, and published curves to lay beside those of a study."""
from dataclasses import dataclass

from adit.study.fragility.curves import Curve


@dataclass(frozen=True)
class DamageState:
    """Reached where the answer is larger than `above`."""
    name: str
    above: float


@dataclass(frozen=True)
class DamageSet:
    """`states`: DamageStates from the least to the worst; `of`: the answer that they are thresholds of."""
    of: str
    states: tuple
    source: str


@dataclass(frozen=True)
class Published:
    """`curves`: {state: Curve} over `measure` in `unit`."""
    title: str
    measure: str
    unit: str
    curves: dict
    source: str


DAMAGE_SETS = {
    "argyroudis_pitilakis": DamageSet(
        of="the largest bending moment of the lining over its capacity, both with the thrust",
        states=(DamageState("minor", 1.0), DamageState("moderate", 1.5), DamageState("extensive", 2.5), DamageState("collapse", 3.5)),
        source="S.A. Argyroudis, K.D. Pitilakis: Seismic fragility curves of shallow tunnels in alluvial deposits. "
               "Soil Dynamics and Earthquake Engineering 35 (2012) 1-12"),
    "metro_station_drift": DamageSet(
        of="the largest drift of a storey of a box over its height",
        states=(DamageState("slight", 0.0014), DamageState("moderate", 0.0032), DamageState("severe", 0.0066), DamageState("collapse", 0.0112)),
        source="Seismic vulnerability evaluation of metro station complex structures in TOD mode based on IDA method. Buildings 15 (2025) 699; "
               "from a pushover of one station"),
}

HAZUS = "Hazus Earthquake Model Technical Manual 5.1 (FEMA 2022), as in SimCenter's Damage and Loss Model Library, rows "
PUBLISHED = {
    "hazus_bored": Published("HAZUS, bored tunnels", "PGA", "g",
                             {"slight": Curve(0.60, 0.6), "moderate": Curve(0.80, 0.6)}, HAZUS + "HTU.GS.1"),
    "hazus_cut_and_cover": Published("HAZUS, cut-and-cover tunnels", "PGA", "g",
                                     {"slight": Curve(0.50, 0.6), "moderate": Curve(0.70, 0.6)}, HAZUS + "HTU.GS.2"),
}
