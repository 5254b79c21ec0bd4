"""Writes the bar, a box of 9 by 1 by 1 with rounded edges. Usage: bar.py OUT.obj"""
import sys

LENGTH = 9
N = 5  # squares along a short side


def bar():
    ids, points, triangles = {}, [], []
    counts = (LENGTH * N, N, N)

    def vertex(at):
        if at not in ids:
            ids[at] = len(points)
            points.append(rounded([at[k] / N for k in range(3)]))
        return ids[at]

    for axis in range(3):
        i, j = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, 1):
            for u in range(counts[i]):
                for v in range(counts[j]):
                    def corner(du, dv):
                        at = [0, 0, 0]
                        at[axis], at[i], at[j] = side * counts[axis], u + du, v + dv
                        return vertex(tuple(at))
                    a, b, c, d = corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)
                    pair = [(a, b, c), (a, c, d)] if (u + v) % 2 else [(a, b, d), (b, c, d)]
                    triangles.extend(t if side else t[::-1] for t in pair)
    return points, triangles


def rounded(p, radius=0.2):
    """Returns the point of the rounded surface that belongs to a point on the surface of the sharp-edged box."""
    size = (LENGTH, 1, 1)
    core = [min(max(p[k], radius), size[k] - radius) for k in range(3)]
    off = [p[k] - core[k] for k in range(3)]
    length = sum(x * x for x in off) ** 0.5
    return tuple(core[k] + off[k] * radius / length for k in range(3)) if length > 0 else tuple(p)


if __name__ == "__main__":
    from implicit import write_obj
    write_obj(sys.argv[1], "bar", *bar())
