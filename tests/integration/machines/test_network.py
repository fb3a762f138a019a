"""Between two machines a run gives the bits that it gives on one, whatever the network does to its packets."""

import contextlib
import re
import subprocess
import unittest

from programs import BUILD, CASE, COUPLER
from resume.resumed import ResumeTest
from trusted import TrustTest

from network.machines import FAR, NEAR, Link, Machines, NotAllowed
from adit.programs import listening

CRACKING = [word for setting in ("time.duration=3 ms", "time.dt_factor=0.8", "output.field_times=[1 ms]",
                                 "particles.bonds.tensile_strength=100 kN") for word in ("--set", setting)]


class NetworkTest(ResumeTest, TrustTest):
    def machines(self, **quality):
        try:
            return Machines(BUILD / "tests/bench/network_link", Link(**quality))
        except NotAllowed as reason:
            self.skipTest(f"network namespaces are not allowed here: {reason}")

    def near(self, machines, *arguments):
        return subprocess.run(machines.on_near(COUPLER, *arguments), capture_output=True, text=True, timeout=120)


class SameBits(NetworkTest):
    def assert_same_bits(self, server_trust, coupler_trust, **quality):
        scene = CASE / "variants/coupled_52x6.yaml"
        own = self.run_scene(scene, *CRACKING, out="own")
        self.assertGreater((own / "cracks.csv").read_text().count("\n"), 2)
        with self.machines(**quality) as machines, contextlib.ExitStack() as servers:
            addresses = [servers.enter_context(listening(*machines.on_far(
                BUILD / program / program, "--listen", f"{FAR}:0", *server_trust))) for program in ("fdm_server", "dem_server")]
            done = self.near(machines, "run", scene, *CRACKING, "--out", self.folder / "over", "--fdm", addresses[0],
                             "--dem", addresses[1], *coupler_trust)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same(self.folder / "over", own)
        return machines.carried

    def test_by_tls_with_delay_jitter_loss_and_a_narrow_link(self):
        folder = self.certificates("ours", f"near,{NEAR}", f"far,{FAR}")
        carried = self.assert_same_bits(("--tls", folder / "far"), ("--tls", folder / "near"),
                                        delay=0.2, jitter=0.3, loss=0.01, rate=50)
        for data, packets in carried.values():  # it did go that way
            self.assertGreater(packets, 240)
            self.assertGreater(data, 100_000)

    def test_by_a_secret_on_a_network_without_faults(self):
        trust = ("--secret-file", self.secret())
        self.assert_same_bits((*trust, "--insecure"), trust)


class TheLink(NetworkTest):
    """It is as slow, narrow and lossy as it was asked to be."""

    def round_trip_ms(self, **quality):
        with self.machines(**quality) as machines, listening(*machines.on_far(
                BUILD / "dem_server/dem_server", "--listen", f"{FAR}:0", "--insecure")) as address:
            told = self.near(machines, "doctor", address).stdout
        number, unit = re.search(r"round trip +([\d.,]+) (\S+) median", told).groups()
        return float(number.replace(",", "")) * {"µs": 1e-3, "ms": 1}[unit]

    def test_delay_is_waited_for_each_way(self):
        self.assertGreater(self.round_trip_ms(delay=5), 10)

    def test_a_narrow_link_takes_its_time_for_each_byte(self):
        self.assertGreater(self.round_trip_ms(rate=10), 2 * 2262 * 8 / 10e3)  # the bytes that doctor tells; kbit/ms

    def test_packets_are_lost(self):
        for loss, code in ((0, 0), (1, 124)):
            with self.machines(loss=loss) as machines, listening(*machines.on_far(
                    BUILD / "dem_server/dem_server", "--listen", f"{FAR}:0", "--insecure")) as address:
                connect = f"</dev/tcp/{address.replace(':', '/')}"
                done = subprocess.run(machines.on_near("timeout", "2", "bash", "-c", connect), capture_output=True, text=True)
                self.assertEqual(done.returncode, code, done.stderr)


if __name__ == "__main__":
    unittest.main()
