"""A model of ten million particles is computed, drawn, saved and resumed on a machine of 24 GB (nightly): no frame bounds the size of a
model, and what programs hold stays below what docs/performance.md states."""

import pathlib
import subprocess
import threading
import unittest

from programs import COUPLER, ProgramTest, children_of

LATTICE = """
material: {young_modulus: 30 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}
time: {duration: 20 us}
particles:
  packing: {x_min: 0 m, x_max: 5000 m, y_min: 0 m, y_max: 69.3 m, radius: 0.1 m}
  bonds: {tensile_strength: 100 MN}
  loads: [{where: {x_max: 0.3 m}, force: {x: 10 MN}, time: {sine: {frequency: 1 kHz, end: 0.5 ms}}}]
output: {checkpoint: {interval: 600 s}}
"""
PARTICLES = 9_999_800
MOST_GB = {"coupler": 5, "dem_server": 12}  # docs/performance.md


def peak(pid):
    """The most that a process ever held [GB]."""
    lines = dict(line.split(":", 1) for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines())
    return lines["Name"].strip(), int(lines["VmHWM"].split()[0]) / 1e6


class Large(ProgramTest):
    def coupled(self, *arguments):
        """Runs the coupler with a server of its own; looks at both once a second."""
        held = {}
        process = subprocess.Popen([COUPLER, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        done = threading.Event()

        def look():
            while not done.wait(1):
                for pid in (process.pid, *children_of(process.pid)):
                    try:
                        held.update([peak(pid)])
                    except (OSError, KeyError):
                        pass  # it has ended
        threading.Thread(target=look, daemon=True).start()
        output, _ = process.communicate(timeout=3000)
        done.set()
        self.assertEqual(process.returncode, 0, output)
        print(", ".join(f"{name} {gb:.1f} GB" for name, gb in held.items()))
        for name, most in MOST_GB.items():
            self.assertLess(held[name], most, name)

    def test_ten_million_particles(self):
        run = self.folder / "run"
        self.coupled("run", self.scene(LATTICE), "--out", run)
        self.assertEqual(self.summary(run)["particles"], PARTICLES)
        self.assertGreater((run / "fields/particles_00000002.vtp").stat().st_size, 1 << 30)
        self.coupled("resume", run, "--until", "40 us")
        self.assertTrue(self.summary(run)["completed"])


if __name__ == "__main__":
    unittest.main()
