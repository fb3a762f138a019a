"""States, limits and faults: the rules of docs/protocol.md for every participant."""
import struct
import time

from adit.conformance.client import PREAMBLE, Run, require, scene, scene_of, wire

SILENCE_S = 2.5  # in which at least two heartbeats come
PATIENCE_S = 7  # longer than the wait for a greeting, shorter than that for a sign of life


def greeting(participant):
    """greets with its version, its name and the longest frame that it accepts"""
    link = participant.connect()
    require(link.read(8) == PREAMBLE, "does not begin with the preamble of version 2")
    hello = link.next_answer().hello
    require(hello.protocol_version == 2, f"says version {hello.protocol_version} in hello")
    require(hello.program, "has no name in hello")
    other = {"continuum": "dem_server", "particles": "fdm_server"}[participant.role]
    require(hello.program != other, f"has the name of {other}")
    require(hello.max_frame_bytes >= 64 << 10, f"accepts frames of {hello.max_frame_bytes} bytes only")
    link.socket.close()


def computed_keys(participant):
    """lists in hello the keys that it computes: only keys of the scene, and all keys that these checks use"""
    link = participant.connect()
    link.read(8)
    listed = set(link.next_answer().hello.computes)
    link.socket.close()
    require(listed, "lists nothing in hello.computes")
    for path in sorted(listed):
        require(is_key(scene.Scene.DESCRIPTOR, path.split(".")), f"lists {path}, which the scene does not know")
    for path in keys_of(scene_of(participant.role)):
        require(any(f"{path}.".startswith(f"{known}.") for known in listed), f"computes {path}, but does not list it")


def is_key(message, names):
    field = message.fields_by_name.get(names[0])
    if field is None or len(names) == 1:
        return field is not None
    if field.enum_type:
        return len(names) == 2 and names[1].upper() in field.enum_type.values_by_name
    return field.message_type is not None and is_key(field.message_type, names[1:])


def keys_of(message, path=""):
    for field, value in message.ListFields():
        here = f"{path}.{field.name}" if path else field.name
        if field.message_type:
            for part in value if field.label == field.LABEL_REPEATED else [value]:
                yield from keys_of(part, here)
        elif field.enum_type is None:
            yield here
        elif value != field.default_value:
            yield f"{here}.{field.enum_type.values_by_number[value].name.lower()}"


def heartbeats(participant):
    """sends a heartbeat at least every second, and accepts those of the other end"""
    with participant.run() as run:
        run.link.send(wire.Frame(heartbeat=wire.Heartbeat()))
        run.set_up(scene_of(participant.role))
        deadline, count = time.monotonic() + SILENCE_S, 0
        try:
            while time.monotonic() < deadline:
                run.link.socket.settimeout(max(0.01, deadline - time.monotonic()))
                require(run.link.next_frame().WhichOneof("content") == "heartbeat", "sends a frame unasked")
                count += 1
        except TimeoutError:
            pass
        require(count >= 2, f"sent {count} heartbeats in {SILENCE_S} s")


def order(participant):
    """refuses requests out of order, with kind REQUEST"""
    role = participant.role
    advance = wire.Advance(step=0, dt=1e-6)
    for before, request in ((0, {"advance": advance}), (0, {"finish": wire.Finish()}), (1, {"advance": advance}),
                            (1, {"couple": wire.Couple()}), (1, {"setup": wire.Setup(scene=scene_of(role))}),
                            (2, {"weights": wire.Weights()}), (2, {"advance": wire.Advance(step=1, dt=1e-6)})):
        with participant.run() as run:
            if before > 0:
                run.set_up(scene_of(role))
            if before > 1:
                run.weigh(coupled=False)
            run.expect_error(wire.Error.REQUEST, **request)


