# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reads a project in ParaView and checks that its last step equals the output of `wend run`.

Usage: pvpython in_paraview.py PLUGIN PROJECT [PICTURE]"""

import os
import subprocess
import sys
import tempfile

import numpy as np
from paraview import servermanager
from paraview.simple import *
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

plugin, project = sys.argv[1:3]
LoadPlugin(plugin, remote=False, ns=globals())
reader = WendProject(FileName=project)
reader.TimeSteps = 7
reader.UpdatePipelineInformation()
times = list(reader.TimestepValues)
assert len(times) == 7 and times[0] == 0 and times == sorted(times), times


def grid_at(time):
    reader.UpdatePipeline(time)
    return dataset_adapter.WrapDataObject(servermanager.Fetch(reader))


first, middle, last = (grid_at(times[k]) for k in (0, 3, 6))
with tempfile.TemporaryDirectory() as folder:
    name = os.path.join(folder, "end.vtu")
    subprocess.run([os.environ["WEND"], "run", project, "--quiet", "--mesh", name], check=True)
    own = vtkXMLUnstructuredGridReader()
    own.SetFileName(name)
    own.Update()
    end = dataset_adapter.WrapDataObject(own.GetOutput())
size = np.ptp(np.asarray(first.Points), axis=0).max()
assert np.abs(np.asarray(end.Points) - np.asarray(last.Points)).max() < 1e-3 * size
assert np.abs(np.asarray(middle.Points) - np.asarray(last.Points)).max() > 0.05 * size
for name in ("greatest stretch", "least stretch", "measure ratio"):
    assert np.abs(np.asarray(first.CellData[name]) - 1).max() < 1e-9, name
low, high, ratio = (np.asarray(last.CellData[name]) for name in ("least stretch", "greatest stretch", "measure ratio"))
assert (low > 0).all() and (low <= high).all() and (ratio > 0).all() and (high > 1.001).any()

# The measure ratio equals the ratio of the cell sizes that VTK computes.
sizes = CellSize(Input=reader)
sizes.UpdatePipeline(times[6])
key = "Volume" if first.GetCellType(0) == 10 else "Area"
after = np.asarray(dataset_adapter.WrapDataObject(servermanager.Fetch(sizes)).CellData[key])
sizes.UpdatePipeline(times[0])
before = np.asarray(dataset_adapter.WrapDataObject(servermanager.Fetch(sizes)).CellData[key])
assert np.abs(after / before - ratio).max() < 1e-5 * ratio.max()

if len(sys.argv) > 3:
    view = GetActiveViewOrCreate("RenderView")
    view.ViewSize = [800, 450]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.93, 0.94, 0.96]
    shown = Show(reader, view)
    shown.SetRepresentationType("Surface With Edges")
    ColorBy(shown, ("CELLS", "greatest stretch"))
    shown.SetScalarBarVisibility(view, True)
    view.ViewTime = times[6]
    Render(view)
    GetColorTransferFunction("greatest stretch").RescaleTransferFunction(1, float(high.max()))
    bar = GetScalarBar(GetColorTransferFunction("greatest stretch"), view)
    bar.TitleColor = bar.LabelColor = [0.1, 0.15, 0.2]
    view.ResetActiveCameraToNegativeY() if first.GetCellType(0) == 10 else view.ResetCamera()
    GetActiveCamera().Elevation(15)
    view.ResetCamera()
    GetActiveCamera().Zoom(1.3)
    SaveScreenshot(sys.argv[3], view)
print("ParaView shows the project")
