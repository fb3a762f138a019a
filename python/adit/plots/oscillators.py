"""Response spectra of motions for which the run wrote none."""
import numpy as np

DAMPING = 0.05
PERIODS = np.geomspace(0.05, 5, 80)  # [s]
FINER = 4  # times as many values as the motion has, so that peaks between its values are found
ROWS = 10  # in the shortest period: second differences of a displacement then lose 3 % of its acceleration


def pseudo_acceleration(acceleration, interval, periods, damping=DAMPING):
    """Largest displacement of oscillators of these periods [s] on a base of this acceleration, times the square of their circular
    frequency [m/s²]. Between its values the acceleration is band-limited; it is followed by rest until oscillators are calm."""
    calm = int(5 * max(periods) / (2 * np.pi * damping) / interval)
    count = len(acceleration) + calm
    base, w = np.fft.rfft(acceleration, count), 2 * np.pi * np.fft.rfftfreq(count, interval)
    own = (2 * np.pi / np.asarray(periods))[:, None]
    moved = FINER * np.fft.irfft(-base / (own**2 - w**2 + 2j * damping * own * w), FINER * count, axis=1)
    return own[:, 0]**2 * np.abs(moved).max(axis=1)


def of_displacement(displacement, interval):
    """(periods [s], pseudo accelerations [m/s²]) of a place that moves so [m]; periods with fewer than ROWS rows are left out."""
    acceleration = np.diff(displacement, 2) / interval**2
    periods = PERIODS[PERIODS >= ROWS * interval]
    return periods, pseudo_acceleration(acceleration, interval, periods)
