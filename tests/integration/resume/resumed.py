"""Scenes whose states hold, between them, all that changes from step to step; runs that end before their end; what makes
two runs the same."""

import json
import signal
import subprocess
import time

from programs import COUPLER, PATIENCE_S, SOURCE, ProgramTest

CASES = SOURCE / "cases"
CHECKPOINTS = ("--set", "output.checkpoint.interval=30 ms")
# Of the summary: what tells of the way of the run, not of the model.
CLOCKS = ("wall_s", "_cpu_s", "steps_per_s", "_wait_s", "_solve_s", "_compute_s", "_hidden_s", "hidden_share",
          "factor_s", "resident_bytes", "checkpoint_s", "restore_s")
WAYS = {"command", "folder", "started", "inputs", "resumed_at_steps", "scene_hash", "revision"}

# Ground that yields, softens, slides and remembers, in large strain, with what stands in it and around it.
GROUND = """
material: {young_modulus: 200 MPa, poisson_ratio: 0.3, density: 2 t/m^3}
time: {duration: 0.2 s}
statics: {unbalanced_ratio: 2e-4}
initial_stress: {yy: -400 kPa, yy_per_metre: 20 kPa/m, xx: -200 kPa, xx_per_metre: 10 kPa/m}
continuum:
  large_strain: %s
  blocks:
    - {name: tunnel, rectangle: {x_min: -1.5 m, x_max: 1.5 m, y_min: -1.5 m, y_max: 1.5 m}, along: {zones: 6}, across: {zones: 6}}
    - {name: tunnel, ring: {centre: {x: 0, y: 0}, inner_side: 3 m, outer_radius: 3 m}, along: {zones: 24}, across: {zones: 2}}
    - {name: ground, ring: {centre: {x: 0, y: 0}, inner_radius: 3 m, outer_side: 40 m}, along: {zones: 24}, across: {zones: 10, ratio: 1.2}}
  materials:
    - where: {y_min: 8 m}
      material: {young_modulus: 120 MPa, poisson_ratio: 0.3, density: 2 t/m^3, hysteretic: {hyperbola: {reference_strain: 6e-4, exponent: 0.9}}}
    - where: {x_min: 0 m, y_min: 8 m}
      material:
        young_modulus: 120 MPa
        poisson_ratio: 0.3
        density: 2 t/m^3
        hysteretic: {hyperbola: {reference_strain: 6e-4, exponent: 0.9}, memory: reversals, damping: {darendeli: {}}}
    - where: {x_min: -9 m, x_max: 9 m, y_min: -9 m, y_max: 8 m}
      material:
        young_modulus: 200 MPa
        poisson_ratio: 0.3
        density: 2 t/m^3
        mohr_coulomb: {cohesion: 60 kPa, friction_angle: 25 deg, softening: [{plastic_shear_strain: 0.01, cohesion: 20 kPa, friction_angle: 25 deg}]}
        weak_plane: {dip_angle: 60 deg, cohesion: 40 kPa, friction_angle: 18 deg}
  body_loads: [{acceleration: {y: -10 m/s^2}}]
  excavations:
    - {where: {group: tunnel, y_min: 0 m}, stage: 1, released: 0.5}
    - {where: {group: tunnel}, stage: 2}
  linings:
    - name: lining
      along: {circle: {centre: {x: 0 m, y: 0 m}, radius: 3 m}}
      section:
        thickness: 40 cm
        cover: 4 cm
        concrete: {class: C20/25}
        steel: {class: B500B}
        inner: {diameter: 16 mm, spacing: 15 cm}
        outer: {diameter: 12 mm, spacing: 15 cm}
      stage: 2
      joints:
        - {at: {x: 0 m, y: 3 m}, rotational_stiffness: 20 MN*m/rad, yield_moment: 20 kN*m}
        - at: {x: 0 m, y: -3 m}
          contact: {height: 20 cm}
          bolts: [{stiffness: 40 MN/m, pretension: 30 kN, yield_force: 40 kN, position: -2 cm}]
          gasket: {force: {opening: [-1 mm, 0 mm, 4 mm], force: [-40 kN, -10 kN, 0 N]}, position: 15 cm, width: 3 cm, water_pressure: 100 kPa}
  members:
    - name: strut
      from: {x: -3 m, y: 0 m}
      to: {x: 3 m, y: 0 m}
      spacing: 4 m
      width: 40 cm
      section:
        thickness: 20 cm
        cover: 3 cm
        concrete: {class: C20/25}
        steel: {class: B500B}
        inner: {diameter: 16 mm, spacing: 15 cm}
        outer: {diameter: 16 mm, spacing: 15 cm}
      stage: 2
      failure: {residual: 0.2}
  bolts: [{from: {x: 3 m, y: 0 m}, to: {x: 7.87341 m, y: 0 m}, area: 5 cm^2, yield_force: 20 kN, stage: 2}]
  free_field: {left: true, right: true}
  base: {kind: compliant, acceleration: {ricker: {frequency: 10 Hz, time: 0.1 s}, peak: 0.8 g}}
  %s
  histories:
    - {name: surface, quantity: acceleration_x, at: {x: 5 m, y: 20 m}}
    - {name: crown, quantity: moment, lining: lining, at: {x: 3 m, y: 0 m}}
    - {name: crown, quantity: utilisation, lining: lining, at: {x: 3 m, y: 0 m}}
    - {name: strut, quantity: shear_strength, member: strut, at: {x: -3 m, y: 0 m}}
    - {name: joint, quantity: outer_opening, lining: lining, at: {x: 0 m, y: -3 m}}
    - {name: joint, quantity: bolt_force, lining: lining, at: {x: 0 m, y: -3 m}}
output: {peaks: {}, spectra: [{history: surface}], field_times: [0.1 s]}
"""
MAXWELL = "damping: {maxwell: {ratio: 0.005, low_frequency: 1 Hz, high_frequency: 30 Hz}}"

