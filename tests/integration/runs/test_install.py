"""What `cmake --install` and `cpack -G DEB` deliver works from any folder, without the source tree."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from programs import BUILD, PATIENCE_S, ProgramTest, Server

SHORT = ("--set", "time.duration=5 ms", "--set", "output.field_times=[2 ms]")
PROGRAMS = ("coupler", "fdm_server", "dem_server", "simplified")


def project_version():
    cache = (BUILD / "CMakeCache.txt").read_text()
    return re.search(r"^CMAKE_PROJECT_VERSION:STATIC=(\S+)$", cache, re.MULTILINE).group(1)


def succeed(*command, **options):
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=PATIENCE_S, **options)
    if done.returncode:
        raise AssertionError(f"{command} ended with exit code {done.returncode}: {done.stdout}{done.stderr}")
    return done.stdout


class Installed(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.prefix = pathlib.Path(tempfile.mkdtemp(prefix="adit_prefix_"))
        cls.addClassCleanup(shutil.rmtree, cls.prefix)
        succeed("cmake", "--install", BUILD, "--prefix", cls.prefix)

    def user(self, *command):
        """Runs a command as a user who has only the installation, in a folder elsewhere."""
        environment = {"HOME": str(self.folder), "PATH": f"{self.prefix}/bin:/usr/bin:/bin"}
        environment |= {name: os.environ[name] for name in ("ASAN_OPTIONS", "TSAN_OPTIONS") if name in os.environ}
        return succeed(*command, cwd=self.folder, env=environment)

    def test_programs_say_the_version_of_the_project(self):
        for program in PROGRAMS:
            self.assertEqual(self.user(program, "--version"), f"{program} {project_version()}\n")

    def test_the_first_case_runs_from_any_folder_with_results_and_pictures_there(self):
        before = sorted(self.prefix.rglob("*"))
        said = self.user("adit", "run", "cases/cantilever/coupled.yaml", *SHORT)
        self.assertIn("Results: runs/cantilever/coupled/", said)
        run = self.folder / "runs" / "cantilever" / "coupled"
        self.assertTrue(self.summary(run)["completed"])
        for picture in ("deformed_5ms", "force_chains_5ms", "histories"):
            self.assertTrue((run / "pictures" / f"{picture}.png").exists(), picture)
        self.assertIn("report             runs/cantilever/coupled/report.html\n", said)
        (run / "report.html").unlink()
        self.user("adit", "report", "runs/cantilever/coupled")
        self.assertIn("cantilever: coupled", (run / "report.html").read_text())
        self.assertEqual(sorted(self.prefix.rglob("*")), before, "the installation itself is left as it was")

    def test_python_reads_results_by_the_module_of_the_installation(self):
        self.user("coupler", "run", self.prefix / "share" / "adit" / "cases" / "cantilever" / "coupled.yaml", *SHORT, "--out", "run")
        said = self.user("env", f"PYTHONPATH={self.prefix}/lib/python3/dist-packages", "PYTHONDONTWRITEBYTECODE=1", "/usr/bin/python3",
                         "-c", "from adit import Run; print(Run('run').completed, len(Run('run').fields(0.002)['particles'].points))")
        self.assertEqual(said, f"True {self.summary(self.folder / 'run')['particles']}\n")

    def test_a_run_leaves_its_report_out_when_asked_and_a_failed_run_has_one(self):
        run = self.folder / "runs" / "cantilever" / "coupled"
        self.user("adit", "run", "cases/cantilever/coupled.yaml", "--no-report", *SHORT)
        self.assertFalse((run / "report.html").exists())
        environment = {"HOME": str(self.folder), "PATH": f"{self.prefix}/bin:/usr/bin:/bin"}
        failed = subprocess.run(["adit", "run", "cases/cantilever/coupled.yaml", "--set", "time.beyond_critical=true",
                                 "--set", "time.dt=100 us"], cwd=self.folder, env=environment, capture_output=True, text=True)
        self.assertEqual(failed.returncode, 4, failed.stderr)
        self.assertIn("The run failed", (run / "report.html").read_text())

    def test_a_case_with_a_study_runs_where_a_user_copied_it(self):
        shutil.copytree(self.prefix / "share" / "adit" / "cases" / "wave_bar", self.folder / "mine")
        self.user("adit", "run", "mine", "--only", "bar_P_lumped_h10_overlap5_lambda1_dt0.5_*_particles_m1")
        self.assertTrue((self.folder / "runs" / "wave_bar" / "reflection.csv").exists())

    def test_a_server_of_the_installation_takes_part_in_a_run_that_another_machine_couples(self):
        scene = self.prefix / "share" / "adit" / "cases" / "cantilever" / "coupled.yaml"
        with Server(str(self.prefix / "bin" / "dem_server")) as server:  # an absolute path stands for itself
            self.user("coupler", "run", scene, *SHORT, "--dem", server.address, "--out", "remote")
        self.assertTrue(self.summary(self.folder / "remote")["completed"])
        self.assertFalse((self.folder / "remote" / "dem_server.log").exists(), "the coupler started a second server")

    def test_unknown_commands_end_with_the_list_of_commands(self):
        done = subprocess.run([self.prefix / "bin" / "adit", "draw"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        for command in ("run", "plot", "report", "compare", "table", "paraview", "calibrate", "cluster", "trade"):
            self.assertRegex(done.stderr, rf"\n  {command} ")

    def test_links_of_the_readme_lead_to_installed_files(self):
        pages = self.prefix / "share" / "doc" / "adit"
        links = re.findall(r"\]\((?!https?:)([^)#]+)", (pages / "README.md").read_text())
        self.assertGreater(len(links), 5)
        self.assertEqual([link for link in links if not (pages / link).exists()], [])


class Package(ProgramTest):
    def test_the_debian_package_names_what_it_needs_and_its_programs_run(self):
        succeed("cpack", "-G", "DEB", "-B", self.folder, cwd=BUILD)
        package, = self.folder.glob("*.deb")
        self.assertRegex(package.name, rf"^adit_{re.escape(project_version())}_[a-z0-9]+\.deb$")
        # No host receives mail for the project, and the programs explain themselves by --help.
        succeed("lintian", "--allow-root", "--fail-on", "error,warning", "--suppress-tags", "bogus-mail-host,bogus-mail-host-in-debian-changelog,no-manual-page", package)
        needed = succeed("dpkg-deb", "-f", package, "Depends")
        for other in ("python3", "python3-numpy", "python3-matplotlib", "python3-pil", "python3-yaml", "libc6", "libprotobuf"):
            self.assertIn(other, needed)
        succeed("dpkg", "-x", package, self.folder / "root")
        for server in ("fdm", "dem"):
            self.assertTrue((self.folder / f"root/usr/lib/systemd/system/adit-{server}.service").exists())
        for program in PROGRAMS:
            said = succeed(self.folder / "root" / "usr" / "bin" / program, "--version")
            self.assertEqual(said, f"{program} {project_version()}\n")


if __name__ == "__main__":
    unittest.main()
