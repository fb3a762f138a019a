#!/usr/bin/python3
"""An elastic continuum as a participant: one block of equal zones, computed with numpy.

    adapters/python/continuum.py --listen 127.0.0.1:4711 &
    coupler run cases/cantilever/coupled.yaml --fdm 127.0.0.1:4711

It is a template for your own code: docs/your_code.md goes through it.
"""
import numpy as np

from leap_frog import LeapFrog, Load
from reading import BOX, FACTOR, POINT, body_loads, factor, keys, motion_history, prescribed, refuse_others, select
from wire import SceneError, scene, serve, wire

MATERIAL = {"young_modulus": True, "poisson_ratio": True, "density": True}
COMPUTED = {
    "name": True, "description": True, "time": True, "plane": True, "material": MATERIAL,
    "continuum": {
        "block": True, "zone": {scene.ASSUMED_STRAIN}, "material": MATERIAL,
        "edge_loads": {"where": BOX, "force": True, "time": FACTOR},
        "body_loads": {"where": BOX, "acceleration": True, "time": FACTOR},
        "motions": {"where": BOX, "velocity": True, "time": FACTOR},
        "histories": {"name": True, "quantity": True, "at": POINT}}}

CORNERS = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])  # of a zone, in natural coordinates, counter-clockwise
# Places in a zone at which its weight is sampled, and Simpson's rule over them.
SAMPLES = np.array([(x, y) for y in (-0.5, 0, 0.5) for x in (-0.5, 0, 0.5)])
SIMPSON = np.outer([1, 4, 1], [1, 4, 1]).ravel() / 36


def moduli(material, plane):
    """kappa and mu of stress in the plane [Pa]: sxx + syy = 2 kappa (exx + eyy), sxx - syy = 2 mu (exx - eyy)."""
    young, poisson = material.young_modulus, material.poisson_ratio
    in_strain = 1 - 2 * poisson if plane == scene.PLANE_STRAIN else 1.0
    out_of_plane = 1 + poisson if plane == scene.PLANE_STRAIN else 1 - poisson
    return young / (2 * out_of_plane * in_strain), young / (2 * (1 + poisson))


def zone_stiffness(size, kappa, mu):
    """Of an a x b zone, 8 x 8 in the order x0 y0 x1 y1 …: the mean strain, and in-plane bending without shear
    (Wilson and Taylor; fdm_server/zones/shape/assumed_strain.hpp)."""
    area = size[0] * size[1]
    gradient = CORNERS / (2 * size)  # of the mean of each corner's shape function
    exx, eyy, gxy, x_pattern, y_pattern = np.zeros((5, 8))
    exx[0::2], eyy[1::2] = gradient.T
    gxy[0::2], gxy[1::2] = gradient.T[::-1]
    x_pattern[0::2] = y_pattern[1::2] = CORNERS[:, 0] * CORNERS[:, 1] / 4
    energies = ((kappa, exx + eyy), (mu, exx - eyy), (mu, gxy))
    stiffness = sum(area * modulus * np.outer(strain, strain) for modulus, strain in energies)
    young = 4 * kappa * mu / (kappa + mu)  # of uniaxial stress in the plane
    for pattern, side in ((x_pattern, size[0]), (y_pattern, size[1])):
        stiffness += young * area * 4 / (3 * side**2) * np.outer(pattern, pattern)
    return stiffness


