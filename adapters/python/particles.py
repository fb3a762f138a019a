#!/usr/bin/python3
"""Bonded particles as a participant: a hexagonal packing of equal discs with contact bonds, computed with numpy.

    adapters/python/particles.py --listen 127.0.0.1:4712 &
    coupler run cases/cantilever/coupled.yaml --dem 127.0.0.1:4712

It is a template for your own code: docs/your_code.md goes through it. A broken bond leaves a contact that pushes; discs
that were never bonded do not find each other, and the run ends before that could matter.
"""
import numpy as np

from leap_frog import SPIN, LeapFrog, Load
from reading import BOX, FACTOR, POINT, body_loads, factor, keys, motion_history, prescribed, refuse_others, select
from wire import SceneError, scene, serve, wire

MATERIAL = {"young_modulus": True, "poisson_ratio": True, "density": True}
COMPUTED = {
    "name": True, "description": True, "time": True, "plane": True, "material": MATERIAL,
    "particles": {
        "packing": {"x_min": True, "x_max": True, "y_min": True, "y_max": True, "radius": True}, "material": MATERIAL,
        "engine": {scene.Particles.AUTOMATIC, scene.Particles.LATTICE},
        "bonds": {"tensile_strength": True, "shear_strength": True, "normal_stiffness": True, "shear_stiffness": True},
        "loads": {"where": BOX, "force": True, "time": FACTOR},
        "body_loads": {"where": BOX, "acceleration": True, "time": FACTOR},
        "motions": {"where": BOX, "velocity": True, "spin": True, "time": FACTOR},
        "histories": {"name": True, "quantity": True, "at": POINT}}}


def hexagonal(box, radius):
    """Rows from below, each as many discs as fit, those between one less and shifted by a radius. Places, and row and
    column of each disc, columns counted in radii."""
    pitch = np.sqrt(3) * radius
    rows, wide = int((box.y_max - box.y_min) / pitch + 1e-6), int((box.x_max - box.x_min) / (2 * radius) + 1e-6)
    lattice = np.array([(row, 2 * k + (row + 1) % 2) for row in range(rows) for k in range(row % 2, wide)], int).reshape(-1, 2)
    left, below = (box.x_min + box.x_max) / 2 - wide * radius, (box.y_min + box.y_max - rows * pitch) / 2
    return np.stack([left + lattice[:, 1] * radius, below + (lattice[:, 0] + 0.5) * pitch], axis=1), lattice


def touching(lattice):
    """Pairs of discs that touch: along the rows, and up to the right and the left."""
    number = {tuple(place): i for i, place in enumerate(lattice)}
    pairs = [(i, number.get((row + up, column + right)))
             for i, (row, column) in enumerate(lattice) for up, right in ((0, 2), (1, 1), (1, -1))]
    return np.array([pair for pair in pairs if pair[1] is not None], int).reshape(-1, 2)


def lattice_stiffness(material, plane):
    """kn and ks [N/m] of the lattice that deforms like the solid (dem_server/model/calibration.hpp)."""
    young, poisson = material.young_modulus, material.poisson_ratio
    if plane == scene.PLANE_STRAIN:
        young, poisson = young / (1 - poisson**2), poisson / (1 - poisson)
    lame, shear = young * poisson / (1 - poisson**2), young / (2 * (1 + poisson))
    return 2 / np.sqrt(3) * np.array([shear + lame, shear - lame])


