#!/usr/bin/env python3
"""Draws the root section of the wing of wing.py, at rest and deformed, as SVG. Usage: wing_section.py REST.inp MOVED.inp OUT.svg"""
import sys

from wing import AROUND, LAYERS, node

VIEW = (-0.75, -0.42, 1.5, 0.84)  # x, y, width, height
SCALE = 620


def nodes(path):
    """Returns the x and y coordinates of a file's nodes by number."""
    places, reads = {}, False
    for line in open(path):
        if line.startswith("*"):
            reads = line.upper().startswith("*NODE")
        elif reads:
            number, x, y, _ = line.split(",")
            places[int(number)] = float(x), float(y)
    return places


def drawn(places, left):
    """Returns the SVG of the rings and rays at the root, shifted to the right by `left`."""
    paths = [[node(i, j, 0) for i in range(AROUND + 1)] for j in range(LAYERS + 1)]
    paths += [[node(i, j, 0) for j in range(LAYERS + 1)] for i in range(AROUND)]
    lines = []
    for number, path in enumerate(paths):
        points = " ".join(f"{(places[n][0] - VIEW[0]) * SCALE:.2f},{(VIEW[1] + VIEW[3] - places[n][1]) * SCALE:.2f}" for n in path)
        style = 'fill="#4f5bd5" stroke="#2b3038" stroke-width="1.5"' if number == 0 else 'fill="none" stroke="#2b3038" stroke-width="0.5"'
        lines.append(f'<polyline points="{points}" {style}/>')
    width, height = VIEW[2] * SCALE, VIEW[3] * SCALE
    return f'<svg x="{left}" width="{width}" height="{height}">' + "".join(lines) + "</svg>"


rest, moved, out = sys.argv[1:]
width, height = VIEW[2] * SCALE, VIEW[3] * SCALE
with open(out, "w") as file:
    file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{2 * width + 20}" height="{height}">'
               f'<rect width="100%" height="100%" fill="#eef1f4"/>{drawn(nodes(rest), 0)}{drawn(nodes(moved), width + 20)}</svg>')
