"""Physics of every participant: momentum, energy, rigid motion, uniform strain, weights, the step.

All points of a small model are coupling points, so that impulses can give it any motion, and the answers contain the velocity of
every point. A tolerance of 1e-9 leaves room for the rounding of some hundred steps.
"""
import numpy as np

from adit.conformance.client import STATED, NotComputed, require, scene_of, tied, wire

TOLERANCE = 1e-9
# Small enough for particles to stay linear although their bonds turn, large enough for codes that store places instead of displacements [m/s].
SMALL = 1e-6
# Forces on the edge of a lattice differ from those inside; its stored energy is that of the solid but for the rows there.
ENERGY_OF_SOLID = {"continuum": 1e-9, "particles": 0.3}

# What a scene calls forces on the edge of a continuum, and on particles.
LOADS = {"continuum": "edge_loads", "particles": "loads"}


def close(found, expected, what, tolerance=TOLERANCE):
    found, expected = np.asarray(found, float), np.asarray(expected, float)
    scale = max(abs(expected).max(), 1e-300)
    apart = abs(found - expected).max() / scale
    require(apart <= tolerance, f"{what}: off by {apart:.2g} of the largest value, at most {tolerance:g} was expected")


def velocities(predicted):
    return np.reshape(predicted.velocities, (-1, 2))


def start(run, motion, dt):
    """Step 0 without any motion; then the impulses that give every point this velocity."""
    run.step(0, dt)
    return run.step(1, dt, run.masses * motion, want_energies=True)


def noise(run):
    return np.random.default_rng(4).uniform(-SMALL, SMALL, run.points.shape)


def model(participant):
    """states a positive critical step, a box, wave speeds of the material, and the places where it needs weights"""
    with participant.run() as run:
        said = run.set_up(scene_of(participant.role))
    require(0 < said.critical_dt < np.inf, f"critical_dt is {said.critical_dt} s")
    require(said.x_min < said.x_max and said.y_min < said.y_max, "the bounding box is empty")
    require(len(said.sample_points) >= 2 and len(said.sample_points) % 2 == 0, "there are no pairs of sample points")
    modulus = STATED["young"] / (1 - STATED["poisson"]**2)
    for name, stiffness in (("p", modulus), ("s", modulus * (1 - STATED["poisson"]) / 2)):
        found, expected = getattr(said, f"{name}_wave_speed"), np.sqrt(stiffness / STATED["density"])
        require(abs(found - expected) < 0.1 * expected, f"{name}_wave_speed is {found:g} m/s, {expected:g} m/s was expected")


def mass(participant):
    """has the mass that it states, multiplied by the weights"""
    with tied(participant) as whole:
        close(whole.masses[:, 0].sum(), whole.interface.mass, "inverse masses and interface.mass")
        require(len(np.unique(whole.points, axis=0)) == len(whole.points), "offers a point twice")
    with tied(participant, weight=0.25) as quarter:
        close(4 * quarter.masses, whole.masses, "masses under weights of 1/4")


def operator_rows(participant):
    """sends rows that sum to 1, one entry at an own point, and linear interpolation elsewhere"""
    with tied(participant) as run:
        require(list(run.operator.row_starts) == list(range(len(run.points) + 1)) and set(run.operator.values) == {1.0},
                "a point that it offered has another row than one entry, 1")
        require(len(set(run.operator.columns)) == len(run.points), "two points that it offered are one own point")
    with participant.run() as run:
        run.set_up(scene_of(participant.role))
        run.weigh()
        middle = run.points.mean(axis=0)
        between = middle + (run.points - middle) * [0.71, 0.63]
        answer = run.couple(np.concatenate([run.points, between]))
        count, columns, values = len(run.points), np.array(answer.columns), np.array(answer.values)
        place = np.zeros((columns.max() + 1, 2))
        place[columns[:count]] = run.points
        for k, expected in enumerate(between, start=count):
            row = slice(answer.row_starts[k], answer.row_starts[k + 1])
            close(values[row].sum(), 1, f"the sum of row {k}")
            close(values[row] @ place[columns[row]], expected, f"the interpolated place of row {k}")


def chosen_points(participant):
    """ties exactly the points of the request, in its order"""
    chosen = np.random.default_rng(5).permutation(8)
    with tied(participant) as run:
        dt = run.model.critical_dt / 2
        motion = np.zeros(run.points.shape)
        motion[chosen] = noise(run)[chosen]
        expected = velocities(start(run, motion, dt))[chosen]
    with tied(participant, chosen=chosen) as run:
        close(velocities(start(run, motion[chosen], dt)), expected, "velocities of eight points that were chosen")


def applied_force(participant):
    """gives half a kick at step 0: the momentum of a force is F dt / 2"""
    load = LOADS[participant.role]
    with tied(participant, "%s { where { x_max: 0.15 } force { x: 3 y: -5 } }" % load) as run:
        dt = run.model.critical_dt / 2
        first = velocities(run.step(0, dt))
        close((run.masses * first).sum(axis=0), dt / 2 * np.array([3, -5]), "the momentum after step 0")


