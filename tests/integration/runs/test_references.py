"""Cases compute what their reference.json holds, and adit compare --reference says where a run does not."""

import json
import shlex
import shutil
import unittest

import references
from programs import SOURCE, ProgramTest

HERE = ("cavern", "fault_section")  # test_longxi and test_tunnels run those of longxi and qingcaosha
ALL = (*HERE, "hzm", "longxi", "qingcaosha")


class References(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.hzm = references.computed("hzm", cls.folder_for_all())

    def copy_of_hzm(self):
        return shutil.copytree(self.hzm, self.folder / "hzm")

    def test_reduced_variants_agree_with_their_references(self):
        references.assert_agrees(self, self.hzm, "hzm")
        for case in HERE:
            with self.subTest(case):
                references.run_reduced(self, case)

    def test_a_figure_that_is_not_within_its_tolerance_is_named(self):
        run = self.copy_of_hzm()
        summary = self.summary(run)
        for key, found in (("element_joint_max_opening_m", 1.1 * summary["element_joint_max_opening_m"]), ("max_strain", None)):
            changed = json.dumps({**summary, key: found})
            (run / "summary.json").write_text(changed)
            done = references.compare(run, "hzm")
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            outside = [line.split()[0] for line in done.stdout.splitlines() if "NOT WITHIN" in line]
            self.assertEqual(outside, [key])
            self.assertRegex(done.stdout.splitlines()[-1], r"^\d+ of \d+ figures are within their tolerances; .*reference.json")

    def test_a_run_of_another_scene_and_one_that_is_not_complete_are_refused(self):
        run = self.copy_of_hzm()
        summary = self.summary(run)
        for change, said in (({"scene_hash": "0"}, "computed another scene than those of"),
                             ({"completed": False}, "holds no complete run")):
            (run / "summary.json").write_text(json.dumps({**summary, **change}))
            done = references.compare(run, "hzm")
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), done.stderr)
            self.assertIn(said, done.stderr)

    def test_every_tolerance_has_a_reason_and_every_command_a_scene(self):
        self.assertEqual(sorted(path.parent.name for path in references.CASES.glob("*/reference.json")), sorted(ALL))
        for case in ALL:
            with self.subTest(case):
                found = references.contents(case)
                used = {tolerance for run in found["runs"] for _, tolerance in run["figures"].values()}
                self.assertEqual(used, set(found["tolerances"]))
                for tolerance in found["tolerances"].values():
                    self.assertGreater(len(tolerance["reason"]), 40)
                for run in found["runs"]:
                    self.assertIn("commit", run["computed"])
                    self.assertTrue((SOURCE / shlex.split(run["command"])[1]).exists(), run["command"])


if __name__ == "__main__":
    unittest.main()
