"""What follows from the runs of a study: fragility curves, the spread of the answers, and which input matters."""
import csv
import re
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.stats import beta

from adit.results.files import Unusable
from adit.study import detail, indices as influence, search, table
from adit.study.fragility import bootstrap, cloud, curves as fitting, goodness, nrml, observations, pelicun, states
from adit.study.fragility.measures import unit_of
from adit.study.fragility.sets import DamageState
from adit.study.study import Damage

FRACTILES = (16, 50, 84)
TESTED = 8  # motions at least, whose first exceedances test a curve


@dataclass(frozen=True)
class StateCurve:
    """A damage state with the Fit of its curve; `first`: that of the first exceedance of each motion where stripes have one run of each
    motion at each level, else None."""
    damage: Damage
    state: DamageState
    fit: fitting.Fit
    first: fitting.Fit = None

    @cached_property
    def bootstrap(self):
        """None where there is no curve."""
        return bootstrap.bootstrap(self.fit) if self.fit.curve else None

    @cached_property
    def intervals(self):
        """{"median": (low, high), "dispersion": (low, high)}, 95 %."""
        return self.bootstrap.intervals()

    @cached_property
    def goodness(self):
        """Of stripes by the first exceedance of each motion, because its runs depend on each other."""
        return goodness.goodness(self.first or self.fit)


class Outcome:
    """Of the rows of a table (table.rows_of), those that failed count nowhere; and of the runs that are computed in detail (detail.compute)."""

    def __init__(self, study, listed, closer=()):
        self.study, self.listed, self.closer = study, listed, closer
        self.good = [row for row in listed if not row["failed"]]
        self.failed = len(listed) - len(self.good)

    @cached_property
    def intensity(self):
        """[SI] of each good row, over which fragility is told."""
        return table.column(self.good, table.intensity_column(self.study))

    @property
    def unit(self):
        """(name, what one of it is in SI) of intensities as engineers write them."""
        return unit_of(self.study.intensity[0])

    def answers(self, name):
        return np.abs(table.column(self.good, name))

    @cached_property
    def curves(self):
        """[StateCurve] of all damage states, the lightest first; empty without motions."""
        if not self.study.motions or not self.good:
            return []
        motion = np.array([row["motion"] for row in self.good])
        found = []
        for damage in self.study.damage:
            answers = self.answers(damage.of)
            known = ~np.isnan(answers)
            for state in damage.states if known.any() else ():
                exceeded = answers[known] > state.above
                if self.study.levels and self.study.levels[0] == "increments":
                    climb = np.unique([row["sample"] for row in self.good], return_inverse=True)[1]
                    seen = observations.of_climbs(motion[known], self.intensity[known], exceeded, climb[known])
                else:
                    seen = observations.of_runs(motion[known], self.intensity[known], exceeded)
                found.append(StateCurve(damage, state, fitting.fit(seen), self._first(motion[known], self.intensity[known], exceeded)))
        return found

    def _first(self, motion, intensity, exceeded):
        """The Fit of the first exceedance of each motion of stripes; None where they have several runs at a level, are
        few, or where it has no curve."""
        if not self.study.levels or self.study.levels[0] != "stripes" or self.study.samples > 1 or len(set(motion)) < TESTED:
            return None
        first = fitting.fit(observations.of_climbs(motion, intensity, exceeded))
        return first if first.curve else None

    def of_damage(self, damage):
        return [each for each in self.curves if each.damage is damage]

    def regression(self, name):
        """The Cloud of an answer over intensity; None where it cannot be."""
        answers = self.answers(name)
        known = answers > 0
        try:
            return cloud.regression(np.array([row["motion"] for row in self.good])[known], self.intensity[known], answers[known])
        except Unusable:
            return None

    def spread(self, name):
        """{"count", "mean", "deviation", "p16", "p50", "p84"} of an answer over all good runs; None where no run has it."""
        answers = self.answers(name)
        answers = answers[~np.isnan(answers)]
        if not len(answers):
            return None
        return {"count": len(answers), "mean": float(answers.mean()), "deviation": float(answers.std(ddof=1)) if len(answers) > 1 else 0.0,
                **{f"p{share}": float(np.percentile(answers, share)) for share in FRACTILES}}

    def exceeded(self, damage, state):
        """(share of the good runs, (low, high) of its 95 % interval by Clopper and Pearson, Biometrika 26:404, 1934)."""
        answers = self.answers(damage.of)
        answers = answers[~np.isnan(answers)]
        count, of = int((answers > state.above).sum()), len(answers)
        low = 0.0 if count == 0 else float(beta.ppf(0.025, count, of - count + 1))
        high = 1.0 if count == of else float(beta.ppf(0.975, count + 1, of - count))
        return count / of, (low, high)

    def inputs(self):
        """{name: numbers (n,)} of what differs among the good runs: random quantities, the logarithm of intensity, the number of the
        motion."""
        found = {}
        for each in self.study.random:
            values = [row[each["name"]] for row in self.good]
            if not any(isinstance(value, str) for value in values) and len(set(values)) > 1:
                found[each["name"]] = np.array(values, dtype=float)
        if self.study.motions and len(self.good) and np.ptp(self.intensity) > 0:
            found[table.intensity_column(self.study)] = np.log(self.intensity)
        motions = np.unique([row["motion"] for row in self.good], return_inverse=True)[1]
        if motions.max(initial=0) and self.study.levels:  # each motion has several runs
            found["motion"] = motions.astype(float)
        return found

    @cached_property
    def indices(self):
        """{answer: [(input, its first-order index, (low, high))]}; without answers that too few runs have, or that do not vary."""
        inputs = self.inputs()
        found = {}
        for name in self.study.answers if inputs else ():
            answers = self.answers(name)
            known = ~np.isnan(answers)
            try:
                of = influence.indices(np.column_stack(list(inputs.values()))[known], answers[known])["first_order"]
            except Unusable:
                continue
            found[name] = [(given, each.value, each.interval) for given, each in zip(inputs, of)]
        return found


