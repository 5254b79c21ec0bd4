#!/usr/bin/env python3
"""Draws the pictures of the tooltips (resources/tips/*.svg) with the program itself: grids that are held and pulled.

Usage: tip_pictures.py [WEND]   WEND: the program, by default the one on PATH.

The drawings have three tones, which the window replaces by those of its palette: #000000 (ink), #808080 (minor lines) and
#4a5bd4 (highlights).
"""
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

OUT = pathlib.Path(__file__).resolve().parent.parent / "resources" / "tips"
SCALE = 40.0  # pixels of a drawing per unit of the scene


class Grid:
    """A rectangle from (0, 0) to (width, height) with `cells` squares per unit."""

    def __init__(self, width, height, cells):
        self.columns, self.rows = width * cells + 1, height * cells + 1
        self.points = [(i / cells, j / cells) for j in range(self.rows) for i in range(self.columns)]

    def at(self, i, j):
        return j * self.columns + i

    def write(self, path):
        lines = [f"v {x} {y} 0" for x, y in self.points]
        for j in range(self.rows - 1):
            for i in range(self.columns - 1):
                a, b, c, d = (self.at(i, j), self.at(i + 1, j), self.at(i + 1, j + 1), self.at(i, j + 1))
                cells = ((a, b, c), (a, c, d)) if (i + j) % 2 else ((a, b, d), (b, c, d))
                lines += ["f " + " ".join(str(v + 1) for v in cell) for cell in cells]
        path.write_text("\n".join(lines) + "\n")

    def lines(self, step):
        """Yields the numbers of the vertices along every drawn line of the grid, and whether the line is on the boundary."""
        for j in range(0, self.rows, step):
            yield [self.at(i, j) for i in range(self.columns)], j in (0, self.rows - 1)
        for i in range(0, self.columns, step):
            yield [self.at(i, j) for j in range(self.rows)], i in (0, self.columns - 1)


