# SPDX-License-Identifier: AGPL-3.0-or-later
# Outputs the requested time step. ParaView defines `self`, FileName and TimeSteps.
import glob, os, subprocess, sys, tempfile, types
import numpy as np
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

def computed(name, count):
    """Returns the folder of the computed steps, which are reused until the project changes or ParaView ends."""
    runs = sys.modules.setdefault("wend_project_runs", types.ModuleType("wend_project_runs")).__dict__
    key = "%s %d %d" % (name, os.stat(name).st_mtime_ns, count)
    if key not in runs:
        folder = tempfile.TemporaryDirectory()
        done = subprocess.run([os.environ.get("WEND", "wend"), "run", name, "--quiet", "--count", str(count), "--frames",
                               os.path.join(folder.name, "at_####.vtu")], capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(done.stderr.strip())
        runs[key] = folder
    return runs[key].name

executive, info = self.GetExecutive(), self.GetExecutive().GetOutputInformation(0)
times = info.Get(executive.TIME_STEPS())
asked = info.Get(executive.UPDATE_TIME_STEP()) if info.Has(executive.UPDATE_TIME_STEP()) else 0.0
step = int(np.argmin(np.abs(np.subtract(times, asked))))
steps = sorted(glob.glob(os.path.join(computed(FileName, TimeSteps), "at_*.vtu")))
reader = vtkXMLUnstructuredGridReader()
reader.SetFileName(steps[step])
reader.Update()
grid = reader.GetOutput()
self.GetUnstructuredGridOutput().ShallowCopy(grid)
cells = dataset_adapter.WrapDataObject(self.GetUnstructuredGridOutput()).CellData
if "F" in cells.keys():
    # The singular values of the deformation gradient are the stretches along its principal axes.
    gradients = np.asarray(cells["F"]).reshape(grid.GetNumberOfCells(), 3, 3)
    stretches = np.linalg.svd(gradients, compute_uv=False)
    cells.append(stretches[:, 0], "greatest stretch")
    cells.append(stretches[:, -1], "least stretch")
    cells.append(np.linalg.det(gradients), "measure ratio")
