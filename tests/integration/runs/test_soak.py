"""Servers and coupler neither grow nor leak (nightly): memory within 1 % and as many descriptors and threads after a thousand runs on
one pair of servers, some of them refused, cut or killed, and after ten million exchanges of one run."""

import pathlib
import statistics
import subprocess
import unittest

from foreign import Cut, Listener, road
from programs import COUPLER, ProgramTest, Server, children_of, coupler, wait_until

BAR = """
plane: plane_stress
material: {young_modulus: 25 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}
time: {duration: 1 ms, dt_factor: 0.35}
continuum:
  block: {x_min: 0 m, x_max: 4 m, y_min: 0 m, y_max: 1.0392304845 m, zones_x: 8, zones_y: 2}
  edge_loads: [{where: {x_max: 0 m}, force: {y: 10 kN}, time: {sine: {frequency: 50 Hz, end: 10 ms}}}]
  histories: [{name: tip, quantity: displacement_y, at: {x: 0 m, y: 0.5 m}}]
particles:
  packing: {x_min: 2 m, x_max: 5 m, y_min: 0 m, y_max: 1.0392304846 m, radius: 0.1 m}
  motions: [{where: {x_min: 4.85 m}, velocity: {x: 0 m/s, y: 0 m/s}, spin: 0 rad/s}]
interface: {overlap: {particles_begin: {x: 2 m, y: 0 m}, continuum_ends: {x: 4 m, y: 0 m}}}
"""
RUNS, WARM_UP, EXCHANGES = 1000, 100, 10**7
SHARE = 0.01  # by which memory may grow


def holds(pid):
    """Resident memory [KiB], descriptors and threads of a process."""
    lines = dict(line.split(":", 1) for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines())
    return int(lines["VmRSS"].split()[0]), len(list(pathlib.Path(f"/proc/{pid}/fd").iterdir())), int(lines["Threads"])


def cut(kind, data):
    if kind == "predicted":
        raise Cut()
    yield data


class Soak(ProgramTest):
    def assert_even(self, name, before, after):
        """Two lists of what a process held."""
        memory, descriptors, threads = ([statistics.median(values) for values in pair] for pair in zip(zip(*before), zip(*after)))
        print(f"{name}: {memory[0] / 1024:.2f} MiB, then {memory[1] / 1024:.2f} MiB; {descriptors[0]:g} descriptors, then "
              f"{descriptors[1]:g}; {threads[0]:g} threads, then {threads[1]:g}")
        self.assertLess(memory[1], (1 + SHARE) * memory[0], name)
        self.assertEqual(descriptors[0], descriptors[1])
        self.assertEqual(threads[0], threads[1])

    @staticmethod
    def at_rest(server, descriptors):
        """What a server holds once it has parted from its client: no more descriptors than at first."""
        wait_until(lambda: holds(server.process.pid)[1] == descriptors, 60)
        return holds(server.process.pid)

    def test_a_thousand_runs(self):
        scene = self.scene(BAR)
        quiet = ("127.0.0.1:0", "--log-level", "off")  # nobody reads what they log
        with Server("fdm_server", *quiet) as fdm, Server("dem_server", *quiet) as dem:
            servers = {"fdm_server": fdm, "dem_server": dem}
            held = {name: [] for name in servers}
            first = {name: holds(server.process.pid)[1] for name, server in servers.items()}
            for i in range(RUNS):
                self.run_one(i, scene, fdm, dem)
                for name, server in servers.items():
                    held[name].append(self.at_rest(server, first[name]))
        for name, samples in held.items():
            self.assert_even(name, samples[WARM_UP:2 * WARM_UP], samples[-WARM_UP:])

    def run_one(self, i, scene, fdm, dem):
        """Of ten runs, one is refused by a server and one is cut in its steps."""
        address, options, code = dem.address, (), 0
        if i % 10 == 3:
            options, code = ("--set", "particles.loads=[{where: {x_max: -9 m}, force: {x: 1 N}}]"), 2
        if i % 10 == 7:
            address, code = Listener(road(dem, answers=cut)).address, 3
        done = coupler("run", scene, "--out", self.folder / "run", "--fdm", fdm.address, "--dem", address, *options)
        self.assertEqual(done.returncode, code, done.stderr)

    def test_ten_million_exchanges(self):
        scene = self.scene(BAR)
        dt = self.summary(self.run_scene(scene))["dt_s"]
        rows = ("--set", "output.history_interval=0.1 s", "--set", f"time.duration={1.1 * EXCHANGES * dt} s")
        run = subprocess.Popen([COUPLER, "run", scene, "--out", self.folder / "run", *rows], stdout=subprocess.DEVNULL)
        self.addCleanup(run.kill)
        held = []
        while run.poll() is None:
            try:
                processes = [run.pid, *children_of(run.pid)]
                held.append([holds(pid) for pid in processes])
                run.wait(1)
            except (subprocess.TimeoutExpired, OSError):
                pass
        self.assertEqual(run.returncode, 0)
        self.assertGreaterEqual(self.summary(self.folder / "run")["steps"], EXCHANGES)
        held = [sample for sample in held if len(sample) == 3]
        part = len(held) // 10
        for i, name in enumerate(("coupler", "fdm_server", "dem_server")):
            of_one = [sample[i] for sample in held]
            self.assert_even(name, of_one[part:2 * part], of_one[-2 * part:-part])


if __name__ == "__main__":
    unittest.main()
