"""Triangulates the closed surfaces of solids that are given by a function, negative inside and positive outside.

Naive surface nets (one vertex per grid cell that the surface crosses, Gibson 1998) are followed by rounds of relaxation
along the surface and Newton steps back onto it, so that the triangles become even. Everything is deterministic."""
import math


def add(a, b, s=1.0):
    return (a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    size = math.sqrt(dot(a, a)) or 1.0
    return (a[0] / size, a[1] / size, a[2] / size)


def smooth_union(values, k):
    """Returns a soft minimum of the values: parts that are nearer than k blend into each other."""
    least = min(values)
    return least - k * math.log(sum(math.exp((least - v) / k) for v in values))


def ellipsoid(p, centre, radii):
    """Returns the approximate distance to an ellipsoid."""
    q = [(p[i] - centre[i]) / radii[i] for i in range(3)]
    k0 = math.sqrt(dot(q, q))
    k1 = math.sqrt(sum((q[i] / radii[i]) ** 2 for i in range(3)))
    return k0 * (k0 - 1) / k1 if k1 > 0 else -min(radii)


def tube(p, points, radii):
    """Returns the distance to a chain of capsules whose radius changes linearly from point to point."""
    best = math.inf
    for (a, ra), (b, rb) in zip(zip(points, radii), zip(points[1:], radii[1:])):
        d = sub(b, a)
        t = min(1.0, max(0.0, dot(sub(p, a), d) / dot(d, d)))
        q = sub(p, add(a, d, t))
        best = min(best, math.sqrt(dot(q, q)) - (ra + t * (rb - ra)))
    return best


def gradient(f, p, h):
    return tuple((f(add(p, e)) - f(add(p, e, -1))) / (2 * h) for e in ((h, 0, 0), (0, h, 0), (0, 0, h)))


CORNERS = [(i & 1, i >> 1 & 1, i >> 2 & 1) for i in range(8)]
EDGES = [(a, b) for a in range(8) for b in range(a + 1, 8) if bin(a ^ b).count("1") == 1]


def surface(f, low, high, h, rounds=12):
    """Returns the points and triangles of the surface f = 0 within the box, oriented outwards, with edges of about h."""
    counts = [int(math.ceil((high[k] - low[k]) / h)) + 1 for k in range(3)]
    # The grid is centred in the box, so that symmetric shapes stay symmetric.
    start = [(low[k] + high[k] - (counts[k] - 1) * h) / 2 for k in range(3)]
    value = {}
    for z in range(counts[2]):
        for y in range(counts[1]):
            for x in range(counts[0]):
                value[x, y, z] = f((start[0] + x * h, start[1] + y * h, start[2] + z * h))

    vertex, points = {}, []
    for z in range(counts[2] - 1):
        for y in range(counts[1] - 1):
            for x in range(counts[0] - 1):
                v = [value[x + i, y + j, z + k] for i, j, k in CORNERS]
                if (min(v) < 0) == (max(v) < 0):
                    continue
                hits = []
                for a, b in EDGES:
                    if (v[a] < 0) != (v[b] < 0):
                        t = v[a] / (v[a] - v[b])
                        hits.append([CORNERS[a][k] + t * (CORNERS[b][k] - CORNERS[a][k]) for k in range(3)])
                mean = [sum(hit[k] for hit in hits) / len(hits) for k in range(3)]
                vertex[x, y, z] = len(points)
                points.append(tuple(start[k] + ((x, y, z)[k] + mean[k]) * h for k in range(3)))

    quads = []
    for (x, y, z), v in value.items():
        for axis in range(3):
            end = [x, y, z]
            end[axis] += 1
            if tuple(end) not in value or (v < 0) == (value[tuple(end)] < 0):
                continue
            i, j = (axis + 1) % 3, (axis + 2) % 3
            around = []
            for di, dj in ((-1, -1), (0, -1), (0, 0), (-1, 0)):
                cell = [x, y, z]
                cell[i] += di
                cell[j] += dj
                around.append(vertex[tuple(cell)])
            quads.append(around if v < 0 else around[::-1])
    return relaxed(f, points, quads, h, rounds)


def on_surface(f, p, h):
    for _ in range(3):
        g = gradient(f, p, 1e-4 * h)
        size = dot(g, g)
        if size > 0:
            step = max(-0.5 * h, min(0.5 * h, f(p) / math.sqrt(size)))
            p = add(p, g, -step / math.sqrt(size))
    return p


def relaxed(f, points, quads, h, rounds):
    """Evens out the points, splits each quad into two triangles along its shorter diagonal, and returns points and triangles."""
    around = [set() for _ in points]
    for quad in quads:
        for k in range(4):
            around[quad[k]].update((quad[k - 1], quad[(k + 1) % 4]))
    around = [sorted(ids) for ids in around]
    points = [on_surface(f, p, h) for p in points]
    for _ in range(rounds):
        moved = []
        for p, ids in zip(points, around):
            mean = tuple(sum(points[i][k] for i in ids) / len(ids) for k in range(3))
            pull = sub(mean, p)
            n = unit(gradient(f, p, 1e-4 * h))
            moved.append(add(p, add(pull, n, -dot(pull, n)), 0.6))
        points = [on_surface(f, p, h) for p in moved]
    triangles = []
    for a, b, c, d in quads:
        if math.dist(points[a], points[c]) <= math.dist(points[b], points[d]):
            triangles += [(a, b, c), (a, c, d)]
        else:
            triangles += [(a, b, d), (b, c, d)]
    return points, triangles


def write_obj(path, name, points, triangles):
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(f"# {name}: made by art/solids\no {name}\n")
        for p in points:
            file.write("v " + " ".join(f"{x:.5f}" for x in p) + "\n")
        for t in triangles:
            file.write("f " + " ".join(str(i + 1) for i in t) + "\n")
