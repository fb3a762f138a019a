"""Specimens of cases/laboratory: their scenes for other cells and materials, and what a laboratory measures on them."""
import math
from dataclasses import dataclass

import numpy as np

from adit import programs
from adit.runs import coupled_runs

CASE = programs.ROOT / "cases" / "laboratory"
WIDTH, HEIGHT = 0.1, 0.2  # of the specimen [m]
DISC, FLAT = 0.15, 0.9588  # diameter of the disc [m]; by which flats of 20 degrees reduce the stress (Wang et al. 2004)
SPAN, NOTCH = 4, 1 / 3  # of the beam, over its depth
PLATEN, PRESS = 0.02, 0.01  # speed of the platen that crushes, and of the press on the beam [m/s]
JACKET, PRESSED = 1e9, 0.004  # Young's modulus of the jackets [Pa]; when the walls beside them stop [s]
SINKS = 0.02  # by which the walls sink into the jackets, over the size of their cells
BURSTS = 0.3  # of the critical time step: pieces of what bursts touch where nothing touched
ALIKE = 12  # depth of beams of other depths, over the size of their cells


@dataclass(frozen=True)
class Cells:
    size: float  # [m]
    seed: int

    def given(self, **box):
        return {"size": self.size, "seed": self.seed, **box}

    def __str__(self):
        return f"{1000 * self.size:g}mm_{self.seed}"


@dataclass(frozen=True)
class Material:
    name: str
    young_modulus: float  # [Pa]
    poisson_ratio: float
    density: float  # [kg/m^3]
    tensile_strength: float  # [Pa]
    compressive_strength: float  # [Pa]
    fracture_energy: float  # [N/m]
    shearing_energy: float  # [N/m]
    pressures: tuple  # on the sides of specimens that are crushed [Pa]
    slope: float = (1 + math.sin(math.radians(15))) / (1 - math.sin(math.radians(15)))  # of the strength over the pressure

    def given(self):
        fracture = {name: getattr(self, name) for name in (
            "tensile_strength", "compressive_strength", "fracture_energy", "shearing_energy")}
        return {"young_modulus": self.young_modulus, "poisson_ratio": self.poisson_ratio, "density": self.density,
                "fracture": fracture}

    def tests(self):
        return ["tension", "splitting", *self.pressures]


CONCRETE = Material("concrete", 30e9, 0.2, 2400, 2.5e6, 39e6, 100, 300, (0, 5e6, 10e6))
# Lac du Bonnet granite; README.md has the sources.
GRANITE = Material("granite", 69e9, 0.26, 2630, 6.9e6, 200e6, 44, 10e3, (0, 20e6, 40e6))


@dataclass(frozen=True)
class Strength:
    """A strength in `test`: tension, splitting, or compression under about this pressure [Pa]."""
    material: Material
    test: object
    cells: Cells
    HEAD = ("material", "test", "size_m", "seed", "strength_Pa", "pressure_Pa")

    def row(self):
        return self.material.name, self.test, self.cells.size, self.cells.seed

    def __str__(self):
        test = self.test if isinstance(self.test, str) else f"compression_{self.test / 1e6:g}MPa"
        return f"{self.material.name}_{test}_{self.cells}"

    def measure(self, folder):
        """The strength, and the pressure on the sides under which it was reached [Pa]."""
        scene, seconds, particles = self._plan()
        run = coupled_runs.run({"extends": str(CASE / f"{scene}.yaml"), "material": self.material.given(),
                                "time": {"duration": seconds, "dt_factor": BURSTS}, "particles": particles,
                                "output": {"history_interval": seconds / 1000, "field_times": None}}, folder / str(self))
        force = run.histories["force_thrust_N"]
        if self.test == "tension":
            return force.max() / WIDTH, 0
        if self.test == "splitting":
            return FLAT * 2 * -force[_first_peak(-force)] / (np.pi * DISC), 0
        peak = _first_peak(-force)
        return -force[peak] / WIDTH, -run.histories["side_fx_N"][peak] / HEIGHT if self.test else 0

    def _plan(self):
        """(scene, duration [s], changes of its particles)"""
        if self.test == "tension":
            return "tension", 0.018, _specimen(self.cells)
        if self.test == "splitting":
            return "brazilian", 0.024, {"cells": self.cells.given()}
        # Somewhat beyond the stated strength, but not far into the burst of rock.
        stress = 1.1 * self.material.compressive_strength + 1.5 * self.material.slope * self.test
        return "confined", stress / self.material.young_modulus * HEIGHT / PLATEN, self._pressed()

    def _pressed(self):
        """Jackets two cells thick are pressed by walls, which are so stiff that these sink in by SINKS."""
        size = self.cells.size
        jacket, sinks = 2 * size, SINKS * size
        particles = _specimen(self.cells, x_min=-jacket, x_max=WIDTH + jacket)
        if not self.test:
            return {**particles, "walls": [], "histories": [{"name": "force", "quantity": "thrust", "section": "middle"}]}
        stiffness = self.test / sinks * size / math.sqrt(3)  # of a side
        speed = (sinks + self.test * jacket / JACKET) / PRESSED
        stops = {"table": {"time": [0, PRESSED, PRESSED + 1e-5], "value": [1, 1, 0]}}
        return {**particles, "walls": [
            {"name": name, "from": {"x": x, "y": 0}, "to": {"x": x, "y": HEIGHT}, "velocity": {"x": sign * speed, "time": stops},
             "contacts": {"normal_stiffness": stiffness, "shear_stiffness": stiffness / 10, "friction": 0}}
            for name, x, sign in (("left", -jacket, 1), ("right", WIDTH + jacket, -1))]}


