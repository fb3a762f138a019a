"""docs/reliability.md lists the kinds of faults by name, at least 60, each with a test that exists, and leaves out no test of a fault."""

import ast
import re
import unittest

from programs import SOURCE

PAGE = (SOURCE / "docs/reliability.md").read_text()
HERE = SOURCE / "tests/integration"
SUITE = [*(HERE / "faults").glob("test_*.py"), HERE / "errors/test_hostile_client.py", HERE / "resume/test_stop.py"]
NO_FAULTS = {"test_pictures_report_and_comparison_of_an_unfinished_run"}


def python_tests(files):
    return {node.name for file in files for node in ast.walk(ast.parse(file.read_text()))
            if isinstance(node, ast.FunctionDef) and node.name.startswith("test_")}


def cpp_tests():
    source = "".join(file.read_text() for file in (SOURCE / "tests").rglob("*_test.cpp"))
    return {".".join(names) for names in re.findall(r"^(?:TEST|TEST_F|TEST_P|RC_GTEST_PROP)\((\w+),\s*(\w+)", source, re.MULTILINE)}


def rows(heading):
    """The cells of all rows of the tables whose first cell has this heading."""
    for table in re.findall(rf"^\| {heading} \|.*\n\|[-|]+\|\n((?:\|.*\n)+)", PAGE, re.MULTILINE):
        yield from ([cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines())


def tests_in(text):
    return set(re.findall(r"`(test_\w+|[A-Z]\w+\.[A-Z]\w+)`", text))


class ReliabilityPage(unittest.TestCase):
    def setUp(self):
        self.faults = list(rows("fault"))

    def test_kinds_of_faults(self):
        names = [row[0] for row in self.faults]
        self.assertGreaterEqual(len(names), 60)
        self.assertEqual(len(names), len(set(names)))
        self.assertEqual({len(row) for row in self.faults}, {7})

    def test_each_fault_has_a_test_that_exists(self):
        for name, *_, test in self.faults:
            self.assertTrue(tests_in(test), name)
        files = list(HERE.rglob("test_*.py"))
        self.assertEqual(tests_in(PAGE) - {file.stem for file in files} - python_tests(files) - cpp_tests(), set())

    def test_each_test_has_a_fault(self):
        own = {name for name in dir(self) if name.startswith("test_")}
        listed = {test for row in self.faults for test in tests_in(row[-1])}
        self.assertEqual(python_tests(SUITE) - listed - own - NO_FAULTS, set())


if __name__ == "__main__":
    unittest.main()
