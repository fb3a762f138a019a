"""Cloud analysis: the answer itself over intensity, which tells a curve even where few runs reach the threshold.

ln(answer) = a + b ln(intensity) + error (Cornell et al. 2002, J. Struct. Eng. 128:526): the median of a state above a threshold is
(threshold / exp(a))^(1 / b), and its dispersion the deviation of the error over b.
"""
from dataclasses import dataclass

import numpy as np
from scipy.optimize import minimize_scalar

from adit.results.files import Unusable
from adit.study.fragility import likelihood
from adit.study.fragility.bootstrap import RESAMPLES, SEED, Bootstrap, draws
from adit.study.fragility.curves import Curve
from adit.study.fragility.observations import checked


@dataclass(frozen=True)
class Parts:
    """The dispersion that motions have among each other, and what is left within a motion: random ground, seeds, and what intensity
    does not tell."""
    between: float
    within: float


@dataclass(frozen=True)
class Cloud:
    """A regression of ln(answer) over ln(intensity). `motion`, `x`, `y` (n,): numbers of motions, and the logarithms. `r2`: share of the
    variance of y that it tells."""
    motion: np.ndarray
    x: np.ndarray
    y: np.ndarray
    intercept: float
    slope: float
    deviation: float
    r2: float

    def curve(self, threshold):
        """Of the state `answer > threshold`; None where answers do not grow with intensity."""
        if self.slope <= 0:
            return None
        return Curve(float(np.exp((np.log(threshold) - self.intercept) / self.slope)), self.deviation / self.slope)

    def bootstrap(self, threshold, resamples=RESAMPLES, seed=SEED):
        """The Bootstrap of `curve(threshold)`."""
        motions = int(self.motion.max()) + 1
        weights = draws(motions, resamples, seed)[:, self.motion]
        intercept, slope, deviation = least_squares(self.x, self.y, weights)
        kinds = np.where(slope > 0, likelihood.CURVE, likelihood.FLAT)
        shares = weights @ (self.y > np.log(threshold)) / weights.sum(axis=1)
        with np.errstate(divide="ignore", over="ignore"):
            medians = np.where(slope > 0, np.exp((np.log(threshold) - intercept) / slope), np.where(shares < 0.5, np.inf, 0))
        return Bootstrap(self.curve(threshold), motions, kinds, medians, np.where(slope > 0, deviation / slope, np.inf), shares)

    def parts(self):
        """The Parts of the dispersion, by restricted maximum likelihood with a random effect of the motion (Patterson and Thompson 1971,
        Biometrika 58:545); None where no motion has several runs, or answers do not grow with intensity."""
        sizes = np.bincount(self.motion)
        if sizes.max() < 2 or len(sizes) < 2:
            return None

        def effect(share):
            """(-ln(likelihood), variance within, slope) if `share` of the variance is that between motions."""
            ratio = share / (1 - share)
            pulled = (1 - 1 / np.sqrt(1 + sizes * ratio))[self.motion]  # of each motion's mean: what is left is independent

            def independent(values):
                return values - pulled * (np.bincount(self.motion, values) / sizes)[self.motion]
            design = np.column_stack([independent(np.ones_like(self.x)), independent(self.x)])
            solution, (squares,), *_ = np.linalg.lstsq(design, independent(self.y), rcond=None)
            free = len(self.x) - 2
            logarithm = free * np.log(squares) + np.log1p(sizes * ratio).sum() + np.linalg.slogdet(design.T @ design)[1]
            return logarithm / 2, squares / free, solution[1]
        share = minimize_scalar(lambda each: effect(each)[0], bounds=(0, 1 - 1e-9), method="bounded", options={"xatol": 1e-9}).x
        _, variance, slope = effect(share)
        return Parts(float(np.sqrt(variance * share / (1 - share)) / slope), float(np.sqrt(variance) / slope)) if slope > 0 else None


def least_squares(x, y, weights):
    """(intercept, slope, deviation), (R,) each, of weighted regressions with weights (R, n)."""
    total = weights.sum(axis=1)
    mean_x, mean_y = weights @ x / total, weights @ y / total
    dx, dy = x - mean_x[:, None], y - mean_y[:, None]
    slope = (weights * dx * dy).sum(axis=1) / (weights * dx**2).sum(axis=1)
    residual = dy - slope[:, None] * dx
    return mean_y - slope * mean_x, slope, np.sqrt((weights * residual**2).sum(axis=1) / (total - 2))


def regression(motion, intensity, answer):
    """The Cloud of runs, columns (n,). Unusable if an answer is not above 0, or fewer than three runs or one intensity are left."""
    motion, intensity, _ = checked(motion, intensity, np.zeros(len(motion)))
    answer = np.asarray(answer, dtype=float)
    if not (answer > 0).all():
        raise Unusable(f"An answer is {answer[~(answer > 0)][0]:g}, but the regression of a cloud takes "
                       "logarithms: its answers must be above 0.")
    if len(answer) < 3 or np.ptp(intensity) == 0:
        raise Unusable("The regression of a cloud needs three runs or more at different intensities: add motions.")
    x, y = np.log(intensity), np.log(answer)
    (intercept,), (slope,), (deviation,) = least_squares(x, y, np.ones((1, len(x))))
    r2 = 1 - deviation**2 * (len(x) - 2) / (y.var() * len(x)) if np.ptp(y) else 1.0
    return Cloud(motion, x, y, float(intercept), float(slope), float(deviation), float(r2))
