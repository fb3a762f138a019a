"""The likelihood of capacities that lie between bounds, and its maximum for many weightings of the same observations at once.

The capacity of a motion is the intensity at which a damage state is reached. Its logarithm is normal, so that an observation has the
probability Phi(z(upper)) - Phi(z(lower)), where z(x) = slope x + intercept, x = ln(intensity), slope = 1 / dispersion and
intercept = -ln(median) / dispersion. A run that exceeds the state at x has the bounds (-inf, x], a run that does not (x, inf): these
are the Bernoulli terms of Baker (2015, Earthquake Spectra 31:579, eq. 9). A motion that climbs has both bounds (its eq. 6 in intervals).

The logarithm of the likelihood is concave in (slope, intercept), because Phi(u) - Phi(l) is log-concave in (u, l) (Prekopa 1971,
Acta Sci. Math. 32:301). It has a maximum unless a direction exists in which no observation becomes less likely (Albert and
Anderson 1984, Biometrika 71:1, for binary data); `kinds()` finds such directions.
"""
import numpy as np
from scipy.special import log_ndtr, ndtri

CURVE, NEVER, ALWAYS, SEPARATED, FLAT = "curve", "never", "always", "separated", "flat"

ITERATIONS = 100
HALVINGS = 40
ROUNDING = 1e-13  # of the logarithm of a likelihood
SMALLEST_STEP = 1e-7  # of the parameters; that after it is its square


def log_probability(upper, lower):
    """ln(Phi(upper) - Phi(lower)); nan where upper < lower."""
    right = lower > 0  # differences of small tails are exact, of values near 1 they are not
    upper, lower = np.where(right, -lower, upper), np.where(right, -upper, lower)
    whole = log_ndtr(upper)
    return whole + np.log1p(-np.exp(log_ndtr(lower) - whole))


def extremes(upper, lower, weights):
    """Largest lower and smallest upper bound of the observations with a weight, each (R,)."""
    taken = weights > 0
    return np.where(taken, lower, -np.inf).max(axis=1), np.where(taken, upper, np.inf).min(axis=1)


def kinds(upper, lower, weights):
    """Why the likelihood has no maximum at a finite dispersion above 0, or CURVE, which FLAT may still replace, (R,).

    NEVER and ALWAYS: no run tells the other side. SEPARATED: one intensity parts what exceeds from what does not, so that the
    likelihood grows while the dispersion falls to 0. FLAT: the share that exceeds does not rise with intensity.
    """
    largest_lower, smallest_upper = extremes(upper, lower, weights)
    found = np.full(len(weights), CURVE, dtype="<U9")
    taken = weights > 0
    smallest_lower = np.where(taken & np.isfinite(lower), lower, np.inf).min(axis=1)
    largest_upper = np.where(taken & np.isfinite(upper), upper, -np.inf).max(axis=1)
    between = (taken & np.isfinite(lower) & np.isfinite(upper)).any(axis=1)
    found[(smallest_lower >= largest_upper) & ~between] = FLAT
    found[largest_lower <= smallest_upper] = SEPARATED
    found[np.isinf(largest_lower)] = ALWAYS
    found[np.isinf(smallest_upper)] = NEVER
    return found


class Terms:
    """Observations between bounds `upper`, `lower` (m,) of `of` (m,), the number of a state: states share a slope, and each has an
    intercept. Parameters are (R, 1 + states): slope, intercepts."""

    def __init__(self, upper, lower, of=None):
        of = np.zeros(len(upper), dtype=int) if of is None else of
        members = np.eye(of.max() + 1)[of]
        self.upper, self.lower = upper, lower
        self.designs = up, low = [np.column_stack([np.where(np.isfinite(x), x, 0.0), members]) for x in (upper, lower)]
        mixed = up[:, :, None] * low[:, None]
        self.squares = [each.reshape(len(up), -1) for each in (up[:, :, None] * up[:, None], low[:, :, None] * low[:, None],
                                                               mixed + mixed.transpose(0, 2, 1))]

    def z(self, parameters):
        """Of both bounds, (R, m) each."""
        return (np.where(np.isfinite(x), parameters @ design.T, x) for x, design in zip((self.upper, self.lower), self.designs))

    def value(self, parameters, weights):
        """ln(likelihood), (R,); -inf where the parameters are impossible."""
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            terms = log_probability(*self.z(parameters))
            return np.where(weights > 0, weights * np.nan_to_num(terms, nan=-np.inf, neginf=-np.inf), 0.0).sum(axis=1)

    def gradient_and_curvature(self, parameters, weights):
        """(R, p) and (R, p, p) of the logarithm of the likelihood."""
        upper, lower = self.z(parameters)
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):  # of terms without weight, which may be impossible
            log_p = np.where(weights > 0, log_probability(upper, lower), np.inf) + 0.5 * np.log(2 * np.pi)
        at_upper, at_lower = np.exp(-0.5 * upper**2 - log_p), np.exp(-0.5 * lower**2 - log_p)
        upper, lower = (np.where(np.isfinite(z), z, 0.0) for z in (upper, lower))
        gradient = (weights * at_upper) @ self.designs[0] - (weights * at_lower) @ self.designs[1]
        second = (-upper * at_upper - at_upper**2, lower * at_lower - at_lower**2, at_upper * at_lower)  # by upper, by lower, by both
        curvature = sum((weights * each) @ square for each, square in zip(second, self.squares))
        return gradient, curvature.reshape(len(parameters), *2 * gradient.shape[1:])


