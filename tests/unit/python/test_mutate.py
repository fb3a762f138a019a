"""tools/mutate: it makes exactly the changes that its rules say, and names those that no test notices."""

import io
import pathlib
import random
import subprocess
import tempfile
import unittest


from mutation import build, kept, report, source, suite, trial


def after(line):
    """What the rules make of one line of code."""
    return sorted(change.after for change in source.changes("a.cpp", line))


class Changes(unittest.TestCase):
    def test_signs(self):
        self.assertEqual(after("u = a + b;"), ["u = a - b;"])
        self.assertEqual(after("u -= b;"), ["u += b;"])
        self.assertEqual(after("return -b;"), ["return b;"])
        self.assertEqual(after('throw Error(path + ".radius");'), [])

    def test_factors(self):
        self.assertEqual(after("u = a * b;"), ["u = a / b;"])

    def test_indices(self):
        self.assertEqual(after("u = v[i];"), ["u = v[i + 1];"])
        self.assertEqual(after("u = p.x;"), ["u = p.y;"])
        self.assertEqual(after("u = stress.xx;"), ["u = stress.yy;"])

    def test_comparisons(self):
        self.assertEqual(after("u = a < b;"), ["u = a <= b;"])
        self.assertEqual(after("u = std::min(a, b);"), ["u = std::max(a, b);"])
        self.assertEqual(after("std::vector<double> u;"), [])

    def test_conditions(self):
        self.assertEqual(after("if (done) stop();"), ["if (!(done)) stop();"])
        self.assertEqual(after("if (a.size() == b.size()) stop();"),
                         ["if (!(a.size() == b.size())) stop();", "if (a.size() != b.size()) stop();"])
        self.assertEqual(after("if (!done) stop();"), ["if (done) stop();"])
        self.assertEqual(after("u = a && b;"), ["u = a || b;"])

    def test_constants(self):
        self.assertEqual(after("u = 0.5;"), ["u = (0.7 * 0.5);"])
        self.assertEqual(after("u = 3;"), ["u = 4;"])

    def test_what_computes_nothing_stays(self):
        for line in ("// u = a + b;", '#include "a.hpp"', 'u = "a + b < 3";', "static_assert(3 > 2);", "using A = B[3];"):
            self.assertEqual(after(line), [], line)
        self.assertEqual([change.line for change in source.changes("a.cpp", "/* a + b\n a + b */\nu = a + b;")], [3])

    def test_the_choice_follows_its_seed_and_reaches_every_folder(self):
        found = [source.Change(f"{folder}/a.cpp", n, "sign", "", "") for folder in ("one", "two") for n in range(50)]
        first = source.spread(found, 10, random.Random(3))
        self.assertEqual(first, source.spread(found, 10, random.Random(3)))
        self.assertNotEqual(first, source.spread(found, 10, random.Random(4)))
        self.assertEqual(len({change.path for change in first}), 2)
        self.assertEqual(len(set(first)), 10)


SAMPLE = {
    "CMakePresets.json": '{"version": 6, "configurePresets": [{"name": "release", "generator": "Ninja", '
                         '"binaryDir": "${sourceDir}/build/release", "cacheVariables": {"CMAKE_BUILD_TYPE": "Release"}}]}',
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.25)\nproject(sample LANGUAGES CXX)\nenable_testing()\n"
                      "include_directories(${PROJECT_SOURCE_DIR})\nadd_library(sample STATIC sample/area.cpp sample/angle.cpp)\n"
                      "add_subdirectory(tests)\n",
    "tests/CMakeLists.txt": "add_executable(area_tests area_test.cpp)\ntarget_link_libraries(area_tests sample)\n"
                            "add_test(NAME area COMMAND area_tests)\n"
                            "add_executable(angle angle.cpp)\ntarget_link_libraries(angle sample)\n"
                            "add_executable(angle_tests angle_test.cpp)\n"
                            "target_compile_definitions(angle_tests PRIVATE ANGLE=\"$<TARGET_FILE:angle>\")\n"
                            "add_dependencies(angle_tests angle)\nadd_test(NAME angle COMMAND angle_tests)\n",
    "sample/unit.hpp": "inline double metres(double x) {\n  return 1000 * x;\n}\n",
    "sample/area.cpp": '#include "sample/unit.hpp"\n'
                       "double area(double a, double b) {\n  return metres(a) * b;\n}\n"
                       "double girth(double a, double b) {\n  return 2 * (a + b);\n}\n"
                       "int rounds() {\n  volatile int n = 0;\n  while (n < 3) n = n + 1;\n  return n;\n}\n",
    "sample/angle.cpp": "int turn() {\n  return 90;\n}\n",
    "tests/angle.cpp": "int turn();\nint main() {\n  return turn() == 90 ? 0 : 1;\n}\n",
    "tests/angle_test.cpp": "#include <cstdlib>\nint main() {\n  return std::system(ANGLE) == 0 ? 0 : 1;\n}\n",
    "tests/area_test.cpp": "double area(double, double);\ndouble girth(double, double);\nint rounds();\n"
                           "int main() {\n  girth(2, 3);\n  return area(2, 3) == 6000 && rounds() == 3 ? 0 : 1;\n}\n",
    "tests/mutations.txt": "# noticed\nsample/area.cpp\n- return metres(a) * b;\n+ return metres(a) + b;\n\n"
                           "sample/unit.hpp\n- return 1000 * x;\n+ return 100 * x;\n\n"
                           "# never ends\nsample/area.cpp\n- while (n < 3) n = n + 1;\n+ while (n < 3) n = n * 1;\n\n"
                           "# planted\nsample/area.cpp\n- return 2 * (a + b);\n+ return 3 * (a + b);\n= }\n\n"
                           "sample/area.cpp\n- return 2 * (a + b);\n+ return (a + b) * 2;\n\n"
                           "sample/moved.cpp\n- return metres(a) * b;\n+ return metres(a) * c;\n\n"
                           "# in a program that a test starts\nsample/angle.cpp\n- return 90;\n+ return 180;\n",
}


