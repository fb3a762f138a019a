"""Ground that cannot be computed, as a user meets it: one sentence with the place and the remedy, exit code 2, no result."""

from programs import CASE, ProgramTest, coupler

SCENE = """\
material: {young_modulus: 100 MPa, poisson_ratio: 0.25, density: 2000 kg/m^3}
time: {duration: 50 ms}
continuum:
"""
BLOCK = SCENE + "  block: {x_min: 0 m, x_max: 4 m, y_min: 0 m, y_max: 4 m, zones_x: 4, zones_y: 4}\n"
MESH = SCENE + """\
  mesh: {path: ground.msh}
  motions: [{where: {group: ground, y_max: 0 m}, velocity: {x: 0 m/s}}]
"""
NODES = ((0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1))  # from 1
SQUARES = ((1, 2, 5, 4), (2, 3, 6, 5))


def gmsh(nodes=NODES, zones=SQUARES, group="ground"):
    """A mesh of one surface in one physical group, as Gmsh writes it."""
    return "\n".join([
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat", f'$PhysicalNames\n1\n2 1 "{group}"\n$EndPhysicalNames',
        "$Entities\n0 0 1 0\n1 0 0 0 9 9 0 1 1 0\n$EndEntities",
        f"$Nodes\n1 {len(nodes)} 1 {len(nodes)}\n2 1 0 {len(nodes)}", *(str(i + 1) for i in range(len(nodes))),
        *(f"{x} {y} 0" for x, y in nodes), "$EndNodes",
        f"$Elements\n1 {len(zones)} 1 {len(zones)}\n2 1 3 {len(zones)}",
        *(f"{i + 1} {' '.join(map(str, zone))}" for i, zone in enumerate(zones)), "$EndElements\n"])


