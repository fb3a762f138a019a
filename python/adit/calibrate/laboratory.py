"""Laboratory tests on a random packing of cemented discs: uniaxial compression between platens, and a Brazilian test.

SI, per metre of thickness. The packing is grown under a stress that is a fixed share of the contacts' stiffness, so that
it is the same whatever the micro-properties; the tests' durations follow from strength over stiffness.
"""
from dataclasses import dataclass, replace
from functools import partial
from math import pi
from pathlib import Path
from statistics import mean

import numpy as np

from adit.runs import coupled_runs


@dataclass(frozen=True)
class Micro:
    """Contacts and cement share a modulus and a ratio of stiffnesses (Potyondy and Cundall 2004)."""
    modulus: float  # [Pa]: the contacts' normal stiffness per metre of thickness
    stiffness_ratio: float  # normal over shear
    tensile_strength: float  # tensile strength of the cement [Pa]; infinite if it cannot break
    cohesion: float  # cohesion of the cement [Pa]
    friction: float = 0.5  # friction coefficient of the contacts


@dataclass(frozen=True)
class Specimen:
    width: float = 0.05  # [m]
    height: float = 0.1
    radius_min: float = 0.56e-3
    radius_max: float = 0.93e-3  # 1.66 times the smallest
    density: float = 2630.0
    seed: int = 1

    @property
    def mean_radius(self):
        return (self.radius_min + self.radius_max) / 2

    @property
    def disc_radius(self):
        """Radius of the Brazilian disc that is cut out of the middle."""
        return 0.46 * self.width


LAC_DU_BONNET = Micro(62e9, 2.5, 157e6, 157e6)  # from Potyondy and Cundall (2004), without the scatter of strengths
PLATEN_SPEED = 2e-5  # share of sqrt(modulus / density)
GAUGES = 9  # displacements in a row


def _four_digits(value):
    return float(f"{value:.4g}")


def bonds_and_contacts(micro, specimen):
    """The part of a scene's `particles` that gives the micro-properties."""
    digits = _four_digits
    cement = micro.modulus / (2 * specimen.mean_radius)
    parallel = {"normal_stiffness": digits(cement), "shear_stiffness": digits(cement / micro.stiffness_ratio)}
    if np.isfinite(micro.tensile_strength):
        parallel |= {"tensile_strength": digits(micro.tensile_strength), "cohesion": digits(micro.cohesion)}
    return {"bonds": {"parallel": parallel},
            "contacts": {"normal_stiffness": digits(micro.modulus),
                         "shear_stiffness": digits(micro.modulus / micro.stiffness_ratio), "friction": micro.friction}}


def _particles(micro, specimen):
    return {"random_packing": {
                "x_min": 0, "x_max": specimen.width, "y_min": 0, "y_max": specimen.height,
                "radius_min": specimen.radius_min, "radius_max": specimen.radius_max, "seed": specimen.seed,
                # The ratio of stress to stiffness must be the same to the bit; otherwise discs come to rest elsewhere.
                "stress": 3 * _four_digits(micro.modulus) / 10000},
            **bonds_and_contacts(micro, specimen), "damping": {"local": 0.7}}


def _scene(micro, specimen, platens, shortening):
    """The scene of a test in which the platens, lower and upper (y, half width), approach by a length [m]."""
    speed = PLATEN_SPEED * np.sqrt(micro.modulus / specimen.density)
    ramp = 0.05 * shortening / speed
    duration = shortening / speed + ramp / 2
    middle = specimen.width / 2
    particles = _particles(micro, specimen)
    particles["walls"] = [
        {"name": name, "from": {"x": middle - half, "y": y}, "to": {"x": middle + half, "y": y},
         "contacts": {"friction": 0},
         "velocity": {"y": towards * speed / 2, "time": {"table": {"time": [0, ramp], "value": [0, 1]}}}}
        for name, towards, (y, half) in (("lower", 1, platens[0]), ("upper", -1, platens[1]))]
    particles["histories"] = [{"name": name, "quantity": "force_y", "wall": name} for name in ("lower", "upper")]
    return {
        "plane": "plane_strain",
        "material": {"young_modulus": micro.modulus, "poisson_ratio": 0.2, "density": specimen.density},
        "time": {"duration": duration, "dt_factor": 0.8},
        "output": {"history_interval": duration / 1000, "field_times": [0]},
        "particles": particles}