class Sample(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="adit_mutate_")
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for path, text in SAMPLE.items():
            (self.root / path).parent.mkdir(exist_ok=True)
            (self.root / path).write_text(text)
        (self.root / ".gitignore").write_text("/build/\n")
        subprocess.run(["git", "init", "-q"], cwd=self.root, check=True)
        patience, suite._PATIENCE_S = suite._PATIENCE_S, 2
        self.addCleanup(setattr, suite, "_PATIENCE_S", patience)

    def changes(self):
        sources = [path for path in build.sources_of(self.root) if path.endswith(("pp"))]
        return [kept.find(self.root, sources, entry) for entry in kept.read(self.root / "tests" / "mutations.txt")]

    def bench(self, changes):
        scratch = self.root / "build" / "mutate"
        copy = build.Build(self.root, scratch / "1")
        return trial.Bench(copy, {change.path for change in changes}, suite.Times(scratch / "seconds.json"))

    def test_a_change_that_no_test_notices_is_named(self):
        changes = self.changes()
        results = trial.try_all([self.bench(changes)], changes, lambda result: None)
        verdicts = [result.verdict for result in results]
        noticed, unnoticed = trial.Verdict.NOTICED, trial.Verdict.UNNOTICED
        self.assertEqual(verdicts, [noticed, noticed, noticed, unnoticed, trial.Verdict.SAME_CODE, trial.Verdict.NOT_COMPILED, noticed])
        self.assertIn("no end after", results[2].by)
        out = io.StringIO()
        report.print_summary(results, out)
        self.assertIn("sample/area.cpp:6\n  - return 2 * (a + b);\n  + return 3 * (a + b);\n", out.getvalue())
        self.assertNotIn("metres", out.getvalue())
        self.assertRegex(out.getvalue(), r"all +5 +4 +1 +1 +0\n")
        kept.write(self.root / "unnoticed.txt", [changes[3]], self.root)
        self.assertEqual([kept.find(self.root, ["sample/area.cpp"], entry) for entry in kept.read(self.root / "unnoticed.txt")], [changes[3]])
        for path in ("sample/area.cpp", "sample/unit.hpp"):
            self.assertEqual((self.root / path).read_text(), SAMPLE[path])

    def test_tests_that_fail_without_a_change_are_refused(self):
        (self.root / "sample" / "unit.hpp").write_text("inline double metres(double x) {\n  return 10 * x;\n}\n")
        with self.assertRaisesRegex(RuntimeError, "area_tests fails without a change"):
            self.bench([source.Change("sample/area.cpp", 3, "kept", "", "")])

    def test_a_kept_change_whose_line_is_gone_is_refused(self):
        (self.root / "sample" / "unit.hpp").write_text("inline double metres(double x) {\n  return 1e3 * x;\n}\n")
        with self.assertRaisesRegex(kept.Stale, "`return 1000 \\* x;` of sample/unit.hpp stands nowhere now"):
            self.changes()

    def test_every_kept_change_that_no_longer_fits_is_named(self):
        entries = [("sample/area.cpp", "return 7;", "return 8;", None), ("sample/unit.hpp", "return 9;", "return 8;", None)]
        with self.assertRaisesRegex(kept.Stale, "(?s)`return 7;` of sample/area.cpp.*\n.*`return 9;` of sample/unit.hpp"):
            kept.find_all(self.root, ["sample/area.cpp", "sample/unit.hpp"], entries)


if __name__ == "__main__":
    unittest.main()
