"""States: saved by a participant, and continued as if the run had never ended."""
import zlib

import numpy as np

from adit.conformance.client import NotComputed, require, tied, wire
from adit.conformance.physics import LOADS, noise, start, velocities

LOADED = {
    role: "%s { where { x_max: 0.15 } force { y: 1e-3 } time { sine { frequency: 300 phase: 1 } } }" % load
    for role, load in LOADS.items()}
STEPS = 20


def begun(participant, inside=None):
    """A run before its first step."""
    run = tied(participant, LOADED[participant.role] if inside is None else inside)
    if not run.model.state_format:
        run.link.socket.close()
        raise NotComputed("it names no state_format, and is never asked for a state")
    run.dt = run.model.critical_dt / 2
    return run


def moving(participant):
    """A run after some steps."""
    run = begun(participant)
    start(run, noise(run), run.dt)
    go_on(run, 2, STEPS)
    return run


def go_on(run, first, last):
    for n in range(first, last):
        answer = run.step(n, run.dt, want_energies=True)
    return velocities(answer).tobytes(), answer.energies.SerializeToString(deterministic=True)


def saved(run):
    """The parts of the run's state, each as what restores it."""
    parts, offset, size = [], 0, 1
    while offset < size:
        state = run.expect("state", save=wire.Save(offset=offset))
        require(state.data and offset + len(state.data) <= state.size, f"the part of the state at byte {offset} does not fit its size")
        require(zlib.crc32(state.data) == state.checksum, f"the part of the state at byte {offset} has another CRC-32 than it says")
        parts.append(wire.Restore(size=state.size, offset=offset, data=state.data, checksum=state.checksum))
        offset, size = offset + len(state.data), state.size
    return parts


def restored(participant):
    """continues from a state to the same bits as a run that never ended; saving changes nothing"""
    with moving(participant) as run:
        whole = go_on(run, STEPS, 2 * STEPS)
    with moving(participant) as run:
        parts = saved(run)
        require(go_on(run, STEPS, 2 * STEPS) == whole, "a run that saves differs from one that does not")
    with begun(participant) as run:
        for part in parts:
            run.expect("restored", restore=part)
        require(go_on(run, STEPS, 2 * STEPS) == whole, "a run that was restored differs from one that was not")


def refused_states(participant):
    """refuses a state that is damaged or of another model, with kind SCENE; parts out of order and a late one, with REQUEST"""
    with moving(participant) as run:
        parts = saved(run)
        late = parts[0]
        run.expect_error(wire.Error.REQUEST, restore=late)
    damaged = wire.Restore(size=late.size, offset=0, data=late.data[:-1] + bytes([late.data[-1] ^ 1]), checksum=late.checksum)
    misplaced = wire.Restore(size=late.size, offset=8, data=late.data, checksum=late.checksum)
    for part, kind in ((damaged, wire.Error.SCENE), (misplaced, wire.Error.REQUEST)):
        with begun(participant) as run:
            run.expect_error(kind, restore=part)
    with begun(participant) as run:
        other = np.frombuffer(late.data, np.uint8)[:len(late.data) // 2].tobytes()
        cut = wire.Restore(size=len(other), offset=0, data=other, checksum=zlib.crc32(other))
        run.expect_error(wire.Error.SCENE, restore=cut)


CHECKS = (restored, refused_states)