def _platens_at_the_ends(specimen):
    return [(0, specimen.width), (specimen.height, specimen.width)]


def _gauges(specimen, packing):
    """{row: numbers of the discs nearest to its places}: two rows across, two rows along the specimen."""
    w, h = specimen.width, specimen.height
    across, along = np.linspace(0.1, 0.9, GAUGES) * w, np.linspace(0.3, 0.7, GAUGES) * h
    rows = {"bottom": [(x, 0.2 * h) for x in across], "top": [(x, 0.8 * h) for x in across],
            "left": [(0.1 * w, y) for y in along], "right": [(0.9 * w, y) for y in along]}
    points, _ = packing
    return {row: [int(np.argmin(np.hypot(*(points - place).T))) for place in places] for row, places in rows.items()}


def compression_scene(micro, specimen, packing, largest_strain):
    scene = _scene(micro, specimen, _platens_at_the_ends(specimen), largest_strain * specimen.height)
    points, _ = packing
    scene["particles"]["histories"] += [
        {"name": f"{row}_{k}", "quantity": "displacement_y" if row in ("bottom", "top") else "displacement_x",
         "at": {"x": points[disc, 0], "y": points[disc, 1]}}
        for row, discs in _gauges(specimen, packing).items() for k, disc in enumerate(discs)]
    return scene


def brazilian_scene(micro, specimen, packing, shortening):
    """`packing`: (points, radii) [m]. Each platen begins at the rim of the third of the outermost grains."""
    x, y, r = specimen.width / 2, specimen.height / 2, specimen.disc_radius
    points, radius = packing
    inside = np.hypot(points[:, 0] - x, points[:, 1] - y) <= r
    lower = np.sort((points[:, 1] - radius)[inside])[2]
    upper = np.sort((points[:, 1] + radius)[inside])[-3]
    scene = _scene(micro, specimen, [(lower, r), (upper, r)], shortening)
    scene["particles"]["within"] = {"circle": {"centre": {"x": x, "y": y}, "radius": r}}
    return scene


@dataclass
class Loading:
    """The measurements of a test, row by row."""
    run: object
    approach: np.ndarray  # approach of the platens [m]
    stress: np.ndarray  # compressive stress, or in the Brazilian test the tension at the centre [Pa]
    axial: np.ndarray = None  # strains, shortening positive
    lateral: np.ndarray = None  # widening positive

    @property
    def peak(self):
        return int(np.argmax(self.stress))

    @property
    def strength(self):
        return self.stress[self.peak]

    def slope(self, of, over):
        """Slope of one curve over another between a fifth and a half of the strength, by least squares."""
        rows = slice(np.argmax(self.stress >= 0.2 * self.strength), np.argmax(self.stress >= 0.5 * self.strength) + 1)
        return np.polyfit(over[rows], of[rows], 1)[0]

    def elastic_constants(self):
        """Young's modulus and Poisson's ratio of the solid that has these strains in plane strain."""
        in_plane = self.slope(self.lateral, self.axial)
        poisson_ratio = in_plane / (1 + in_plane)
        return self.slope(self.stress, self.axial) * (1 - poisson_ratio**2), poisson_ratio


def _platens(run, scene):
    """(approach [m], force [N]) of the platens, row by row."""
    time = run.histories["time_s"]
    speed = 2 * scene["particles"]["walls"][0]["velocity"]["y"]
    ramp = scene["particles"]["walls"][0]["velocity"]["time"]["table"]["time"][1]
    approach = speed * np.where(time < ramp, time**2 / (2 * ramp), time - ramp / 2)
    return approach, (run.histories["upper_fy_N"] - run.histories["lower_fy_N"]) / 2


