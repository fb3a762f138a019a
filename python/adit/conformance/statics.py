"""Statics: the rules of docs/protocol.md for the steps that relax, and for the first step of time after them."""
import numpy as np

from adit.conformance.client import require, scene_of, tied, wire
from adit.conformance.physics import LOADS, SMALL, close, noise, velocities

STATICS = "statics {} "
WEIGHT = "body_loads { acceleration { x: 1 y: -2 } } "
FALL = np.array([1, -2])
SHARE = 0.5  # of local damping


def relaxing(participant, inside=""):
    return tied(participant, inside, around=STATICS)


def refusals_in_statics(participant):
    """refuses statics after time, fields of statics in time, and another dt without `stop`, with kind REQUEST"""
    for before, wrong in ((False, {"relax": True}), (False, {"stop": True}), (False, {"stage": 1}), (False, {"local_damping": SHARE}),
                          (False, {"scale_masses": True}), (False, {"slowing": SHARE}), (True, {"dt": 2.0}), (True, {"local_damping": 1.0}), (True, {"step": 2})):
        with relaxing(participant) as run:
            dt = run.model.critical_dt / 4
            run.step(0, dt, relax=before)
            asked = {"step": 1, "relax": before, **wrong, "dt": dt * wrong.get("dt", 1)}
            run.expect_error(wire.Error.REQUEST, advance=wire.Advance(**asked))


def loads_in_statics(participant):
    """keeps loads at their values of t = 0, and prescribed velocities at 0"""
    load = LOADS[participant.role]
    grows = "time { table { time: 0 time: 1e-6 value: 1 value: 9 } }"
    with relaxing(participant, "%s { where { x_max: 0.15 } force { x: 3 y: -5 } %s }" % (load, grows)) as run:
        dt = run.model.critical_dt / 2
        for n in range(5):
            found = (run.masses * velocities(run.relax(n, dt))).sum(axis=0)
            close(found, (n + 0.5) * dt * np.array([3, -5]), f"the momentum after step {n} of statics")
    with relaxing(participant, WEIGHT + "motions { where { x_max: 0.15 } velocity { x: 2 } }") as run:
        held = np.isinf(run.masses[:, 0])
        for n in range(3):
            answer = velocities(run.relax(n, run.model.critical_dt / 2))
        require(held.any() and not answer[held, 0].any(), "moves in statics what is prescribed")


def relaxation(participant):
    """reports in each step of statics its unbalanced forces of the step before and its kinetic energy of this step"""
    load = LOADS[participant.role]
    with relaxing(participant, "%s { where { x_max: 0.15 } force { x: 3 } }" % load) as run:
        dt = run.model.critical_dt / 2
        answer = run.relax(0, dt)
        close(answer.relaxation.kinetic_energy, (run.masses * velocities(answer)**2).sum() / 2, "the kinetic energy")
        said = run.relax(1, dt).relaxation
        close(said.unbalanced_force, 3, "the unbalanced force of a load of 3 N, nothing else being strained")
        close([said.net_x, said.net_y], [3, 0], "the sum of the unbalanced forces")
        require(said.points == len(run.points), f"relaxes {said.points} points, {len(run.points)} were expected")
        require(0 < said.largest_unbalanced_force <= 3 and run.model.x_min <= said.x <= 0.15,
                f"names {said.largest_unbalanced_force:g} N at x = {said.x:g} m as the largest unbalanced force")


def local_damping(participant):
    """applies to each component a share of its unbalanced force, against its velocity"""
    changes = []
    for share in (0, SHARE):
        with relaxing(participant) as run:
            dt = run.model.critical_dt / 2
            run.relax(0, dt)
            before = velocities(run.relax(1, dt, impulses=run.masses * noise(run)))
            changes.append(velocities(run.relax(2, dt, local_damping=share)) - before)
    free, braked = changes
    close(braked, free - SHARE * np.abs(free) * np.sign(before), "the change of velocity under local damping", 1e-6)


