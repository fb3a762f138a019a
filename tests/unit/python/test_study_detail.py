"""The worst runs of a study are computed in detail in a stated order, and what the table tells of them are the largest values over time."""
import unittest
from pathlib import Path
from tempfile import TemporaryDirectory
from types import SimpleNamespace
from unittest import mock

import numpy as np

from adit.plots import style
from adit.results.files import Unusable
from adit.study import detail, page, pictures
from adit.study.design import Row
from adit.study.study import Detail, Levels

TIMES = np.linspace(0, 1, 5)
LEVEL = 0.2 * 9.80665
HALF_WIDTH = 10.0


def study(**changes):
    given = {"path": Path("s.yaml"), "scene": Path("tunnel.yaml"), "set": {}, "keep": [], "detail": Detail("opening_m", 2),
             "levels": Levels("stripes", "pga", [LEVEL], None, "")}
    return SimpleNamespace(**(given | changes))


def listed(*answers):
    """Rows of a table with these answers, each in a folder of its own, the later ones first by name."""
    return [{"run": number + 1, "motion": "m", "level": LEVEL, "sample": "0_0", "opening_m": answer, "folder": f"runs/{9 - number}"}
            for number, answer in enumerate(answers)]


class Worst(unittest.TestCase):
    def test_are_the_largest_by_size_of_those_that_have_the_answer(self):
        rows = listed(1.0, None, -3.0, float("nan"), 2.0)
        self.assertEqual(detail.worst(Detail("opening_m", 5), rows), [2, 4, 0])
        self.assertEqual(detail.worst(Detail("opening_m"), rows), [2])
        self.assertEqual(detail.worst(Detail("opening_m"), listed(None, None)), [])

    def test_come_in_the_order_of_their_hashes_where_they_are_equal(self):
        self.assertEqual(detail.worst(Detail("opening_m", 3), listed(2.0, 2.0, 2.0)), [2, 1, 0])

    def test_are_different_runs(self):
        """Rows that differ only in what functions are given have one run: the worst of them counts."""
        rows = listed(1.0, 2.0, 3.0, 4.0)
        rows[2]["folder"] = rows[3]["folder"]
        self.assertEqual(detail.worst(Detail("opening_m", 2), rows), [3, 1])

    def test_have_the_place_that_their_answer_is_about(self):
        places = {"element_joint_max_opening_m": "opening", "max_moment_lateral_N_m": "moment", "max_shear_lateral_N": "shear", "max_strain": "strain",
                  "leak": "opening"}
        for answer, place in places.items():
            self.assertEqual(detail.place_of(answer), f"worst-{place}")


class Scene(unittest.TestCase):
    TUNNEL = {"tunnel": {"joints": [{}]}}

    def test_of_a_tunnel_with_joints_and_a_window_is_needed(self):
        for stated, said in (({"continuum": {}}, "tunnel.yaml is no scene of a whole tunnel with joints"), ({"simplified": {}}, "with joints"),
                             ({"simplified": {"tunnel": {"sections": [{}]}}}, "with joints"),
                             ({"simplified": self.TUNNEL}, "tunnel.yaml has no simplified.zoom, the width")):
            with self.assertRaisesRegex(Unusable, said):
                detail.check(study(), stated)
        detail.check(study(), {"simplified": self.TUNNEL | {"zoom": {"width": 90.0}}})


class Way(unittest.TestCase):
    def go(self, *results):
        """(the rows that are computed, what the way returns, by how many fewer runs) where the runs give these results."""
        fewer = []
        way = detail.way({"beam": "b", "section": "s"}, SimpleNamespace(expect=fewer.append))
        asked = [next(way)]
        for result in results:
            try:
                asked.append(way.send(result))
            except StopIteration as end:
                return asked, end.value, fewer
        self.fail(f"goes on after {asked}")

    def test_leads_from_the_beam_to_its_section(self):
        self.assertEqual(self.go({"answers": {}}, {"answers": {}}), (["b", "s"], [("s", {"answers": {}})], []))

    def test_ends_at_a_beam_that_fails(self):
        failed = {"failed": "no room"}
        self.assertEqual(self.go(failed), (["b"], [("b", failed)], [-1]))


class Tasks(unittest.TestCase):
    def test_are_those_of_the_run_by_the_beam_and_of_the_scene_that_it_writes(self):
        plan = SimpleNamespace(study=study(set={"time.dt": "1 ms", "simplified.model": "chain"}, keep=["envelopes.csv"]), out=Path("/o"),
                               program="/bin/simplified", release="simplified 1")
        row = {model: Row(settings={"a": "2"}, hash=f"h_{model}") for model in detail.MODELS}
        with mock.patch.object(detail.programs, "program", "/bin/{}".format):
            beam, section = detail.tasks_of(plan, row, "worst-shear")
        self.assertEqual(beam["settings"], {"time.dt": "1 ms", "simplified.model": "beam", "a": "2"})
        self.assertEqual(beam["options"], ["--zoom", "worst-shear"])
        self.assertEqual(beam["keep"], ["zoom", "joints.csv", "envelopes.csv"])
        self.assertEqual(section["scene"], "/o/detail/h_beam/zoom/worst-shear.yaml")
        self.assertEqual(section["settings"], {})
        self.assertEqual(section["program"], "/bin/coupler")


