"""Draws five surfaces that other programs refuse to bend, at rest and bent by 90°. Usage: bent.py WEND OUT

The surfaces are a knot, which is sound but passes near itself; a vase with a single wall, an open top and missing
triangles, as from a scanner; a chain of rings that do not touch; a bolt of bodies that cross each other; and a fern of
loose leaves without thickness. Writes OUT/NAME-rest.png and OUT/NAME-bent.png for each."""
import json
import math
import pathlib
import random
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "../../resources/samples/art/solids"))
import portrait  # noqa: E402
from eagle import spline  # noqa: E402

ENDS = 0.12  # fraction of the length that is held or rotated at each end


class Model:
    """A triangle mesh whose parts share no vertices."""

    def __init__(self):
        self.points, self.triangles = [], []

    def grid(self, place, rows, columns, closed_rows=False, closed_columns=False, keeps=lambda i, j: True):
        """Adds rows × columns squares over place(u, v), with u and v from 0 to 1. Squares for which keeps(i, j) is false become holes."""
        first = len(self.points)
        across = columns if closed_columns else columns + 1
        down = rows if closed_rows else rows + 1
        self.points += [place(i / rows, j / columns) for i in range(down) for j in range(across)]
        for i in range(rows):
            for j in range(columns):
                if keeps(i, j):
                    a, b = first + i * across, first + (i + 1) % down * across
                    k, n = j, (j + 1) % across
                    self.triangles += [(a + k, b + k, b + n), (a + k, b + n, a + n)]

    def caps(self, rows, columns, ends=(True, True)):
        """Closes the tube that was added last by fans around the centres of its first and last row, as far as `ends` selects them."""
        first = len(self.points) - (rows + 1) * columns
        for end, row in zip(ends, (first, first + rows * columns)):
            if not end:
                continue
            ring = range(row, row + columns)
            self.points.append(tuple(sum(self.points[i][k] for i in ring) / columns for k in range(3)))
            for j in range(columns):
                pair = (row + j, row + (j + 1) % columns)
                self.triangles.append((len(self.points) - 1, *(pair if row == first else pair[::-1])))

    def tube(self, way, radius, along, around, closed=False):
        """Adds a tube of radius radius(u) around the curve way(u), with u from 0 to 1. A tube that is not closed gets caps."""
        def place(u, v):
            p, ahead = way(u), tuple(b - a for a, b in zip(way(u - 1e-4), way(u + 1e-4)))
            side = unit(cross(ahead, (0.3, -0.2, 1)))
            up = unit(cross(side, ahead))
            r = radius(u)
            c, s = r * math.cos(2 * math.pi * v), r * math.sin(2 * math.pi * v)
            return tuple(p[k] + c * side[k] + s * up[k] for k in range(3))

        self.grid(place, along, around, closed_rows=closed, closed_columns=True)
        if not closed:
            self.caps(along, around)

    def prism(self, sides, radius, low, high, rows=2):
        """Adds a capped prism along the x axis."""
        def place(u, v):
            return low + u * (high - low), radius * math.cos(2 * math.pi * v), radius * math.sin(2 * math.pi * v)

        self.grid(place, rows, sides, closed_columns=True)
        self.caps(rows, sides)

    def write(self, path):
        with open(path, "w", encoding="utf-8") as file:
            file.writelines("v %.6f %.6f %.6f\n" % p for p in self.points)
            file.writelines("f %d %d %d\n" % tuple(i + 1 for i in t) for t in self.triangles)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    size = math.sqrt(sum(x * x for x in a)) or 1.0
    return tuple(x / size for x in a)


def knot():
    """Returns a cord along x with an overhand knot."""
    def way(u):
        t = 4.2 * (2 * u - 1)
        near = math.exp(-((t / 2.1) ** 4))
        a = 1.5 * t
        return (1.15 * t - 2.1 * near * math.sin(a), near * 1.25 * math.cos(a) - 0.6 * near, 0.75 * near * math.sin(2 * a))

    model = Model()
    model.tube(way, lambda u: 0.3, 360, 24)
    return model


def vase():
    """Returns a vase along x with a single wall, an open top, and holes where a scanner missed something."""
    profile = [(0, (0, 0.8)), (0.12, (0.5, 1.1)), (0.36, (2, 1.5)), (0.6, (3.6, 1.1)), (0.8, (4.8, 0.6)), (0.9, (5.6, 0.58)), (1, (6.4, 0.95))]

    def place(u, v):
        x, r = spline(profile, u)
        r *= 1 + 0.03 * math.cos(12 * 2 * math.pi * v)
        return x, r * math.cos(2 * math.pi * v), r * math.sin(2 * math.pi * v)

    rng = random.Random(3)
    holes = [(rng.randrange(12, 80), rng.randrange(96), rng.randrange(2, 5)) for _ in range(16)]

    def keeps(i, j):
        return all((i - a) ** 2 + ((j - b + 48) % 96 - 48) ** 2 > r * r for a, b, r in holes)

    model = Model()
    model.grid(place, 84, 96, closed_columns=True, keeps=keeps)
    model.caps(84, 96, ends=(True, False))
    return model


