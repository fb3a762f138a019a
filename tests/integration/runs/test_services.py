"""Servers as services: units that systemd takes, credentials, logs as JSON lines."""

import json
import os
import re
import shutil
import signal
import subprocess
import unittest

from programs import BUILD, CASE, PATIENCE_S, ProgramTest, Server, coupler

SHORT = ("--set", "time.duration=2 ms", "--set", "output.field_times=[]")
KEYS = ["time", "level", "program", "run", "message"]


def lines(text):
    return [json.loads(line) for line in text.splitlines()]


class Logs(ProgramTest):
    def assert_lines(self, said, program):
        self.assertTrue(said)
        for line in said:
            self.assertEqual(list(line), KEYS)
            self.assertRegex(line["time"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z$")
            self.assertIn(line["level"], ("debug", "info", "warning", "error"))
            self.assertEqual(line["program"], program)

    def test_a_server_tells_of_its_runs(self):
        with Server("dem_server", "127.0.0.1:0", "--log-format", "json") as server:
            for out in ("one", "two"):
                self.run_scene(CASE / "full_dem.yaml", "--dem", server.address, *SHORT, out=out)
            server.process.send_signal(signal.SIGTERM)
            said = lines(server.process.stderr.read())
        self.assert_lines(said, "dem_server")
        run = re.escape(f"{CASE.name}/full_dem")
        began = [line for line in said if re.match(f"run {run} begins", line["message"])]
        self.assertEqual([line["run"] for line in began], 2 * [f"{CASE.name}/full_dem"])
        self.assertEqual((said[-1]["run"], said[-1]["message"]), ("", "stopped by a signal"))

    def test_a_server_that_cannot_begin_says_why(self):
        result = subprocess.run([BUILD / "dem_server/dem_server", "--log-format", "json", "--listen", "nowhere"],
                                capture_output=True, text=True, timeout=PATIENCE_S)
        said, = lines(result.stderr)
        self.assert_lines([said], "dem_server")
        self.assertEqual(said["level"], "error")
        self.assertIn("`nowhere` is not an address", said["message"])

    def test_the_coupler_and_its_servers_tell_alike(self):
        out = self.folder / "run"
        result = coupler("run", CASE / "coupled.yaml", "--log-format", "json", "--out", out, *SHORT)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_lines(lines(result.stderr), "coupler")
        self.assertIn(f"results            {out}", result.stdout)
        for server in ("fdm_server", "dem_server"):
            self.assert_lines(lines((out / f"{server}.log").read_text()), server)

    def test_errors_are_lines_too(self):
        scene = self.scene('name: "a\\nb"\n')
        for program in (coupler, lambda *words: subprocess.run([BUILD / "simplified/simplified", *map(str, words)],
                                                               capture_output=True, text=True, timeout=PATIENCE_S)):
            result = program("check", scene, "--log-format", "json")
            self.assertEqual(result.returncode, 2)
            self.assertEqual(lines(result.stderr)[-1]["level"], "error")


class Units(ProgramTest):
    def setUp(self):
        super().setUp()
        self.units = []
        for name in ("fdm", "dem"):
            text = (BUILD / f"services/adit-{name}.service").read_text()
            self.assertIn(f"ExecStart=/usr/bin/{name}_server ", text)
            self.units.append(self.scene(text.replace("/usr/bin/", f"{BUILD}/{name}_server/"), f"adit-{name}.service"))

    @unittest.skipUnless(shutil.which("systemd-analyze"), "systemd-analyze is not installed")
    def test_systemd_takes_them_and_finds_little_exposed(self):
        result = subprocess.run(["systemd-analyze", "verify", *self.units], capture_output=True, text=True)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for unit in self.units:
            result = subprocess.run(["systemd-analyze", "security", "--offline=true", "--threshold=15", unit], capture_output=True, text=True)
            self.assertEqual(result.returncode, 0, result.stdout)

    def test_its_own_options_are_right(self):
        for unit in self.units:
            command = re.search(r"^ExecStart=(.*)$", unit.read_text(), re.MULTILINE)[1].split()
            options = re.search(r'^Environment="(\w+)=(.*)"$', unit.read_text(), re.MULTILINE)
            self.assertEqual(command.pop(), f"${options[1]}")
            words = options[2].replace("%t/" + unit.stem, str(self.folder)).split()
            server = subprocess.Popen([*command, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            self.assertEqual(server.stdout.readline(), f"listening on unix:{self.folder}/socket\n")
            server.terminate()
            server.communicate()
            self.assertEqual(server.returncode, 0)

    def test_a_secret_may_be_a_credential_whose_mode_names_a_group(self):
        secret = self.scene("f" * 64, "secret")
        secret.chmod(0o440)
        command = [BUILD / "dem_server/dem_server", "--listen", "127.0.0.1:0", "--secret-file", secret]
        refused = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertIn("chmod 600", refused.stderr)
        service = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   env=os.environ | {"CREDENTIALS_DIRECTORY": str(self.folder)})
        self.assertTrue(service.stdout.readline().startswith("listening on "))
        service.terminate()
        service.communicate()


if __name__ == "__main__":
    unittest.main()
