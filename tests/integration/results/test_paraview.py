"""The state that adit paraview writes asks ParaView for parts, arrays and ranges that the files of the run hold, as VTK
reads them. ParaView itself is not installed where tests run: a stand-in for its module notes what the state asks for."""

import subprocess
import sys
import unittest
from types import ModuleType
from unittest import mock
from xml.etree import ElementTree

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from programs import ADIT, CASE, PATIENCE_S, SOURCE, ProgramTest

READERS = {".vtu": vtk.vtkXMLUnstructuredGridReader, ".vtp": vtk.vtkXMLPolyDataReader}


def asked(state):
    """Runs a state with a stand-in for paraview.simple; returns the stand-in."""
    simple = mock.MagicMock()
    package, module = ModuleType("paraview"), ModuleType("paraview.simple")
    names = ("ExtractBlock", "Clean", "WarpByVector", "Glyph", "GetActiveViewOrCreate", "PVDReader", "Show", "Hide", "ColorBy",
             "GetColorTransferFunction", "GetAnimationScene", "ResetCamera")
    for name in names:
        setattr(module, name, getattr(simple, name))
    module.__all__ = list(names)
    with mock.patch.dict(sys.modules, {"paraview": package, "paraview.simple": module}):
        exec(compile(state.read_text(), state, "exec"), {})
    return simple


def parts(collection):
    """{name: its file at the last time} of a PVD."""
    entries = list(ElementTree.parse(collection).getroot().iter("DataSet"))
    last = max(float(entry.get("timestep")) for entry in entries)
    return {entry.get("name"): collection.parent / entry.get("file") for entry in entries if float(entry.get("timestep")) == last}


def read(path):
    reader = READERS[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


class ParaView(ProgramTest):
    def state_of(self, run):
        done = subprocess.run([*ADIT, "paraview", run], capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, f"state              {run / 'fields' / 'paraview.py'}\n")
        return run / "fields" / "paraview.py"

    def coupled(self):
        return self.run_scene(CASE / "coupled.yaml", "--set", "time.duration=34 ms", "--set", "output.field_times=[20 ms]")

    def test_it_opens_what_the_run_wrote(self):
        run = self.coupled()
        simple = asked(self.state_of(run))
        opened = simple.PVDReader.call_args.kwargs["FileName"]
        self.assertEqual(opened, str((run / "fields" / "fields.pvd").resolve()))
        files, summary = parts(run / "fields" / "fields.pvd"), self.summary(run)
        shown = [call.kwargs["registrationName"] for call in simple.ExtractBlock.call_args_list]
        self.assertEqual(shown, ["grid", "particles", "bonds"])
        self.assertLessEqual(set(shown), set(files))
        self.assertEqual(read(files["grid"]).GetNumberOfCells(), summary["zones"])
        self.assertEqual(read(files["particles"]).GetNumberOfCells(), summary["particles"])
        self.assertEqual(read(files["bonds"]).GetNumberOfCells(), summary["bonds"])

    def test_colours_and_displacements_are_arrays_of_the_files_within_their_ranges(self):
        run = self.coupled()
        simple, files = asked(self.state_of(run)), parts(run / "fields" / "fields.pvd")
        self.assertEqual(simple.WarpByVector.call_count, 3)
        coloured = [call.args[1] for call in simple.ColorBy.call_args_list]
        self.assertEqual(coloured, [("POINTS", "displacement_m"), ("POINTS", "displacement_m"), ("CELLS", "normal_force_N")])
        limits = [call.args for call in simple.GetColorTransferFunction().RescaleTransferFunction.call_args_list]
        largest = {}
        for (where, array), name in zip(coloured, ("grid", "particles", "bonds")):
            data = read(files[name])
            self.assertIsNotNone(data.GetPointData().GetArray("displacement_m"), name)
            found = (data.GetPointData() if where == "POINTS" else data.GetCellData()).GetArray(array)
            self.assertIsNotNone(found, f"{name}: {array}")
            values = vtk_to_numpy(found)
            size = numpy.abs(values) if values.ndim == 1 else numpy.hypot(*values[:, :2].T)
            largest[array] = max(largest.get(array, 0), size.max())
        for (_, array), (low, high) in zip(coloured, limits):
            self.assertAlmostEqual(high / largest[array], 1, delta=1e-12)
            self.assertEqual(low, 0 if array == "displacement_m" else -high)

    def test_cells_are_shown_as_polygons_and_their_cracks_by_their_opening(self):
        run = self.run_scene(SOURCE / "cases" / "laboratory" / "compression.yaml", "--set", "time.duration=14 ms", "--set",
                             "output.field_times=[14 ms]")
        simple, files = asked(self.state_of(run)), parts(run / "fields" / "fields.pvd")
        self.assertEqual([call.kwargs["registrationName"] for call in simple.ExtractBlock.call_args_list], ["bonds", "cells", "cracks"])
        self.assertEqual(read(files["cells"]).GetNumberOfPolys(), self.summary(run)["particles"])
        cracks = read(files["cracks"])
        self.assertEqual(cracks.GetNumberOfLines(), self.summary(run)["crack_count"])
        self.assertEqual(simple.ColorBy.call_args_list[2].args[1], ("CELLS", "opening_m"))
        limits = simple.GetColorTransferFunction().RescaleTransferFunction.call_args_list[2].args
        self.assertEqual(limits, (0, vtk_to_numpy(cracks.GetCellData().GetArray("opening_m")).max()))

    def test_the_displacement_is_seen_and_not_out_of_proportion(self):
        run = self.coupled()
        namespace = {}
        exec("\n".join(line for line in self.state_of(run).read_text().splitlines() if line.startswith("SCALE")), namespace)
        tip = numpy.abs(vtk_to_numpy(read(parts(run / "fields" / "fields.pvd")["grid"]).GetPointData().GetArray("displacement_m"))).max()
        self.assertGreater(namespace["SCALE"] * tip, 0.02 * 10, "of the beam's 10 m")
        self.assertLess(namespace["SCALE"] * tip, 0.08 * 10)

    def test_a_run_without_fields_is_refused_in_one_sentence(self):
        run = self.run_scene(CASE / "coupled.yaml", "--set", "time.duration=1 ms", "--set", "output.field_times=[]")
        for piece in (run / "fields").glob("*"):
            piece.unlink()
        done = subprocess.run([*ADIT, "paraview", run], capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1))
        self.assertIn("holds no fields: ask for them by output.field_times", done.stderr)


if __name__ == "__main__":
    unittest.main()
