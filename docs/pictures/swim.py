"""Draws one cycle of a swimming fish frame by frame. Usage: swim.py WEND OUT

A wave travels along the spine of a fully elastic solid. It grows during the first second; the second one is the cycle.
Writes OUT/fish.obj, OUT/fish.wend and OUT/swim_00.png to OUT/swim_11.png, and prints the distance between the start and
the end of the cycle."""
import json
import math
import pathlib
import subprocess
import sys

import bent

FRAMES = 12
PIECES = 12  # cubics per cycle
SPINE = [-1.5, -0.9, -0.3, 0.4, 1.1, 1.75]
VIEW = math.radians(-30), math.radians(32)
SIZE = 480, 360
BACK, BELLY, FIN, DARK = (58, 122, 172), (236, 231, 214), (70, 118, 158), (22, 26, 34)


def fish():
    """Returns the fish, with its head at the left and a flat, high tail."""
    model = bent.Model()

    def place(u, v):
        x = -2 + 4.2 * u
        body = math.sin(math.pi * min(1, 0.03 + 0.94 * u ** 0.75))
        fin = max(0, (u - 0.8) / 0.2)
        wide = 0.42 * body * (1 - fin) + 0.05
        high = 0.62 * body * (1 - fin) + 0.06 + 0.72 * fin ** 1.4
        back = 0.35 * fin * abs(math.sin(2 * math.pi * v)) ** 2
        return x + back, wide * math.cos(2 * math.pi * v), high * math.sin(2 * math.pi * v)

    model.grid(place, 44, 20, closed_columns=True)
    model.caps(44, 20)
    model.triangles = [(a, c, b) for a, b, c in model.triangles]  # orients them outwards
    return model


def sway(x, t):
    """Returns the sideways displacement of the spine at x and time t: a wave towards the tail whose amplitude grows along
    the body and during the first cycle."""
    size = 0.08 + 0.42 * ((x + 2) / 4.2) ** 2
    grows = min(1, t) ** 2 * (3 - 2 * min(1, t))
    return grows * size * math.sin(2 * math.pi * t - 1.5 * x)


def way(x):
    """Returns the control points of a chain of cubics through the displacements at x, with matching velocities."""
    points = []
    for i in range(2 * PIECES + 1):
        t, third = i / PIECES, 1 / (3 * PIECES)
        place, rate = sway(x, t), (sway(x, t + 1e-5) - sway(x, t - 1e-5)) / 2e-5
        points += [[x, place - third * rate, 0], [x, place, 0], [x, place + third * rate, 0]]
    return points[1:-1]


def project():
    handles = []
    for k, x in enumerate(SPINE):
        curve = {"kind": "curve", "interpolation": "bezier", "frame": "none", "points": way(x), "time": [0, 2]}
        handles.append({"name": f"spine {k + 1}", "at": {"points": [[x, 0, 0]]}, "motion": [curve]})
    return {
        "format": "wend", "version": 1,
        "domain": {"surface": "fish.obj", "vertices": 1200},
        "material": {"phi": "metr", "memory": "elastic"},
        "handles": handles,
        "time": {"end": 2, "cycle": [1, 2]},
    }


def mixed(a, b, share):
    share = max(0.0, min(1.0, share))
    return tuple(x + share * (y - x) for x, y in zip(a, b))


def paint():
    """Returns the texture in rows from top to bottom, over the length and height of the fish at rest: a dark back, a pale
    belly and an eye."""
    width, height = 640, 256
    rows = []
    for j in range(height):
        z = 0.8 - 1.6 * (j + 0.5) / height
        row = []
        for i in range(width):
            x = -2 + 4.6 * (i + 0.5) / width
            colour = mixed(mixed(BELLY, BACK, (z + 0.22) / 0.3), FIN, (x - 1.25) / 0.4)
            if abs(math.hypot((x + 1.0) / 0.9, z + 0.02) - 0.34) < 0.012 and x > -1.0:
                colour = mixed(colour, DARK, 0.5)  # the gill
            eye = math.hypot(x + 1.5, z - 0.1)
            row.append(DARK if eye < 0.07 else (240, 236, 222) if eye < 0.1 else colour)
        rows.append(row)
    return rows


def read_points(path):
    with open(path, encoding="utf-8") as file:
        return [tuple(map(float, line.split()[1:4])) for line in file if line.startswith("v ")]


def draw(model, frames, out):
    """Draws all frames at the same scale and position."""
    bent.portrait.SIZE = SIZE
    texture = [((p[0] + 2) / 4.6, (p[2] + 0.8) / 1.6) for p in model.points]
    picture = paint()
    seen = [(bent.portrait.turned(p, *VIEW), p) for frame in frames for p in frame]
    limits = [choose(seen, key=lambda one: one[0][k])[1] for k in (0, 1) for choose in (min, max)]
    for number, points in enumerate(frames):
        colours = bent.portrait.portrait(points + limits, texture, model.triangles, model.triangles,
                                         [picture] * len(model.triangles), *VIEW)
        bent.portrait.write_png(out / f"swim_{number:02}.png", bent.portrait.averaged(colours))


def main(wend, out):
    model = fish()
    model.write(out / "fish.obj")
    (out / "fish.wend").write_text(json.dumps(project()), encoding="utf-8")
    # The frames include the end of the cycle, which should equal its start.
    subprocess.run([wend, "run", out / "fish.wend", "--frames", out / "fish_##.obj", "--count", str(2 * FRAMES + 1), "--quiet"], check=True)
    frames = [read_points(out / f"fish_{number:02}.obj") for number in range(FRAMES, 2 * FRAMES + 1)]
    print("end of the cycle: %.1e from its start" % max(math.dist(p, q) for p, q in zip(frames[0], frames[-1])))
    draw(model, frames[:-1], out)


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]))