def body_load(participant):
    """falls as a rigid body with any weights, and books the work of its weight"""
    for weight in (1.0, 0.25):
        with tied(participant, "body_loads { acceleration { x: 1 y: -2 } }", weight) as run:
            dt = run.model.critical_dt / 2
            for n in range(5):
                answer = run.step(n, dt, want_energies=True)
                falling = np.tile((n + 0.5) * dt * np.array([1, -2]), (len(run.points), 1))
                close(velocities(answer), falling, f"velocities of step {n}")
            fallen = dt * dt * sum(k + 0.5 for k in range(4))
            close(answer.energies.external_work, run.interface.mass * 5 * fallen, "work of the weight")


def prescribed(participant):
    """moves prescribed points at (n + 1/2) dt, and ignores impulses there"""
    ramp = "time { table { time: 0 time: 1 value: 0 value: 1 } }"
    with tied(participant, "motions { where { x_max: 0.15 } velocity { x: 2 } %s }" % ramp) as run:
        dt = run.model.critical_dt / 2
        held = np.isinf(run.masses[:, 0])
        require(held.any() and not held.all() and not np.isinf(run.masses[:, 1]).any(),
                "inverse masses are not 0 for just the components that are prescribed")
        for n in range(3):
            impulses = np.ones(run.points.shape) if n > 0 else ()
            answer = velocities(run.step(n, dt, impulses))
            close(answer[held, 0], np.full(held.sum(), 2 * (n + 0.5) * dt), f"prescribed velocities of step {n}")


def rigid_translation(participant):
    """keeps a uniform motion, without any force"""
    with tied(participant) as run:
        motion = np.tile([SMALL, -2 * SMALL], (len(run.points), 1))
        answer = start(run, motion, run.model.critical_dt / 2)
        for n in range(2, 50):
            answer = run.step(n, run.model.critical_dt / 2, want_energies=True)
        close(velocities(answer), motion, "velocities after 50 steps", 1e-6)
        kinetic = (run.masses * motion**2).sum() / 2
        close(answer.energies.kinetic, kinetic, "kinetic energy", 1e-6)
        require(abs(answer.energies.strain) < 1e-6 * kinetic, "a rigid motion strains the model")


def rigid_rotation(participant):
    """has no stress when it turns as a rigid body, by a small angle"""
    if participant.role == "particles":
        raise NotComputed("the spins of particles begin at 0, and impulses do not turn them")
    with tied(participant) as run:
        x, y = (run.points - run.points.mean(axis=0)).T
        motion = SMALL * np.stack([-y, x], axis=1)
        answer = start(run, motion, run.model.critical_dt / 2)
        close(velocities(answer), motion, "velocities after a small turn")


def uniform_strain(participant):
    """passes the patch test: under uniform strain its inside stays at rest and stores the energy of the solid"""
    for gradient in ([[1, 0], [0, 0]], [[0, 0], [0, 1]], [[0.5, 0.5], [0.5, -1]]):
        with tied(participant) as run:
            dt = run.model.critical_dt / 2
            middle = run.points.mean(axis=0)
            motion = SMALL / dt * (run.points - middle) @ np.array(gradient)
            answer = start(run, motion, dt)
            low, high = run.points.min(axis=0), run.points.max(axis=0)
            margin = 0.26 if participant.role == "particles" else 1e-6
            inside = ((run.points > low + margin) & (run.points < high - margin)).all(axis=1)
            at_rest = np.where(inside[:, None], velocities(answer), motion)
            close(at_rest, motion, "velocities inside under uniform strain", 1e-6)
            strain = SMALL * np.array(gradient)
            young, poisson = STATED["young"], STATED["poisson"]
            density = young / (1 - poisson**2) * ((1 - poisson) * (strain**2).sum() + poisson * np.trace(strain)**2) / 2
            expected = density * run.interface.mass / STATED["density"]
            close(answer.energies.strain, expected, "strain energy under uniform strain",
                  max(ENERGY_OF_SOLID[participant.role], 1e-6 if participant.role == "particles" else 0))


def momentum(participant):
    """keeps linear momentum to rounding for any motion"""
    with tied(participant) as run:
        motion = noise(run)
        before = (run.masses * motion).sum(axis=0)
        answer = start(run, motion, run.model.critical_dt / 2)
        for n in range(2, 200):
            answer = run.step(n, run.model.critical_dt / 2)
        total = np.abs(run.masses * motion).sum()
        after = (run.masses * velocities(answer)).sum(axis=0)
        changed = abs(after - before).max() / total
        require(changed < TOLERANCE, f"momentum changed by {changed:.2g} of the sum of its amounts")