def stop(participant):
    """stops on request, and starts from rest by half a kick, also with another dt"""
    with relaxing(participant, WEIGHT) as run:
        dt = run.model.critical_dt / 2
        for n, (length, asked) in enumerate(((1, {}), (1, {}), (1, {"stop": True}), (0.5, {"stop": True}), (0.5, {}))):
            answer = velocities(run.relax(n, length * dt, **asked))
            kicks = {0: 0.5, 1: 1.5, 2: 0.5, 3: 0.25, 4: 0.75}[n]
            close(answer, np.tile(kicks * dt * FALL, (len(run.points), 1)), f"velocities of step {n} under weight")


def slowing(participant):
    """slows the corrected motion by a share before a step, if it states `slows`"""
    with relaxing(participant, WEIGHT) as run:
        if not run.model.slows:
            return
        dt = run.model.critical_dt / 2
        run.relax(0, dt)
        answer = velocities(run.relax(1, dt, slowing=SHARE))
        close(answer, np.tile(((1 - SHARE) / 2 + 1) * dt * FALL, (len(run.points), 1)), "velocities under weight, slowed")


def scaled_masses(participant):
    """uses the scaled masses that it stated, with unchanged loads, if it states `scales_masses`"""
    with relaxing(participant, WEIGHT) as run:
        if not run.model.scales_masses:
            return
        scaled = 1 / np.reshape(run.operator.scaled_inverse_masses, (-1, 2))[list(run.operator.columns)]
        dt = run.model.critical_static_dt or run.model.critical_dt
        answer = run.relax(0, dt / 2, scale_masses=True)
        close(scaled * velocities(answer), dt / 4 * FALL * run.masses, "the momentum of scaled masses after half a kick")
        said = run.relax(1, dt / 2, scale_masses=True).relaxation
        close(said.unbalanced_force, np.hypot(*FALL) * run.masses[:, 0].sum(), "the unbalanced force of the weight")
        run.expect_error(wire.Error.REQUEST, advance=wire.Advance(step=2, dt=dt / 2, relax=True))


def rest_of_statics(participant):
    """begins time at rest with the stresses reached: displacements, energies and work count from there"""
    held = "motions { where { x_max: 0.15 } velocity { x: 0 y: 0 } } "
    place = {"continuum": "at { x: 2 y: 1 }", "particles": "at { x: 1 y: 0.5 }"}[participant.role]
    watched = "histories { name: \"u\" quantity: DISPLACEMENT_Y %s }" % place
    with participant.run() as run:
        run.set_up(scene_of(participant.role, held + WEIGHT + watched, STATICS))
        run.weigh(coupled=False)
        dt = run.model.critical_dt / 2
        for n in range(6000):
            said = run.relax(n, dt, local_damping=0.8, want_histories=n % 100 == 0).relaxation
            if n > 100 and said.unbalanced_force / said.points < 1e-6 * said.internal_force / said.elements:
                break
        sagged = run.relax(n + 1, dt, local_damping=0.8, want_histories=True).histories[0]
        require(sagged < 0, f"sags by {-sagged:g} m under its weight")
        moved, sums = [], []
        for n in range(100):
            answer = run.step(n, dt, want_energies=True, want_histories=True)
            e = answer.energies
            moved.append(answer.histories[0])
            sums.append(e.kinetic + e.strain + e.released + e.dissipated - e.external_work)
            if n == 0:
                require(e.external_work == e.released == 0, "the work of statics is in the sums of time")
    require(moved[0] == 0, "displacements do not begin from 0 with time")
    apart = max(map(abs, moved)) / abs(sagged)
    require(apart < 1e-3, f"moves by {apart:.2g} of its sag when time begins, though it was at rest")
    close(sums, [sums[0]] * len(sums), "the energy ledger after statics", 1e-9)


def impulses_of_statics(participant):
    """accepts impulses on the last step of statics with the first step of time, without any effect"""
    with relaxing(participant) as run:
        dt = run.model.critical_dt / 2
        for n in range(2):
            run.relax(n, dt)
        answer = velocities(run.step(0, dt, impulses=run.masses * SMALL))
        require(not answer.any(), "what corrects the last step of statics moves the first step of time")


CHECKS = (refusals_in_statics, loads_in_statics, relaxation, local_damping, stop, slowing, scaled_masses,
          rest_of_statics, impulses_of_statics)
