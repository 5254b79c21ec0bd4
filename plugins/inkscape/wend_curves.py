# SPDX-License-Identifier: AGPL-3.0-or-later
"""Samples cubic Bézier curves, which are tuples of four complex numbers, and fits curves to samples."""

SMOOTH = 1e-3  # maximum angle in radians between the tangents at a smooth node


def point(curve, u):
    a, b, c, d = curve
    v = 1 - u
    return v * v * v * a + 3 * v * v * u * b + 3 * v * u * u * c + u * u * u * d


def sampled(curve, spacing=2.0):
    """Returns points at equal parameter steps, about `spacing` apart, including both ends."""
    length = sum(abs(q - p) for p, q in zip(curve, curve[1:]))
    count = min(max(int(length / spacing) + 1, 8), 500)
    return [point(curve, k / count) for k in range(count + 1)]


def unit(vector):
    return vector / abs(vector) if vector else 0


def leaving(curve):
    """Returns the unit direction in which the curve leaves its first point, or 0 if the curve is a point."""
    return unit(next((p - curve[0] for p in curve[1:] if p != curve[0]), 0))


def arriving(curve):
    return -leaving(curve[::-1])


def is_smooth(before, after):
    a, b = arriving(before), leaving(after)
    turn = b * a.conjugate()
    return bool(a and b) and turn.real > 0 and abs(turn.imag) < SMOOTH


def _parameters(points):
    """Returns the chord length from the first point to each point, relative to the total length."""
    lengths = [0.0]
    for p, q in zip(points, points[1:]):
        lengths.append(lengths[-1] + abs(q - p))
    return [one / lengths[-1] for one in lengths]


def _least_squares(points, u, start, end):
    """Returns the cubic with the given end points and directions that is nearest to the points at the parameters u. The
    lengths a and b of its arms solve the normal equations of  Σ |B(uᵢ) − pᵢ|²."""
    first, last = points[0], points[-1]
    aa = ab = bb = ra = rb = 0.0
    for p, s in zip(points, u):
        v = 1 - s
        da, db = 3 * v * v * s * start, -3 * v * s * s * end
        rest = p - (v * v * (v + 3 * s) * first + s * s * (s + 3 * v) * last)
        aa += abs(da) ** 2
        bb += abs(db) ** 2
        ab += (da * db.conjugate()).real
        ra += (da * rest.conjugate()).real
        rb += (db * rest.conjugate()).real
    det = aa * bb - ab * ab
    chord = abs(last - first)
    a = b = chord / 3
    if det > 1e-12 * aa * bb:
        fitted = (ra * bb - rb * ab) / det, (rb * aa - ra * ab) / det
        if min(fitted) > 1e-3 * chord:
            a, b = fitted
    return first, first + a * start, last - b * end, last


def _nearer(curve, p, u):
    """Returns the parameter after one step of Newton's method from u towards the curve's point nearest to p."""
    a, b, c, d = curve
    v = 1 - u
    d1 = 3 * (v * v * (b - a) + 2 * v * u * (c - b) + u * u * (d - c))
    d2 = 6 * (v * (c - 2 * b + a) + u * (d - 2 * c + b))
    off = point(curve, u) - p
    slope = abs(d1) ** 2 + (off * d2.conjugate()).real
    return u if slope <= 0 else min(max(u - (off * d1.conjugate()).real / slope, 0.0), 1.0)


def fitted(points, start, end, tolerance):
    """Returns cubics from the first to the last point, with the given directions at the ends, that are within the
    tolerance of all points. If one cubic is not enough, splits at the worst point, where the two parts join smoothly."""
    points = [p for k, p in enumerate(points) if k == 0 or p != points[k - 1]]
    if len(points) < 2:
        return [(points[0],) * 4]
    u = _parameters(points)
    for _ in range(4):
        curve = _least_squares(points, u, start, end)
        errors = [abs(point(curve, s) - p) for s, p in zip(u, points)]
        worst = max(range(len(points)), key=errors.__getitem__)
        if errors[worst] <= tolerance or len(points) == 2:
            return [curve]
        u = [_nearer(curve, p, s) for p, s in zip(points, u)]
    worst = min(max(worst, 1), len(points) - 2)
    middle = unit(points[worst + 1] - points[worst - 1]) or unit(points[worst] - points[worst - 1])
    return fitted(points[: worst + 1], start, middle, tolerance) + fitted(points[worst:], middle, end, tolerance)


def bent(curves, images, closed, tolerance):
    """Returns curves fitted to `images`, the mapped samples of a chain of cubics. Smooth nodes stay smooth, and corners stay corners."""

    def join(k):  # returns the direction at the node before curve k, or 0 at a corner
        if (k == 0 and not closed) or not is_smooth(curves[k - 1], curves[k]):
            return 0
        return unit(images[k][1] - images[k - 1][-2])

    result = []
    for k, image in enumerate(images):
        after = (k + 1) % len(curves)
        start = join(k) or unit(image[1] - image[0])
        end = (join(after) if after or closed else 0) or unit(image[-1] - image[-2])
        result += fitted(image, start, end, tolerance)
    return result