def energy_ledger(participant):
    """closes its energy ledger: kinetic + strain + released + dissipated - work is constant"""
    load = LOADS[participant.role]
    inside = ("%s { where { x_max: 0.15 } force { y: 1 } time { sine { frequency: 300 phase: 1 } } } "
              "motions { where { x_min: 1.8 } velocity { x: 1e-6 y: 2e-6 } time { sine { frequency: 200 } } }" % load)
    for weight in (1.0, 0.3):
        with tied(participant, inside, weight) as run:
            dt, sums, largest = run.model.critical_dt / 2, [], 0
            for n in range(300):
                e = run.step(n, dt, want_energies=True).energies
                sums.append(e.kinetic + e.strain + e.released + e.dissipated - e.external_work)
                largest = max(largest, e.kinetic + e.strain)
            apart = max(abs(np.array(sums) - sums[0])) / largest
            require(apart < TOLERANCE * 100, f"the energy ledger is off by {apart:.2g} of the largest energy")


def critical_step(participant):
    """is stable at 0.999 of the critical step that it states"""
    with tied(participant) as run:
        dt = 0.999 * run.model.critical_dt
        motion = noise(run)
        answer = start(run, motion, dt)
        for n in range(2, 2000):
            answer = run.step(n, dt)
        grown = abs(velocities(answer)).max() / SMALL
        require(grown < 1e3, f"the largest velocity has grown by a factor {grown:.2g} in 2000 steps")


def what_is_wanted(participant):
    """gives the same bits whether or not energies are requested, and in every run"""
    runs = []
    for wanted in (False, True, True):
        with tied(participant) as run:
            dt = run.model.critical_dt / 2
            run.step(0, dt, want_energies=wanted)
            answer = run.step(1, dt, run.masses * noise(run), want_energies=wanted)
            for n in range(2, 30):
                answer = run.step(n, dt, want_energies=wanted)
            runs.append(velocities(answer))
    require((runs[0] == runs[1]).all(), "velocities depend on whether energies are wanted")
    require((runs[1] == runs[2]).all(), "two equal runs differ")


def snapshot(participant):
    """sends snapshots corrected by their impulses, in pieces of consistent sizes"""
    with tied(participant) as run:
        dt = run.model.critical_dt / 2
        run.step(0, dt)
        impulses = run.masses * [SMALL, 0]
        drawn = run.expect("snapshot", snapshot_request=wire.SnapshotRequest(impulses=impulses.ravel().tolist()))
        cells = {wire.Piece.VERTICES: 1, wire.Piece.LINES: 2, wire.Piece.QUADS: 4}
        moving = False
        for piece in drawn.pieces:
            points, corners = len(piece.points) // 2, len(piece.connectivity)
            require(corners % cells[piece.shape] == 0 and max(piece.connectivity, default=0) < max(points, 1),
                    f"the cells of piece {piece.name} do not fit its points")
            for count, fields in ((points, piece.point_fields), (corners // cells[piece.shape], piece.cell_fields)):
                for field in fields:
                    require(len(field.values) == field.components * count, f"field {field.name} of {piece.name} has a wrong size")
                    moving = moving or field.name == "velocity_m_per_s" and np.isclose(max(field.values), SMALL)
        require(moving, "no piece shows the corrected velocity as velocity_m_per_s")
        close(velocities(run.step(1, dt)), np.tile([SMALL, 0], (len(run.points), 1)), "velocities after the snapshot", 1e-6)


def histories(participant):
    """reports displacements of step n and velocities half a step before, in the order of the scene"""
    place = "at { x: 1 y: 1 }" if participant.role == "continuum" else "at { x: 1 y: 0.5 }"
    inside = "body_loads { acceleration { x: 1 y: -2 } } " + " ".join(
        "histories { name: \"%s\" quantity: %s %s }" % (quantity, quantity, place)
        for quantity in ("DISPLACEMENT_Y", "DISPLACEMENT_X", "VELOCITY_Y"))
    with participant.run() as run:
        run.set_up(scene_of(participant.role, inside))
        run.weigh(coupled=False)
        dt = run.model.critical_dt / 2
        for n in range(4):
            found = run.step(n, dt, want_histories=True).histories
            require(len(found) == 3, f"sent {len(found)} histories where 3 were expected")
        moved = dt * dt * sum(k + 0.5 for k in range(3))
        close(found, [-2 * moved, moved, -2 * 2.5 * dt], "histories of step 3")


def strongest(participant):
    """reports the largest bond force of each step with requested energies"""
    if participant.role == "continuum":
        raise NotComputed("a continuum has no bonds")
    with tied(participant) as run:
        dt = run.model.critical_dt / 2
        run.step(0, dt)
        answer = run.step(1, dt, run.masses * noise(run), want_energies=True)
        require(answer.strongest and answer.strongest[-1].step == 1, "did not say the largest bond force of the step")
        require(answer.strongest[-1].force > 0, "says 0 for a strained lattice")


CHECKS = (model, mass, operator_rows, chosen_points, applied_force, body_load, prescribed, rigid_translation, rigid_rotation, uniform_strain,
          momentum, energy_ledger, critical_step, what_is_wanted, snapshot, histories, strongest)
