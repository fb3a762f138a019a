"""The case daikai: racking of the elastic station beside Wang's, columns that fail as they did in 1995."""

import unittest

import numpy as np

from programs import SOURCE, ProgramTest

from adit import Run
from adit.cases import daikai

CASE = SOURCE / "cases" / "daikai"


class Daikai(ProgramTest):
    def shaken(self, name, *settings):
        return Run(self.run_scene(CASE / f"{name}.yaml", "--set", "output.field_times=[]", *settings, out=name.replace("/", "_")))

    def test_the_elastic_box_racks_as_wangs_does(self):
        run = self.shaken("elastic/racking")
        self.assertAlmostEqual(daikai.racking_ratio(run) / daikai.wang_of(run.scene), 1, delta=0.1)
        # The column bears at rest what the roof and its cover weigh over half of both spans, fixed or hinged at the walls.
        weight = (4.8 * 1900 + 0.8 * 2500) * 9.81 * 8.15 * 3.5
        self.assertTrue(1.0 * weight < -run.histories["top_thrust_N"][0] < 1.25 * weight, (weight, run.histories["top_thrust_N"][0]))

    def test_the_station_loses_its_columns(self):
        runs = [self.shaken(name, "--set", "time.duration=3.1 s") for name in ("pulse", "pulse_vertical")]
        for run in runs:
            self.assertLess(run.summary["max_energy_drift"], 1e-10)
            h, lost = run.histories, run.summary["member_column_failed_time_s"]
            before, after = h["time_s"] < lost, h["time_s"] > lost + 0.02
            self.assertGreater(h["top_utilisation"][before].max(), 1)
            self.assertEqual(abs(h["top_thrust_N"][after]).max(), 0)
            self.assertLess(h["street_uy_m"][-1], 5 * h["street_uy_m"][before].min())  # the street follows the roof
        spread = [np.ptp(run.histories["top_thrust_N"][run.histories["time_s"] < run.summary["member_column_failed_time_s"]]) for run in runs]
        self.assertGreater(spread[1], 3 * spread[0])  # the vertical motion changes the thrust, and the column fails no later
        self.assertLessEqual(runs[1].summary["member_column_failed_time_s"], runs[0].summary["member_column_failed_time_s"])


if __name__ == "__main__":
    unittest.main()
