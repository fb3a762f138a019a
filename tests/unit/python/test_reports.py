"""Sentences of reports tell what acted, from the scene as it was computed and summary.json."""

import json
import pathlib
import re
import tempfile
import unittest

import yaml

from adit.compare import differences
from adit.report import computed, origin, overview, response
from adit.report.results import Results

MOTION = {"ricker": {"frequency": 2}, "peak": 4.0}


class ReportTest(unittest.TestCase):
    def results(self, scene, **summary):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        folder = pathlib.Path(folder.name)
        (folder / "scene.yaml").write_text(yaml.safe_dump(scene))
        (folder / "summary.json").write_text(json.dumps(summary))
        return Results(folder)


def text_of(markup):
    return re.sub(r"<[^>]+>", " ", markup)


class Acted(ReportTest):
    """Where another number acted than the stated one, both are told."""

    def test_of_the_motion_of_each_model(self):
        ground = {"base": {"kind": "rigid", "acceleration": MOTION}}
        scene = {"continuum": ground, "regions": [{"name": "tube", "particles": {}}, {"name": "rock", "continuum": ground}]}
        stated = [{"key": f"{path}.base.acceleration.peak", "stated": 4.0, "acted": acted, "unit": "m/s^2"}
                  for path, acted in (("continuum", 0.5), ("regions[1].continuum", 0.75))]
        told = text_of(computed.chapter(self.results(scene, stated=stated)))
        for acted in ("0.5 m/s² (0.05099 g)", "0.75 m/s² (0.07648 g)"):
            self.assertIn(f"Its peak is stated as 4 m/s² (0.4079 g); the part that the run takes has {acted}.", told)
        self.assertNotIn("with a peak", told)
        self.assertEqual(text_of(computed.chapter(self.results(scene, stated=[]))).count("with a peak of 4 m/s² (0.4079 g)."), 2)

    def test_of_the_motion_of_a_whole_tunnel(self):
        scene = {"simplified": {"excitation": {"motion": MOTION}}}
        for acted, expected in ((3.98, "with a peak of 4 m/s² (0.4079 g)."), (2.0, "the part that the run takes has 2 m/s² (0.2039 g).")):
            results = self.results(scene, model="beam", peak_input_acceleration_m_per_s2=acted)
            self.assertIn(expected, text_of(computed.chapter(results)))

    def test_of_the_duration(self):
        stated = [{"key": "time.duration", "stated": 0.3, "acted": 0.31, "unit": "s"}]
        self.assertIn("310 ms were computed, 300 ms are stated.",
                      overview.state(self.results({}, completed=True, duration_s=0.3, stated=stated)))
        self.assertIn("300 ms were computed.", overview.state(self.results({}, completed=True, duration_s=0.3, stated=[])))


class Rows(ReportTest):
    """Tables leave out what means nothing for what was computed."""
    COUNTS = {"crack_count": 0, "debonded_count": 0, "multiplier_work_J": 0.0, "coupler_solve_s": 0.0, "max_energy_drift": 1e-12,
              "wall_s": 1.5}

    def rows(self, results):
        chapters = overview.figures(results), response.energy(results), origin.timing(results)
        return set(re.findall(r'data-key="(\w+)"', "".join(chapters)))

    def test_of_a_run(self):
        grouped = {"particles": {"groups": [{"name": "ring"}]}}
        for scene, sizes, missing in (
                ({"continuum": {}}, (9, 0, 0, 0), {"crack_count", "debonded_count", "multiplier_work_J", "coupler_solve_s"}),
                ({"particles": {}}, (0, 9, 0, 0), {"crack_count", "debonded_count", "multiplier_work_J", "coupler_solve_s"}),
                ({"particles": {}}, (0, 9, 8, 0), {"debonded_count", "multiplier_work_J", "coupler_solve_s"}),
                (grouped, (0, 9, 8, 0), {"multiplier_work_J", "coupler_solve_s"}),
                ({"continuum": {}, **grouped}, (9, 9, 8, 7), set())):
            results = self.results(scene, **self.COUNTS, **dict(zip(("zones", "particles", "bonds", "coupling_points"), sizes)))
            self.assertEqual(self.COUNTS.keys() - self.rows(results), missing)
            lines = "".join(overview.lines([results]))
            self.assertEqual([word in lines for word in ("cracks", "debonded")], [name not in missing for name in ("crack_count", "debonded_count")])

    def test_of_a_comparison(self):
        """A run without particles has no cracks beside one that has some."""
        runs = [self.results({}, crack_count=0, zones=9, particles=0, bonds=0), self.results({}, crack_count=3, zones=0, particles=9, bonds=8)]
        self.assertEqual([row.key for row in differences.rows(runs)], ["zones", "particles", "bonds"])
        (line,) = [line for line in overview.lines(runs) if "cracks" in line]
        self.assertEqual(line.split(), ["cracks", "-", "3"])


if __name__ == "__main__":
    unittest.main()
