"""What no correct participant says ends the run with exit code 3, the name and address of the one that said it, and what was wrong."""

import unittest

from faults.faulty import FaultTest
from foreign import Listener, between
from programs import CASE, Server, coupler

SHORT = ("--set", "time.duration=2 ms", "--set", "output.field_times=[1 ms]")
NAN, INF = float("nan"), float("inf")


def put(**values):
    """Sets numbers; lists get the value in their first place."""
    def change(message):
        for name, value in values.items():
            part = getattr(message, name)
            if isinstance(part, float):
                setattr(message, name, value)
            else:
                part[0] = value
    return change


def from_step(first, change):
    return lambda answer: change(answer) if answer.step >= first else None


def with_energies(change):
    return lambda answer: change(answer.energies) if answer.HasField("energies") else None


def with_histories(value):
    return lambda answer: answer.histories.__setitem__(0, value) if answer.histories else None


def piece(**values):
    def change(snapshot):
        for name, value in values.items():
            setattr(snapshot.pieces[0], name, value)
    return change


def field(**values):
    def change(snapshot):
        for name, value in values.items():
            setattr(snapshot.pieces[0].point_fields[0], name, value)
    return change


def offer_twice(interface):
    interface.points.extend(interface.points[:2])


def tie_twice(operator):
    operator.columns[1] = operator.columns[0]


# By their tests: participant, its answer, what is changed in it, what the message says.
FAULTS = {
    "models": [
        ("fdm", "model", put(critical_dt=NAN), "model.critical_dt is nan"),
        ("dem", "model", put(critical_dt=INF), "model.critical_dt is inf"),
        ("dem", "model", put(critical_dt=0.0), "model.critical_dt is 0, which must be positive"),
        ("dem", "model", put(p_wave_speed=-1.0), "model.p_wave_speed is -1"),
        ("fdm", "model", put(x_min=1e9), "bounding box"),
        ("dem", "model", put(sample_points=NAN), "model.sample_points[0] is nan"),
        ("dem", "model", lambda model: model.sample_points.pop(), "not pairs"),
    ],
    "interfaces": [
        ("dem", "interface", put(mass=INF), "interface.mass is inf"),
        ("dem", "interface", put(points=NAN), "interface.points[0] is nan"),
        ("dem", "interface", offer_twice, "twice"),
    ],
    "operators": [
        ("fdm", "operator", put(values=NAN), "operator.values[0] is nan"),
        ("fdm", "operator", put(inverse_masses=-1.0), "an inverse mass is negative"),
        ("fdm", "operator", put(inverse_masses=1e-320), "beyond that of any mass"),
        ("dem", "operator", tie_twice, "two coupling points are one point of its own"),
    ],
    "velocities": [
        ("dem", "predicted", from_step(8, put(velocities=INF)), "predicted.velocities[0] is inf"),
        ("fdm", "predicted", from_step(8, put(velocities=NAN)), "predicted.velocities[0] is nan"),
    ],
    "energies": [
        ("dem", "predicted", with_energies(put(kinetic=NAN)), "predicted.energies.kinetic is nan"),
        ("fdm", "predicted", with_energies(put(dissipated=INF)), "predicted.energies.dissipated is inf"),
    ],
    "histories": [
        ("fdm", "predicted", with_histories(NAN), "sent nan as the displacement_y of history 0"),
        ("fdm", "predicted", with_histories(INF), "sent inf as the displacement_y of history 0"),
    ],
    "events": [
        ("dem", "predicted", lambda answer: put(force=NAN)(answer.strongest.add(step=answer.step)), "force is nan"),
        ("dem", "predicted", lambda answer: answer.cracks.add(step=answer.step, x=INF), "predicted.cracks[0].x is inf"),
        ("dem", "predicted", put(compute_seconds=NAN), "predicted.compute_seconds is nan"),
    ],
    "shares": [
        ("dem", "predicted", with_energies(lambda energies: energies.shares.add(name="a/b")), "is named `a/b`"),
        ("dem", "predicted", with_energies(lambda energies: [energies.shares.add(name="x") for _ in "12"]), "two shares"),
        ("dem", "predicted", from_step(8, with_energies(lambda energies: energies.shares.add(name="late"))), "other shares"),
    ],
    "snapshots": [
        ("dem", "snapshot", piece(name="../grid"), "name is not of letters"),
        ("dem", "snapshot", piece(name=""), "name is not of letters"),
        ("dem", "snapshot", piece(name="grid"), "a second piece is named `grid`"),
        ("dem", "snapshot", piece(shape=7), "its shape is none of"),
        ("dem", "snapshot", lambda snapshot: snapshot.pieces[0].points.pop(), "not pairs of x and y"),
        ("dem", "snapshot", lambda snapshot: snapshot.pieces[0].connectivity.append(10**6), "names point 1000000"),
        ("dem", "snapshot", field(name="a\"/>"), "a field's name is not of letters"),
        ("fdm", "snapshot", field(components=7), "expected 7 for each"),
    ],
    "greetings_and_ends": [
        ("dem", "bye", put(cpu_seconds=NAN), "bye.cpu_seconds is nan"),
        ("dem", "hello", lambda hello: hello.ClearField("max_frame_bytes"), "accepts frames of 0 bytes only"),
    ],
    "overlaps_without_weights": [
        ("dem", "model", lambda model: model.ClearField("sample_points"), "sent no sample points"),
        ("fdm", "model", lambda model: model.ClearField("sample_points"), "sent no sample points"),
    ],
}


