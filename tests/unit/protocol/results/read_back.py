"""Prints what VTK reads from a file: names, sizes, and every value as its 64 bits in hexadecimal."""
import sys
from pathlib import Path
from xml.etree import ElementTree

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader


def show(label, array):
    values = vtk_to_numpy(array)
    bits = values.astype(values.dtype.newbyteorder("<")).view("<u8").ravel()
    print(label, array.GetNumberOfComponents(), *(f"{int(b):016x}" for b in bits))


def show_fields(label, data):
    for i in range(data.GetNumberOfArrays()):
        show(f"{label} {data.GetArrayName(i)}", data.GetArray(i))


def show_dataset(dataset):
    show("points", dataset.GetPoints().GetData())
    show_fields("point_field", dataset.GetPointData())
    show_fields("cell_field", dataset.GetCellData())
    for i in range(dataset.GetNumberOfCells()):
        cell = dataset.GetCell(i)
        print("cell", cell.GetCellType(), *(cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())))


def read(path):
    reader = vtkXMLPolyDataReader() if path.suffix == ".vtp" else vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def show_collection(path):
    """ParaView, not VTK, reads a PVD: its attributes, and what VTK finds in the files that it names."""
    for entry in ElementTree.parse(path).getroot().iter("DataSet"):
        cells = read(path.parent / entry.get("file")).GetNumberOfCells()
        print("time", entry.get("timestep"), "part", entry.get("part"), entry.get("name"), cells, "cells")


file = Path(sys.argv[1])
show_collection(file) if file.suffix == ".pvd" else show_dataset(read(file))
