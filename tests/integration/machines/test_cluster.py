"""The job of adit cluster computes what one machine computes, goes on after a signal or a lost server, and lets nobody else in.

Slurm is not needed: small programs take the places of srun, scontrol and sbatch and start the servers on this machine.
"""

import os
import signal
import subprocess
import unittest

from programs import ADIT, BUILD, CASE, PATIENCE_S, wait_until
from resume.resumed import ResumeTest

STAND_INS = {
    # srun OPTIONS COMMAND runs the command here, as long as it is not told to end.
    "srun": 'echo "$*" >>"$ASKED"; while [[ $1 == --* ]]; do shift; done; exec "$@"',
    # scontrol show hostnames NODES
    "scontrol": 'echo "$3"',
    "sbatch": 'echo "sbatch $*" >>"$ASKED"'}
SCENE = f"""
extends: {CASE}/variants/coupled_52x6.yaml
time: {{duration: 5 ms}}
output: {{field_times: [4 ms]}}
"""
ALONE = """
plane: plane_strain
material: {young_modulus: 25 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}
time: {duration: 5 ms}
continuum: {block: {x_min: 0 m, x_max: 8 m, y_min: 0 m, y_max: 4 m, zones_x: 8, zones_y: 4}}
"""
LONG = SCENE.replace("5 ms", "100 ms")  # for a signal to come in time


