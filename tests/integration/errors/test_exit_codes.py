"""docs/reliability.md lists every exit code that the programs have, and no other."""

import re
import unittest

from programs import SOURCE


class ExitCodes(unittest.TestCase):
    def test_the_table_is_that_of_the_programs(self):
        header = (SOURCE / "protocol/errors.hpp").read_text()
        body = re.search(r"enum ExitCode : int \{(.*?)\}", header, re.DOTALL)[1]
        codes = {name: int(code) for name, code in re.findall(r"(k\w+) = (\d+)", body)}
        page = (SOURCE / "docs/reliability.md").read_text()
        rows = {name: int(code) for code, name in re.findall(r"^\| (\d+)(?: \+ n)? \| [^|]+ \| `(k\w+)` \|$", page, re.MULTILINE)}
        self.assertIn("kUserError", codes)
        self.assertEqual(rows, codes)


if __name__ == "__main__":
    unittest.main()