def chain():
    model = Model()
    for ring in range(9):
        turn = math.pi / 2 * (ring % 2)

        def way(u, ring=ring, turn=turn):
            a = 2 * math.pi * u
            side = 0.55 * math.sin(a)
            return 1.25 * ring + 0.95 * math.cos(a), side * math.cos(turn), side * math.sin(turn)

        model.tube(way, lambda u: 0.17, 48, 14, closed=True)
    return model


def bolt():
    """Returns a bolt whose head, shank, washer and thread are separate bodies that cross each other."""
    model = Model()
    model.prism(6, 1.25, 0, 0.9, rows=1)
    model.prism(48, 1.6, 0.85, 1.1)
    model.prism(40, 0.7, 0.5, 8, rows=60)

    def thread(u):
        a = 2 * math.pi * 13 * u
        return 2.6 + 5.1 * u, 0.7 * math.cos(a), 0.7 * math.sin(a)

    model.tube(thread, lambda u: 0.14 * min(1, 0.05 + 30 * u, 0.05 + 30 * (1 - u)), 620, 8)
    return model


def fern():
    model = Model()
    model.tube(lambda u: (9 * u, 0.0, 0.25 * math.sin(3 * u)), lambda u: 0.11 * (1.1 - u), 80, 10)
    for pair in range(22):
        root = 0.9 + 0.36 * pair
        size = 2.2 * math.sin(math.pi * (0.1 + 0.86 * pair / 21)) ** 0.8
        for side in (-1, 1):
            def leaf(u, v, root=root, size=size, side=side):
                width = 0.42 * size ** 0.6 * math.sin(math.pi * min(1, u + 0.04)) ** 0.7 * (v - 0.5) * 0.9
                lift = 0.25 * math.sin(3 * root / 9) + 0.5 * size * u * (0.5 - u) + 0.5 * abs(v - 0.5) * 0.3
                return root + 0.55 * size * u + width, side * (0.08 + size * u), lift

            model.grid(leaf, 12, 4)
    return model


# Function, colour, view (degrees about z and from above), and options of a cage, which holds loose parts together.
MODELS = {
    "knot": (knot, (0.78, 0.55, 0.33), (-15, 55), None),
    "vase": (vase, (0.36, 0.55, 0.62), (-15, 50), None),
    "chain": (chain, (0.62, 0.65, 0.70), (-20, 45), {"detail": 0.4}),
    "bolt": (bolt, (0.55, 0.57, 0.62), (-15, 50), None),
    "fern": (fern, (0.36, 0.58, 0.30), (-20, 60), {"detail": 0.6}),
}


def project(path, points, cage):
    """Returns a project that holds the left end and rotates the right one by 90° about z, so that the middle line becomes
    a quarter of a circle."""
    low, high = min(p[0] for p in points), max(p[0] for p in points)
    length, middle = high - low, sum(p[1] for p in points) / len(points)
    radius = 2 * length / math.pi
    centre = [low + length / 2, middle + radius - length / 2, 0]
    return {
        "format": "wend",
        "version": 1,
        "domain": {"surface": path, "vertices": 4000, **({"cage": cage} if cage else {})},
        "material": {"phi": "metr"},
        "handles": [
            {"name": "held", "at": {"region": {"halfspace": {"point": [low + ENDS * length, 0, 0], "normal": [-1, 0, 0]}}}},
            {
                "name": "turned",
                "at": {"region": {"halfspace": {"point": [high - ENDS * length, 0, 0], "normal": [1, 0, 0]}}},
                "motion": [{"kind": "rotate", "centre": centre, "axis": [0, 0, 1], "angle": math.pi / 2, "time": [0, 1]}],
            },
        ],
        "time": {"end": 1},
    }


def draw(source, target, colour, view):
    """Draws both sides of the triangles, each lit by its own normals."""
    points, texture, triangles, corners, paints = portrait.read_obj(source, tuple(255 * c for c in colour))
    count = len(points)
    both = triangles + [(count + a, count + c, count + b) for a, b, c in triangles]
    colours = portrait.portrait(2 * points, texture, both, 2 * corners, 2 * paints, *map(math.radians, view))
    portrait.write_png(target, portrait.averaged(colours))


if __name__ == "__main__":
    wend, out = sys.argv[1], pathlib.Path(sys.argv[2])
    for name, (make, colour, view, cage) in MODELS.items():
        model, rest, bent = make(), out / f"{name}.obj", out / f"{name}-bent.obj"
        model.write(rest)
        (out / f"{name}.wend").write_text(json.dumps(project(f"{name}.obj", model.points, cage)), encoding="utf-8")
        subprocess.run([wend, "run", out / f"{name}.wend", "--mesh", bent, "--quiet"], check=True)
        draw(rest, out / f"{name}-rest.png", colour, view)
        draw(bent, out / f"{name}-bent.png", colour, view)
