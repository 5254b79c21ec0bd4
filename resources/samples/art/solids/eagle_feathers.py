"""Writes the detailed surface of the eagle: wings and tail of feathers, a hooked beak, eyes and feet, finer than the solid that carries it.

Usage: eagle_feathers.py OUT.obj     its materials are in eagle-feathers.mtl, its texture is drawn by plumage.py"""
import math
import sys

from eagle import WING, flat_part, spline
from implicit import add, cross, dot, ellipsoid, smooth_union, sub, surface, tube, unit
from plumage import HEIGHT, WIDTH


def blade(p, root, angle, length, half_width, half_height, rise=0.0):
    """Returns the approximate distance to a flat feather from its root along the angle in the plane, with a raised tip."""
    along = (math.cos(angle), math.sin(angle), rise)
    size = math.sqrt(dot(along, along))
    along = tuple(a / size for a in along)
    across = unit((-along[1], along[0], 0))
    up = cross(along, across)
    q = sub(p, add(root, along, length / 2))
    return ellipsoid((dot(q, along), dot(q, across), dot(q, up)), (0, 0, 0), (length / 2, half_width, half_height))


def wing(p):
    x = abs(p[0])
    ahead, up, chord, thick = spline(WING, min(max(x, 0.15), 2.4))
    notch = 0.035 * math.cos(2 * math.pi * x / 0.17)
    behind = p[1] < ahead
    return flat_part(x, 0.0, 2.38, p[1] - ahead, p[2] - up, 1.3 * chord + notch if behind else chord, 0.2 * thick + 0.03)


def fingers(p):
    q = (abs(p[0]), p[1], p[2])
    if q[0] < 1.7:
        return 1.0
    return min(
        blade(q, (2.28, -0.17 - 0.075 * k, 0.25), 0.12 - 0.32 * k, 0.72 - 0.03 * k, 0.075, 0.045, 0.1)
        for k in range(5)
    )


def tail(p):
    if p[1] > -0.4:
        return 1.0
    return min(blade(p, (0.05 * k, -0.9, 0.05), -math.pi / 2 + 0.16 * k, 1.22, 0.14, 0.05) for k in range(-4, 5))


def eagle(p):
    head = smooth_union(
        [
            ellipsoid(p, (0, -0.05, 0), (0.33, 0.92, 0.32)),
            tube(p, [(0, 0.50, 0.08), (0, 0.95, 0.30)], [0.27, 0.19]),
            ellipsoid(p, (0, 1.08, 0.37), (0.19, 0.25, 0.18)),
            wing(p),
        ],
        0.05,
    )
    beak = tube(
        p, [(0, 1.20, 0.37), (0, 1.38, 0.37), (0, 1.50, 0.31), (0, 1.53, 0.22)], [0.13, 0.095, 0.065, 0.03]
    )
    return smooth_union([head, beak, fingers(p), tail(p)], 0.02)


def foot(p):
    q = (abs(p[0]), p[1], p[2])
    toes = [tube(q, [(0.17, 0, -0.5), (0.17 + dx, dy, -0.58)], [0.045, 0.035]) for dx, dy in
            ((-0.1, 0.17), (0, 0.21), (0.1, 0.17), (0, -0.13))]
    return smooth_union([tube(q, [(0.15, -0.1, -0.2), (0.17, 0, -0.5)], [0.075, 0.05])] + toes, 0.02)


def ball(centre, radius, rings=7, around=12):
    """Returns the points and triangles of a small sphere."""
    points = [add(centre, (0, 0, radius))]
    for i in range(1, rings):
        t = math.pi * i / rings
        for j in range(around):
            a = 2 * math.pi * j / around
            points.append(
                add(centre, (radius * math.sin(t) * math.cos(a), radius * math.sin(t) * math.sin(a), radius * math.cos(t)))
            )
    points.append(add(centre, (0, 0, -radius)))
    last, triangles = len(points) - 1, []
    for j in range(around):
        k = (j + 1) % around
        triangles += [(0, 1 + j, 1 + k), (last, last - around + k, last - around + j)]
        for i in range(rings - 2):
            a, b = 1 + i * around, 1 + (i + 1) * around
            triangles += [(a + j, b + j, b + k), (a + j, b + k, a + k)]
    return points, triangles


def parts():
    """Yields the material, points and triangles of each part."""
    yield "plumage", *surface(eagle, (-3.1, -2.2, -0.5), (3.1, 1.7, 0.7), 0.052, 5)
    yield "feet", *surface(foot, (-0.4, -0.3, -0.68), (0.4, 0.3, -0.1), 0.045, 5)
    for side in (-1, 1):
        yield "iris", *ball((side * 0.150, 1.155, 0.435), 0.052)
        yield "pupil", *ball((side * 0.177, 1.165, 0.443), 0.032)


def write(path):
    first = 1
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write("# eagle-feathers: made by art/solids\nmtllib eagle-feathers.mtl\n")
        for material, points, triangles in parts():
            for p in points:
                file.write("v " + " ".join(f"{x:.4f}" for x in p) + "\n")
                file.write(f"vt {p[0] / WIDTH + 0.5:.4f} {(p[1] + 0.2) / HEIGHT + 0.5:.4f}\n")
            file.write(f"usemtl {material}\n")
            for t in triangles:
                file.write("f " + " ".join(f"{first + i}/{first + i}" for i in t) + "\n")
            first += len(points)


if __name__ == "__main__":
    write(sys.argv[1])
