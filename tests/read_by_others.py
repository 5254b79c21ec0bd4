#!/usr/bin/python3
"""Checks that other programs read the files that Wend writes: every mesh format, version and encoding, with and without
values and border, for a mesh in the plane, tetrahedra and a filled surface.

Compares points, cells, values and groups. Then converts a vocabulary of cells and groups between every pair of formats.
Needs meshio, VTK, h5py, netCDF4 and gmsh (Debian: python3-meshio python3-vtk9 python3-h5py python3-netcdf4 gmsh); not
part of ./test.

    tests/read_by_others.py [WEND]        (build/release/wend)

Prints one line for each file and exits with 1 if anything differs.
"""
import contextlib
import io
import itertools
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

import meshio
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

ROOT = pathlib.Path(__file__).resolve().parent.parent
WEND = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/wend").resolve()
CORNERS = {3: "triangle", 4: "tetra"}
failures = 0


class Mesh:
    """Points, cells by their number of corners, and values by name: of points, and of cells by corners."""

    def __init__(self, points, cells, point_data, cell_data, groups=None):
        self.points = np.asarray(points, float)
        self.cells, self.point_data, self.cell_data = cells, point_data, cell_data
        self.groups = groups  # corners → list of names, one per cell; None if the format has no groups


def rows(values, count):
    return np.asarray(values, float).reshape(count, -1)


def truth(path):
    """Returns the mesh of a .vtu in text, read as plain XML."""
    arrays = {"Points": {}, "Cells": {}, "PointData": {}, "CellData": {}}
    for part in xml.parse(path).getroot().iter():
        if part.tag in arrays:
            for array in part.iter("DataArray"):
                arrays[part.tag][array.get("Name")] = np.array((array.text or "").split(), float)
    points = rows(arrays["Points"]["Points"], len(arrays["Points"]["Points"]) // 3)
    ends = arrays["Cells"]["offsets"].astype(int)
    starts = np.concatenate([[0], ends[:-1]])
    corners = ends - starts
    connectivity = arrays["Cells"]["connectivity"].astype(int)
    cells, data = {}, {}
    for n in CORNERS:
        of = np.flatnonzero(corners == n)
        if len(of):
            cells[n] = np.array([connectivity[starts[c]:ends[c]] for c in of])
            data[n] = {name: rows(v, len(ends))[of] for name, v in arrays["CellData"].items()}
    return Mesh(points, cells, {n: rows(v, len(points)) for n, v in arrays["PointData"].items()}, data)


def by_meshio(path):
    with contextlib.redirect_stdout(io.StringIO()) as said, contextlib.redirect_stderr(said):
        mesh = meshio.read(path, "avsucd" if path.suffix == ".avs" else None)
    assert not said.getvalue().strip(), said.getvalue()
    names = {(tag, dim): name for name, (tag, dim) in mesh.field_data.items()}
    cells, data, groups = {}, {}, {}
    for k, block in enumerate(mesh.cells):
        n = {name: n for n, name in CORNERS.items()}[block.type]
        corners = block.data[:, [0, 1, 3, 2]] if n == 4 and path.suffix == ".avs" else block.data  # VTK's order
        cells.setdefault(n, []).append(corners)
        of = data.setdefault(n, {})
        for name, values in mesh.cell_data.items():
            of.setdefault(name, []).append(rows(values[k], len(block.data)))
        if "gmsh:physical" in mesh.cell_data:
            groups.setdefault(n, []).extend(names.get((tag, n - 1)) for tag in mesh.cell_data["gmsh:physical"][k])
    return Mesh(mesh.points, {n: np.concatenate(b) for n, b in cells.items()},
                {name: rows(v, len(mesh.points)) for name, v in mesh.point_data.items()},
                {n: {name: np.concatenate(v) for name, v in of.items()} for n, of in data.items()}, groups or None)


VTK_READERS = {".vtu": vtk.vtkXMLUnstructuredGridReader, ".vtk": vtk.vtkUnstructuredGridReader,
               ".avs": vtk.vtkAVSucdReader}


def by_vtk(path):
    reader = VTK_READERS[path.suffix]()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("error"))
    reader.SetFileName(str(path))
    if path.suffix == ".vtk":
        reader.ReadAllFieldsOn()
    reader.Update()
    assert not errors, "VTK reports an error"
    grid = reader.GetOutput()
    types = vtk_to_numpy(grid.GetCellTypesArray())
    offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    connectivity = vtk_to_numpy(grid.GetCells().GetConnectivityArray())

    def arrays(of, count):
        return {of.GetArrayName(i): rows(vtk_to_numpy(of.GetArray(i)), count) for i in range(of.GetNumberOfArrays())}

    points = vtk_to_numpy(grid.GetPoints().GetData())
    values = arrays(grid.GetCellData(), len(types))
    cells, data = {}, {}
    for n, kind in ((3, vtk.VTK_TRIANGLE), (4, vtk.VTK_TETRA)):
        of = np.flatnonzero(types == kind)
        if len(of):
            cells[n] = np.array([connectivity[offsets[c]:offsets[c + 1]] for c in of])
            data[n] = {name: v[of] for name, v in values.items()}
    return Mesh(points, cells, arrays(grid.GetPointData(), len(points)), data)