def newton(terms, weights, parameters):
    """Parameters (R, p) at which the likelihood of each row of `weights` (R, m) is largest. Steps are halved until it grows."""
    parameters, active = parameters.copy(), np.arange(len(weights))
    value = terms.value(parameters, weights)
    for _ in range(ITERATIONS):
        gradient, curvature = terms.gradient_and_curvature(parameters[active], weights[active])
        step = np.linalg.solve(-curvature, gradient[..., None])[..., 0]
        for _ in range(HALVINGS):
            new = terms.value(parameters[active] + step, weights[active])
            worse = ~(new >= value[active] - ROUNDING * np.abs(value[active]))
            if not worse.any():
                break
            step[worse] /= 2
        step[worse], new[worse] = 0, value[active][worse]
        parameters[active] += step
        value[active] = new
        active = active[np.abs(step).max(axis=1) > SMALLEST_STEP * np.abs(parameters[active]).max(axis=1)]
        if not len(active):
            break
    return parameters


def maximize(upper, lower, weights, of=None):
    """Parameters (R, 1 + states) at which the likelihood of each row of `weights` (R, m) is largest. Each row must have a maximum."""
    finite = np.concatenate([x[np.isfinite(x)] for x in (upper, lower)])
    middle, scale = finite.mean(), finite.std()
    terms = Terms((upper - middle) / scale, (lower - middle) / scale, of)
    start = newton(terms, weights.mean(axis=0, keepdims=True), np.eye(1, terms.designs[0].shape[1]))
    parameters = newton(terms, weights, np.repeat(start, len(weights), axis=0))
    slope = parameters[:, :1] / scale
    return np.hstack([slope, parameters[:, 1:] - middle * slope])


def medians_and_dispersions(upper, lower, weights):
    """(kinds, medians, dispersions, shares), (R,) each.

    Where there is no maximum they are the limit that the likelihood approaches: NEVER and ALWAYS have the median inf and 0 and no
    dispersion (nan); SEPARATED has the dispersion 0 and the middle of the gap on the logarithmic scale; FLAT has an infinite
    dispersion. `shares`: of what exceeds, among observations with one bound.
    """
    found = kinds(upper, lower, weights)
    medians, dispersions = np.full(len(weights), np.nan), np.full(len(weights), np.nan)
    fitted = np.flatnonzero(found == CURVE)
    if len(fitted):
        slope, intercept = maximize(upper, lower, weights[fitted]).T
        found[fitted[slope <= 0]] = FLAT
        rising, slope, intercept = fitted[slope > 0], slope[slope > 0], intercept[slope > 0]
        with np.errstate(over="ignore"):
            medians[rising], dispersions[rising] = np.exp(-intercept / slope), 1 / slope
    separated = found == SEPARATED
    if separated.any():
        medians[separated] = np.exp(np.mean(extremes(upper, lower, weights[separated]), axis=0))
        dispersions[separated] = 0
    shares = weights @ np.isinf(lower) / weights.sum(axis=1)
    dispersions[found == FLAT] = np.inf
    medians[(found == NEVER) | (found == FLAT) & (shares < 0.5)] = np.inf
    medians[(found == ALWAYS) | (found == FLAT) & (shares >= 0.5)] = 0
    return found, medians, dispersions, shares


def normal_scores(intensity, found, medians, dispersions, shares):
    """z of which Phi(z) is the probability of exceedance (R, n), of the curves or limits of `medians_and_dispersions()` at
    intensities (n,)."""
    found = found[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        z = (np.log(intensity) - np.log(medians)[:, None]) / dispersions[:, None]
    z[(found == SEPARATED) & np.isnan(z)] = 0  # at the median itself
    return np.where(found == NEVER, -np.inf, np.where(found == ALWAYS, np.inf, np.where(found == FLAT, ndtri(shares)[:, None], z)))
