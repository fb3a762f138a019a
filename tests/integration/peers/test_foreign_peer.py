"""Another code can take part: all it needs is wire.proto. Here it is Python, between the coupler and a real server."""

import struct
import time
import unittest

from foreign import Listener, between, framed, road
from link import MAGIC, VERSION, wire_pb2
from programs import CASE, ProgramTest, Server, coupler

SHORT = ("--set", "time.duration=2 ms", "--set", "output.field_times=[]")


class ForeignPeer(ProgramTest):
    def run_with(self, tamper, *more):
        return self.run_on(lambda dem: between(dem, tamper), *more)

    def run_on(self, way_to, *more):
        with Server("dem_server") as dem:
            listener = Listener(way_to(dem))
            return coupler("run", CASE / "coupled.yaml", "--out", self.folder / "foreign", "--dem", listener.address, *SHORT,
                           *more)

    def test_a_python_participant_gives_the_same_results_to_the_bit(self):
        result = self.run_with(lambda frame: None)
        self.assertEqual(result.returncode, 0, result.stderr)
        own = self.run_scene(CASE / "coupled.yaml", *SHORT, out="own")
        for name in ("histories.csv", "cracks.csv"):
            self.assertEqual((self.folder / "foreign" / name).read_bytes(), (own / name).read_bytes())

    def test_the_user_hears_of_a_long_set_up(self):
        def packing(kind, data):
            if kind == "model":
                yield framed(wire_pb2.Frame(heartbeat={"progress": "growing 9 discs:\nstep 3 of 20"}).SerializeToString())
                time.sleep(2.5)
            yield data

        result = self.run_on(lambda dem: road(dem, answers=packing))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stderr,
                         r"dem_server at \S+ builds its model \(2 s so far\): growing 9 discs: step 3 of 20\n")
        self.assertNotIn("fdm_server at", result.stderr)

    def assert_refused(self, tamper, text):
        result = self.run_with(tamper)
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn("dem_server", result.stderr)
        self.assertIn(text, result.stderr)

    def test_an_operator_that_does_not_fit_is_refused(self):
        def tamper(frame):
            if frame.WhichOneof("content") == "operator":
                frame.operator.columns[0] = 10**6

        self.assert_refused(tamper, "a point that it does not have")

    def test_missing_velocities_are_refused(self):
        def tamper(frame):
            if frame.WhichOneof("content") == "predicted" and frame.predicted.step == 5:
                del frame.predicted.velocities[-1]

        self.assert_refused(tamper, "velocities")

    def test_another_answer_than_asked_for_is_refused(self):
        def tamper(frame):
            if frame.WhichOneof("content") == "model":
                frame.bye.cpu_seconds = 1

        self.assert_refused(tamper, "model was expected")

    def test_a_peer_that_saves_no_state_takes_part_without_checkpoints(self):
        def tamper(frame):
            if frame.WhichOneof("content") == "model":
                frame.model.ClearField("state_format")

        result = self.run_with(tamper, "--set", "output.checkpoint={}")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stderr, r"note: checkpoint: none can be written, because dem_server at \S+ \(particles\)")
        run = self.folder / "foreign"
        self.assertFalse((run / "checkpoints").exists())
        self.assertTrue(any("none can be written" in note for note in self.summary(run)["notes"]))

    def test_a_state_that_was_damaged_is_refused(self):
        def tamper(frame):
            if frame.WhichOneof("content") == "state":
                frame.state.checksum ^= 1

        result = self.run_with(tamper, "--set", "output.checkpoint={}")
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn("sent a part of its state with a wrong checksum", result.stderr)
        self.assertEqual(list((self.folder / "foreign" / "checkpoints").iterdir()), [])

    def test_a_peer_that_does_not_say_its_wave_speed_takes_part_unless_the_solve_needs_it(self):
        def tamper(frame):
            if frame.WhichOneof("content") == "model":
                frame.model.ClearField("p_wave_speed")

        self.assertEqual(self.run_with(tamper).returncode, 0)
        split = ("--set", "interface.solve=split")
        result = self.run_with(tamper, *split)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("interface.decay_rate", result.stderr)
        self.assertIn("dem_server", result.stderr)
        self.assertEqual(self.run_with(tamper, *split, "--set", "interface.decay_rate=1000").returncode, 0)

    def greeting(self, reply):
        def serve(client):
            client.sendall(reply)
            client.recv(1000)
            client.recv(1000)

        listener = Listener(serve)
        result = coupler("run", CASE / "full_dem.yaml", "--out", self.folder / "run", "--dem", listener.address)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn(listener.address, result.stderr)
        return result.stderr

    def test_a_peer_of_an_older_or_newer_protocol_version_is_refused_with_both_versions(self):
        for version in (0, VERSION - 1, 7):
            hello = wire_pb2.Frame()
            hello.hello.protocol_version = version
            hello.hello.program = "dem_server"
            hello.hello.release = "9.9"
            payload = hello.SerializeToString()
            preamble = MAGIC + struct.pack("<I", version)
            message = self.greeting(preamble + struct.pack("<I", len(payload)) + payload)
            self.assertIn(f"version {version}", message)
            self.assertIn(f"version {VERSION}", message)

    def test_a_peer_that_speaks_something_else_is_named(self):
        self.assertIn("protocol", self.greeting(b"HTTP/1.1 400 Bad Request\r\n\r\n"))


if __name__ == "__main__":
    unittest.main()