class Particles(LeapFrog):
    def setup(self, request, model):
        refuse_others(request.scene, COMPUTED)
        self.given = request.scene.particles
        if not (self.given.HasField("packing") and self.given.HasField("bonds")):
            raise SceneError("particles", "has no packing or no bonds; this participant computes bonded hexagonal packings")
        material = self.given.material if self.given.HasField("material") else request.scene.material
        self.radius, self.laws = self.given.packing.radius, self.given.bonds
        self.centres, lattice = hexagonal(self.given.packing, self.radius)
        self.ids, self.bonds = np.arange(len(self.centres)), touching(lattice)
        if not len(self.bonds):
            raise SceneError("particles.packing", "holds no two discs that touch; enlarge the box or reduce the radius")
        self.kn, self.ks = lattice_stiffness(material, request.scene.plane)
        self.kn = self.laws.normal_stiffness if self.laws.HasField("normal_stiffness") else self.kn
        self.ks = self.laws.shear_stiffness if self.laws.HasField("shear_stiffness") else self.ks
        if self.ks < 0:
            raise SceneError("material.poisson_ratio", "is above 1/4 (plane strain) or 1/3 (plane stress), the most of bonds")
        self.mass = material.density * 2 * np.sqrt(3) * self.radius**2  # of a hexagonal cell
        low, high = self.centres.min(axis=0) - self.radius, self.centres.max(axis=0) + self.radius
        self.tolerance = 1e-9 * max(high - low)

        # Each bond alone, with equal shares of the masses at its ends, has the highest frequency of all.
        ends = np.bincount(self.bonds.ravel())[self.bonds].sum(axis=1).max() / self.mass
        model.critical_dt = 2 / np.sqrt(max(self.kn, 3 * self.ks) * ends)  # the inertia is m R^2 / 2
        model.critical_element = "bond"
        model.x_min, model.y_min, model.x_max, model.y_max = *low, *high
        stiffness = np.sqrt(3) / 4 * np.array([3 * self.kn + self.ks, self.kn + self.ks])
        model.p_wave_speed, model.s_wave_speed = np.sqrt(stiffness / material.density)
        middles = self.centres[self.bonds].mean(axis=1)
        model.sample_points.extend(np.concatenate([self.centres, middles]).ravel().tolist())

    def weights(self, request, interface):
        coupled = len(request.weights) > 0
        weights = np.array(request.weights) if coupled else np.ones(len(self.centres) + len(self.bonds))
        exists, at_bonds = weights[:len(self.centres)] != 0, weights[len(self.centres):]
        stays = exists[self.bonds].all(axis=1)
        if not stays.any():
            raise SceneError("interface.overlap", "leaves no bonded particles; let the packing reach beyond the overlap")
        self.bond_weights = np.maximum(at_bonds[stays], request.floor)
        self.bonds = (np.cumsum(exists) - 1)[self.bonds[stays]]
        own = np.maximum(weights[:len(self.centres)][exists], request.floor)
        self.centres, self.ids = self.centres[exists], self.ids[exists]
        # A disc weighs the mean of its bonds: then no weight shortens the critical step.
        counts = np.bincount(self.bonds.ravel(), minlength=len(self.centres))
        sums = np.bincount(self.bonds.ravel(), np.repeat(self.bond_weights, 2), len(self.centres))
        disc_weights = np.where(counts > 0, sums / np.maximum(counts, 1), own)
        masses = self.mass * disc_weights[:, None] * [1, 1, self.radius**2 / 2]
        motions = prescribed(self.given.motions, "particles.motions", self.centres, self.tolerance)
        self.begin(self.centres, masses, self.read_loads(masses[:, 0]), motions)
        self.rest = self.centres[self.bonds[:, 1]] - self.centres[self.bonds[:, 0]]
        self.intact = np.ones(len(self.bonds), bool)
        self.normal, self.shear = np.zeros((2, len(self.bonds)))
        self.cracked, self.shear_cracks, self.released = np.zeros(0, int), np.zeros(0, bool), 0.0
        self.probes = self.read_probes()
        if coupled:
            low, high = (request.x_min, request.y_min), (request.x_max, request.y_max)
            offered = self.centres[((self.centres >= low) & (self.centres <= high)).all(axis=1)]
            interface.points.extend(offered.ravel().tolist())
        interface.particles, interface.bonds, interface.mass = len(self.centres), len(self.bonds), masses[:, 0].sum()
        breakable = np.isfinite([self.laws.tensile_strength, self.laws.shear_strength]).any()
        interface.breakable_bonds = len(self.bonds) if breakable else 0

    def read_loads(self, masses):
        loads = []
        for i, load in enumerate(self.given.loads):
            chosen = select(load.where, self.centres, self.tolerance, f"particles.loads[{i}].where")
            force = np.array([load.force.x, load.force.y]) / len(chosen)
            loads.append(Load(chosen, np.tile(force, (len(chosen), 1)), factor(load.time)))
        return loads + body_loads(self.given.body_loads, "particles.body_loads", self.centres, masses, self.tolerance)

    def read_probes(self):
        probes = []
        for i, history in enumerate(self.given.histories):
            path = f"particles.histories[{i}]"
            kind, column = motion_history(history, path, scene.Quantity)
            distances = np.linalg.norm(self.centres - (history.at.x, history.at.y), axis=1)
            if distances.min() > 2 * self.radius:
                raise SceneError(f"{path}.at", "lies more than a diameter away from all particles")
            probes.append((kind, column, distances.argmin()))
        return probes

    def couple(self, request, operator):
        """The coupler sends offered centres back as the same 64 bits, so that they are found without a tolerance."""
        number = {place.tobytes(): i for i, place in enumerate(self.centres)}
        places = np.reshape(request.points, (-1, 2))
        found = [number.get(place.tobytes()) for place in places]
        if None in found:
            raise SceneError("interface.overlap", "ties particles beside their centres, which this participant does not compute")
        self.tie(np.arange(len(found)), np.array(found), np.ones(len(found)), len(found))
        self.fill_operator(operator)

    def internal_forces(self, dt):
        first, second = self.bonds.T
        slid, moved = (field[second] - field[first] for field in (self.v, self.u))
        now = self.rest + moved[:, :2]
        length = np.hypot(*now.T)
        along = now / length[:, None]
        across = np.stack([-along[:, 1], along[:, 0]], axis=1)
        arm = length / 2
        # L - L0 without the loss of digits that a difference of two lengths has.
        stretch = np.sum(moved[:, :2] * (self.rest + now), axis=1) / (length + 2 * self.radius)
        slip = dt * (np.sum(slid[:, :2] * across, axis=1) - arm * (self.v[first, SPIN] + self.v[second, SPIN]))
        normal, shear = self.kn * stretch, np.where(self.intact, self.shear + self.ks * slip, 0.0)
        self.break_bonds(normal, shear, dt * np.sum(slid[:, :2] * along, axis=1), slip)
        if (np.hypot(*moved[~self.intact, :2].T) > self.radius / 2).any():  # then other discs may meet
            raise SceneError("particles", "break and move by more than half a radius; this participant finds no new contacts, "
                             "use dem_server")
        self.normal = np.where(self.intact, normal, np.minimum(normal, 0))
        self.shear = np.where(self.intact, shear, 0)

        force = self.bond_weights[:, None] * (self.normal[:, None] * along + self.shear[:, None] * across)
        moment = self.bond_weights * self.shear * arm
        sums = np.zeros_like(self.u)
        np.add.at(sums, first, np.column_stack([force, moment]))
        np.add.at(sums, second, np.column_stack([-force, moment]))
        return sums

    def break_bonds(self, normal, shear, stretching, slip):
        in_tension = self.intact & (normal > self.laws.tensile_strength)
        breaks = in_tension | (self.intact & (abs(shear) > self.laws.shear_strength))
        self.cracked = np.flatnonzero(breaks)
        self.shear_cracks = ~in_tension[self.cracked]
        # What they stored, F(n-1) F(n) / 2k as leap-frog keeps it; a contact goes on bearing compression.
        by_normal = np.where(normal > 0, normal * (normal / self.kn - stretching), 0)
        by_shear = shear * (shear / self.ks - slip) if self.ks > 0 else 0
        self.released += np.sum((self.bond_weights * (by_normal + by_shear) / 2)[breaks])
        self.intact &= ~breaks

    def strain_energy(self):
        by_shear = self.shear**2 / self.ks if self.ks > 0 else 0
        return np.sum(self.bond_weights * (self.normal**2 / self.kn + by_shear)) / 2

    def advance(self, request, predicted):
        super().advance(request, predicted)
        if request.want_energies:
            predicted.energies.released = self.released

    def tell_events(self, predicted):
        step = predicted.step
        middles = self.centres[self.bonds].mean(axis=1)
        strongest = abs(self.normal).argmax()
        x, y = middles[strongest]
        predicted.strongest.add(step=step, force=abs(self.normal[strongest]), x=x, y=y)
        for bond, sheared in zip(self.cracked, self.shear_cracks):
            angle = np.arctan2(*self.rest[bond][::-1]) - np.pi / 2  # of the crack, at right angles to the bond
            (x, y), (first, second) = middles[bond], self.ids[self.bonds[bond]]
            predicted.cracks.add(step=step, mode=wire.Crack.SHEAR if sheared else wire.Crack.TENSILE, x=x, y=y,
                                 length=2 * self.radius / np.sqrt(3), parent_a=first, parent_b=second, group="particles",
                                 orientation=angle if angle > -np.pi / 2 else angle + np.pi)

    def read_histories(self, values):
        for kind, column, disc in self.probes:
            values.append((self.u if kind == "displacement" else self.before)[disc, column])

    def snapshot_request(self, request, snapshot):
        self.correct(request.impulses)
        discs = snapshot.pieces.add(name="particles", shape=wire.Piece.VERTICES, connectivity=range(len(self.centres)))
        bonds = snapshot.pieces.add(name="bonds", shape=wire.Piece.LINES, connectivity=self.bonds.ravel().tolist())
        for piece in (discs, bonds):
            piece.points.extend(self.centres.ravel().tolist())
            piece.point_fields.add(name="displacement_m", components=2, values=self.u[:, :2].ravel().tolist())
        discs.point_fields.add(name="velocity_m_per_s", components=2, values=self.v[:, :2].ravel().tolist())
        discs.point_fields.add(name="radius_m", components=1, values=[self.radius] * len(self.centres))
        for name, values in (("normal_force_N", self.normal), ("shear_force_N", self.shear), ("weight", self.bond_weights)):
            bonds.cell_fields.add(name=name, components=1, values=values.tolist())

    def finish(self, request, bye):
        bye.updates = len(self.centres) * max(self.next - 1, 0)  # step 0 does not move


if __name__ == "__main__":
    serve("numpy_particles", Particles, list(keys(scene.Scene.DESCRIPTOR, COMPUTED)))