def by_gmsh(path):
    """Returns the mesh that meshio reads from a copy of the file that Gmsh has read and written again."""
    copy = path.with_name(path.stem + "-gmsh.msh")
    done = subprocess.run(["gmsh", str(path), "-save", "-format", "msh41", "-o", str(copy)],
                          capture_output=True, text=True)
    said = done.stdout + done.stderr
    assert done.returncode == 0 and "Error" not in said and "Warning" not in said, said
    mesh = by_meshio(copy)
    mesh.point_data, mesh.cell_data = {}, {n: {} for n in mesh.cells}  # Gmsh writes values to other files
    return mesh


def same(a, b, what, tolerance=0):
    assert a.shape == b.shape, f"{what}: {a.shape} instead of {b.shape}"
    assert np.allclose(a, b, rtol=tolerance, atol=tolerance, equal_nan=True), f"{what} differs"


def widened(values):
    """Returns planar vectors and matrices padded with zeros to three dimensions, as Gmsh draws them."""
    n = values.shape[1]
    if n == 4:
        values = np.pad(values.reshape(-1, 2, 2), ((0, 0), (0, 1), (0, 1))).reshape(-1, 9)
    return np.pad(values, ((0, 0), (0, 1))) if n == 2 else values


def sorted_mesh(mesh):
    order = np.lexsort(mesh.points.T)
    number = np.argsort(order)
    cells = {n: number[c] for n, c in mesh.cells.items()}
    return Mesh(mesh.points[order], {n: c[np.lexsort(c.T)] for n, c in cells.items()}, mesh.point_data,
                mesh.cell_data, mesh.groups)


def compare(found, wanted, values, border, groups, reader, rounding=0):
    if reader is by_gmsh:  # Gmsh orders points and cells by their entities
        found, wanted = sorted_mesh(found), sorted_mesh(wanted)
    same(found.points, wanted.points, "points", 1e-15 if reader is by_gmsh else rounding)
    kinds = [n for n in wanted.cells if border or n == max(wanted.cells)]
    assert sorted(found.cells) == sorted(kinds), f"cells of {sorted(found.cells)} corners instead of {sorted(kinds)}"
    for n in kinds:
        same(found.cells[n], wanted.cells[n], f"cells of {n} corners")
        if values:
            for name, v in wanted.cell_data[n].items():
                if name == "label":
                    continue
                got = found.cell_data[n].get(name)
                assert got is not None, f"the field {name} is missing"
                same(got, widened(v) if got.shape != v.shape else v, f"{name} on cells of {n} corners", rounding)
        if groups and found.groups is not None:
            assert set(found.groups[n]) == groups[n], f"groups {set(found.groups[n])} of cells of {n} corners"
            assert len(found.groups[n]) == len(found.cells[n]), "a cell without a group"
    if values:
        for name, v in wanted.point_data.items():
            if name == "uv":
                continue
            got = found.point_data.get(name)
            assert got is not None, f"the field {name} is missing"
            same(got, v, name, rounding)