def grow(specimen, folder):
    """(points, radii) [m] of the packing that all tests of a specimen share."""
    scene = _scene(LAC_DU_BONNET, specimen, _platens_at_the_ends(specimen), 1e-9)
    _, pieces = next(coupled_runs.run(scene, folder).snapshots())
    return pieces["particles"].points, pieces["particles"].field("radius_m")


def compress(micro, specimen, packing, folder, largest_strain):
    scene = compression_scene(micro, specimen, packing, largest_strain)
    run = coupled_runs.run(scene, folder)
    approach, force = _platens(run, scene)
    gauges = _gauges(specimen, packing)

    def strain(low, high, axis):
        """Difference of the mean displacements of two rows, divided by their mean distance."""
        low_u, high_u = (np.mean([run.histories[f"{row}_{k}_u{'xy'[axis]}_m"] for k in range(GAUGES)], axis=0)
                         for row in (low, high))
        return (high_u - low_u) / (packing[0][gauges[high], axis] - packing[0][gauges[low], axis]).mean()

    return Loading(run, approach, force / specimen.width, -strain("bottom", "top", 1), strain("left", "right", 0))


def split(micro, specimen, packing, folder, shortening):
    """The Brazilian test: tension 2 P / (pi D) at the centre (ISRM 1978)."""
    scene = brazilian_scene(micro, specimen, packing, shortening)
    run = coupled_runs.run(scene, folder)
    approach, force = _platens(run, scene)
    return Loading(run, approach, force / (pi * specimen.disc_radius))


@dataclass
class Rock:
    """The laboratory tests of a rock."""
    compression: Loading
    brazilian: Loading

    def properties(self):
        young_modulus, poisson_ratio = self.compression.elastic_constants()
        return {"young_modulus_Pa": young_modulus, "poisson_ratio": poisson_ratio,
                "uniaxial_compressive_strength_Pa": self.compression.strength,
                "brazilian_tensile_strength_Pa": self.brazilian.strength}


def _to_failure(test, shortening):
    """Repeats test(shortening), each time with twice the shortening, until the load has fallen by a third."""
    for doublings in range(4):
        loading = test(2**doublings * shortening)
        if loading.stress[-1] < 2 / 3 * loading.strength:
            return loading
    raise coupled_runs.Failed(f"{loading.run.folder}: the specimen does not break")


def test(micro, specimen, packing, folder):
    """Both tests, to failure."""
    strain = micro.tensile_strength / micro.modulus
    tests = {
        "compression": lambda at: _to_failure(partial(compress, micro, specimen, packing, at), 1.5 * strain),
        "brazilian": lambda at: _to_failure(partial(split, micro, specimen, packing, at),
                                            6 * strain * specimen.disc_radius)}
    return Rock(**dict(coupled_runs.for_all(lambda name: tests[name](folder / name), tests)))


@dataclass
class Laboratory:
    """Specimens of one kind that differ in their seeds, with their packings."""
    specimens: dict  # seed: (Specimen, packing)
    folder: Path

    @staticmethod
    def grown(specimen, seeds, folder):
        specimens = {seed: replace(specimen, seed=seed) for seed in range(1, seeds + 1)}
        packings = dict(coupled_runs.for_all(lambda seed: grow(specimens[seed], folder / f"packing_{seed}"), specimens))
        return Laboratory({seed: (specimens[seed], packings[seed]) for seed in specimens}, folder)

    def _all(self, test, name):
        """[test(specimen, packing, folder)] for all seeds."""
        done = dict(coupled_runs.for_all(
            lambda seed: test(*self.specimens[seed], self.folder / f"{name}_{seed}"), self.specimens))
        return [done[seed] for seed in self.specimens]

    def test(self, micro, name):
        """[Rock] for all seeds."""
        return self._all(partial(test, micro), name)

    def elastic_constants(self, micro, largest_strain, name):
        """Means over all seeds, from compression alone."""
        tested = self._all(partial(compress, micro, largest_strain=largest_strain), name)
        return map(mean, zip(*(loading.elastic_constants() for loading in tested)))


def mean_properties(rocks):
    return {name: mean(rock.properties()[name] for rock in rocks) for name in rocks[0].properties()}