def conclude(study, listed, closer, out, pictures):
    """Writes what follows from the rows; yields what the user is told. `closer`: the runs that are computed in detail."""
    outcome = Outcome(study, listed, closer)
    if outcome.failed:
        yield f"failed             {outcome.failed} of {len(listed)} runs; the column `failed` of the table says why"
    if not outcome.good:
        return
    if missed := search.missed(study, outcome.good):
        yield (f"levels             {len(missed)} of {len(outcome.good)} runs have not reached theirs within {100 * search.WITHIN:g} %; "
               f"{table.level_column(study)} tells what they have reached")
    if outcome.curves:
        yield from _fragility(outcome, out)
    else:
        for name in study.answers:
            if spread := outcome.spread(name):
                yield f"{name}: median {spread['p50']:.4g}, 16 to 84 % of the runs {spread['p16']:.4g} to {spread['p84']:.4g}"
        for damage in study.damage:
            for state in damage.states:
                share, (low, high) = outcome.exceeded(damage, state)
                yield f"{state.name}: {100 * share:.3g} % of the runs ({100 * low:.2g} to {100 * high:.2g} %)"
    yield from _indices(outcome, out)
    yield from detail.told(study, closer)
    if pictures:
        from adit.study import page, pictures as drawing  # matplotlib is imported only where something is drawn

        drawn = drawing.draw(outcome, out)
        yield f"report             {page.write(outcome, drawn, out)}"


def _fragility(outcome, out):
    unit, si = outcome.unit
    measure = table.intensity_column(outcome.study)
    yield f"fragility over {measure.partition('_m')[0]} [{unit}]"
    rows = []
    for each in outcome.curves:
        row = {"of": each.damage.of, "state": each.state.name, "above": each.state.above}
        if each.fit.curve:
            low, high = (value / si for value in each.intervals["median"])
            narrow, wide = each.intervals["dispersion"]
            fit = f"p = {each.goodness.p:.2g}" if each.goodness.p is not None else each.goodness.sentence
            yield (f"  {each.state.name}: median {each.fit.curve.median / si:.3g} ({low:.3g} to {high:.3g}), dispersion {each.fit.curve.dispersion:.3g} "
                   f"({narrow:.2g} to {wide:.2g}); {fit}")
            rows.append(row | {"median": each.fit.curve.median / si, "median_low": low, "median_high": high, "dispersion": each.fit.curve.dispersion,
                               "dispersion_low": narrow, "dispersion_high": wide, "unit": unit, "test": each.goodness.test, "p": each.goodness.p})
        else:
            yield f"  {each.state.name}: {each.fit.sentence(unit, si)}"
            rows.append(row | dict.fromkeys(("median", "median_low", "median_high", "dispersion", "dispersion_low", "dispersion_high"), "")
                        | {"unit": unit, "test": "", "p": ""})
    with open(out / "fragility.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    for damage in outcome.study.damage:
        yield from _crossings(outcome, damage, unit, si)
        yield from _parts(outcome, damage)
    yield from _for_risk_engines(outcome, out)


def _crossings(outcome, damage, unit, si):
    of = outcome.of_damage(damage)
    low, high = outcome.intensity.min(), outcome.intensity.max()
    for i, j, at in states.crossings([each.fit.curve for each in of], low, high):
        yield f"  the curves of {of[i].state.name} and {of[j].state.name} cross at {at / si:.3g} {unit}: compute more runs, or add levels there"


def _parts(outcome, damage):
    regression = outcome.regression(damage.of)
    parts = regression and regression.parts()
    if parts:
        yield (f"  by regression of {damage.of} (R² = {regression.r2:.2f}): dispersion {parts.between:.3g} between motions, "
               f"{parts.within:.3g} within a motion")


def _for_risk_engines(outcome, out):
    study = outcome.study
    measure, period, _ = study.intensity
    for damage in study.damage:
        curves = {_plain(each.state.name): each.fit.curve for each in outcome.of_damage(damage) if each.fit.curve}
        if not curves:
            continue
        name = f"{study.name}_{damage.of}" if len(study.damage) > 1 else study.name
        nrml.write(out / f"{name}.xml", _plain(study.name), curves, measure.upper(), 0.0, outcome.intensity.max(), period=period,
                   description=study.read.get("description", ""))
        yield f"OpenQuake          {out / f'{name}.xml'}"
        if measure != "arias":
            pelicun.write(out / f"{name}_pelicun.csv", {_plain(study.name): curves}, measure.upper(), period=period)
            yield f"pelicun            {out / f'{name}_pelicun.csv'}"


def _plain(name):
    """A name as risk engines take it."""
    return re.sub(r"[^A-Za-z0-9_-]", "_", name)


def _indices(outcome, out):
    if not outcome.indices:
        return
    with open(out / "indices.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["answer", "input", "first_order", "low", "high"])
        writer.writerows([name, given, value, *interval] for name, each in outcome.indices.items() for given, value, interval in each)
    for name, each in outcome.indices.items():
        told = ", ".join(f"{given} {max(value, 0):.2f}" for given, value, _ in sorted(each, key=lambda one: -one[1]))
        yield f"variance of {name} by input: {told}"