def run(folder, project, *options):
    done = subprocess.run([WEND, "run", project, "--quiet", "--backend", "cpu", *map(str, options)], cwd=folder,
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def check(folder, project, wanted, options, file, readers, **what):
    global failures
    label = f"{project:14} {' '.join(options):44}"
    try:
        run(folder, project, "--mesh", file, *options)
    except AssertionError as error:
        failures += 1
        return print(f"{label} NOT WRITTEN: {error}")
    for reader in readers:
        result = "ok"
        try:
            compare(reader(folder / file), wanted, values=what["values"] and reader is not by_gmsh,
                    border=what["border"], groups=what["groups"] if file.endswith(".msh") else None, reader=reader,
                    # VTK reads .avs in single precision; Abaqus numbers have at most 20 characters.
                    rounding=4e-7 if reader is by_vtk and file.endswith(".avs") else 1e-14 if file.endswith(".inp") else 0)
        except Exception as error:  # readers may raise any exception
            failures += 1
            result = f"FAILED: {str(error).strip()[:300]}"
        print(f"{label} {file:7} {reader.__name__[3:]:7} {result}")


def grid(folder):
    """Writes a jittered strip of triangles, a block of tetrahedra, and the surface of the block in two materials."""
    random = np.random.default_rng(5)
    n = 6
    flat = np.array([(i, j, 0) for j in range(3) for i in range(n)], float)
    flat[:, :2] += random.uniform(-0.2, 0.2, (len(flat), 2))
    squares = [(j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i) for j in range(2) for i in range(n - 1)]
    triangles = np.array([t for a, b, c, d in squares for t in ((a, b, c), (a, c, d))])
    meshio.write_points_cells(folder / "flat.obj", flat, [("triangle", triangles)])

    block = np.array([(i, j, k) for k in range(3) for j in range(3) for i in range(n)], float)
    block += random.uniform(-0.15, 0.15, block.shape)
    at = lambda p: (p[2] * 3 + p[1]) * n + p[0]
    tetrahedra = []
    for box in itertools.product(range(n - 1), range(2), range(2)):
        for order in itertools.permutations(range(3)):
            corner = list(box)
            cell = [at(corner)]
            for axis in order:
                corner[axis] += 1
                cell.append(at(corner))
            a, b, c, d = block[cell]
            if np.linalg.det([b - a, c - a, d - a]) < 0:
                cell[2], cell[3] = cell[3], cell[2]
            tetrahedra.append(cell)
    meshio.write(folder / "block.vtu", meshio.Mesh(block, [("tetra", np.array(tetrahedra))]))
    faces = {}
    for cell in tetrahedra:
        for out in ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)):
            face = tuple(cell[k] for k in out)
            faces.setdefault(tuple(sorted(face)), []).append(face)
    outer = [faces[f][0] for f in sorted(faces) if len(faces[f]) == 1]
    lines = ["v %.17g %.17g %.17g" % tuple(p) for p in block]
    for name, part in (("iron", outer[: len(outer) // 2]), ("wood", outer[len(outer) // 2:])):
        lines += [f"usemtl {name}"] + ["f %d %d %d" % tuple(v + 1 for v in f) for f in part]
    (folder / "block.obj").write_text("\n".join(lines) + "\n")


def project(folder, name, domain, ends, region, move):
    text = {"format": "wend", "version": 1, "domain": domain,
            "material": {"regions": [{"shape": region, "phi": 1.2,
                                      "stiffness": {"axis": [1] + [0] * (len(move) - 1), "ratio": 5}}]},
            "handles": [{"at": {"region": ends[0]}},
                        {"at": {"region": ends[1]}, "motion": [{"kind": "translate", "by": move}]}]}
    (folder / name).write_text(json.dumps(text))


def mixed(folder):
    """Writes two hexahedra, two wedges and a pyramid in a row, with a quadrilateral, a line and numbers, by meshio, and a
    project of them."""
    points = np.array([[x, y, z] for x in range(4) for z in (0, 1) for y in (0, 1)] + [[3.7, 0.5, 0.5]], float)
    at = lambda x, y, z: 4 * x + 2 * z + y
    box = [at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)]
    prism = lambda a, b, c: [at(a[0], y, a[1]) if k == 0 else at(b[0], y, b[1]) if k == 1 else at(c[0], y, c[1])
                             for y in (1, 0) for k in range(3)]
    cells = [("hexahedron", np.array([box, [v + 4 for v in box]])),
             ("wedge", np.array([prism((2, 0), (3, 0), (3, 1)), prism((2, 0), (3, 1), (2, 1))])),
             ("pyramid", np.array([[at(3, 0, 0), at(3, 1, 0), at(3, 1, 1), at(3, 0, 1), 16]])),
             ("quad", np.array([[at(0, 0, 0), at(0, 1, 0), at(0, 1, 1), at(0, 0, 1)]])),
             ("line", np.array([[at(0, 0, 0), at(1, 0, 0)]]))]
    numbers = [np.array([11, 12]), np.array([12, 12]), np.array([11]), np.array([21]), np.array([31])]
    meshio.Mesh(points, cells, cell_data={"physical": numbers}).write(folder / "mixed.vtu", binary=False)
    box = lambda low, high: {"region": {"box": {"min": [low, -1, -1], "max": [high, 2, 2]}}}
    (folder / "mixed.wend").write_text(json.dumps(
        {"format": "wend", "version": 1, "domain": {"mesh": "mixed.vtu"},
         "handles": [{"at": {"group": "21"}},
                     {"at": box(2.9, 4), "motion": [{"kind": "rotate", "centre": [3, 0.5, 0.5], "axis": [1, 0, 0],
                                                     "angle": 0.4}]}]}))


def by_kinds(path):
    """Returns the points that meshio reads and, for each kind of cell, the nodes and the number of each cell, or -1 if
    there are no numbers."""
    with contextlib.redirect_stdout(io.StringIO()):
        mesh = meshio.read(path, "avsucd" if path.suffix == ".avs" else None)
    names = {".msh": "gmsh:physical", ".mesh": "medit:ref", ".avs": "avsucd:material", ".bdf": "nastran:ref"}
    name = names.get(path.suffix, "physical")
    kinds = {}
    for k, block in enumerate(mesh.cells):
        number = mesh.cell_data[name][k] if name in mesh.cell_data else np.full(len(block.data), -1)
        kinds.setdefault(block.type, []).append((block.data, np.ravel(number)))
    return mesh.points, {kind: (np.concatenate([a for a, _ in all]), np.concatenate([b for _, b in all]))
                         for kind, all in kinds.items()}


def whole(folder):
    """Checks that cells of every kind are written as they were read, in every format."""
    global failures
    mixed(folder)
    run(folder, "mixed.wend", "--mesh", "truth.vtu", "--fields", "none")
    points, kinds = by_kinds(folder / "truth.vtu")
    came = by_kinds(folder / "mixed.vtu")[1]
    # The list lacks .inp, because this meshio cannot read Abaqus pyramids.
    for file, options in (("b.vtu", []), ("b.vtu", ["--encoding", "binary"]), ("b.vtk", []), ("b.vtk", ["--encoding", "binary"]),
                          ("b.msh", []), ("b.msh", ["--encoding", "binary"]), ("b.msh", ["--msh", "2.2"]),
                          ("b.msh", ["--msh", "2.2", "--encoding", "binary"]), ("b.mesh", []), ("b.bdf", [])):
        label = f"{'mixed.wend':14} {' '.join(options):44} {file:7} meshio "
        try:
            run(folder, "mixed.wend", "--mesh", file, "--fields", "none", *options)
            got_points, got = by_kinds(folder / file)
            same(got_points, points, "points", 1e-13)
            assert sorted(got) == sorted(came), f"cells {sorted(got)} instead of {sorted(came)}"
            for kind, (nodes, numbers) in came.items():
                same(got[kind][0], nodes, kind)
                if (got[kind][1] != -1).all():
                    same(got[kind][1], numbers, f"numbers of {kind}")
            print(label, "ok")
        except Exception as error:  # readers may raise any exception
            failures += 1
            print(label, f"FAILED: {str(error).strip()[:300]}")


VOCABULARY = """$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
4
3 11 "steel core"
3 12 "rubber part"
2 21 "fixed end"
1 31 "wall"
$EndPhysicalNames
"""
# The contents that each format can hold: s solids, h solids other than tetrahedra, q quadrilaterals, l lines, n names of groups.
TARGETS = {".msh": "shqln", ".inp": "shqln", ".med": "shqln", ".cgns": "shqln", ".exo": "shqln", ".xdmf": "shqln",
           ".bdf": "shql", ".mesh": "shql", ".avs": "shql", ".vtu": "shql", ".vtk": "shql", ".node": "sl",
           ".vtp": "ql", ".ply": "ql", ".off": "ql", ".obj": "qln", ".stl": "n"}


def vocabulary(folder, solid):
    """Writes two hexahedra, two wedges and a pyramid with a quadrilateral and a line, in named groups, or, unless
    `solid`, the faces of one of these hexahedra with a line."""
    points = [(x, y, z) for x in range(4) for z in (0, 1) for y in (0, 1)] + [(3.7, 0.5, 0.5)]
    at = lambda x, y, z: 4 * x + 2 * z + y
    box = [at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)]
    prism = lambda a, b, c: [at(*p[:1], y, p[1]) for y in (1, 0) for p in (a, b, c)]
    if solid:
        cells = [(5, 11, box), (5, 12, [v + 4 for v in box]), (6, 12, prism((2, 0), (3, 0), (3, 1))),
                 (6, 12, prism((2, 0), (3, 1), (2, 1))), (7, 11, [at(3, 0, 0), at(3, 1, 0), at(3, 1, 1), at(3, 0, 1), 16]),
                 (3, 21, [at(0, 0, 0), at(0, 1, 0), at(0, 1, 1), at(0, 0, 1)]), (1, 31, [at(0, 0, 0), at(1, 0, 0)])]
    else:
        points = points[:8]
        faces = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6))
        cells = [(3, 21, [box[k] for k in face]) for face in faces] + \
                [(2, 21, [box[3], box[0], box[4]]), (2, 21, [box[3], box[4], box[7]]), (1, 31, [box[0], box[1]])]
    text = VOCABULARY + f"$Nodes\n{len(points)}\n" + "".join(
        f"{k + 1} {x} {y} {z}\n" for k, (x, y, z) in enumerate(points)) + f"$EndNodes\n$Elements\n{len(cells)}\n"
    for k, (kind, tag, nodes) in enumerate(cells):
        text += f"{k + 1} {kind} 2 {tag} {tag} " + " ".join(str(v + 1) for v in nodes) + "\n"
    (folder / "vocabulary.msh").write_text(text + "$EndElements\n")


