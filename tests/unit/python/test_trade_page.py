"""docs/trade.md is what its template and the stored results make; a template that names what is not there is refused in one sentence."""
import pathlib
import re
import shutil
import tempfile
import unittest

from adit.accuracy.dimensions import Dimension
from adit.accuracy.runs import Computed
from adit.results.files import Unusable
from adit.trade.ladders import TUNNELS
from adit.trade.own.rows import markdown, rows_of
from adit.trade.own.rungs import Ladder
from adit.trade.page import page
from adit.trade.page.places import filled, ladders_of
from adit.trade.page.results import read
from adit.trade.table import read_csv, write_csv


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class InTheTree(unittest.TestCase):
    def test_the_page_is_what_template_and_results_make(self):
        self.assertEqual(page.PAGE.read_text(encoding="utf-8"), page.text(page.stored()))

    def test_its_pictures_are_there(self):
        pictures = re.findall(r"!\[.*\]\((.*)\)", page.PAGE.read_text(encoding="utf-8"))
        self.assertEqual([(page.PAGE.parent / picture).exists() for picture in pictures], [True] * len(page.PICTURED))

    def test_all_results_are_stored(self):
        self.assertEqual({path.stem for path in page.STORED.iterdir()}, set(ladders_of(page.TEMPLATE)))


def made(name):
    """Rows of a tunnel: the answers of the nth of N models are n, those of the last one N, and it takes n seconds of a CPU."""
    ladder = TUNNELS[name].ladder(quick=False)
    count = len(ladder.rungs)
    return [{"family": rung.family, "model": rung.name, "particles": 1200, "zones": 0, "updates": 3e6, "cpu_s": float(n), "wall_s": 60.0,
             "memory_bytes": 5e6} | {quantity.key: float(n) for quantity in ladder.quantities}
            | {f"{quantity.key} error": n / count - 1 for quantity in ladder.quantities} for n, rung in enumerate(ladder.rungs, 1)]


class Places(InFolder):
    def filled(self, template, results=None):
        path = self.folder / "template.md"
        path.write_text(template, encoding="utf-8")
        return filled(path, results or {"hzm": made("hzm")})

    def test_a_question_has_the_cost_and_the_differences_of_its_model(self):
        """Of six models the beam is the second: it takes 2 s and finds 2/6 of what the last one does."""
        text = self.filled("before\n{{when hzm\nhow far | beam | offset, moment\nhow exactly | window of 90 m | offset\n}}\nafter")
        self.assertEqual(text.splitlines(), [
            "before", "| question | model | CPU [s] | difference from the finest |", "|---|---|---|---|",
            "| how far | beam | 2.0 | offset -67 %, moment -67 % |", "| how exactly | window of 90 m | 6.0 | the finest model |", "after"])

    def test_a_table_has_all_models(self):
        rows = self.filled("{{table hzm}}").splitlines()
        self.assertEqual(len(rows), 2 + 6)
        self.assertTrue(rows[2].startswith("| chain of rigid bodies | 1,200 | 0 | 3.0 | 1 | 5 | 1000.0 (-83 %) |"), rows[2])
        self.assertTrue(rows[-1].startswith("| window of 90 m | 1,200 | 0 | 3.0 | 6 | 5 | 6000.0 |"), rows[-1])

    def test_minutes_are_those_of_all_models(self):
        """Six models of 1 to 6 s and one of 99 s."""
        self.assertEqual(self.filled("{{minutes}}", {"hzm": made("hzm"), "bar": [{"cpu_s": 99.0}, {"cpu_s": None}]}), "2")

    def test_what_is_not_there_is_told_in_one_sentence(self):
        for template, message in (
                ("{{tabel hzm}}", "template.md: `tabel hzm`: there is no such place; the places are table, when, choices, minutes."),
                ("{{table hzn}}", "there is no such ladder; the ladders are longxi, longxi_cells, qingcaosha, hzm."),
                ("{{when hzm\nhow far | beams | offset\n}}", "there is no model `beams`; there are chain of rigid bodies, beam,"),
                ("{{when hzm\nhow far | beam | offsets\n}}", "there is no quantity `offsets`; there are opening of the edge, offset,"),
                ("{{when hzm\nhow far | beam\n}}", "`how far | beam` is no row `question | model | quantities`.")):
            with self.subTest(template), self.assertRaises(Unusable) as raised:
                self.filled(template)
            self.assertIn(message, str(raised.exception))
            self.assertNotIn("\n", str(raised.exception))

    def test_a_quantity_that_a_model_does_not_have_is_told(self):
        rows = made("hzm")
        rows[0]["rotation error"] = None
        with self.assertRaisesRegex(Unusable, "`chain of rigid bodies` has no difference of `rotation`"):
            self.filled("{{when hzm\nhow far | chain of rigid bodies | rotation\n}}", {"hzm": rows})


