"""What runs tell of the capacity of a motion: the intensity at which a damage state is reached."""
from dataclasses import dataclass

import numpy as np

from adit.results.files import Unusable


@dataclass(frozen=True)
class Observations:
    """The capacity of observation i lies in (`lower[i]`, `upper[i]`], which are intensities, 0 or inf. `motion[i]` numbers its ground
    motion from 0; observations of one motion depend on each other. `noun`: what an observation is."""
    motion: np.ndarray
    lower: np.ndarray
    upper: np.ndarray
    noun: str

    def __len__(self):
        return len(self.motion)

    @property
    def motions(self):
        return int(self.motion.max()) + 1

    def merged(self):
        """(ln(upper), ln(lower), counts): the different bounds (m,), and how often each motion has them (motions, m)."""
        bounds, number = np.unique(np.column_stack([self.upper, self.lower]), axis=0, return_inverse=True)
        counts = np.zeros((self.motions, len(bounds)))
        np.add.at(counts, (self.motion, number), 1)
        with np.errstate(divide="ignore"):
            return (*np.log(bounds).T, counts)


DIGITS = 10  # of intensities: levels that differ by rounding are one, and no gap or overlap of bounds


def checked(motion, intensity, exceeded):
    """The columns as arrays, motions as numbers from 0."""
    motion, exceeded = np.asarray(motion), np.asarray(exceeded, dtype=bool)
    intensity = np.array([float(f"{each:.{DIGITS}g}") for each in np.asarray(intensity, dtype=float)])
    if not len(motion):
        raise Unusable("No run is left for a fragility curve: compute the study first.")
    wrong = np.flatnonzero(~((intensity > 0) & np.isfinite(intensity)))
    if len(wrong):
        raise Unusable(f"Motion {motion[wrong[0]]} has the intensity {intensity[wrong[0]]:g}, but a fragility curve needs intensities "
                       "above 0: leave this motion out.")
    return np.unique(motion, return_inverse=True)[1], intensity, exceeded


def of_runs(motion, intensity, exceeded):
    """Each run for itself, as in stripes and clouds: it exceeds the state at its intensity or does not. Columns (n,)."""
    motion, intensity, exceeded = checked(motion, intensity, exceeded)
    return Observations(motion, np.where(exceeded, 0.0, intensity), np.where(exceeded, intensity, np.inf), "runs")


def of_climbs(motion, intensity, exceeded, sample=None):
    """Motions that climb from level to level: the capacity lies above the last level before the first that exceeds the state, and up
    to that one (the first exceedance counts, as in Vamvatsikos and Cornell 2002, Earthq. Eng. Struct. Dyn. 31:491), or above the last
    level. Columns (n,) of runs in any order; `sample` (n,): number of the sample, where a motion climbs more than once."""
    motion, intensity, exceeded = checked(motion, intensity, exceeded)
    sample = np.zeros(len(motion)) if sample is None else np.asarray(sample)
    climbs, climb = np.unique(np.column_stack([motion, sample]), axis=0, return_inverse=True)
    upper = np.full(len(climbs), np.inf)
    np.minimum.at(upper, climb[exceeded], intensity[exceeded])
    below = intensity < upper[climb]
    lower = np.zeros(len(climbs))
    np.maximum.at(lower, climb[below], intensity[below])
    return Observations(climbs[:, 0].astype(int), lower, upper, "climbs")