def places(points, nodes):
    return frozenset(tuple(np.round(points[v], 6)) for v in nodes)


def found_by_vtk(path):
    """Returns all cells of a file as sets of the positions of their corners, and the names of its groups, or None if VTK
    does not report them."""
    reader = {".cgns": vtk.vtkCGNSReader, ".exo": vtk.vtkExodusIIReader, ".vtp": vtk.vtkXMLPolyDataReader,
              ".obj": vtk.vtkOBJReader, ".ply": vtk.vtkPLYReader, **VTK_READERS}[path.suffix]()
    errors, names, grids = [], None, []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("error"))
    reader.SetFileName(str(path))
    if path.suffix == ".cgns":
        reader.UpdateInformation()
        reader.SetLoadBndPatch(True)
    if path.suffix == ".exo":
        reader.UpdateInformation()
        for kind in (reader.ELEM_BLOCK, reader.SIDE_SET):
            for k in range(reader.GetNumberOfObjects(kind)):
                reader.SetObjectStatus(kind, k, 1)
        names = {reader.GetObjectName(kind, k).split(" ID:")[0].removeprefix("Unnamed block").strip()
                 for kind in (reader.ELEM_BLOCK, reader.SIDE_SET) for k in range(reader.GetNumberOfObjects(kind))}
    reader.Update()
    # In CGNS files VTK takes lines beside solid cells for solid cells, and complains that they have no values.
    assert not errors or path.suffix == ".cgns", "VTK reports an error"
    output = reader.GetOutputDataObject(0)
    if output.IsA("vtkMultiBlockDataSet"):
        walk = output.NewIterator()
        walk.InitTraversal()
        while not walk.IsDoneWithTraversal():
            grids.append(walk.GetCurrentDataObject())
            walk.GoToNextItem()
    else:
        grids = [output]
    cells = set()
    for grid in grids:
        for c in range(grid.GetNumberOfCells()):
            ids = grid.GetCell(c).GetPointIds()
            nodes = [ids.GetId(k) for k in range(ids.GetNumberOfIds())]
            cells.add(frozenset(tuple(np.round(grid.GetPoint(v), 6)) for v in nodes))
    return cells, names