class ClusterTest(ResumeTest):
    def setUp(self):
        super().setUp()
        self.input, self.job, self.asked = self.scene(SCENE, "beam.yaml"), self.folder / "job", self.folder / "asked"
        self.results = self.job / "beam"
        tools = self.folder / "tools"
        tools.mkdir()
        for name, script in STAND_INS.items():
            (tools / name).write_text(f"#!/usr/bin/env bash\n{script}\n")
            (tools / name).chmod(0o755)
        self.environment = dict(os.environ, PATH=f"{tools}:{os.environ['PATH']}", ASKED=str(self.asked),
                                SLURM_JOB_NODELIST_HET_GROUP_1="localhost", SLURM_JOB_NODELIST_HET_GROUP_2="127.0.0.1")

    def write(self, *arguments):
        return subprocess.run([*ADIT, "cluster", self.input, "--out", self.job, *arguments], capture_output=True, text=True)

    def written(self, *arguments):
        done = self.write(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"sbatch {self.job}/job.sh", done.stdout)
        return (self.job / "job.sh").read_text()

    def start(self):
        """The job, as Slurm would start it on the first node."""
        process = subprocess.Popen(["bash", self.job / "job.sh"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   env=self.environment)
        self.addCleanup(process.kill)
        return process

    def stepping(self):
        self.input.write_text(LONG)
        self.written("--nodes", "3")
        process = self.start()
        wait_until(lambda: (self.results / "fields/fields.pvd").exists() or process.poll() is not None)
        self.assertIsNone(process.poll())
        return process

    def end(self, process, code):
        said = process.communicate(timeout=PATIENCE_S)
        self.assertEqual(process.returncode, code, said)
        self.assertFalse((self.job / "tls").exists())  # nor keys that outlive the job
        return "".join(said)

    def server(self, program):
        """Its process id, from the file of its log."""
        found = subprocess.run(["pgrep", "--full", f"{BUILD}/{program}/{program} .*{self.job}"], capture_output=True, text=True)
        return [int(line) for line in found.stdout.split()]


class TheJob(ClusterTest):
    def test_three_nodes_compute_what_one_machine_computes(self):
        self.written("--nodes", "3")
        self.end(self.start(), 0)
        self.assert_same(self.results, self.run_scene(self.input, out="own"))
        asked = self.asked.read_text()
        for component, model in ((1, "dem_server"), (2, "fdm_server")):
            self.assertRegex(asked, f"--het-group={component} .*{model} --listen 0.0.0.0:0 --tls ")
        self.assertNotIn("sbatch", asked)

    def test_the_coupler_computes_on_its_node_what_has_none(self):
        self.written("--nodes", "2")
        self.end(self.start(), 0)
        self.assertEqual(self.asked.read_text().count("--het-group"), 1)
        self.assertTrue(self.summary(self.results)["completed"])

    def test_one_node_needs_neither_servers_nor_certificates(self):
        self.assertNotIn("hetjob", self.written("--nodes", "1"))
        self.end(self.start(), 0)
        self.assertFalse(self.asked.exists())
        self.assertTrue(self.summary(self.results)["completed"])

    def test_a_continuum_alone_has_one_node_beside_the_coupler(self):
        """The line of `coupler check` that follows its table begins with a number, too, but is no model."""
        self.input.write_text(ALONE)
        self.assertEqual(self.written("--nodes", "2").count("\nserve "), 1)
        self.end(self.start(), 0)
        self.assertTrue(self.summary(self.results)["completed"])
        refused = self.write("--nodes", "3")
        self.assertIn("the scene has 1 model,", refused.stderr)

    def test_before_its_time_is_up_it_submits_itself_again_and_goes_on(self):
        process = self.stepping()
        process.send_signal(signal.SIGUSR1)
        self.end(process, 128 + signal.SIGTERM)
        self.assertIn(f"sbatch {self.job}/job.sh", self.asked.read_text())
        self.assertFalse(self.summary(self.results)["completed"])
        self.assertFalse(self.server("dem_server"))
        self.end(self.start(), 0)
        self.assertTrue(self.summary(self.results)["resumed_at_steps"])
        self.assert_same(self.results, self.run_scene(self.input, out="own"))

    def test_a_user_ends_it_with_a_checkpoint(self):
        process = self.stepping()
        process.send_signal(signal.SIGTERM)
        self.end(process, 128 + signal.SIGTERM)
        self.assertNotIn("sbatch", self.asked.read_text())
        self.assertTrue(list(self.results.glob("checkpoints/*/checkpoint.json")))

    def test_a_lost_server_is_named_and_all_others_end(self):
        process = self.stepping()
        os.kill(self.server("dem_server")[0], signal.SIGKILL)
        self.assertIn("dem_server", self.end(process, 3))
        self.assertFalse(self.server("fdm_server"))

    def test_a_server_that_does_not_start_ends_it_at_once(self):
        path = self.job / "job.sh"
        text = self.written("--nodes", "3")
        path.write_text(text.replace("fdm_server/fdm_server", "fdm_server/nowhere"))
        self.assertIn(f"see {self.job}/continuum.log", self.end(self.start(), 1))
        self.assertIn("nowhere", (self.job / "continuum.log").read_text())

    def test_only_machines_of_the_job_are_served(self):
        process = self.stepping()
        for key in self.job.glob("tls/*/key.pem"):
            self.assertEqual(key.stat().st_mode & 0o777, 0o600)
            self.assertEqual(key.parent.stat().st_mode & 0o777, 0o700)
        port = (self.job / "particles.address").read_text().rpartition(":")[2].strip()
        probe = subprocess.run([BUILD / "coupler/coupler", "doctor", f"localhost:{port}"], capture_output=True, text=True)
        self.assertEqual(probe.returncode, 2, probe.stdout)
        self.assertIn("TLS", probe.stdout + probe.stderr)
        process.terminate()
        self.end(process, 128 + signal.SIGTERM)


class TheDirectives(ClusterTest):
    def test_each_node_is_a_component_and_all_lines_come_first(self):
        text = self.written("--nodes", "3", "--threads", "16", "--time", "7-00:00:00", "--", "--partition=long", "--mem=8G")
        head, _, rest = text.partition("\nset -euo")
        self.assertNotIn("#SBATCH", rest)
        lines = [line for line in head.splitlines() if not line.startswith("#") and line]
        self.assertEqual(lines, [])  # Slurm reads no directive after a command
        common, *others = head.split("\n#SBATCH hetjob\n")
        self.assertEqual(len(others), 2)
        for component in (common, *others):
            self.assertIn("--partition=long --mem=8G", component)
        self.assertIn("#SBATCH --time=7-00:00:00", common)
        self.assertIn("#SBATCH --signal=B:USR1@300", common)
        self.assertIn("--cpus-per-task=2 ", common)  # the coupler alone
        self.assertTrue(all("--cpus-per-task=16 " in other for other in others))

    def test_more_nodes_than_models_are_refused(self):
        done = self.write("--nodes", "4")
        self.assertEqual(done.returncode, 2)
        self.assertIn("the scene has 2 models", done.stderr)
        self.assertFalse(self.job.exists())

    def test_a_scene_that_cannot_be_computed_is_refused(self):
        self.input.write_text(SCENE.replace("5 ms", "-1 s"))
        done = self.write("--nodes", "3")
        self.assertEqual(done.returncode, 2)
        self.assertIn("time.duration", done.stderr)


if __name__ == "__main__":
    unittest.main()