def changed(kind, change):
    def tamper(frame):
        if frame.WhichOneof("content") == kind:
            change(getattr(frame, kind))
    return tamper


class Peers(FaultTest):
    def run_between(self, which, tamper, *options):
        with Server(f"{which}_server") as server:
            listener = Listener(between(server, tamper))
            return listener.address, coupler("run", CASE / "coupled.yaml", "--out", self.folder / "run",
                                             f"--{which}", listener.address, *SHORT, *options)

    def assert_blamed(self, faults):
        for which, kind, change, words in FAULTS[faults]:
            with self.subTest(f"{which} {kind}: {words}"):
                address, result = self.run_between(which, changed(kind, change))
                self.assert_lost(which, address, result, words)

    def test_models_that_cannot_be(self):
        self.assert_blamed("models")

    def test_interfaces_that_cannot_be(self):
        self.assert_blamed("interfaces")

    def test_operators_that_cannot_be(self):
        self.assert_blamed("operators")

    def test_velocities_that_are_not_finite(self):
        self.assert_blamed("velocities")

    def test_energies_that_are_not_finite(self):
        self.assert_blamed("energies")

    def test_histories_that_are_not_finite(self):
        self.assert_blamed("histories")

    def test_cracks_and_forces_that_are_not_finite(self):
        self.assert_blamed("events")

    def test_shares_that_come_and_go(self):
        self.assert_blamed("shares")

    def test_snapshots_that_cannot_be_drawn(self):
        self.assert_blamed("snapshots")

    def test_greetings_and_ends_that_cannot_be(self):
        self.assert_blamed("greetings_and_ends")

    def test_participants_without_sample_points(self):
        self.assert_blamed("overlaps_without_weights")

    def test_velocities_beyond_light(self):
        """Whoever sends them is named, not the one whom they would break."""
        for which in ("fdm", "dem"):
            for speed in (1e300, -1e30, 3e8):
                address, result = self.run_between(which, changed("predicted", from_step(8, put(velocities=speed))))
                self.assertEqual(result.returncode, 4, result.stderr)
                self.assert_said(result.stderr, f"{which}_server at {address}: step 8: ", "faster than light")
                self.assert_unfinished(f"{which}_server at {address}")

    def test_a_history_may_be_missing_where_its_quantity_may(self):
        history = "particles.histories=[{name: middle, quantity: porosity, at: {x: 8 m, y: 0.5 m}, radius: 0.3 m}]"
        missing = changed("predicted", with_histories(NAN))
        self.assertEqual(self.run_between("dem", missing, "--set", history)[1].returncode, 0)

    def test_a_figure_of_a_name_that_is_taken_is_left_out_and_told(self):
        _, result = self.run_between("dem", changed("bye", lambda bye: bye.figures.add(name="completed", value=7)))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("figure `completed` is left out", result.stdout)
        self.assertIs(self.summary(self.folder / "run")["completed"], True)

    def test_energy_that_goes_without_cause_ends_the_run_and_names_who_lost_it(self):
        def lose(energies):
            for part in ("kinetic", "strain"):
                setattr(energies, part, 0.1 * getattr(energies, part))

        address, result = self.run_between("fdm", changed("predicted", with_energies(lose)), "--set", "time.duration=20 ms")
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertIn(f"most of it in `continuum` (fdm_server at {address})", result.stderr)
        self.assertFalse(self.summary(self.folder / "run")["completed"])


if __name__ == "__main__":
    unittest.main()
