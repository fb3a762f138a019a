"""Fragility: the probability that a damage state is exceeded, over the intensity of the ground motion.

Columns (n,) of runs go in, as arrays: `motion` (any labels), `intensity` (above 0, in a unit of the caller), `exceeded` (bool) or `answer`.

    observations.of_runs(motion, intensity, exceeded)           -> Observations  stripes and clouds
    observations.of_climbs(motion, intensity, exceeded, sample) -> Observations  increments
    curves.fit(observations)                                    -> Fit           .curve (Curve or None), .kind, .sentence(unit, size)
    curves.Curve(median, dispersion)                            .probability(intensity), .widened(0.3, 0.4)
    Fit.asymptotic(level)                                       -> {"median": (low, high), "dispersion": (low, high)}
    bootstrap.bootstrap(fit, resamples, seed)                   -> Bootstrap     .intervals(level), .band(intensity, level), .without
    goodness.goodness(fit)                                      -> Goodness      .test, .statistic, .p, .sentence
    goodness.shares(observations)                               -> levels, known, exceeded: the points beside a curve
    states.crossings(curves, low, high)                         -> [(i, j, intensity)]
    states.common_dispersion([observations of each state])      -> [Curve or None]
    cloud.regression(motion, intensity, answer)                 -> Cloud         .curve(threshold), .bootstrap(threshold), .r2, .parts()
    needed.motions_needed(dispersion, share, level), needed.reached(interval, share), needed.motions_in_all(interval, motions, share)
    sets.DAMAGE_SETS, sets.PUBLISHED                            damage states and curves of the literature
    nrml.write(path, name, {state: Curve}, measure, lowest, highest, period=, no_damage=, description=), nrml.read(path)
    pelicun.write(path, {ID: {state: Curve}}, measure, period=), pelicun.read(path)

The files of nrml and pelicun convert curves from SI (measures.MEASURES: PGA, PGV, ARIAS, SA). Requests that cannot be fulfilled raise
adit.results.files.Unusable.
"""
