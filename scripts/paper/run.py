#!/usr/bin/python3
"""Writes docs/paper.md and its pictures from the measurements of `wend bench paper`. Needs python3-scipy, rsvg-convert, optipng.

    scripts/paper/run.py [WEND [FOLDER]]        (build/release/wend; FOLDER keeps the results, which are then reused)
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from scipy.interpolate import LinearNDInterpolator

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE.parent))
from mesh_text import read_mesh  # noqa: E402
WEND = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/wend").resolve()
PICTURES = ROOT / "docs/pictures"
INK, PAPER = "#2b3038", "#eef1f4"
LOW, MIDDLE, HIGH = np.array([38, 92, 158]), np.array([247, 247, 247]), np.array([217, 116, 20])  # smaller, unchanged, larger cells


def measures(points, cells):
    return np.linalg.det(points[cells[:, 1:]] - points[cells[:, :1]])


def colours(change):
    """Returns the colours of relative changes of measure: blue where it halved, orange where it doubled."""
    t = np.clip(np.log2(np.maximum(change, 1e-9)), -1, 1)[:, None]
    return np.where(t < 0, MIDDLE + (LOW - MIDDLE) * -t, MIDDLE + (HIGH - MIDDLE) * t)


def polygon(points, colour, edge=None):
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    fill = "#%02x%02x%02x" % tuple(np.clip(colour, 0, 255).astype(int))
    return f'<polygon points="{path}" fill="{fill}" stroke="{edge or fill}" stroke-width=".5"/>'


class Panel:
    """A picture of one deformed shape, with y upwards."""

    def __init__(self, size, extent, margin=14):
        low, high = extent
        self.scale = min((size[k] - 2 * margin) / (high - low)[k] for k in (0, 1))
        self.middle, self.size, self.parts = (low + high) / 2, np.array(size), []

    def at(self, points):
        return (np.asarray(points) - self.middle) * [self.scale, -self.scale] + self.size / 2

    def line(self, points, width=1.0, colour=INK, opacity=1.0):
        path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in self.at(points))
        self.parts.append(f'<path d="{path}" fill="none" stroke="{colour}" stroke-width="{width}" stroke-opacity="{opacity}"/>')

    def flat(self, rest, cells, pose, spacing):
        for p, c in zip(self.at(pose)[cells], colours(measures(pose, cells) / measures(rest, cells))):
            self.parts.append(polygon(p, c))
        for ring in borders(cells):
            self.line(pose[ring], 1.4)
        where, inside = LinearNDInterpolator(rest, pose), triangle_finder(rest, cells)
        low, high = rest.min(0), rest.max(0)
        for axis in (0, 1):  # material lines, which form a grid at rest
            for value in np.arange(low[axis] + spacing, high[axis] - 1e-9, spacing):
                p = np.zeros((400, 2))
                p[:, axis], p[:, 1 - axis] = value, np.linspace(low[1 - axis], high[1 - axis], 400)
                q = np.where(inside(p)[:, None], where(p), np.nan)
                for piece in np.split(q, np.flatnonzero(np.isnan(q[:, 0]))):
                    piece = piece[~np.isnan(piece[:, 0])]
                    if len(piece) > 2:
                        self.line(piece, 0.8, opacity=0.75)

    def dots(self, points, colour):
        self.parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{colour}" stroke="#fff"/>' for x, y in self.at(points)]

    def solid(self, rest, cells, pose, view):
        change = measures(pose, cells) / measures(rest, cells)
        faces = {}
        for c, cell in enumerate(cells):
            for k, order in enumerate(((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))):
                face = tuple(cell[list(order)])
                faces.setdefault(tuple(sorted(face)), []).append((face, c))
        outer = [one[0] for one in faces.values() if len(one) == 1]
        corners = pose[np.array([face for face, _ in outer])] @ view.T
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        normal *= np.sign(measures(rest, cells)[0])
        shade = 0.55 + 0.45 * np.clip(normal @ np.array([-0.4, 0.5, 0.77]), 0, 1)
        paint = colours(change[[c for _, c in outer]]) * shade[:, None]
        for i in np.argsort(corners[:, :, 2].mean(1)):
            if normal[i, 2] > 0:
                self.parts.append(polygon(self.at(corners[i, :, :2]), paint[i], "#" + 3 * f"{int(70 + 60 * shade[i]):02x}"))


def borders(cells):
    after = {}
    edges = {(c[k], c[(k + 1) % 3]) for c in cells for k in range(3)}
    after = {a: b for a, b in edges if (b, a) not in edges}
    while after:
        ring = [next(iter(after))]
        while ring[-1] in after:
            ring.append(after.pop(ring[-1]))
        yield ring


def triangle_finder(points, cells):
    """Returns a function that tells whether points are inside a mesh, by the parity of crossings with its boundary."""
    rings = [points[ring] for ring in borders(cells)]

    def inside(p):
        odd = np.zeros(len(p), bool)
        for ring in rings:
            for a, b in zip(ring[:-1], ring[1:]):
                crosses = (a[1] > p[:, 1]) != (b[1] > p[:, 1])
                with np.errstate(divide="ignore", invalid="ignore"):
                    odd ^= crosses & (p[:, 0] < a[0] + (p[:, 1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]))
        return odd
    return inside


def sheet(rows, name, size):
    """Writes panels in rows, each with a caption below it, as a PNG."""
    width, height = size[0] * max(map(len, rows)), (size[1] + 26) * len(rows)
    svg = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="DejaVu Sans" font-size="13">',
           f'<rect width="100%" height="100%" fill="{PAPER}"/>']
    for y, row in enumerate(rows):
        for x, (panel, text) in enumerate(row):
            svg.append(f'<g transform="translate({x * size[0]},{y * (size[1] + 26)})">' + "".join(panel.parts) +
                       f'<text x="{size[0] / 2}" y="{size[1] + 14}" text-anchor="middle" fill="{INK}">{text}</text></g>')
    out = PICTURES / f"{name}.png"
    subprocess.run(["rsvg-convert", "-o", out], input="\n".join(svg + ["</svg>"]), text=True, check=True)
    subprocess.run(["convert", out, "+dither", "-colors", "200", "-strip", out], check=True)
    subprocess.run(["optipng", "-quiet", "-o4", out], check=True)


class Results:
    def __init__(self, folder, table):
        self.folder, self.table = folder, table
        self.rows = {(case["name"].split(": ")[-1], row["what"]): row["figures"] for case in table["cases"] for row in case["rows"]}

    def shape(self, scene, variant, shape, extension=".obj"):
        plain = lambda text: text.replace("'", "").replace(" ", "-")
        pose, cells = read_mesh(self.folder / f"{plain(scene)}-{plain(variant)}-deformed{extension}")
        return read_mesh(self.folder / (plain(shape) + extension))[0], cells, pose

    def flat(self, scene, shape, variants, texts, size, spacing=0.25, pins=()):
        every = [self.shape(scene, v, shape) for v in variants]
        low, high = np.min([e[2].min(0) for e in every], 0), np.max([e[2].max(0) for e in every], 0)
        row = []
        for one, text in zip(every, texts):
            panel = Panel(size, (low, high))
            panel.flat(*one, spacing)
            for p, colour in pins:
                panel.dots(LinearNDInterpolator(one[0], one[2])(p), colour)
            row.append((panel, text))
        return row

    def solid(self, scene, shape, variants, size, view):
        every = [self.shape(scene, v, shape, ".mesh") for v in variants]
        seen = [e[2] @ view.T for e in every]
        extent = np.min([s.min(0) for s in seen], 0)[:2], np.max([s.max(0) for s in seen], 0)[:2]
        row = []
        for one, v in zip(every, variants):
            panel = Panel(size, extent)
            panel.solid(*one, view)
            row.append((panel, v))
        return row


ENERGIES = ["EQUIA", "METR", "AKVF", "CONF"]


def looking(turn, tilt):
    c, s, d, t = np.cos(turn), np.sin(turn), np.cos(tilt), np.sin(tilt)
    return np.array([[1, 0, 0], [0, d, t], [0, -t, d]]) @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])


def pictures(r):
    sheet([r.flat("strip", "strip", ENERGIES, ENERGIES, (270, 300)), r.flat("star", "star", ENERGIES, ENERGIES, (270, 270))],
          "paper-energies", (270, 300))
    kinds = ["none", "the paper's", "invariant"]
    sheet([r.flat("square", "square", kinds, kinds, (300, 300), 0.0625)], "paper-smoothness", (300, 300))
    pins = [([[0.21, 0.33], [0.17, 0.71]], INK), ([[1.4, 0.43], [2.63, 0.57], [3.77, 0.39]], "#c4371b")]
    pinned = r.flat("pinned strip", "strip", ENERGIES, ENERGIES, (440, 260), pins=pins)
    sheet([pinned[:2], pinned[2:]], "paper-pins", (440, 260))
    sheet([r.flat("blended strip", "strip", ["EQUIA to CONF"], ["EQUIA at the left end to CONF at the right one"], (400, 300)) +
           r.flat("strip", "strip", ["METR"], ["METR everywhere"], (400, 300))], "paper-blend", (400, 300))
    sheet([r.flat("stretched strip", "strip", [v], [t], (540, 130)) for v, t in
           (("plain", "the same all along"), ("lengthwise", "the middle 20 times stiffer lengthwise"),
            ("across", "the middle 20 times stiffer across"))], "paper-stiffness", (540, 130))
    upright = looking(0, 1.25) @ looking(0.6, 0)
    sheet([r.solid("twisted bar", "bar", ENERGIES, (270, 170), upright), r.solid("bent bar", "bar", ENERGIES, (270, 230), looking(0.35, 0.6)),
           r.solid("thick star", "thick star", ENERGIES, (270, 250), looking(0.3, 0.7))], "paper-solids", (270, 250))


def number(value):
    return "0" if value == 0 else f"{value:.1e}".replace("e-0", "e-") if abs(value) < 1e-3 else f"{value:.3g}"


def errors(r, scene, variants, columns):
    heads = {"angle": "angle", "volume": "area or volume", "metric": "metric", "worst 1 %": "the worst 1 % of the cells have of it",
             "whole measure's change": "the whole grows by", "metric, middle third": "metric, middle third", "off its path": "pins off by"}
    text = {"worst 1 %": lambda v: f"{100 * v:.0f} %", "whole measure's change": lambda v: f"{100 * v:+.2f} %"}
    lines = ["| | " + " | ".join(heads[c] for c in columns) + " |", "| --- |" + " --- |" * len(columns)]
    for v in variants:
        lines.append(f"| {v} | " + " | ".join(text.get(c, number)(r.rows[scene, v][c]) for c in columns) + " |")
    return "\n".join(lines)


def times(table):
    lines = ["| vertices / cells | | analysis | assembly | factor + solve | ten steps | factors |", "| --- | --- | --- | --- | --- | --- | --- |"]
    for case in table["cases"]:
        if case["name"] != "the paper's times":
            continue
        for row in case["rows"]:
            f = row["figures"]
            lines.append(f"| {case['dimension']}D {case['vertices']:,} / {case['cells']:,} | {row['what'].removeprefix('ten RK4 steps').strip(', ') or 'Wend'} | "
                         f"{f['analysis (ms)']:.0f} ms | {f['assembly of a field (ms)']:.1f} ms | {f['factor + solve of a field (ms)']:.1f} ms | "
                         f"{row['seconds']:.2f} s | {f['factorizations']:.0f} |")
    return "\n".join(lines)


def claims(table):
    lines = ["| finding | holds | figures |", "| --- | --- | --- |"]
    for claim in table["claims"]:
        lines.append(f"| {claim['what']} | {'yes' if claim['holds'] else '**no**'} | " +
                     (" < " if claim["holds"] else ", ").join(f"{k} {number(v)}" for k, v in claim["values"].items()) + " |")
    return "\n".join(lines)


def soft():
    """Returns the table of how far the original AKVF code leaves handles from their positions; see scripts/comparison."""
    cases = json.loads((HERE.parent / "comparison/others.json").read_text())["cases"]
    lines = ["| case | weight | handles off by | of length 4 |", "| --- | --- | --- | --- |"]
    for name in ("strip_5k_bend90", "strip_5k_bend180", "strip_5k_stretch"):
        for row in cases[name]:
            if row["program"].startswith("AKVF orig.") and "steps" not in row["program"]:
                lines.append(f"| {name} | {row['program'].split('alpha ')[1]} | {number(row['constraint'])} | {100 * row['constraint'] / 4:.2g} % |")
    return "\n".join(lines)


def page(r):
    four = ["angle", "volume", "metric", "whole measure's change"]
    fill = {"STRIP": errors(r, "strip", ENERGIES, four), "STAR": errors(r, "star", ENERGIES, four),
            "SQUARE": errors(r, "square", ["none", "the paper's", "invariant"], ["metric", "worst 1 %"]),
            "CUBE": errors(r, "cube", ["none", "the paper's", "invariant"], ["metric", "worst 1 %"]),
            "PINS": errors(r, "pinned strip", ENERGIES, ["angle", "volume", "metric", "off its path"]),
            "BLEND": errors(r, "blended strip", ["EQUIA to CONF"], four[:3]),
            "STIFF": errors(r, "stretched strip", ["plain", "lengthwise", "across"], ["metric", "metric, middle third"]),
            "TWIST": errors(r, "twisted bar", ENERGIES, four), "BEND": errors(r, "bent bar", ENERGIES, four),
            "THICK": errors(r, "thick star", ENERGIES, four), "TIMES": times(r.table), "CLAIMS": claims(r.table), "SOFT": soft(),
            "MACHINE": f"{r.table['machine']}, {r.table['cores']} cores"}
    text = (HERE / "page.md").read_text()
    for name, value in fill.items():
        text = text.replace(f"@{name}@", value)
    (ROOT / "docs/paper.md").write_text(text)


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else scratch)
        table = folder / "table.json"
        if not table.exists():
            subprocess.run([WEND, "bench", "paper", "--keep", folder, "-o", table], check=True)
        results = Results(folder, json.loads(table.read_text()))
        pictures(results)
        page(results)


if __name__ == "__main__":
    main()