def found_by_meshio(path):
    if path.suffix == ".inp":  # this meshio cannot read Abaqus pyramids; they are replaced by lines, which are ignored
        blocks = path.read_text().split("*ELEMENT, ")
        path.write_text("*ELEMENT, ".join(
            block if not block.startswith("TYPE=C3D5") else "TYPE=T3D2\n" + re.sub(r"(?m)^(\d+, \d+, \d+),.*$", r"\1", block.split("\n", 1)[1])
            for block in blocks))
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        mesh = meshio.read(path)
    names = None
    if path.suffix == ".msh":
        names = set(mesh.field_data)
    if path.suffix == ".xdmf":
        names = set(mesh.field_data)
    if path.suffix == ".med":
        names = {name for all in mesh.cell_tags.values() for name in all}
    if path.suffix == ".inp":
        names = {name.strip('"') for name in mesh.cell_sets}
    return {places(mesh.points, nodes) for block in mesh.cells for nodes in block.data}, names


def found(path):
    if path.suffix in (".vtu", ".vtk", ".vtp", ".avs", ".cgns", ".exo", ".obj", ".ply"):
        return found_by_vtk(path)
    if path.suffix == ".off":  # few programs read polygons other than triangles
        lines = [line.split() for line in path.read_text().splitlines() if line.strip()]
        count = int(lines[1][0])
        points = np.array(lines[2:2 + count], float)
        return {places(points, map(int, line[1:1 + int(line[0])])) for line in lines[2 + count:]}, None
    return found_by_meshio(path)