# Ground that is grouted, excavated, lined by zones in two layers and covered by a fill, under several laws.
FILLED = """
material: {young_modulus: 200 MPa, poisson_ratio: 0.3, density: 2 t/m^3}
time: {duration: 0.1 s}
statics: {unbalanced_ratio: 2e-4, count_from_stage: 1}
initial_stress: {yy: 0 Pa, yy_per_metre: 20 kPa/m, xx: 0 Pa, xx_per_metre: 10 kPa/m}
tunnels:
  - name: tube
    centre: {x: 0 m, y: -10 m}
    circle: {radius: 2.4 m}
    stage: 2
    released: 0.4
    lining:
      as: zones
      layers:
        - {name: outer, thickness: 30 cm, material: {young_modulus: 2 GPa, poisson_ratio: 0.2, density: 2.4 t/m^3}}
        - {name: inner, thickness: 40 cm, material: {young_modulus: 4 GPa, poisson_ratio: 0.2, density: 2.4 t/m^3}}
continuum:
  block: {x_min: -12 m, x_max: 12 m, y_min: -20 m, y_max: 4 m, zones_x: 32, zones_y: 32}
  excavations: [{where: {y_min: 0 m}}]
  materials:
    - where: {y_max: -4 m, x_min: -11 m, x_max: 11 m}
      material: {young_modulus: 200 MPa, poisson_ratio: 0.3, density: 2 t/m^3, mohr_coulomb: {cohesion: 80 kPa, friction_angle: 25 deg}}
    - where: {x_min: -6 m, x_max: 6 m, y_min: -16 m, y_max: -4 m}
      material: {young_modulus: 600 MPa, poisson_ratio: 0.25, density: 2.1 t/m^3, hysteretic: {hyperbola: {reference_strain: 1e-3}}}
      stage: 1
    - where: {x_min: -3 m, x_max: 3 m, y_min: 0 m, y_max: 2 m}
      material: {young_modulus: 50 MPa, poisson_ratio: 0.3, density: 1.8 t/m^3}
      stage: 5
  body_loads: [{acceleration: {y: -10 m/s^2}}]
  free_field: {left: true, right: true}
  base: {kind: compliant, acceleration: {ricker: {frequency: 10 Hz, time: 0.05 s}, peak: 0.8 g}}
  damping: {maxwell: {ratio: 0.01, low_frequency: 1 Hz, high_frequency: 30 Hz}}
  histories:
    - {name: surface, quantity: acceleration_x, at: {x: 5 m, y: 0 m}}
    - {name: fill, quantity: acceleration_x, at: {x: 0 m, y: 1 m}}
output: {peaks: {}, field_times: [50 ms]}
"""