def _first_peak(force):
    """Where it is largest before it first falls by a tenth: halves of a disc, and what a jacket holds, may bear more later."""
    largest = np.maximum.accumulate(force)
    fallen = (force < 0.9 * largest) & (largest > 0.1 * largest[-1])
    return force[:fallen.argmax() if fallen.any() else None].argmax()


def _specimen(cells, **sides):
    """Cells of the specimen and of platens that are at least one cell high."""
    height = max(cells.size, 0.01)
    return {"cells": cells.given(y_min=-height, y_max=HEIGHT + height, **sides)}


def strengths(material, measured):
    """Lines of a table: means over the packings of each size, and their range, over what is stated."""
    sizes = sorted({test.cells.size for test in measured}, reverse=True)
    yield f"{material.name:24}" + "".join(f"{1000 * size:g} mm".rjust(24) for size in sizes)

    def of(test, size):
        return np.array([values for one, values in measured.items() if one.test == test and one.cells.size == size]).T

    def slope(size):
        strength, pressure = of(material.pressures[-1], size)
        return (strength - of(0, size)[0]) / pressure

    def line(what, values):
        return f"{what:24}" + "".join(f"{v.mean():8.3f} ({v.min():.3f}-{v.max():.3f})".rjust(24) for v in values)

    yield line("tension / stated", [of("tension", size)[0] / material.tensile_strength for size in sizes])
    yield line("splitting / tension", [of("splitting", size)[0] / of("tension", size)[0] for size in sizes])
    yield line("crushing / stated", [of(0, size)[0] / material.compressive_strength for size in sizes])
    yield line("slope", [slope(size) for size in sizes]) + f"{material.slope:10.3f} stated"


