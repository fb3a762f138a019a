"""Bad input never produces a result: exit code 2 and one sentence with file, line and what was expected."""

import socket
import subprocess
import unittest

from programs import BUILD, CASE, PATIENCE, SOURCE, ProgramTest, Server, coupler

SCENE = (CASE / "coupled.yaml").read_text().replace("extends: full_dem.yaml", f"extends: {CASE / 'full_dem.yaml'}")


class UserErrors(ProgramTest):
    def refusal(self, *arguments):
        result = coupler("run", *arguments, "--out", self.folder / "run")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assert_one_line(result.stderr)
        self.assertFalse((self.folder / "run" / "summary.json").exists())
        return result.stderr

    def refused_scene(self, old, new):
        self.assertIn(old, SCENE)
        path = self.scene(SCENE.replace(old, new, 1))
        line = 1 + next(i for i, text in enumerate(path.read_text().split("\n")) if new.split("\n")[-1] in text)
        return self.refusal(path), f"{path}:{line}:"

    def assert_says(self, message, place, *texts):
        self.assertIn(place, message)
        for text in texts:
            self.assertIn(text, message)

    def test_a_file_that_the_system_does_not_let_be_read(self):
        self.assertIn("/proc/self/mem: the file cannot be read", self.refusal("/proc/self/mem"))

    def test_misspelled_key(self):
        message, place = self.refused_scene("edge_loads:", "edge_load:")
        self.assert_says(message, place, "continuum.edge_load", "did you mean `edge_loads`")

    def test_wrong_unit(self):
        message, place = self.refused_scene("x_min: 0 m, x_max: 10 m", "x_min: 0 m, x_max: 10 kg")
        self.assert_says(message, place, "continuum.block.x_max", "10 kg", "length")

    def test_missing_field(self):
        message, place = self.refused_scene(", zones_x: 20, zones_y: 4}", ", zones_x: 20}")
        self.assert_says(message, place, "zones_y")

    def test_overlap_outside_the_models(self):
        message, place = self.refused_scene("continuum_ends: {x: 6 m", "continuum_ends: {x: 16 m")
        self.assert_says(message, place, "interface.overlap.continuum_ends", "(16, 0) m", "(10, ")

    def test_negative_radius(self):
        message = self.refusal(CASE / "coupled.yaml", "--set", "particles.packing.radius=-0.1 m")
        self.assert_says(message, "--set particles.packing.radius", "-0.1 m", "above 0")

    def test_time_step_above_the_limit(self):
        message = self.refusal(CASE / "coupled.yaml", "--set", "time.dt=1 ms")
        self.assert_says(message, "--set time.dt", "0.001 s", "critical")

    def test_a_load_that_selects_nothing_is_found_by_the_server_and_located_by_the_coupler(self):
        message, place = self.refused_scene("where: {x_max: 0 m}", "where: {x_max: -1 m}")
        self.assert_says(message, place, "continuum.edge_loads[0].where", "boundary")

    def refused_mesh(self, change):
        """The case's mesh after a change, beside a scene that stands on the case's."""
        case = SOURCE / "cases" / "excavation"
        (self.folder / "changed.msh").write_text(change((case / "tunnel.msh").read_text()))
        scene = f"extends: {case / 'mesh.yaml'}\ncontinuum:\n  mesh: {{path: changed.msh}}\n"
        return self.refusal(self.scene(scene))

    def test_a_mesh_travels_to_the_server_and_its_errors_come_back_with_the_scenes_line(self):
        message = self.refused_mesh(lambda text: text.replace("4.1 0 8", "2.2 0 8"))
        self.assert_says(message, ":3:", "continuum.mesh.path", "changed.msh:2: is in format 2.2")
        self.assert_says(self.refused_mesh(lambda text: text[:len(text) // 2]), "continuum.mesh.path", "not complete")
        message = self.refused_mesh(lambda text: text.replace('"heading"', '"haeding"'))
        self.assert_says(message, "continuum.excavations[0].where.group", "did you mean `haeding`")

    def test_a_mesh_that_is_not_there(self):
        message = self.refusal(SOURCE / "cases" / "excavation" / "mesh.yaml", "--set", "continuum.mesh.path=no.msh")
        self.assert_says(message, "continuum.mesh.path", "no such file")

    def test_missing_file(self):
        self.assert_says(self.refusal(self.folder / "absent.yaml"), str(self.folder / "absent.yaml"))

    def test_output_folder_with_other_things_in_it(self):
        (self.folder / "run").mkdir()
        (self.folder / "run" / "thesis.tex").write_text("x")
        self.assert_says(self.refusal(CASE / "coupled.yaml"), "thesis.tex", "--out")

    def test_nobody_listens_at_the_address(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            address = f"127.0.0.1:{free.getsockname()[1]}"
        self.assert_says(self.refusal(CASE / "coupled.yaml", "--dem", address), address)

    def test_address_without_port(self):
        self.assert_says(self.refusal(CASE / "coupled.yaml", "--dem", "localhost"), "localhost")

    def test_servers_exchanged(self):
        with Server("dem_server") as dem, Server("fdm_server") as fdm:
            message = self.refusal(CASE / "coupled.yaml", "--fdm", dem.address, "--dem", fdm.address)
        self.assert_says(message, f"dem_server at {dem.address} cannot compute the continuum", "fdm_server is needed")

    def test_a_server_that_the_scene_does_not_need(self):
        self.assert_says(self.refusal(CASE / "full_fdm.yaml", "--dem", "127.0.0.1:1"), "--dem", "no `particles`")

    def test_one_server_for_both_sides(self):
        same = ("--dem", "127.0.0.1:1", "--fdm", "127.0.0.1:1")
        self.assert_says(self.refusal(CASE / "coupled.yaml", *same), "127.0.0.1:1", "both")

    def test_a_name_that_leads_out_of_the_results(self):
        self.assert_says(self.refusal(CASE / "full_fdm.yaml", "--set", "name=../escape"), "--set name", "../escape")

    def test_field_times_after_the_end(self):
        message = self.refusal(CASE / "full_fdm.yaml", "--set", "output.field_times=[1 s]")
        self.assert_says(message, "--set output.field_times", "1 s", "0.05 s")

    def test_a_refused_run_leaves_the_results_of_the_one_before(self):
        before = self.run_scene(CASE / "full_fdm.yaml")
        names = sorted(path.name for path in before.rglob("*"))
        for refused in (("--fdm", "127.0.0.1:1"), ("--set", "time.dt=1 s")):
            result = coupler("run", CASE / "full_fdm.yaml", "--out", before, *refused)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertEqual(sorted(path.name for path in before.rglob("*")), names)

    def test_a_history_interval_longer_than_the_run_gives_its_ends(self):
        run = self.run_scene(CASE / "full_fdm.yaml", "--set", "output.history_interval=1e30 s",
                             "--set", "output.field_times=[]")
        self.assertEqual(len((run / "histories.csv").read_text().splitlines()), 3)

    def test_port_in_use(self):
        with Server("dem_server") as first:
            second = subprocess.run([BUILD / "dem_server" / "dem_server", "--listen", first.address],
                                    capture_output=True, text=True, timeout=20 * PATIENCE)
        self.assertEqual(second.returncode, 2, second.stderr)
        self.assertIn(first.address.split(":")[1], second.stderr)

    def test_address_beyond_loopback_needs_consent(self):
        result = subprocess.run([BUILD / "dem_server" / "dem_server", "--listen", "0.0.0.0:0"],
                                capture_output=True, text=True, timeout=20 * PATIENCE)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("--insecure", result.stderr)

    def test_more_threads_than_any_machine_has(self):
        result = subprocess.run([BUILD / "fdm_server" / "fdm_server", "--threads", "1000000"],
                                capture_output=True, text=True, timeout=20 * PATIENCE)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("--threads: Value 1000000 not in range", result.stderr)


if __name__ == "__main__":
    unittest.main()