# Ground beside a beam of particles and zones that slips along it, and two steps in one.
BEDDED = """
extends: %s/cantilever/coupled.yaml
time: {duration: 20 ms, dt_factor: 0.1, substeps: 2}
continuum:
  foundations: [{y: {stiffness: 1 GN/m^3, dashpot: 10 kN*s/m^3, slip_stress: 100 kPa, hardening: 0.1}}]
particles:
  foundations: [{y: {stiffness: 1 GN/m^3, dashpot: 10 kN*s/m^3, slip_stress: 100 kPa, hardening: 0.1}}]
interface: {solve: consistent}
output: {history_interval: 0.1 ms, field_times: [10 ms]}
"""

# Discs of several sizes under all laws between moving walls.
GRAINS = """
material: {young_modulus: 50 MPa, poisson_ratio: 0.2, density: 2 t/m^3}
time: {duration: 0.2 s}
particles:
  random_packing: {x_min: 0 m, x_max: 1 m, y_min: 0 m, y_max: 2 m, radius_min: 20 mm, radius_max: 30 mm, stress: 1 MPa}
  contacts: {normal_stiffness: 100 MN/m, shear_stiffness: 40 MN/m, friction: 0.5, normal_damping: 0.2, shear_damping: 0.1}
  bonds: {parallel: {normal_stiffness: 10 GPa/m, shear_stiffness: 4 GPa/m, tensile_strength: 100 kPa, cohesion: 300 kPa, friction_angle: 30 deg}}
  damping: {local: 0.1}
  body_loads: [{acceleration: {y: -10 m/s^2}}]
  walls:
    - {name: floor, from: {x: -1 m, y: 0 m}, to: {x: 2 m, y: 0 m}}
    - {name: top, from: {x: -1 m, y: 2 m}, to: {x: 2 m, y: 2 m}, velocity: {y: -0.5 m/s}}
  histories: [{name: top, quantity: force_y, wall: top}]
output: {peaks: {}, field_times: [0.1 s]}
"""

# Cells that have turned under their weight before time begins, and are crushed.
CELLS = """
extends: %s/laboratory/compression.yaml
time: {duration: 15 ms}
statics: {unbalanced_ratio: 1e-3}
particles:
  body_loads: [{acceleration: {y: -10 m/s^2}}]
  histories: [{name: all, quantity: crack_width, at: {x: 50 mm, y: 100 mm}, radius: 200 mm}]
output: {peaks: {}, field_times: [14 ms]}
"""