class Made(unittest.TestCase):
    """A joint at 30 m, which closes by 4 mm and opens by 2 mm by the beam, and by half as much again in its section; it turns by 0.1 mrad, so
    that its edge, 10 m from the axis, opens by 1 mm more."""

    OPENING = np.array([0, -4e-3, 0, 2e-3, 0])

    def setUp(self):
        folder = TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(style.plt.close, "all")
        self.out = Path(folder.name)
        beam, section = (self.out / "detail" / f"h_worst-opening_{model}" for model in detail.MODELS)
        (beam / "zoom").mkdir(parents=True)
        section.mkdir()
        (beam / "scene.yaml").write_text(f"simplified: {{tunnel: {{sections: [{{width: {2 * HALF_WIDTH}}}]}}}}\n")
        (beam / "joints.csv").write_text("chainage_m,group\n10,segments\n30,elements\n")
        (section / "scene.yaml").write_text("particles: {joints: [{from: {x: 30}}], springs: ["
                                            "{name: gasket_1, from: {y: 5}}, {name: gasket_2, from: {y: -5}}, {name: key_1, from: {y: 0}}]}\n")
        turned, zero = np.full(5, -1e-4), np.zeros(5)
        self.table(beam / "zoom" / "worst-opening_joint.csv", opening_m=self.OPENING, offset_m=zero, rotation_rad=turned,
                   axial_force_N=1e9 * self.OPENING, shear_N=zero, moment_Nm=zero)
        self.table(section / "histories.csv", joint_opening_m=1.5 * self.OPENING, joint_offset_m=zero, joint_rotation_rad=turned,
                   gasket_1_force_N=1e9 * self.OPENING, gasket_2_force_N=5e8 * self.OPENING, key_1_force_N=zero)

    @staticmethod
    def table(path, **columns):
        columns = {"time_s": TIMES} | columns
        np.savetxt(path, np.column_stack(list(columns.values())), delimiter=",", header=",".join(columns), comments="")

    def row(self, **result):
        pair = {model: Row(hash=f"h_worst-opening_{model}") for model in detail.MODELS}
        return detail.row_of(SimpleNamespace(study=study(), out=self.out), listed(3e-3)[0], pair, result, "worst-opening")

    def test_the_table_has_the_largest_values_of_both_models(self):
        row = self.row()
        self.assertEqual((row["joint"], row["chainage_m"]), ("elements", 30.0))
        expected = {"beam_opening_m": 2e-3, "section_opening_m": 3e-3,  # that the joint closes by more does not count
                    "beam_edge_opening_m": 3e-3, "section_edge_opening_m": 4e-3, "beam_rotation_rad": 1e-4,
                    "beam_axial_force_N": 4e6, "section_axial_force_N": 6e6, "section_moment_Nm": 5 * 2e6, "section_key_force_N": 0}
        for column, value in expected.items():
            with self.subTest(column):
                self.assertAlmostEqual(row[column] / (value or 1), 1 if value else 0, 12)

    def test_what_fails_is_a_row_with_its_reason(self):
        self.assertEqual(list(self.row(failed="no room")), list(self.row()))
        self.assertEqual(self.row(failed="no room")["failed"], "no room")
        self.assertIsNone(self.row(failed="no room")["beam_opening_m"])

    def test_the_user_is_told_both_models_or_the_reason(self):
        for row, said in ((self.row(), ", elements at 30 m: edge opening 3 mm by the beam, 4 mm by its unified section (+33.3 %)"),
                          (self.row(failed="no room"), " failed: no room"),
                          (self.row() | {"place": "worst-moment"}, ", elements at 30 m: moment 0 N m by the beam, 10 MN m by its unified section")):
            self.assertEqual(list(detail.told(study(), [row])), [f"in detail          run 1, m at 0.2 g{said}"])
        without = listed(1.0)[0] | {"level": None}
        self.assertEqual(detail.name_of(study(levels=None), without), "run 1, m")
        self.assertEqual(detail.name_of(study(levels=None), without | {"motion": ""}), "run 1")

    def test_the_page_has_both_models_and_reasons(self):
        outcome = SimpleNamespace(study=study(), closer=[self.row(), self.row(failed="no <room>")])
        told = "".join(map(str, page.detail.told(outcome)))
        self.assertIn("run 1, m at 0.2 g: largest values of elements at 30 m", told)
        self.assertIn("<td>3 mm</td><td>4 mm</td><td>+33.3 %</td>", told)
        self.assertIn("could not be computed in detail: no &lt;room&gt;", told)

    def test_the_picture_has_both_models_over_time(self):
        ((name, drawing),) = pictures.detail.joints(SimpleNamespace(study=study(), closer=[self.row(), self.row(failed="no room")]), self.out)
        self.assertEqual(name, "detail_1")
        _, panels = style.plt.subplots(drawing.layout.rows)
        drawing.paint(*panels)
        lines = {line.get_label(): line.get_ydata() for line in panels[0].get_lines()}
        np.testing.assert_allclose(lines["beam"], 1e3 * self.OPENING + 1)  # mm
        np.testing.assert_allclose(lines["unified section"], 1.5e3 * self.OPENING + 1)


if __name__ == "__main__":
    unittest.main()