def matrix(folder, solid):
    """Converts every format into every other and checks that the cells that both hold, and the names of groups, are kept."""
    global failures
    vocabulary(folder, solid)
    done = subprocess.run([WEND, "convert", "vocabulary.msh", "a.vtu"], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    everything, _ = found_by_vtk(folder / "a.vtu")
    kinds = {"line": lambda c: len(c) == 2, "quad": lambda c: len(c) == 4 and len({p[0] for p in c}) == 1,
             "solid": lambda c: len(c) > 4}
    formats = [f for f, holds in TARGETS.items() if ("s" in holds) == solid or not solid and f != ".node"]
    print(f"\n{'cells of space' if solid else 'a surface'}: rows are read, columns written")
    print(" " * 7 + "".join(f"{f:>7}" for f in formats))
    for source in formats:
        row = f"{source:7}"
        first = subprocess.run([WEND, "convert", "vocabulary.msh", "from" + source], cwd=folder, capture_output=True, text=True)
        for target in formats:
            result = "ok"
            try:
                assert first.returncode == 0, first.stderr
                done = subprocess.run([WEND, "convert", "from" + source, "to" + target], cwd=folder, capture_output=True, text=True)
                assert done.returncode == 0, done.stderr
                cells, names = found(folder / ("to" + (".ele" if target == ".node" else target)))
                holds = set(TARGETS[source]) & set(TARGETS[target])
                for cell in everything:
                    whole = ("l" in holds if len(cell) == 2 else len(cell) == 3 or "q" in holds and (len(cell) == 4 or "h" in holds))
                    if target == ".inp" and len(cell) == 5:  # this meshio cannot read Abaqus pyramids
                        continue
                    if target in (".cgns", ".ply") and len(cell) == 2:  # VTK reads no lines in these formats
                        continue
                    if whole and target != ".node":
                        assert cell in cells, f"a cell of {len(cell)} nodes is missing"
                if "n" in holds and names is not None:
                    wanted = {"steel core", "rubber part", "fixed end", "wall"} if solid else {"fixed end"} | ({"wall"} if "l" in holds else set())
                    wanted = {n.replace(" ", "_") for n in wanted} if ".obj" in (source, target) else wanted
                    assert wanted <= names, f"names {sorted(names)}"
            except (Exception, SystemExit) as error:  # meshio may exit the program
                failures += 1
                result = "FAILED"
                print(f"{source} to {target}: {str(error).strip()[:200]}", file=sys.stderr)
            row += f"{result:>7}"
        print(row)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        grid(folder)
        ball = lambda x: {"sphere": {"centre": [x, 1, 1], "radius": 1.2}}
        disc = lambda x: {"circle": {"centre": [x, 1], "radius": 1.2}}
        project(folder, "flat.wend", {"mesh": "flat.obj"}, (disc(0), disc(5)),
                {"circle": {"centre": [2.5, 1], "radius": 1}}, [0.5, 1])
        for kind, domain in (("block", {"mesh": "block.vtu"}), ("filled", {"surface": "block.obj", "vertices": 150})):
            project(folder, f"{kind}.wend", domain, (ball(0), ball(5)),
                    {"sphere": {"centre": [2.5, 1, 1], "radius": 1}}, [0.5, 1, 0.3])
        groups = {"flat.wend": {3: {"surface"}}, "block.wend": {3: {"boundary"}, 4: {"volume"}},
                  "filled.wend": {3: {"iron", "wood"}, 4: {"volume"}}}
        for which, values, asked in itertools.product(groups, (True, False), (True, False)):
            if which == "flat.wend" and asked:
                continue
            options = (["--border"] if asked else []) + ([] if values else ["--fields", "none"])
            run(folder, which, "--mesh", "truth.vtu", "--border")
            wanted = truth(folder / "truth.vtu")
            flat, made = which == "flat.wend", which == "filled.wend"
            what = {"values": values, "groups": groups[which]}
            for encoding in ("text", "binary", "compressed"):
                code = ["--encoding", encoding]
                check(folder, which, wanted, options + code, "a.vtu", [by_vtk, by_meshio], border=asked or flat, **what)
                if encoding == "compressed":
                    continue
                check(folder, which, wanted, options + code, "a.vtk", [by_vtk], border=asked or flat, **what)
                for version in ("4.1", "2.2"):
                    two_kinds = values and version == "2.2"  # this meshio reads no values of two kinds of cells
                    readers = [by_gmsh] if two_kinds and asked else [by_meshio, by_gmsh]
                    check(folder, which, wanted, options + code + ["--msh", version], "a.msh", readers,
                          border=asked or flat or (made and not two_kinds), **what)
            # This meshio reads no values of files with two kinds of cells.
            check(folder, which, wanted, options, "a.avs", [by_vtk] if asked else [by_vtk, by_meshio],
                  border=asked or flat, **what)
            what["values"] = False  # the next formats have none
            check(folder, which, wanted, options, "a.mesh", [by_meshio], border=asked or flat or made, **what)
            check(folder, which, wanted, options, "a.inp", [by_meshio], border=asked or flat or made, **what)
        whole(folder)
        matrix(folder, True)
        matrix(folder, False)
    print("all read as written" if failures == 0 else f"{failures} FAILED")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
