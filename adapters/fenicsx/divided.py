"""The ground over the ranks: each of them steps the points that FEniCSx gave it, and what is asked of all is summed."""
import numpy as np
from reading import refuse_others

from ground import COMPUTED, Ground
from leap_frog import LeapFrog, Load, Motion
from wire import Unstable, wire
from zones import Zones, highest_eigenvalue


class Continuum(Ground):
    def __init__(self, ranks):
        self.ranks = ranks

    def setup(self, request, model):
        refuse_others(request.scene, COMPUTED)
        self.read_materials(self.read_grid(request.scene), request.scene.plane)
        kappa, mu, density = kinds = np.unique([self.kappa, self.mu, self.density], axis=1)
        if self.ranks.rank == 0:
            highest = max(highest_eigenvalue(self.size, *kind) for kind in kinds.T)
        model.critical_dt = 2 / np.sqrt(self.ranks.bcast(highest if self.ranks.rank == 0 else None))
        model.p_wave_speed, model.s_wave_speed = np.sqrt([((kappa + mu) / density).max(), (mu / density).max()])
        self.describe(model)

    def begin(self, points, masses, loads, motions):
        self.whole = LeapFrog()  # knows the masses of all points
        self.whole.begin(points, masses, loads, motions)
        self.divided = Zones(self.ranks, points, self.zones, self.zone_weights * self.kappa, self.zone_weights * self.mu)
        own = self.divided.own
        self.number = np.full(len(points), -1)  # of each point among those of this rank
        self.number[own] = np.arange(len(own))
        loads = [Load(*self.part(load.points, load.forces), load.factor) for load in loads]
        motions = [Motion(*self.part(motion.where[0]), motion.where[1], motion.velocity, motion.factor) for motion in motions]
        super().begin(points[own], masses[own], loads, motions)
        self.divided.follow(self.u)
        dashpots = self.read_quiet()[own]
        self.quiet = np.flatnonzero(dashpots.any(axis=1))
        self.dashpots, self.drag, self.dissipated = dashpots[self.quiet], 0.0, 0.0

    def part(self, points, *arrays):
        """This rank's numbers of those points that are its own, in their order, and what the arrays have for them."""
        numbers = self.number[points]
        here = np.argsort(numbers)[np.count_nonzero(numbers < 0):]
        return numbers[here], *(array[here] for array in arrays)

    def read_probes(self):
        return [(kind, column, *self.part(points, shares)) for kind, column, points, shares in super().read_probes()]

    def couple(self, request, operator):
        places = np.reshape(request.points, (-1, 2))
        rows, columns, shares = self.interpolate(places, "interface.overlap")
        self.whole.tie(rows, columns, shares, len(places))
        self.whole.fill_operator(operator)
        columns, rows, shares = self.part(columns, rows, shares)
        self.tie(rows, columns, shares, len(places))

    def internal_forces(self, dt):
        return self.divided.forces()

    def strain_energy(self):
        return -np.sum(self.u * self.divided.forces()) / 2

    def resist(self, force, dt):
        """Dashpots against the mean of the velocities before and after (fdm_server/solver/dashpots.hpp)."""
        before, half = self.v[self.quiet], dt / 2 * self.inverse[self.quiet]
        drag = -self.dashpots * (before + half * force[self.quiet]) / (1 + half * self.dashpots)
        force[self.quiet] += drag
        self.dissipated -= dt / 2 * np.sum(before * (self.drag + drag))
        self.drag = drag

    def advance(self, request, predicted):
        part, failure = wire.Predicted(), ""
        try:
            super().advance(request, part)
        except Unstable as error:
            failure = str(error)
        energies = (part.energies.kinetic, part.energies.strain, part.energies.external_work, self.dissipated)
        sums = np.zeros(1 + len(energies) + 2 * self.coupling_points + len(self.probes))
        if not failure:
            sums[1:] = *energies, *part.velocities, *(part.histories or np.zeros(len(self.probes)))
        sums[0] = bool(failure)
        self.ranks.Allreduce(sums.copy(), sums)
        if sums[0]:
            raise Unstable(next(filter(None, self.ranks.allgather(failure))))
        if not np.isfinite(sums).all():
            raise Unstable(f"step {request.step}: the energies are not finite; give a smaller time step")
        predicted.step = request.step
        predicted.velocities.extend(sums[5:5 + 2 * self.coupling_points])
        if request.want_energies:
            names = ("kinetic", "strain", "external_work", "dissipated")
            predicted.energies.MergeFrom(wire.Energies(**dict(zip(names, sums[1:5]))))
        if request.want_histories:
            predicted.histories.extend(sums[5 + 2 * self.coupling_points:])

    def snapshot_request(self, request, snapshot):
        self.correct(request.impulses)
        divided = self.ranks.gather((self.divided.own, self.u, self.v, self.divided.zones))
        if not divided:
            return
        u, v, rank = np.zeros_like(self.points), np.zeros_like(self.points), np.zeros(len(self.zones))
        for number, (own, part_u, part_v, zones) in enumerate(divided):
            u[own], v[own], rank[zones] = part_u, part_v, number
        self.draw(snapshot, u, v)
        snapshot.pieces[0].cell_fields.add(name="rank", components=1, values=rank.tolist())
