"""The path of a crack by linear elastic fracture mechanics: displacement discontinuities of constant strength (Crouch and Starfield 1983,
Boundary Element Methods in Solid Mechanics) along the outline of a plate and its crack, which grows where the hoop stress around its
tip is largest (Erdogan and Sih 1963, J. Basic Eng. 85, 519). Places are complex numbers x + iy [m]."""
import numpy as np

POISSON_RATIO = 0.2  # of no effect on the path of a crack in a plate that is loaded along its outline (Michell)


def tractions(points, normals, starts, ends):
    """Stresses across and along faces at `points` by discontinuities across and along the elements, over twice the shear modulus:
    a matrix of twice as many rows as points, and of twice as many columns as elements [1/m]."""
    half = np.abs(ends - starts) / 2
    along = (ends - starts) / (2 * half)
    place = (points[:, None] - (starts + ends) / 2) / along
    left, right, y = place.real - half, place.real + half, place.imag
    left_2, right_2 = left**2 + y**2, right**2 + y**2
    # derivatives of Crouch's potential
    f_xy = y / left_2 - y / right_2
    f_yy = right / right_2 - left / left_2
    f_xyy = (left**2 - y**2) / left_2**2 - (right**2 - y**2) / right_2**2
    f_yyy = 2 * y * (left / left_2**2 - right / right_2**2)
    turn = normals[:, None] / along
    cosine, sine = turn.real, turn.imag

    def on_faces(xx, yy, xy):
        return (xx * cosine**2 + 2 * xy * cosine * sine + yy * sine**2,
                (yy - xx) * cosine * sine + xy * (cosine**2 - sine**2))

    across = on_faces(f_yy + y * f_yyy, f_yy - y * f_yyy, -y * f_xyy)
    slip = on_faces(2 * f_xy + y * f_xyy, -y * f_xyy, f_yy + y * f_yyy)
    return np.block([[across[0], slip[0]], [across[1], slip[1]]]) / (4 * np.pi * (1 - POISSON_RATIO))


def turning(opening, slip):
    """By how much a crack turns to the left that opens and slips like this at its tip [rad]; slip: of its left face ahead."""
    return 0.0 if slip == 0 else 2 * np.arctan((opening - np.hypot(opening, np.sqrt(8) * slip)) / (4 * slip))


def cut(corners, size):
    """Points along a line with these corners, about `size` apart."""
    parts = [start + (end - start) * np.arange(1, max(1, round(abs(end - start) / size)) + 1) / max(1, round(abs(end - start) / size))
             for start, end in zip(corners[:-1], corners[1:])]
    return np.concatenate([[corners[0]], *parts])


def discontinuities(starts, ends, stress, outer):
    """(opening, slip) of elements, times twice the shear modulus, that give these normal stresses on them and no shear stress;
    the first `outer` elements are the outline of the plate, whose motion as a whole nothing resists."""
    points, along = (starts + ends) / 2, (ends - starts) / np.abs(ends - starts)
    of_outline = np.arange(len(points)) < outer
    motions = [of_outline * motion / along for motion in (1, 1j, 1j * (points - points[:outer].mean()))]
    rigid = np.array([[*motion.imag, *motion.real] for motion in motions]).T
    matrix = np.block([[tractions(points, 1j * along, starts, ends), rigid], [rigid.T, np.zeros((3, 3))]])
    found = np.linalg.solve(matrix, [*stress, *np.zeros(len(points) + 3)])
    return -found[:len(points)], -found[len(points):2 * len(points)]


def crack_path(outline, pressure, notch, size, length):
    """Points of the crack that grows from the tip of a notch.
    outline: corners of the plate, closed; pressure: of places on it, in balance; notch: its mouth and its tip; size: of the elements;
    length: of the crack. All lengths in one unit, and pressures in another."""
    edge, crack = cut(outline, size), list(cut(notch, size))
    first, outer = len(crack) - 1, len(edge) - 1
    for _ in range(round(length / size)):
        starts, ends = np.array([*edge[:-1], *crack[:-1]]), np.array([*edge[1:], *crack[1:]])
        middles = (starts + ends)[:outer] / 2
        opening, slip = discontinuities(starts, ends, [*-pressure(middles), *np.zeros(len(crack) - 1)], outer)
        ahead = crack[-1] - crack[-2]
        crack.append(crack[-1] + size * ahead / abs(ahead) * np.exp(1j * turning(opening[-1], slip[-1])))
    return np.array(crack[first:])


def distances(places, path):
    """Of places from a path [as given]."""
    start, way = path[:-1], np.diff(path)
    along = np.clip(((places[:, None] - start) * way.conj()).real / np.abs(way)**2, 0, 1)
    return np.abs(places[:, None] - start - along * way).min(axis=1)