class Continuum(LeapFrog):
    def setup(self, request, model):
        refuse_others(request.scene, COMPUTED)
        material = self.read_grid(request.scene)
        self.density = material.density
        kappa, mu = moduli(material, request.scene.plane)
        self.stiffness = zone_stiffness(self.size, kappa, mu)
        # No frequency of the grid is above the highest of a zone that stands alone (Irons and Treharne).
        highest = np.linalg.eigvalsh(self.stiffness)[-1] / (self.density * self.size.prod() / 4)
        model.critical_dt = 2 / np.sqrt(highest)
        model.p_wave_speed, model.s_wave_speed = np.sqrt([(kappa + mu) / self.density, mu / self.density])
        self.describe(model)

    def read_grid(self, described):
        """The grid of the scene, and its material."""
        self.given = described.continuum
        if not self.given.HasField("block"):
            raise SceneError("continuum.block", "is missing; this participant computes one block of equal zones")
        block = self.given.block
        self.low, self.high = np.array([block.x_min, block.y_min]), np.array([block.x_max, block.y_max])
        self.size = (self.high - self.low) / (block.zones_x, block.zones_y)
        self.tolerance = 1e-9 * np.linalg.norm(self.high - self.low)
        x = np.linspace(block.x_min, block.x_max, block.zones_x + 1)
        y = np.linspace(block.y_min, block.y_max, block.zones_y + 1)
        self.points = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
        first = (np.arange(block.zones_y)[:, None] * (block.zones_x + 1) + np.arange(block.zones_x)).ravel()
        self.zones = first[:, None] + [0, 1, block.zones_x + 2, block.zones_x + 1]
        return self.given.material if self.given.HasField("material") else described.material

    def describe(self, model):
        model.critical_element = "zone"
        model.x_min, model.y_min, model.x_max, model.y_max = *self.low, *self.high
        model.sample_points.extend((self.middles()[:, None] + SAMPLES * self.size).ravel().tolist())

    def middles(self):
        return self.points[self.zones].mean(axis=1)

    def weights(self, request, interface):
        coupled = len(request.weights) > 0
        samples = np.reshape(request.weights, (-1, 9)) if coupled else np.ones((len(self.zones), 9))
        exists = (samples != 0).any(axis=1)
        if not exists.any():
            raise SceneError("interface.overlap", "leaves no zone of the continuum; let the block reach beyond the overlap")
        self.zone_weights = np.maximum(samples @ SIMPSON, request.floor)[exists]
        self.keep(exists)
        masses = np.bincount(self.zones.ravel(), np.repeat(self.zone_weights * self.density * self.size.prod() / 4, 4))
        motions = prescribed(self.given.motions, "continuum.motions", self.points, self.tolerance)
        self.begin(self.points, np.stack([masses, masses], axis=1), self.read_loads(masses), motions)
        self.probes = self.read_probes()
        if coupled:
            low, high = (request.x_min, request.y_min), (request.x_max, request.y_max)
            offered = ((self.points >= low) & (self.points <= high)).all(axis=1)
            interface.points.extend(self.points[offered].ravel().tolist())
        interface.zones, interface.grid_points, interface.mass = len(self.zones), len(self.points), masses.sum()

    def keep(self, exists):
        """Zones without weight vanish, with the points that no other zone has."""
        kept, zones = np.unique(self.zones[exists], return_inverse=True)
        self.points, self.zones = self.points[kept], zones.reshape(-1, 4)

    def read_loads(self, masses):
        loads = []
        for i, load in enumerate(self.given.edge_loads):
            path = f"continuum.edge_loads[{i}].where"
            points, lengths, _ = self.edges_in(load.where, path)
            shares = np.bincount(points.ravel(), np.repeat(lengths / lengths.sum() / 2, 2), len(self.points))
            chosen = np.flatnonzero(shares)
            loads.append(Load(chosen, np.outer(shares[chosen], (load.force.x, load.force.y)), factor(load.time)))
        return loads + body_loads(self.given.body_loads, "continuum.body_loads", self.points, masses, self.tolerance)

    def edges_in(self, area, path):
        """Ends, lengths and zones of the block's outer edges that lie wholly in the area."""
        inside = select(area, self.points, self.tolerance, path)
        ends = np.concatenate([self.zones[:, [side, (side + 1) % 4]] for side in range(4)])
        middles = self.points[ends].mean(axis=1)
        outer = ((abs(middles - self.low) < self.tolerance) | (abs(middles - self.high) < self.tolerance)).any(axis=1)
        chosen = np.flatnonzero(outer & np.isin(ends, inside).all(axis=1))
        if not len(chosen):
            raise SceneError(path, "selects no edge; widen it so that it holds both ends of one")
        ends = ends[chosen]
        return ends, np.linalg.norm(self.points[ends[:, 1]] - self.points[ends[:, 0]], axis=1), chosen % len(self.zones)

    def read_probes(self):
        probes = []
        for i, history in enumerate(self.given.histories):
            path = f"continuum.histories[{i}]"
            kind, column = motion_history(history, path, scene.Quantity)
            _, points, shares = self.interpolate(np.array([[history.at.x, history.at.y]]), f"{path}.at")
            probes.append((kind, column, points, shares))
        return probes

    def interpolate(self, places, path):
        """Entries (place, point, share) of the bilinear shape functions. A place on a side or a corner of a zone
        depends on the points there only; that of a grid point has one entry, 1."""
        middles = self.middles()
        entries = []
        for k, place in enumerate(places):
            natural = 2 * (place - middles) / self.size
            inside = np.flatnonzero((abs(natural) <= 1 + 1e-9).all(axis=1))
            if not len(inside):
                raise SceneError(path, f"holds the place ({place[0]:g}, {place[1]:g}) m, where the continuum has no zone")
            at = natural[inside[0]]
            at = np.where(abs(at) > 1 - 1e-9, np.sign(at), at)
            shape = ((1 + CORNERS * at) / 2).prod(axis=1)
            entries += [(k, self.zones[inside[0], corner], shape[corner]) for corner in np.flatnonzero(shape)]
        rows, columns, shares = zip(*entries)
        return np.array(rows), np.array(columns), np.array(shares)

    def couple(self, request, operator):
        places = np.reshape(request.points, (-1, 2))
        self.tie(*self.interpolate(places, "interface.overlap"), len(places))
        self.fill_operator(operator)

    def zone_forces(self):
        displacements = self.u[self.zones].reshape(-1, 8)
        return displacements, self.zone_weights[:, None] * (displacements @ self.stiffness)

    def internal_forces(self, dt):
        forces = np.zeros_like(self.u)
        np.subtract.at(forces, self.zones.ravel(), self.zone_forces()[1].reshape(-1, 2))
        return forces

    def strain_energy(self):
        return np.sum(np.multiply(*self.zone_forces())) / 2

    def read_histories(self, values):
        for kind, column, points, shares in self.probes:
            field = self.u if kind == "displacement" else self.before
            values.append(shares @ field[points, column])

    def snapshot_request(self, request, snapshot):
        self.correct(request.impulses)
        self.draw(snapshot, self.u, self.v)

    def draw(self, snapshot, displacements, velocities):
        piece = snapshot.pieces.add(name="grid", shape=wire.Piece.QUADS)
        piece.points.extend(self.points.ravel().tolist())
        piece.connectivity.extend(self.zones.ravel().tolist())
        for name, values in (("displacement_m", displacements), ("velocity_m_per_s", velocities)):
            piece.point_fields.add(name=name, components=2, values=values.ravel().tolist())
        piece.cell_fields.add(name="weight", components=1, values=self.zone_weights.tolist())

    def finish(self, request, bye):
        bye.updates = len(self.zones) * max(self.next - 1, 0)  # step 0 does not move


if __name__ == "__main__":
    serve("numpy_continuum", Continuum, list(keys(scene.Scene.DESCRIPTOR, COMPUTED)))
