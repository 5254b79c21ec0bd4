#!/usr/bin/python3
"""Measures how much the result depends on the triangulation of a shape and writes docs/tessellation.md. Needs python3-scipy.

    scripts/tessellation/run.py [WEND]          (build/release/wend)

A strip of 2 by 1, held at its left end, is pulled at one vertex or at all vertices in a circle. The displacements at
fixed positions of the shape, away from the handle, are compared with those of the finest mesh, in per cent of the pull.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from scipy.interpolate import LinearNDInterpolator
from scipy.spatial import Delaunay, cKDTree

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
WEND = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/wend").resolve()
ENERGIES = ["equia", "metr", "akvf", "conf"]
WIDTH, HEIGHT, HANDLE, PULL, RADIUS = 2.0, 1.0, (1.5, 0.5), (0.1, 0.25), 0.15


def border(h):
    x, y = np.linspace(0, WIDTH, round(WIDTH / h) + 1), np.linspace(0, HEIGHT, round(HEIGHT / h) + 1)[1:-1]
    return np.vstack([[(a, b) for a in x for b in (0, HEIGHT)], [(a, b) for a in (0, WIDTH) for b in y]])


def inside(points, margin):
    low, high = margin, np.array([WIDTH, HEIGHT]) - margin
    return points[((points > low) & (points < high)).all(1)]


def hexagonal(h, stretch=1.0):
    a, b = h * stretch, h * 0.75 ** 0.5
    rows = [np.column_stack([np.arange(0, WIDTH + a, a) + (k % 2) * a / 2, np.full(len(np.arange(0, WIDTH + a, a)), y)])
            for k, y in enumerate(np.arange(b, HEIGHT, b))]
    return np.vstack(rows)


def delaunay(points):
    cells = Delaunay(points).simplices
    e = points[cells[:, 1:]] - points[cells[:, :1]]
    return points, cells[np.abs(np.linalg.det(e)) > 1e-12]


def irregular(h, random):
    """Returns a mesh of points that are evened out for some rounds, so that its angles are like those of a mesher, not of a lattice."""
    points = random.uniform((0, 0), (WIDTH, HEIGHT), (round(WIDTH * HEIGHT / h ** 2 * 1.15), 2))
    edge = border(h)
    for _ in range(30):  # Lloyd's algorithm, with the means of the triangles' centres instead of the centres of Voronoi cells
        p, cells = delaunay(np.vstack([points, edge]))
        sums, count = np.zeros_like(p), np.zeros(len(p))
        for k in range(3):
            np.add.at(sums, cells[:, k], p[cells].mean(1))
            np.add.at(count, cells[:, k], 1)
        points = sums[:len(points)] / np.maximum(count[:len(points)], 1)[:, None]
    return delaunay(np.vstack([inside(points, 0.4 * h), edge]))


def graded(h, random):
    """Returns a mesh that is three times as fine at the left as at the right."""
    u = np.vstack([irregular(h, random)[0]])
    x = u[:, 0] / WIDTH
    return delaunay(np.column_stack([WIDTH * (x + x * x) / 2, u[:, 1]]))


def grid(n, pick):
    """Returns squares that are split along the diagonal selected by pick(i, j), or into four triangles if it returns None."""
    nx, ny = 2 * n, n
    p = np.array([(WIDTH * i / nx, HEIGHT * j / ny) for j in range(ny + 1) for i in range(nx + 1)])
    at = lambda i, j: j * (nx + 1) + i
    cells, extra = [], []
    for j in range(ny):
        for i in range(nx):
            a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
            way = pick(i, j)
            if way is None:
                m = len(p) + len(extra)
                extra.append(p[[a, b, c, d]].mean(0))
                cells += [(a, b, m), (b, c, m), (c, d, m), (d, a, m)]
            else:
                cells += [(a, b, c), (a, c, d)] if way else [(a, b, d), (b, c, d)]
    return np.vstack([p, *([extra] if extra else [])]), np.array(cells)


def obtuse(h):
    """Returns rows of flat triangles with angles of 110 degrees at their tips; half triangles close the rows."""
    a = 1.75 * h
    nx, ny = round(WIDTH / a), round(HEIGHT / (0.35 * a) / 4) * 4
    rows = []
    for j in range(ny + 1):
        x = np.linspace(0, WIDTH, nx + 1) if j % 2 == 0 else np.concatenate([[0], (np.arange(nx) + 0.5) * WIDTH / nx, [WIDTH]])
        rows.append(np.column_stack([x, np.full(len(x), HEIGHT * j / ny)]))
    start = np.cumsum([0] + [len(r) for r in rows])
    cells = []
    for j in range(ny):
        even, odd = (j, j + 1) if j % 2 == 0 else (j + 1, j)
        for i in range(nx + 1):
            cells.append((start[even] + i, start[odd] + i, start[odd] + i + 1))
        for i in range(nx):
            cells.append((start[even] + i, start[even] + i + 1, start[odd] + i + 1))
    return np.vstack(rows), np.array(cells)


def tessellations():
    random = np.random.default_rng(1)
    h = 0.0205
    n = 48
    return {
        "Delaunay, 20k": irregular(h / 2, random),
        "Delaunay, 5k": irregular(h, random),
        "Delaunay, 1.3k": irregular(2 * h, random),
        "graded 1:3": graded(h, random),
        "stretched 2:1": delaunay(np.vstack([inside(hexagonal(h / 1.4, 2), 0.5 * h), border(h)])),
        "one diagonal": grid(n, lambda i, j: True),
        "alternating": grid(n, lambda i, j: (i + j) % 2 == 0),
        "criss-cross": grid(round(n / 2 ** 0.5), lambda i, j: None),
        "all obtuse": obtuse(h),
    }


def with_vertex(points, cells):
    """Returns the mesh with the vertex nearest to HANDLE moved there, which changes a mesh that was not made for it."""
    off, at = cKDTree(points).query(HANDLE)
    if off < 1e-12:
        return points, cells
    moved = points.copy()
    moved[at] = HANDLE
    return delaunay(moved)


def pose(points, cells, energy, kind, folder, name):
    at = cKDTree(points).query(HANDLE)[1]
    place = {"vertices": [int(at)]} if kind == "vertex" else {"region": {"circle": {"centre": HANDLE, "radius": RADIUS}}}
    held = np.flatnonzero(points[:, 0] < 1e-9).tolist()
    e = points[cells[:, 1:]] - points[cells[:, :1]]
    cells = np.where((np.linalg.det(e) < 0)[:, None], cells[:, [0, 2, 1]], cells)
    base = folder / f"{name}-{energy}-{kind}".replace(" ", "_").replace(",", "").replace(":", "").replace(".", "")
    base.with_suffix(".obj").write_text("".join(f"v {x:.17g} {y:.17g} 0\n" for x, y in points) +
                                        "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in cells))
    project = {"format": "wend", "version": 1, "domain": {"mesh": base.name + ".obj"}, "material": {"phi": energy},
               "handles": [{"name": "held", "at": {"vertices": held}},
                           {"name": "pulled", "at": place, "motion": [{"kind": "translate", "by": PULL, "time": [0, 1]}]}],
               "time": {"end": 1}}
    base.with_suffix(".wend").write_text(json.dumps(project))
    out = folder / (base.name + "-end.obj")
    subprocess.run([WEND, "run", base.with_suffix(".wend"), "--quiet", "--threads", "1", "--backend", "cpu", "--mesh", out], check=True)
    end = np.array([line.split()[1:3] for line in out.read_text().splitlines() if line.startswith("v ")], float)
    return end - points


def main():
    meshes = {name: with_vertex(*mesh) for name, mesh in tessellations().items()}
    places = np.random.default_rng(2).uniform((0.02, 0.02), (WIDTH - 0.02, HEIGHT - 0.02), (4000, 2))
    places = places[np.linalg.norm(places - HANDLE, axis=1) > RADIUS + 0.1]
    jobs = [(kind, energy, name) for kind in ("vertex", "circle") for energy in ENERGIES for name in meshes]
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        def moved(job):
            kind, energy, name = job
            points, cells = meshes[name]
            d = pose(points, cells, energy, kind, pathlib.Path(folder), name)
            return LinearNDInterpolator(points, d)(places)
        fields = dict(zip(jobs, pool.map(moved, jobs)))
    first, *others = meshes
    lines = []
    for kind in ("vertex", "circle"):
        lines += [f"\n### Pulled at {'one vertex' if kind == 'vertex' else 'all vertices in a circle'}", "| mesh | vertices | " +
                  " | ".join(e.upper() for e in ENERGIES) + " |", "| --- | --- |" + " --- |" * len(ENERGIES)]
        for name in others:
            off = [np.nanmax(np.linalg.norm(fields[kind, e, name] - fields[kind, e, first], axis=1)) / np.linalg.norm(PULL) for e in ENERGIES]
            lines.append(f"| {name} | {len(meshes[name][0]):,} | " + " | ".join(f"{100 * x:.1f} %" for x in off) + " |")
            print(lines[-1], flush=True)
    page = (pathlib.Path(__file__).resolve().parent / "page.md").read_text()
    (ROOT / "docs/tessellation.md").write_text(page.replace("@TABLES@", "\n".join(lines).strip()).replace("@VERTICES@", f"{len(meshes[first][0]):,}"))


if __name__ == "__main__":
    main()
