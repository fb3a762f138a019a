"""What this continuum reads of a scene beyond the template: layers, point loads, quiet boundaries. Every rank reads it all."""
import continuum as template
import numpy as np
from reading import BOX, FACTOR, factor, select

from leap_frog import Load

COMPUTED = {**template.COMPUTED, "continuum": {
    **template.COMPUTED["continuum"],
    "materials": {"where": BOX, "material": template.MATERIAL},
    "point_loads": {"where": BOX, "force": True, "time": FACTOR},
    "quiet": {"where": BOX, "normal": True, "shear": True}}}


class Ground(template.Continuum):
    def read_materials(self, material, plane):
        """Moduli and density of each zone."""
        kinds, kind = [material], np.zeros(len(self.zones), int)
        for i, area in enumerate(self.given.materials):
            kind[select(area.where, self.middles(), self.tolerance, f"continuum.materials[{i}].where")] = len(kinds)
            kinds.append(area.material)
        self.kappa, self.mu = np.array([template.moduli(one, plane) for one in kinds])[kind].T
        self.density = np.array([one.density for one in kinds])[kind]

    def keep(self, exists):
        super().keep(exists)
        self.kappa, self.mu, self.density = self.kappa[exists], self.mu[exists], self.density[exists]

    def read_loads(self, masses):
        loads = super().read_loads(masses)
        for i, load in enumerate(self.given.point_loads):
            chosen = select(load.where, self.points, self.tolerance, f"continuum.point_loads[{i}].where")
            forces = np.tile([load.force.x, load.force.y], (len(chosen), 1)) / len(chosen)
            loads.append(Load(chosen, forces, factor(load.time)))
        return loads

    def read_quiet(self):
        """Dashpots of each point, for x and for y [N s/m] (Lysmer and Kuhlemeyer)."""
        found = np.zeros_like(self.points)
        for i, quiet in enumerate(self.given.quiet):
            ends, lengths, zones = self.edges_in(quiet.where, f"continuum.quiet[{i}].where")
            share = self.zone_weights[zones] * lengths / 2
            normal = quiet.normal * share * np.sqrt(self.density * (self.kappa + self.mu))[zones]
            shear = quiet.shear * share * np.sqrt(self.density * self.mu)[zones]
            along_x = abs(np.diff(self.points[ends, 0], axis=1)[:, 0]) > self.tolerance
            np.add.at(found[:, 0], ends, np.where(along_x, shear, normal)[:, None])
            np.add.at(found[:, 1], ends, np.where(along_x, normal, shear)[:, None])
        return found
