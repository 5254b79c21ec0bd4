#!/usr/bin/env python3
"""Writes a wing between two walls as hexahedra with a boundary layer, and the motion of its skin.

Usage: wing.py FOLDER

The wing is an ellipse of chord 1 and thickness 0.12 that spans from the wall z = 0 to the wall z = 2. The first cells
at its skin are 0.002 high, and each layer is 1.25 times as high as the one before. FOLDER gets wing.inp (Abaqus, with
the node sets SKIN, FAR, ROOT and TIP), skin.csv (the displacements of the skin, which pitches by 20 degrees at the root
and less towards the tip, where it rises by 0.3) and wing.wend.
"""
import json
import math
import pathlib
import sys

AROUND, LAYERS, SPAN = 64, 22, 10
CHORD, THICKNESS, LENGTH = 1.0, 0.12, 2.0
FIRST, GROWTH = 0.002, 1.25

def node(i, j, k):
    """Returns the number, from 1, of the node with the indices i around the wing, j outwards and k along the span."""
    return 1 + (k * (LAYERS + 1) + j) * AROUND + i % AROUND


def place(i, j, k):
    """Returns the position of a node. Rays leave the ellipse along confocal hyperbolas, so that they cross the skin at right angles."""
    height = FIRST * (GROWTH**j - 1) / (GROWTH - 1)
    a, b = CHORD / 2, THICKNESS / 2
    focus = math.sqrt(a * a - b * b)
    angle = 2 * math.pi * i / AROUND
    minor = b + height
    return focus * math.hypot(1, minor / focus) * math.cos(angle), minor * math.sin(angle), LENGTH * k / SPAN


def displacement(x, y, z):
    """Returns the displacement of a point of the skin: a pitch about the quarter chord and a rise towards the tip."""
    share = z / LENGTH
    pitch = math.radians(20) * (1 - 0.5 * share)
    cx = -CHORD / 4
    dx, dy = x - cx, y
    return (dx * math.cos(pitch) - dy * math.sin(pitch) - dx,
            dx * math.sin(pitch) + dy * math.cos(pitch) - dy + 0.3 * share * share, 0.0)


def write(folder):
    """Writes wing.inp, skin.csv and wing.wend."""
    every = [(i, j, k) for k in range(SPAN + 1) for j in range(LAYERS + 1) for i in range(AROUND)]
    sets = {"SKIN": lambda i, j, k: j == 0, "FAR": lambda i, j, k: j == LAYERS,
            "ROOT": lambda i, j, k: k == 0, "TIP": lambda i, j, k: k == SPAN}

    lines = ["*HEADING", "A wing between two walls", "*NODE"]
    lines += [f"{node(*n)}, " + ", ".join(repr(c) for c in place(*n)) for n in every]
    lines.append("*ELEMENT, TYPE=C3D8, ELSET=AIR")
    number = 0
    for k in range(SPAN):
        for j in range(LAYERS):
            for i in range(AROUND):
                number += 1
                ring = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)]
                corners = [node(a, b, k) for a, b in ring] + [node(a, b, k + 1) for a, b in ring]
                lines.append(f"{number}, " + ", ".join(map(str, corners)))
    for name, holds in sets.items():
        lines.append(f"*NSET, NSET={name}")
        ids = [str(node(*n)) for n in every if holds(*n)]
        lines += [", ".join(ids[first:first + 16]) for first in range(0, len(ids), 16)]
    (folder / "wing.inp").write_text("\n".join(lines) + "\n")

    rows = ["id,dx,dy,dz"]
    for n in every:
        if n[1] == 0:
            rows.append(f"{node(*n) - 1}," + ",".join(repr(c) for c in displacement(*place(*n))))
    (folder / "skin.csv").write_text("\n".join(rows) + "\n")

    project = {
        "format": "wend", "version": 1,
        "domain": {"mesh": "wing.inp"},
        "handles": [
            {"name": "skin", "at": {"group": "SKIN"}, "motion": [{"kind": "field", "file": "skin.csv"}]},
            {"name": "far", "at": {"group": "FAR"}},
            {"name": "root", "at": {"group": "ROOT"}, "hold": {"slide": "rest"}},
            {"name": "tip", "at": {"group": "TIP"}, "hold": {"slide": "rest"}},
        ],
    }
    (folder / "wing.wend").write_text(json.dumps(project, indent=2) + "\n")


if __name__ == "__main__":
    write(pathlib.Path(sys.argv[1]))