def steps(participant):
    """refuses steps out of order, another dt, impulses where none belong, with kind REQUEST"""
    role = participant.role
    for wrong in ({"step": 2, "dt": 1e-6}, {"step": 0, "dt": 1e-6}, {"step": 1, "dt": 2e-6}, {"step": 1, "dt": -1e-6},
                  {"step": 1, "dt": 1e-6, "impulses": [1.0]}):
        with participant.run() as run:
            run.set_up(scene_of(role))
            run.weigh()
            run.couple(run.points)
            run.step(0, 1e-6)
            run.expect_error(wire.Error.REQUEST, advance=wire.Advance(**wrong))
    with participant.run() as run:
        run.set_up(scene_of(role))
        run.weigh()
        run.couple(run.points)
        impulses = [1.0] * run.points.size
        run.expect_error(wire.Error.REQUEST, advance=wire.Advance(step=0, dt=1e-6, impulses=impulses))


def unknown_keys(participant):
    """refuses a key of the scene that it does not know, with kind SCENE"""
    described = scene_of(participant.role)
    described.material.MergeFromString(b"\x98\x75\x01")  # field 1875, a number
    with participant.run() as run:
        run.expect_error(wire.Error.SCENE, setup=wire.Setup(scene=described))


def empty_places(participant):
    """refuses an area that selects nothing, with kind SCENE and the path of the area"""
    with participant.run() as run:
        described = scene_of(participant.role, "motions { where { x_min: 50 } velocity { x: 0 } }")
        kind, answer = run.ask(setup=wire.Setup(scene=described))
        if kind == "model":
            kind, answer = run.ask(weights=wire.Weights())
        require(kind == "error" and answer.kind == wire.Error.SCENE, f"answers {kind} to a motion of nothing")
        path = f"{participant.role}.motions[0]"
        require(answer.path.startswith(path), f"names `{answer.path}` where `{path}.where` was expected")


def one_run_after_another(participant):
    """says bye, waits for the client to close, and serves the next run at once"""
    participant.serves_another_run()
    for _ in range(3):
        with Run(participant.connect()) as run:
            run.set_up(scene_of(participant.role))
            run.expect("bye", finish=wire.Finish())


def busy(participant):
    """refuses a second client during a run, with kind REFUSED"""
    with participant.run() as run:
        run.set_up(scene_of(participant.role))
        second = participant.connect()
        require(second.read(8) == PREAMBLE, "tells a second client no version")
        answer = second.next_answer()
        require(answer.error.kind == wire.Error.REFUSED, f"answers a second client by {answer.WhichOneof('content')}")
        second.socket.close()
        run.expect("bye", finish=wire.Finish())
    participant.serves_another_run()


def other_version(participant):
    """refuses a client of another version, and serves the next run"""
    link = participant.connect()
    link.socket.sendall(b"ADIT" + struct.pack("<I", 7))
    link.send(wire.Frame(hello=wire.Hello(protocol_version=7, program="conformance", max_frame_bytes=1 << 20)))
    ends(link)
    participant.serves_another_run()


def malformed(participant):
    """ends a run on bytes that are not a frame, and serves the next one"""
    for bytes_sent in (b"\x04\x00\x00\x00\xff\xff\xff\xff", b"\x02\x00\x00\x00\x92\x3e"):
        run = participant.run()
        run.link.socket.sendall(bytes_sent)
        ends(run.link)
        participant.serves_another_run()


def too_long(participant):
    """ends a run on a frame above its limit without waiting for the bytes, and serves the next one"""
    run = participant.run()
    run.link.socket.sendall(struct.pack("<I", 0xffffffff))
    ends(run.link)
    participant.serves_another_run()


def lost_client(participant):
    """serves the next run after a client that vanished"""
    run = Run(participant.connect())
    run.set_up(scene_of(participant.role))
    run.link.socket.close()
    participant.serves_another_run()


def ends(link):
    """The other end closes, after an error frame or without one."""
    deadline = time.monotonic() + PATIENCE_S
    link.socket.settimeout(PATIENCE_S)
    try:
        while link.socket.recv(4096):
            require(time.monotonic() < deadline, f"keeps the connection for {PATIENCE_S} s")
    except TimeoutError:
        require(False, f"keeps the connection for {PATIENCE_S} s")
    except OSError:
        pass
    link.socket.close()


CHECKS = (greeting, computed_keys, heartbeats, order, steps, unknown_keys, empty_places, one_run_after_another, busy,
          other_version, malformed, too_long, lost_client)