class Results(InFolder):
    def test_rows_are_read_as_they_were_written(self):
        rows = made("hzm")
        rows[0]["rotation"] = None
        write_csv(self.folder / "hzm.csv", rows)
        self.assertEqual(read("hzm", self.folder), rows)

    def test_results_of_other_models_are_refused(self):
        write_csv(self.folder / "hzm.csv", made("hzm")[1:])
        with self.assertRaisesRegex(Unusable, "hzm.csv holds other models or quantities than hzm has today"):
            read("hzm", self.folder)

    def to_folder(self):
        """The page is written there."""
        for name, path in (("STORED", self.folder / "trade"), ("PAGE", self.folder / "trade.md"), ("PICTURES", self.folder)):
            self.addCleanup(setattr, page, name, getattr(page, name))
            setattr(page, name, path)

    def test_only_what_has_no_results_is_computed(self):
        (self.folder / "hzm.csv").touch()
        self.to_folder()
        self.assertEqual(page.missing(self.folder), [name for name in ladders_of(page.TEMPLATE) if name != "hzm"])

    def test_new_results_come_into_the_page_and_stay_there(self):
        shutil.copytree(page.STORED, self.folder / "trade")
        self.to_folder()
        write_csv(self.folder / "hzm.csv", made("hzm"))
        page.write(self.folder)
        self.assertIn("| window of 90 m | 1,200 | 0 | 3.0 | 6 | 5 | 6000.0 |", page.PAGE.read_text(encoding="utf-8"))
        self.assertEqual(page.stored()["hzm"], made("hzm"))
        self.assertEqual({path.name for path in self.folder.glob("*.png")}, {f"trade_{name}.png" for name in page.PICTURED})


def answer(levels):
    """Errors of order 2 in the length of zones and 1 in that of particles; a finer model takes eight times as long."""
    zones, particles = (levels.get(name, 0) for name in ("zones", "particles"))
    return Computed(levels, {"q": 1 + 0.04 / 4**zones + 0.02 / 2**particles}, 8.0**zones + 8.0**particles)


class OwnRows(InFolder):
    def rows(self, budget):
        dimensions = [Dimension(name, {name: 8.0}, power, ("finer", "coarser")) for name, power in (("zones", 1), ("particles", -1))]
        ladder = Ladder(answer, dimensions, [], budget)
        self.assertTrue(ladder.climb())
        write_csv(self.folder / "scene.csv", rows_of(ladder, ["q"]))
        return read_csv(self.folder / "scene.csv")

    def test_the_table_tells_differences_from_the_finest_and_orders(self):
        lines = list(markdown(self.rows(1e9), ["q"], "packings"))
        self.assertIn("| stated | stated | 0 | 2 | 1.06 (+3.9 %) |", lines)
        self.assertIn("| zones | zones_x2 | 0 | 9 | 1.03 (+0.98 %, order 2) |", lines)
        self.assertIn("| particles | particles_x2 | 0 | 9 | 1.05 (+2.9 %, order 1) |", lines)
        self.assertIn("| all of these | zones_x2,particles_x2 | 0 | 16 | 1.02 |", lines)
        self.assertEqual(lines[-1], "The finest model is zones_x2,particles_x2.")

    def test_models_beyond_the_budget_are_named(self):
        self.assertEqual(list(markdown(self.rows(10), ["q"], "packings"))[-1], "Beyond the budget: zones_x2, particles_x2, zones_x2,particles_x2.")


if __name__ == "__main__":
    unittest.main()
