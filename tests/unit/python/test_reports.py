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


class Conditions(ReportTest):
    """What a checking engineer asks first stands in one table."""

    def told(self, scene, **summary):
        rows = re.findall(r'<th scope="row">(.*?)</th><td>(.*?)</td>', computed.chapter(self.results(scene, **summary)))
        return dict(rows)

    def test_of_a_staged_run(self):
        excavations = [{"where": {"group": "tunnel", "y_min": 0}, "stage": 1, "released": 0.6}, {"where": {"group": "tunnel"}, "stage": 3}]
        ground = {"excavations": excavations, "materials": [{"where": {"y_max": 2}}, {"where": {"group": "fill"}, "stage": 3}],
                  "linings": [{"name": "crown", "stage": 2}], "bolts": [{"stage": 2}] * 4,
                  "body_loads": [{"acceleration": {"y": -9.81}}],
                  "damping": {"rayleigh": {"ratio": 0.02, "low_frequency": 1, "high_frequency": 8}},
                  "base": {"kind": "compliant", "acceleration": {**MOTION, "low_corner": 0.2, "high_corner": 10, "taper": 0.5, "from": 1.85}}}
        ring = {"body_loads": [{"acceleration": {"y": -9.81}}], "damping": {"local": 0.1}}
        told = self.told({
            "continuum": ground, "particles": ring, "statics": {"unbalanced_ratio": 1e-4, "count_from_stage": 1, "damping": "adaptive"},
            "initial_stress": {"surface": 2, "surcharge": 1e4, "layers": [{"bottom": -10, "density": 1900, "k0": 0.5}]},
        }, statics_steps=1234, statics_unbalanced_ratio=9.5e-5)
        self.assertEqual(told, {
            "initial stress": "weight of layers: surface at y = 2 m; surcharge 10 kPa; to y = −10 m 1,900 kg/m³, K0 = 0.5",
            "body load of the continuum and the particles": "y = −9.81 m/s²",
            "stage 1": "excavated: group tunnel, y_min = 0 m of the continuum, 60 % of the forces released",
            "stage 2": "the rest of stage 1 released; installed: lining crown of the continuum; installed: 4 bolts of the continuum",
            "stage 3": "excavated: group tunnel of the continuum, 100 % of the forces released; changed or filled: group fill of the continuum",
            "statics before time begins": "until the mean unbalanced force is 1 × 10⁻⁴ of the mean internal force; 9.5 × 10⁻⁵ reached in "
                                          "1,234 steps; adaptive damping; displacements and cracks count from stage 1",
            "damping of the continuum": "Rayleigh, 2 % at 1 Hz and 8 Hz", "damping of the particles": "local, 0.1 of the unbalanced force",
            "processing of the motion of the continuum": "Butterworth filter with low corner 0.2 Hz and high corner 10 Hz, tapers of 500 ms, "
                                                         "baseline corrected, used from 1.85 s"})

    def test_of_stated_components_and_of_what_is_not_stated(self):
        told = self.told({"continuum": {}, "initial_stress": {"xx": -1e6, "yy_per_metre": 2e4}})
        self.assertEqual(told["initial stress"], "xx = −1 MPa, yy = 0 Pa at y = 0, growing with y by 20 kPa/m, positive in tension")
        self.assertEqual(told["damping of the continuum"], "none beside that of the material")
        told = self.told({"continuum": {"base": {"acceleration": {**MOTION, "baseline": False}}}, "statics": {}})
        self.assertEqual(told["initial stress"], "none is stated: the stress before time begins follows from the loads")
        self.assertEqual(told["processing of the motion of the continuum"], "no filter, baseline not corrected")

    def test_of_a_whole_tunnel(self):
        told = self.told({"simplified": {"excitation": {"motion": {**MOTION, "until": 20}}}}, model="beam")
        self.assertEqual(told, {"processing of the motion": "no filter, baseline corrected, used until 20 s"})


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