# A ring of segments in particles, installed in a stage, in zones with a larger step.
RING = """
material: {young_modulus: 163 MPa, poisson_ratio: 0.2, density: 1.8 t/m^3}
time: {duration: 0.1 s, substeps: 4}
statics: {unbalanced_ratio: 1e-3, count_from_stage: 1}
initial_stress: {yy: 0 Pa, yy_per_metre: 18 kPa/m, xx: 0 Pa, xx_per_metre: 9 kPa/m}
tunnels:
  - name: ring
    centre: {x: 0 m, y: -10 m}
    circle: {radius: 2.4 m}
    stage: 1
    released: 0.3
    lining:
      thickness: 80 cm
      material: {young_modulus: 10 GPa, poisson_ratio: 0.2, density: 2.5 t/m^3}
      bonds: {tensile_strength: 100 kN, shear_strength: 300 kN}
      segments: 4
      first_joint: 15 deg
      bolts: {length: 90 cm, stiffness: 50 MN/m, strength: 40 kN}
      friction: 0.5
    particles:
      radius: 10 cm
      ground: 1.6 m
      overlap: 1 m
      bonds: {tensile_strength: 4 kN, shear_strength: 4 kN}
      contacts: {friction: 0.4, normal_damping: 0.2, shear_damping: 0.2}
continuum:
  block: {x_min: -10 m, x_max: 10 m, y_min: -20 m, y_max: 0 m, zones_x: 40, zones_y: 40}
  body_loads: [{acceleration: {y: -10 m/s^2}}]
  free_field: {left: true, right: true}
  base: {kind: compliant, acceleration: {ricker: {frequency: 10 Hz, time: 0.08 s}, peak: 1 g}}
  histories: [{name: surface, quantity: acceleration_x, at: {x: 0 m, y: 0 m}}]
output: {peaks: {highest_frequency: 50 Hz}, field_times: [0 s]}
"""

# Their scenes or the files of them, with options.
SCENES = {
    "lattice that cracks": (CASES / "cantilever" / "coupled.yaml", ("--set", "output.peaks={}", "--set", "time.dt_factor=0.1")),
    "ground that yields": (GROUND % ("false", MAXWELL), ()),
    "ground in large strain": (GROUND % ("true", "damping: {local: {alpha: 0.1}}"), ()),
    "ground that is filled": (FILLED, ()),
    "beam on a foundation": (BEDDED % CASES, ()),
    "grains": (GRAINS, ()),
    "cells": (CELLS % CASES, ()),
    "ring of segments": (RING, ()),
    "regions": (CASES / "cavern" / "crown_invert.yaml", ("--set", "time.duration=50 ms", "--set", "output.field_times=[10 ms]")),
}


def results_of(run):
    """Content of all results by their paths; the summary without clocks."""
    results = {}
    for file in sorted(run.rglob("*")):
        path = file.relative_to(run)
        if file.is_dir() or file.suffix == ".log" or path.parts[0] == "checkpoints" \
                or path.name in (".lock", "scene.yaml", "scene_as_written.yaml"):
            continue
        results[str(path)] = file.read_bytes()
    summary = json.loads(results.pop("summary.json"))
    results["summary.json"] = {name: value for name, value in summary.items()
                               if name not in WAYS and not name.endswith(CLOCKS)}
    return results


class ResumeTest(ProgramTest):
    def scene_of(self, name):
        """The file of one of SCENES, and its options."""
        scene, options = SCENES[name]
        return self.scene(scene) if isinstance(scene, str) else scene, options

    def assert_same(self, run, whole):
        found, expected = results_of(run), results_of(whole)
        self.assertEqual(found.keys(), expected.keys())
        for path, content in expected.items():
            if isinstance(content, dict):
                self.assertEqual(found[path], content)
            else:
                self.assertTrue(found[path] == content, f"{path} differs")

    def wait_for(self, condition, process, patience=PATIENCE_S):
        end = time.monotonic() + patience
        while not condition():
            if process.poll() is not None:
                return
            if time.monotonic() > end:
                self.fail("no checkpoint came")
            time.sleep(0.005)

    def start(self, *arguments):
        process = subprocess.Popen([COUPLER, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True)
        self.addCleanup(process.kill)
        return process

    def stopped(self, scene, out, *arguments):
        """A run that a signal ended after its first checkpoint."""
        run = self.folder / out
        process = self.start("run", scene, "--out", run, *arguments, *CHECKPOINTS)
        self.wait_for(lambda: any(run.glob("checkpoints/0*")), process)
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=PATIENCE_S)
        self.assertEqual(process.returncode, 128 + signal.SIGTERM)
        return run