@dataclass(frozen=True)
class Beam:
    """`led`: whether edges of cells follow the line above the notch, so that the notch ends exactly and the crack is straight."""
    depth: float  # [m]
    cells: Cells
    led: bool
    HEAD = ("depth_m", "size_m", "seed", "led", "load_N_per_m", "work_over_energy")

    def row(self):
        return self.depth, self.cells.size, self.cells.seed, int(self.led)

    def __str__(self):
        return f"beam_{1000 * self.depth:g}mm_{self.cells}{'_led' if self.led else ''}"

    def measure(self, folder):
        """The largest load [N/m]; the work of the press, over the fracture energy of the ligament."""
        run = coupled_runs.run({"extends": str(CASE / "beam.yaml"), "time": {"duration": self.depth / 300 / PRESS},
                                "particles": self._scene(), "output": {"history_interval": 4e-5, "field_times": None}},
                               folder / str(self))
        load, path = 2 * np.abs(run.histories["left_shear_N"]), -run.histories["press_uy_m"]
        return load.max(), np.trapz(load, path) / (CONCRETE.fracture_energy * (1 - NOTCH) * self.depth)

    def _scene(self):
        """Blocks are as wide as a cell."""
        half, block = SPAN * self.depth / 2, self.cells.size
        places = {"left_bearing": (-half, {"y_max": block}), "right_bearing": (half, {"y_max": block}),
                  "press": (0, {"y_min": self.depth - block})}
        blocks = {name: {"x_min": x - block / 2, "x_max": x + block / 2, **y} for name, (x, y) in places.items()}
        tip, under_press = {"x": 0, "y": NOTCH * self.depth}, {"x": 0, "y": self.depth - block}
        notch = {"name": "notch", "from": {"x": 0, "y": 0}, "to": tip, "open": True}
        ligament = {"from": tip, "to": under_press, "bonds": {}}
        return {
            "cells": self.cells.given(x_min=-1.125 * half, x_max=1.125 * half, y_min=0, y_max=self.depth),
            "groups": [{"name": name, "where": where} for name, where in blocks.items()],
            "joints": [notch, ligament] if self.led else [notch],
            "motions": [{"where": where, "velocity": {"y": -PRESS if name == "press" else 0}} for name, where in blocks.items()],
            "sections": [{"name": "left", "from": {"x": -half / 2, "y": 0}, "to": {"x": -half / 2, "y": self.depth}}],
            "histories": [{"name": "press", "quantity": "displacement_y", "at": {"x": 0, "y": self.depth - block / 2}},
                          {"name": "left", "quantity": "shear_force", "section": "left"}]}


def beams(cells):
    """The beam of 120 mm with up to three packings of each size, its crack led and not, and alike beams of other depths."""
    few = [one for one in cells if one.seed <= 3]
    return [*(Beam(0.12, one, led) for one in few for led in (True, False)),
            *(Beam(depth, Cells(depth / ALIKE, seed), True) for depth in (0.06, 0.24) for seed in sorted({one.seed for one in few}))]


def elastic_fracture(depth, energy):
    """The load at which a crack from the notch would run by linear fracture mechanics with this energy [N/m] (Srawley 1976)."""
    a = NOTCH
    shape = 3 * math.sqrt(a) * (1.99 - a * (1 - a) * (2.15 - 3.93 * a + 2.7 * a**2)) / (2 * (1 + 2 * a) * (1 - a)**1.5)
    return math.sqrt(CONCRETE.young_modulus * energy * depth) / (SPAN * shape)


def loads(measured):
    """Lines of a table of the beams, and Bazant's law through the loads of those whose crack is led."""
    groups = {}
    for beam, values in measured.items():
        groups.setdefault((beam.depth, beam.cells.size, beam.led), []).append(values)
    yield f"{'depth':>8}{'cells':>8}{'crack':>7}{'load':>13}{'range':>15}{'over depth':>12}{'work':>6}{'linear fracture mechanics':>27}"
    for (depth, size, led), values in sorted(groups.items()):
        load, work = np.array(values).T
        yield (f"{1000 * depth:5g} mm{1000 * size:5g} mm{'led' if led else 'free':>7}{load.mean() / 1e3:8.1f} kN/m"
               f"{load.min() / 1e3:8.1f} - {load.max() / 1e3:4.1f}{load.mean() / depth / 1e6:8.3f} MPa{work.mean():6.2f}"
               f"{elastic_fracture(depth, CONCRETE.fracture_energy) / 1e3:22.0f} kN/m")
    alike = {depth: np.mean([load for load, _ in values]) for (depth, size, led), values in sorted(groups.items())
             if math.isclose(depth, ALIKE * size) and led}
    if len(alike) < 3:
        return
    depth, load = np.array(list(alike)), np.array(list(alike.values()))
    slope, start = np.polyfit(depth, (depth / load)**2, 1)  # 1 / (load / depth)^2 = start + slope depth
    law = depth / np.sqrt(start + slope * depth)
    yield (f"Bazant: load / depth = {1e-6 / math.sqrt(start):.3f} MPa / sqrt(1 + depth / {start / slope:.3f} m), within "
           f"{100 * np.abs(load / law - 1).max():.1f} %; fracture energy of large beams {1 / slope / elastic_fracture(1, 1)**2:.0f} N/m")