def bent(wend, grid, material, handles, *options):
    """Returns the positions of the vertices at the end of the motion."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        grid.write(folder / "grid.obj")
        project = {"format": "wend", "version": 1, "domain": {"mesh": "grid.obj"}, "material": material,
                   "handles": handles, "time": {"end": 1}}
        (folder / "grid.wend").write_text(json.dumps(project))
        subprocess.run([wend, "run", "grid.wend", "--mesh", "bent.obj", "--quiet", *options], cwd=folder, check=True)
        return [tuple(map(float, line.split()[1:3]))
                for line in (folder / "bent.obj").read_text().splitlines() if line.startswith("v ")]


def path(points, tone, width):
    text = " ".join(f"{x * SCALE:.1f},{y * SCALE:.1f}" for x, y in points)
    return f'  <polyline points="{text}" stroke="{tone}" stroke-width="{width}"/>'


def draw(name, grid, points, step, marks, box, is_special=lambda p: False, way=()):
    """Writes a drawing. `marks` lists pairs (position of a pin, whether it was pulled), `box` is the visible area in
    units of the scene, and `way` is the path of a pin."""
    low, high = box
    size = [(h - l) * SCALE for l, h in zip(low, high)]
    rows = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{size[0]:.0f}" height="{size[1]:.0f}" '
            f'viewBox="{low[0] * SCALE:.0f} {low[1] * SCALE:.0f} {size[0]:.0f} {size[1]:.0f}" fill="none" '
            f'stroke-linecap="round" stroke-linejoin="round">']
    for vertices, border in sorted(grid.lines(step), key=lambda line: line[1]):
        line = [points[v] for v in vertices]
        rows.append(path(line, "#000000" if border else "#808080", 2 if border else 1.2))
        special = [points[v] for v in vertices if is_special(grid.points[v])]
        if not border and len(special) > 1:
            rows.append(path(special, "#4a5bd4", 2))
    if way:
        rows.append(path(way, "#4a5bd4", 1.2))
    for (x, y), pulled in marks:
        tone = "#4a5bd4" if pulled else "#000000"
        rows.append(f'  <circle cx="{x * SCALE:.1f}" cy="{y * SCALE:.1f}" r="5" fill="{tone}"/>')
    (OUT / f"{name}.svg").write_text("\n".join(rows) + "\n</svg>\n")


def near(grid, at, radius):
    return [v for v, (x, y) in enumerate(grid.points) if (x - at[0]) ** 2 + (y - at[1]) ** 2 <= radius ** 2 + 1e-9]


def pulled(name, vertices, by):
    return {"name": name, "at": {"vertices": vertices}, "motion": [{"kind": "translate", "by": by, "time": [0, 1]}]}


def energies(wend):
    """Draws a square that is held at its left side and pulled at its right, for each energy."""
    grid = Grid(2, 2, 12)
    left, right = near(grid, (0.25, 1), 0.17), near(grid, (1.75, 1), 0.17)
    handles = [{"name": "left", "at": {"vertices": left}}, pulled("right", right, [0.6, 0])]
    for name, phi in (("area", "equia"), ("length", "metr"), ("rigid", "akvf"), ("angle", "conf")):
        points = bent(wend, grid, {"phi": phi}, handles)
        draw(f"energy-{name}", grid, points, 4, [((0.25, 1), False), ((2.35, 1), True)], ((-0.5, -0.75), (3.1, 2.75)))


def reaches(wend):
    """Draws a strip that is held at its lower side while a point of its upper side is pulled, with a short and a long smoothing length."""
    grid = Grid(3, 1, 16)
    below = [grid.at(i, grid.rows - 1) for i in range(grid.columns)]
    handles = [{"name": "below", "at": {"vertices": below}}, pulled("top", [grid.at(24, 0)], [0, -0.6])]
    for name, length in (("near", 0.005), ("far", 0.12)):
        material = {"phi": "metr", "smoothing": {"kind": "invariant", "length": length}}
        points = bent(wend, grid, material, handles)
        draw(f"reach-{name}", grid, points, 4, [((1.5, -0.6), True)], ((-0.2, -0.85), (3.2, 1.2)))


def stiffness(wend):
    """Draws a bar that is held at its left end and pulled at its right, without and with a left half that is stiff along the bar."""
    grid = Grid(3, 1, 12)
    sides = [[grid.at(i, j) for j in range(grid.rows)] for i in (0, grid.columns - 1)]
    handles = [{"name": "left", "at": {"vertices": sides[0]}}, pulled("right", sides[1], [1.5, 0])]
    stiff = {"name": "stiff", "shape": {"box": {"min": [-1, -1], "max": [1.5, 2]}},
             "stiffness": {"axis": [1, 0], "ratio": 50}}
    for name, regions in (("even", []), ("part", [stiff])):
        points = bent(wend, grid, {"phi": "metr", "regions": regions}, handles)
        draw(f"stiffness-{name}", grid, points, 3, [((0, 0.5), False), ((4.5, 0.5), True)], ((-0.2, -0.3), (4.7, 1.3)),
             lambda p: bool(regions) and p[0] <= 1.5)


def circled(name, vertices, at, radius):
    """Returns a pin that moves once around a circle above it."""
    points = [[at[0] + radius * math.sin(a), at[1] - radius * (1 - math.cos(a))]
              for a in (2 * math.pi * k / 48 for k in range(49))]
    return {"name": name, "at": {"vertices": vertices},
            "motion": [{"kind": "curve", "interpolation": "polyline", "points": points, "time": [0, 1]}]}


def memories(wend):
    """Draws a strip that is held at its left end and whose right end has moved around a circle and back: without memory,
    with memory, and before and after relaxing."""
    grid = Grid(3, 1, 12)
    left = [grid.at(0, j) for j in range(grid.rows)]
    handles = [{"name": "left", "at": {"vertices": left}}, circled("right", near(grid, (3, 0.5), 0.2), (3, 0.5), 0.75)]
    circle = [(3 + 0.75 * math.sin(a), 0.5 - 0.75 * (1 - math.cos(a))) for a in (math.pi * k / 24 for k in range(49))]
    for name, memory, options, way in (("memory-none", 0, (), circle), ("memory-full", 40, (), circle),
                                       ("relax-before", 0, (), ()), ("relax-after", 0, ("--settle",), ())):
        points = bent(wend, grid, {"phi": "metr", "memory": memory}, handles, *options)
        box = ((-0.3, -1.2), (4.0, 1.5)) if way else ((-0.3, -0.3), (3.5, 1.5))
        draw(name, grid, points, 3, [((0, 0.5), False), ((3, 0.5), True)], box, way=way)


def main():
    wend = str(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else shutil.which("wend")).resolve())
    OUT.mkdir(exist_ok=True)
    for make in (energies, reaches, stiffness, memories):
        make(wend)


if __name__ == "__main__":
    main()
