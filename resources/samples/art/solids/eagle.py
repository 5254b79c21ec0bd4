"""Writes the eagle: a body, a neck, a head with a beak, a fanned tail and two wings, which blend smoothly. Usage: eagle.py OUT.obj

The x axis points sideways, y ahead and z up."""
import math
import sys

from implicit import ellipsoid, smooth_union, surface, tube, write_obj


def spline(keys, u):
    """Returns the values at u of a smooth curve through (u, values) keys: cubics whose slopes come from the neighbouring keys."""
    for i in range(len(keys) - 1):
        (u0, a), (u1, b) = keys[i], keys[i + 1]
        if u > u1:
            continue
        before, after = keys[max(i - 1, 0)], keys[min(i + 2, len(keys) - 1)]
        t = (u - u0) / (u1 - u0)
        values = []
        for k in range(len(a)):
            m0 = (b[k] - before[1][k]) / (u1 - before[0]) * (u1 - u0)
            m1 = (after[1][k] - a[k]) / (after[0] - u0) * (u1 - u0)
            values.append(
                (1 + 2 * t) * (1 - t) ** 2 * a[k]
                + t * (1 - t) ** 2 * m0
                + t * t * (3 - 2 * t) * b[k]
                + t * t * (t - 1) * m1
            )
        return values
    return keys[-1][1]


# Keys along the span: forward and upward offset, half chord, half thickness.
WING = [
    (0.15, (0.12, 0.10, 0.56, 0.19)),
    (0.75, (0.24, 0.28, 0.46, 0.165)),
    (1.35, (0.26, 0.38, 0.43, 0.14)),
    (1.95, (0.02, 0.34, 0.36, 0.12)),
    (2.40, (-0.30, 0.24, 0.22, 0.11)),
]
TAIL = [(-1.70, (0.10, 0.44, 0.105)), (-1.20, (0.06, 0.34, 0.11)), (-0.50, (0.02, 0.24, 0.18))]


def flat_part(along, first, last, across, up, half_width, half_height):
    """Returns the approximate distance to a leaf with an elliptic cross-section and rounded ends, negative inside."""
    over = max(first - along, 0.0, along - last)
    q = (across / half_width, up / half_height, over / half_height)
    k0 = math.sqrt(q[0] ** 2 + q[1] ** 2 + q[2] ** 2)
    k1 = math.sqrt((q[0] / half_width) ** 2 + (q[1] / half_height) ** 2 + (q[2] / half_height) ** 2)
    return k0 * (k0 - 1) / k1 if k1 > 0 else -half_height


def wing(p):
    x = abs(p[0])
    ahead, up, chord, thick = spline(WING, min(max(x, 0.15), 2.4))
    return flat_part(x, 0.0, 2.4, p[1] - ahead, p[2] - up, chord, thick)


def tail(p):
    up, wide, thick = spline(TAIL, min(max(p[1], -1.75), -0.55))
    return flat_part(p[1], -1.75, -0.4, p[0], p[2] - up, wide, thick)


def eagle(p):
    return smooth_union(
        [
            ellipsoid(p, (0, -0.05, 0), (0.38, 0.90, 0.36)),
            tube(p, [(0, 0.50, 0.08), (0, 0.95, 0.30)], [0.30, 0.22]),
            ellipsoid(p, (0, 1.08, 0.36), (0.21, 0.27, 0.20)),
            tube(p, [(0, 1.25, 0.36), (0, 1.46, 0.32), (0, 1.54, 0.22)], [0.13, 0.10, 0.08]),
            tail(p),
            wing(p),
        ],
        0.07,
    )


if __name__ == "__main__":
    write_obj(sys.argv[1], "eagle", *surface(eagle, (-2.8, -2.1, -0.7), (2.8, 1.9, 0.9), 0.08))
