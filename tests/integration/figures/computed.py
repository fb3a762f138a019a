"""Runs whose numbers are compared: a scene, its results, and the sums of energies that every one of them must keep."""

import json

import numpy as np

from figures.told import Told
from programs import ProgramTest

from adit import Run
from adit.results.pieces import Piece
from adit.report import page
from report.test_pages import Elements, value

# What energies.csv lists by cause, and the column of the ledger in histories.csv that each one is part of.
CAUSES = {"contacts": "strain", "contact_bonds": "strain", "parallel_bonds": "strain", "joints": "strain", "springs": "strain",
          "foundations": "strain", "loads": "external_work", "body_loads": "external_work", "motions": "external_work",
          "walls": "external_work", "ground": "external_work", "friction": "dissipated", "contact_dashpots": "dissipated",
          "local_damping": "dissipated", "viscous_damping": "dissipated", "quiet_edges": "dissipated", "foundation_losses": "dissipated"}


def told_report(test, run):
    """The page says the same as the summary, to four digits; returns its text and {key: number} of what it shows."""
    text = page.of_run(run.folder).read_text()
    cells = {key: cell for (kind, key), cell in Elements(text).cells.items() if kind == "data-key"}
    numbers = {key: run.summary[key] for key in cells if isinstance(run.summary[key], (int, float)) and not isinstance(run.summary[key], bool)}
    for key, number in numbers.items():
        test.assertAlmostEqual(value(cells[key]), number, delta=5e-4 * abs(number), msg=key)
    return text, numbers


class ComputedTest(ProgramTest):
    def computed(self, scene, **files):
        """Runs a scene, given as mappings; `files`: the contents of those that it reads."""
        for name, content in files.items():
            (self.folder / f"{name}.csv").write_text(content)
        self.run = Run(self.run_scene(self.scene(json.dumps(scene))))
        return self.run

    def pieces(self, instant):
        """{name: Piece} of an instant by its number, those of each region by themselves."""
        return {name: Piece(path) for name, path in self.run.instants[instant][1].items()}

    @property
    def time(self):
        return self.run.histories["time_s"]

    def told_histories(self, expected, **tolerance):
        """Compares the histories that a scene asks for; the ledger is left to others."""
        ledger = {name for name in self.run.histories if name.endswith("_J")} | {"energy_drift", "time_s", "max_bond_force_N"}
        told = Told(self, "histories.csv", self.run.histories, ledger - expected.keys())
        told.equal(expected, **tolerance)
        told.all_told()

    def told_energies(self, size, tolerance=1e-9, **expected):
        """Compares energies.csv: what is not expected is 0, and the ledger of histories.csv holds the sums."""
        told = Told(self, "energies.csv", self.run.table("energies.csv"), {"time_s", "particles_time_step_J"})
        told.equal({f"particles_{cause}_J": expected.get(cause, 0) + 0 * self.time for cause in CAUSES}, tolerance, size)
        told.all_told()
        for column in ("strain", "external_work", "dissipated"):
            listed = sum(told.numbers[f"particles_{cause}_J"] for cause, of in CAUSES.items() if of == column)
            np.testing.assert_allclose(self.run.histories[f"particles_{column}_J"], listed, rtol=0, atol=1e-12 * size, err_msg=column)
        ledger = {name: self.run.histories[f"particles_{name}_J"] for name in ("kinetic", "strain", "released", "dissipated", "external_work")}
        balance = sum(ledger.values()) - 2 * ledger["external_work"] + told.numbers["particles_time_step_J"]  # with this cause the books close
        moves = ledger["kinetic"] > 0  # where it rests or turns, rows tell 0 for what the scheme has below
        np.testing.assert_allclose(balance[moves], balance[moves][:1].sum(), rtol=0, atol=1e-9 * size)

    def told_piece(self, name, expected, tolerance=1e-9, size=None):
        """Compares all fields of a piece at the end; `size` is that of its forces and stresses."""
        piece = self.run.fields()[name]
        told = Told(self, name, {**piece.point_fields, **piece.cell_fields})
        for field, values in expected.items():
            forces = field.endswith(("_N", "_Nm", "_Pa"))
            told.equal({field: np.broadcast_to(np.asarray(values, float), piece[field].shape)}, tolerance, size if forces else None)
        told.all_told()
        return piece
