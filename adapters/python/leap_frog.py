"""Points with masses under central differences, as both templates step them:

    v(n+1/2) = v(n-1/2) + dt f(n) / m,    u(n+1) = u(n) + dt v(n+1/2),    from rest with half a kick

and what docs/protocol.md asks of every participant: loads, prescribed motions, impulses at coupling points, energies.
Arrays have a row for each point and a column for each component: x, y, and perhaps a spin.
"""
import math

import numpy as np

from wire import RequestError, Unstable


SPIN = 2  # the third component, where there is one


def together(points):
    """The same points, as a slice where they follow one another: numpy then copies nothing."""
    first = points[0] if len(points) else 0
    return slice(first, first + len(points)) if (np.diff(points) == 1).all() else points


class Load:
    """Forces on some points, a row (x, y) for each, times a factor."""

    def __init__(self, points, forces, factor):
        self.points, self.forces, self.factor = together(points), forces, factor
        self.last = 0.0


class Motion:
    """One component of some points has a velocity times a factor."""

    def __init__(self, points, column, velocity, factor):
        self.where = (points, column)
        self.velocity, self.factor = velocity, factor
        self.before = self.reaction = 0.0


class LeapFrog:
    next = 0  # step

    def begin(self, places, masses, loads, motions):
        """`places`: x and y of each point; `masses`: weighted, one for each component."""
        self.places, self.masses, self.loads, self.motions = places, masses, loads, motions
        self.inverse = 1 / masses
        for motion in motions:
            self.inverse[motion.where] = 0
        self.u, self.v, self.before = (np.zeros_like(masses) for _ in range(3))
        self.work = 0.0  # of loads and prescribed motions
        self.next, self.dt, self.kick = 0, None, None
        self.corrected = True
        self.tie(np.zeros(0, int), np.zeros(0, int), np.zeros(0), 0)

    def tie(self, rows, columns, shares, count):
        """The velocity at coupling point rows[e] has shares[e] of that of point columns[e]."""
        self.rows, self.columns, self.shares, self.coupling_points = rows, columns, shares, count

    def fill_operator(self, operator):
        own, numbers = np.unique(self.columns, return_inverse=True)  # the points that take part, and their new numbers
        operator.row_starts.extend(np.searchsorted(self.rows, range(self.coupling_points + 1)).tolist())
        operator.columns.extend(numbers.tolist())
        operator.values.extend(self.shares.tolist())
        operator.inverse_masses.extend(self.inverse[own, :2].ravel().tolist())

    # What a template supplies.
    def internal_forces(self, dt):
        """Forces at the present displacements; dt is that of the step that led there."""
        raise NotImplementedError

    def strain_energy(self):
        raise NotImplementedError

    def read_histories(self, values):
        raise NotImplementedError

    def resist(self, force, dt):
        """Adds the forces that depend on all others, such as those of dashpots; from rest there are none."""

    def tell_events(self, predicted):
        """Cracks, and the largest bond force."""

    def advance(self, request, predicted):
        self.check(request)
        self.correct(request.impulses)
        self.step(request.step, request.dt)
        predicted.step = request.step
        predicted.velocities.extend(self.at_coupling_points(self.v[:, :2]).ravel().tolist())
        self.tell_events(predicted)
        if request.want_energies:
            predicted.energies.kinetic = self.kinetic_energy(request.step == 0)
            predicted.energies.strain = self.strain_energy()
            predicted.energies.external_work = self.work
        if request.want_histories:
            self.read_histories(predicted.histories)

    def check(self, request):
        if request.step != self.next:
            raise RequestError(f"step {request.step} came where step {self.next} was expected")
        if not 0 < request.dt < math.inf or self.dt not in (None, request.dt):
            raise RequestError(f"step {request.step}: dt is {request.dt} s, after {self.dt} s; keep it positive and equal")
        if request.relax:
            raise RequestError("relax came, but this participant refuses scenes with statics")

    def correct(self, impulses):
        """Impulses at the coupling points end the step before: it becomes final."""
        if not impulses:
            return
        if self.corrected or len(impulses) != 2 * self.coupling_points:
            raise RequestError(f"{len(impulses)} impulses came for {self.coupling_points} coupling points, too early, or twice")
        self.corrected = True
        own = np.zeros_like(self.places)
        np.add.at(own, self.columns, self.shares[:, None] * np.reshape(impulses, (-1, 2))[self.rows])
        self.v[:, :2] += self.inverse[:, :2] * own
        for motion in self.motions:  # what is prescribed does not yield: its reaction takes the impulse up
            points, column = motion.where
            if column < 2:
                force = own[points, column] / self.kick
                motion.reaction = motion.reaction - force
                self.work -= self.dt * np.sum(motion.before * force) / 2

    def step(self, n, dt):
        self.dt, self.kick = dt, dt if n > 0 else dt / 2
        self.before = self.v
        self.book_loads(n * dt)
        force = self.integrate(n)
        for motion in self.motions:
            after = motion.velocity * motion.factor((n + 0.5) * dt)
            motion.before = self.before[motion.where] if n > 0 else -after  # from rest v(-1/2) = -v(1/2)
            change = after - motion.before if n > 0 else after  # but 0 where it comes to its velocity at once
            reaction = self.masses[motion.where] * change / dt - force[motion.where]
            if n > 0:
                self.work += dt * np.sum(motion.before * (motion.reaction + reaction)) / 2
            motion.reaction = reaction
            self.v[motion.where] = after
        if not np.isfinite(self.v).all():
            x, y = self.places[np.flatnonzero(~np.isfinite(self.v).all(axis=1))[0]]
            raise Unstable(f"step {n}: the velocity at ({x:g}, {y:g}) m is not finite; give a smaller time step")
        self.next, self.corrected = n + 1, False

    def book_loads(self, time):
        """Their work, by the trapezoid of the force; the velocity is 0 before step 0, so that it books nothing."""
        for load in self.loads:
            factor = load.factor(time)
            self.work += self.dt * np.sum(load.forces * self.v[load.points, :2]) * (load.last + factor) / 2
            load.last = factor

    def integrate(self, n):
        """To the displacements at n and to the velocities at n + 1/2 that no motion prescribes; the forces at n."""
        if n > 0:
            self.u += self.dt * self.v
        force = self.internal_forces(self.dt)
        for load in self.loads:
            force[load.points, :2] += load.last * load.forces
        if n > 0:
            self.resist(force, self.dt)
        self.v = self.v + self.kick * self.inverse * force
        return force

    def kinetic_energy(self, from_rest):
        """1/2 sum m v(n-1/2) v(n+1/2), the form that the scheme keeps; what is prescribed has v(-1/2) = 0 from rest."""
        before = -self.v if from_rest else self.before
        for motion in self.motions if from_rest else ():
            before[motion.where] = 0
        return np.sum(self.masses * before * self.v) / 2

    def at_coupling_points(self, velocities):
        found = np.zeros((self.coupling_points, 2))
        np.add.at(found, self.rows, self.shares[:, None] * velocities[self.columns])
        return found
