"""The response of the model: histories, envelopes, cracks, energy."""
from adit import Unusable
from adit.plots import lining_pictures, time_pictures, tunnel_pictures
from adit.report import around, pictures
from adit.report.markup import details, section, table, tag
from adit.report.quantities import figure, place, quantity, unit_of
from adit.results.rounding import coordinate, settled

LISTED = 20  # cracks
BALANCE = (("largest gap of the energy balance, of the peak energy", "max_energy_drift"),
           ("energy kept, of what was put in", "energy_kept"), ("work of the multipliers", "multiplier_work_J"))


def histories(results):
    """A picture for each quantity; forces of sections stand in the envelopes."""
    of_sections = around.columns(results)
    drawn = []
    for name, (units, lines) in time_pictures.quantities_of(results).items():
        lines = [line for line in lines if line[0] not in of_sections]
        if lines:
            left_out = len(lines) - time_pictures.MOST_LINES
            told = f"{left_out} more histories of this quantity are in histories.csv."
            drawn.append(pictures.figure(time_pictures.histories(results, {name: (units, lines)}, f"{name} over time"),
                                         tag("p", told, class_="note") if left_out > 0 else None))
    return section("histories", "Histories", drawn)


def envelopes(results):
    """Along the tunnel, around rings and along linings; thrust and moment against the capacity."""
    drawn = []
    if results.is_simplified:
        try:
            drawn = [pictures.figure(tunnel_pictures.envelopes(results)),
                     pictures.figure(tunnel_pictures.time_distance(results))]
        except Unusable as reason:
            results.faults.append(str(reason))
    linings = around.of_linings(results, results.last_pieces.get("linings"))
    drawn += [pictures.figure(each) for each in (*around.of_sections(results), *linings)]
    capacities = (lining_pictures.lining_capacity, lining_pictures.member_capacity, lining_pictures.section_capacity)
    drawn += [pictures.figure(drawing) for each in capacities if not results.is_simplified and (drawing := each(results))]
    return section("envelopes", "Envelopes", drawn)


def cracks(results):
    found, s = results.table("cracks.csv"), results.summary
    if found is None:
        return None
    if not len(found["time_s"]):
        return section("cracks", "Cracks", tag("p", "No bond broke."))
    told = [_first(s, "crack_count", "first_crack", "crack", "inside one body"),
            _first(s, "debonded_count", "first_debonding", "debonded bond", "between two groups")]
    names = [name for name in ("time_s", "mode", "x_m", "y_m", "length_m", "group", "stage") if name in found]
    rows = [(str(i + 1), *(_said(name, found[name][i]) for name in names)) for i in range(min(LISTED, len(found["time_s"])))]
    heads = ("bond", *(name.removesuffix("_m").removesuffix("_s") for name in names))
    listed = table("Broken bonds in the order of time, from cracks.csv", heads, rows)
    every = len(found["time_s"])
    some = "The broken bond" if every == 1 else f"The first {len(rows)} of {every:,} broken bonds"
    return section("cracks", "Cracks", told, _paths(results), details(some, listed))


def _paths(results):
    """The longest of the paths to which cracks between cells join, where there are any."""
    found = results.table("crack_paths.csv")
    if found is None:
        return None
    names = [name for name in ("mode", "length_m", "opening_m", "slip_m", "x_m", "y_m", "region") if name in found]
    every = len(found["path"])
    rows = [(f"{found['path'][i]:.0f}", *(_said(name, found[name][i]) for name in names)) for i in range(min(LISTED, every))]
    heads = ("path", "mode", "length", "widest opening", "largest slip", "widest at x", "widest at y", "region")[:1 + len(names)]
    listed = table("Cracks that meet, joined to paths: at the end of the run, from crack_paths.csv", heads, rows)
    return details("The crack path" if every == 1 else f"{len(rows)} of {every:,} crack paths", listed)


def _first(s, count, first, what, where):
    """A sentence on the broken bonds of one kind, where there are any."""
    if s.get(f"{first}_time_s") is None:
        return None
    of = f"The only {what}" if s[count] == 1 else f"The first of {s[count]:,} {what}s"
    return tag("p", f"{of} {where} broke at {quantity(s[f'{first}_time_s'], 's')}, {place(s[f'{first}_x_m'], s[f'{first}_y_m'])}.")


def _said(name, value):
    if name in ("x_m", "y_m"):
        value = coordinate(float(value))
    return quantity(float(value), unit_of(name)) if unit_of(name) else f"{value}".removesuffix(".0")


def energy(results):
    s = results.figures
    drawn = None if results.is_simplified else time_pictures.energy(results)
    rows = [(said, figure(s, key)) for said, key in BALANCE if s.get(key) is not None]
    ended = {name: float(values[-1]) for name, values in (results.table("energies.csv") or {}).items() if name != "time_s" and len(values)}
    largest = max(map(abs, ended.values()), default=0)
    by_cause = [(name.removesuffix("_J").replace("_", " "), quantity(value, "J")) for name, value in ended.items() if settled(value, largest)]
    told = tag("p", "What is stored and dissipated must equal the work done. The gap is of the order of rounding for an intact "
                    "continuum; bonds that break and contacts that close within a step raise it.") if rows else None
    causes = details("Energy by cause at the end", table("The last row of energies.csv", None, by_cause)) if by_cause else None
    balance = table("Balance, from summary.json", None, rows)
    return section("energy", "Energy ledger", told, balance, pictures.figure(drawn), causes)
