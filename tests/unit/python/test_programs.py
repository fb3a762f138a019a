"""Where the package finds the programs, if pip has put it apart from them."""

import json
import tempfile
import types
import unittest
from pathlib import Path
from unittest import mock

from adit import programs


class InstalledFrom(unittest.TestCase):
    def found(self, url):
        distribution = types.SimpleNamespace(read_text=lambda name: json.dumps({"url": url}))
        with mock.patch.object(programs.metadata, "distribution", return_value=distribution):
            return programs._installed_from()

    def test_a_source_tree_whose_name_has_spaces_and_accents(self):
        with tempfile.TemporaryDirectory(prefix="Adit für 100 % ") as folder:
            tree = Path(folder)
            (tree / "scripts").mkdir()
            (tree / "scripts" / "build").touch()
            self.assertEqual(self.found((tree / "python").as_uri()), tree)

    def test_a_tree_that_is_gone_and_an_archive(self):
        for url in ("file:///nowhere/python", "https://example.org/adit.tar.gz"):
            with self.subTest(url):
                self.assertIsNone(self.found(url))


if __name__ == "__main__":
    unittest.main()