class GroundErrors(ProgramTest):
    def refusal(self, scene, *settings):
        options = [word for setting in settings for word in ("--set", setting)]
        result = coupler("run", scene, "--out", self.folder / "run", *options)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assert_one_line(result.stderr)
        self.assertFalse((self.folder / "run" / "summary.json").exists())
        return result.stderr

    def refused_mesh(self, text, *said):
        (self.folder / "ground.msh").write_text(text)
        message = self.refusal(self.scene(MESH))
        for words in ("scene.yaml:", *said):
            self.assertIn(words, message)

    def refused(self, setting, *said):
        message = self.refusal(self.scene(BLOCK), setting)
        for words in ("--set " + setting[:20], *said):
            self.assertIn(words, message)

    def test_a_sound_mesh_is_computed(self):
        (self.folder / "ground.msh").write_text(gmsh())
        self.run_scene(self.scene(MESH))

    def test_tangled_zones(self):
        for zones in (((1, 2, 5, 4), (2, 6, 3, 5)), ((1, 5, 2, 4), (2, 3, 6, 5)), ((1, 2, 5, 5), (2, 3, 6, 5))):
            self.refused_mesh(gmsh(zones=zones), "continuum.mesh.path: has a tangled zone: element ", "is not convex at its corner (")

    def test_holes_in_the_connectivity(self):
        self.refused_mesh(gmsh(zones=((1, 2, 5, 9), (2, 3, 6, 5))), "ground.msh:", "has an element of node 9, which does not exist")
        double = (*NODES[:5], (1, 0), (2, 0), (2, 1), (1, 1))
        self.refused_mesh(gmsh(double, ((1, 2, 5, 4), (6, 7, 8, 9))), "is not joined at (1, 0) m", "make them one point")
        hanging = (*NODES, (1, 0.5), (2, 0.5))
        self.refused_mesh(gmsh(hanging, (SQUARES[0], (2, 3, 8, 7), (7, 8, 6, 5))), "is not joined at (1, 0.5) m",
                          "a point of element 2 lies on a side of element 1")
        apart = (*NODES, (5, 0), (6, 0), (6, 1), (5, 1))
        self.refused_mesh(gmsh(apart, (*SQUARES, (7, 8, 9, 10))), "falls into pieces: element 3 at (5.5, 0.5) m")

    def test_zones_on_top_of_each_other(self):
        self.refused_mesh(gmsh(zones=(*SQUARES, SQUARES[0])), "overlaps itself: element 1 and element 3", "or keep one of them")

    def test_wrong_group(self):
        self.refused_mesh(gmsh(group="grund"), "continuum.motions[0].where.group: is `ground`", "did you mean `grund`?")

    def test_impossible_elasticity(self):
        self.refused("material.young_modulus=-1 MPa", "expected a pressure above 0 Pa")
        self.assertIn("material: makes a critical time step of",
                      self.refusal(self.scene(BLOCK), "material.young_modulus=1e300"))
        self.refused("material.poisson_ratio=0.5", "below 0.5")
        self.refused("material.density=0", "above 0 kg/m^3")
        self.refused("material.density=2 kg", "is a mass")

    def test_large_strain_beside_an_interface(self):
        message = self.refusal(CASE / "coupled.yaml", "continuum.large_strain=true", "plane=plane_strain")
        self.assertIn("continuum.large_strain: moves the grid away from the places where an interface joins it", message)

    def test_impossible_strength(self):
        for law, *said in (
                ("{cohesion: -5 kPa}", "cohesion: is -5 kPa", "at least 0 Pa"), ("{friction_angle: 30 deg}", "cohesion: is missing"),
                ("{cohesion: 5 kPa, friction_angle: 20 deg, dilation_angle: 30 deg}", "dilation_angle: is 0.52", "more than the friction angle"),
                ("{cohesion: 5 kPa, friction_angle: 30}", "friction_angle: is 30 rad"),
                ("{cohesion: 5 kPa, friction_angle: 30 deg, tension: 50 kPa}", "tension: is 50000 Pa", "at most cohesion"),
                ("{cohesion: 5 kPa, softening: [{plastic_shear_strain: 0.1}, {plastic_shear_strain: 0.05}]}",
                 "softening[1].plastic_shear_strain: is 0.05", "larger than 0.1")):
            self.refused(f"material.mohr_coulomb={law}", "material.mohr_coulomb.", *said)

    def test_impossible_curves_and_planes(self):
        self.refused("material.hysteretic={}", "names no curve")
        self.refused("material.hysteretic={hyperbola: {reference_strain: 0}}", "reference_strain: is 0", "above 0")
        self.refused("material.hysteretic={table: {shear_strain: [1e-5, 1e-4, 1e-3], ratio: [1, 0.5]}}", "ratio: has 2 elements, expected 3, as many as `shear_strain`")
        self.refused("material.hysteretic={table: {shear_strain: [1e-5, 1e-4, 1e-3], ratio: [1, 0.5, 0.7]}}", "G/Gmax falls with the strain")
        self.refused("material.hysteretic={hyperbola: {reference_strain: 1e-3}, memory: turns}", "memory: is `turns`", "reversals")
        self.refused("material.hysteretic={hyperbola: {reference_strain: 1e-3}, damping: {darendeli: {}}}", "damping: needs `memory: reversals`")
        self.refused("material.weak_plane={dip_angle: 30 deg, cohesion: -1}", "weak_plane.cohesion: is -1 Pa")

    def test_frequencies_that_are_none(self):
        for pulse in ("ricker: {frequency: %s, time: 0.1 s}", "sine: {frequency: %s, end: 1 s}", "gabor: {frequency: %s, time: 1 s}"):
            for frequency in ("0 Hz", "-3 Hz"):
                self.refused(f"continuum.base={{acceleration: {{{pulse % frequency}}}}}", f"frequency: is {frequency}", "above 0 Hz")
        pulse = "continuum.base={acceleration: {ricker: {frequency: 5 Hz, time: 0.1 s}, "
        self.refused(pulse + "low_corner: 0 Hz}}", "low_corner: is 0 Hz", "above 0 Hz")
        self.refused(pulse + "low_corner: 20 Hz, high_corner: 5 Hz}}", "high_corner: is 5 Hz, expected a frequency above `low_corner` = 20 Hz")
        self.refused(pulse + "high_corner: 1 GHz}}", "the corner frequency of the filter is 1e+09 Hz", "give one below 500 Hz")
        damping = "continuum.damping={rayleigh: {ratio: 0.05, low_frequency: %s, high_frequency: %s}}"
        self.refused(damping % ("0 Hz", "10 Hz"), "low_frequency: is 0 Hz", "above 0 Hz")
        self.refused(damping % ("10 Hz", "1 Hz"), "high_frequency: is 1 Hz, expected a frequency of at least `low_frequency` = 10 Hz")

    def refused_record(self, name, text, *said):
        (self.folder / name).write_text(text)
        self.refused(f"continuum.base={{acceleration: {{file: {{path: {self.folder / name}}}}}}}", f"{name}:", *said)

    def test_records_with_wrong_counts(self):
        header = "PEER\nsomewhere\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= {}, DT= .02 SEC\n"
        for count in (3, 5, 10102):
            self.refused_record("x.AT2", header.format(count) + " .1 .2 .1 .0\n", f"x.AT2:4: states {count} points, but 4 values follow")
        self.refused_record("x.AT2", header.format(6) + "-818. .2 .1 .0\n", "moreover, the largest value is 818 G")
        self.refused_record("x.csv", "time_s,acceleration_g\n0,0\n", "has 1 rows of values")
        self.refused_record("x.csv", "time_s,acceleration_g\n0,0\n0.02,1\n0.05,0\n0.06,0\n", "x.csv:4: is 0.03 s after the row before")

    def test_records_with_wrong_units(self):
        self.refused_record("x.AT2", "PEER\n\nVELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS= 4, DT= .02 SEC\n .1 .2 .1 .0\n",
                            "x.AT2:3: `CM/S` is not a unit of acceleration")
        self.refused_record("x.csv", "time,acceleration\n0,0\n0.02,1\n", "x.csv:1: `time` states no unit")
        self.refused_record("x.csv", "time_s,acceleration_furlong\n0,0\n0.02,1\n", "`furlong` is not a unit of acceleration")
        self.refused_record("x.csv", "time_s,acceleration_m/s^2\n0,0\n0.02,341\n", "the largest value is 341 m/s^2, beyond any earthquake")
