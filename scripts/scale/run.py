#!/usr/bin/python3
"""Measures how time and memory grow with the number of vertices of a solid, for the tables of docs/scale.md.

    scripts/scale/run.py [--energies] [--solver NAME] [--wend FILE] [--folder FOLDER] VERTICES …

A bar of 4 : 1 : 1, made of jittered cubes of six tetrahedra each, is held at one end and rotated by 90° at the other,
with a tolerance of 10⁻³. Prints a row of the table for every number of vertices (approximately), with --energies one for
every energy. Meshes and projects stay in FOLDER.
"""
import argparse
import itertools
import json
import math
import os
import pathlib
import random
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
ENERGIES = ["equia", "metr", "akvf", "conf"]
# The orders of the axes along the paths from one corner of a cube to the opposite one; each path is a tetrahedron.
PATHS = [(0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2)]


def write_bar(path, n):
    """Writes a bar of 4n by n by n cubes. Points are moved by up to 0.15 of an edge; points of a face stay in it."""
    count = (4 * n + 1, n + 1, n + 1)
    stride = (count[1] * count[2], count[2], 1)
    generator = random.Random(1)

    def coordinate(k, axis):
        return k / n if k in (0, count[axis] - 1) else (k + generator.uniform(-0.15, 0.15)) / n

    with open(path, "w") as file:
        file.write(f"MeshVersionFormatted 2\nDimension 3\nVertices\n{count[0] * count[1] * count[2]}\n")
        for place in itertools.product(*map(range, count)):
            file.write("%.9f %.9f %.9f 0\n" % tuple(coordinate(k, axis) for axis, k in enumerate(place)))
        file.write(f"Tetrahedra\n{24 * n ** 3}\n")
        for x, y, z in itertools.product(range(4 * n), range(n), range(n)):
            corner = 1 + x * stride[0] + y * stride[1] + z
            for k, (a, b, _) in enumerate(PATHS):
                cell = [corner, corner + stride[a], corner + stride[a] + stride[b], corner + sum(stride)]
                if k >= 3:
                    cell[2], cell[3] = cell[3], cell[2]
                file.write("%d %d %d %d 0\n" % tuple(cell))
        file.write("End\n")


def write_project(path, mesh, energy):
    def end(name, x):
        return {"name": name, "at": {"region": {"box": {"min": [x - 1e-6, -1, -1], "max": [x + 1e-6, 2, 2]}}}}
    turn = {"kind": "rotate", "centre": [4, 0.5, 0.5], "axis": [1, 0, 0], "angle": math.pi / 2, "time": [0, 1]}
    path.write_text(json.dumps({
        "format": "wend", "version": 1, "domain": {"mesh": mesh.name}, "material": {"phi": energy},
        "handles": [end("held", 0), end("turned", 4) | {"motion": [turn]}], "time": {"end": 1},
        "integration": {"method": "dopri5", "tolerance": 1e-3}}, indent=1))


def run(wend, project, report, solver):
    """Runs wend in a separate process and returns the exit code, CPU seconds, elapsed seconds and peak bytes."""
    start = time.monotonic()
    child = os.posix_spawn(wend, [str(wend), "run", str(project), "--quiet", "--solver", solver, "--report", str(report)], os.environ)
    _, status, usage = os.wait4(child, 0)
    return os.waitstatus_to_exitcode(status), usage.ru_utime + usage.ru_stime, time.monotonic() - start, 1024 * usage.ru_maxrss


def row(wend, folder, vertices, energy, solver):
    n = round((vertices / 4) ** (1 / 3))
    mesh, report = folder / f"bar-{n}.mesh", folder / f"bar-{n}-{energy}-{solver}.json"
    if not mesh.exists():
        write_bar(mesh, n)
    project = folder / f"bar-{n}-{energy}.wend"
    write_project(project, mesh, energy)
    code, cpu, seconds, peak = run(wend, project, report, solver)
    if code != 0:
        return f"| {vertices:,} | {energy.upper()} | {solver} | exit code {code} after {cpu:.0f} s |"
    r = json.loads(report.read_text())
    return (f"| {r['vertices']:,} | {energy.upper()} | {r['solver']} | {r['evaluations']} | {r['factorizations']} | {r['solverIterations']} | "
            f"{cpu:.1f} | {seconds:.0f} | {peak / 1e9:.2f} GB | {r['flips']} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("vertices", type=int, nargs="+")
    parser.add_argument("--energies", action="store_true", help="all four, instead of METR alone")
    parser.add_argument("--solver", default="multigrid")
    parser.add_argument("--wend", type=pathlib.Path, default=ROOT / "build/release/wend")
    parser.add_argument("--folder", type=pathlib.Path)
    options = parser.parse_args()
    print("| vertices | energy | solver | fields | set-ups | iterations | CPU seconds | seconds | peak memory | flips |\n" + "| --- " * 10 + "|")
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.folder or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for vertices in options.vertices:
            for energy in ENERGIES if options.energies else ["metr"]:
                print(row(options.wend.resolve(), folder, vertices, energy, options.solver), flush=True)


if __name__ == "__main__":
    main()
