"""Provides helpers that draw the sample pictures: smooth outlines, tapered limbs, cell patterns, SVG text.

Coordinates are pixels of the finished picture, with y down. Random numbers are seeded, so that all results are
reproducible."""
import math
import random


def fmt(v):
    return f"{v:.1f}".rstrip("0").rstrip(".")


def pt(p):
    return f"{fmt(p[0])} {fmt(p[1])}"


def _tangents(points, closed, tension):
    n = len(points)
    out = []
    for i in range(n):
        a = points[(i - 1) % n] if closed or i > 0 else points[i]
        b = points[(i + 1) % n] if closed or i < n - 1 else points[i]
        out.append(((b[0] - a[0]) * tension, (b[1] - a[1]) * tension))
    return out


def cubics(points, closed=True, tension=1 / 6):
    """Returns the Catmull-Rom spline through the points as cubic Beziers. A point (x, y, 'c') is a corner, where the tangent is zero."""
    flat = [(p[0], p[1]) for p in points]
    tangent = _tangents(flat, closed, tension)
    for i, p in enumerate(points):
        if len(p) > 2:
            tangent[i] = (0, 0)
    n = len(flat)
    pieces = []
    for i in range(n if closed else n - 1):
        j = (i + 1) % n
        a, b = flat[i], flat[j]
        length = math.dist(a, b)

        def limited(t):
            size = math.hypot(*t)
            return t if size <= 0.45 * length or size == 0 else (t[0] * 0.45 * length / size, t[1] * 0.45 * length / size)

        ta, tb = limited(tangent[i]), limited(tangent[j])
        pieces.append((a, (a[0] + ta[0], a[1] + ta[1]), (b[0] - tb[0], b[1] - tb[1]), b))
    return pieces


def path_of(pieces, closed=True):
    text = "M" + pt(pieces[0][0])
    for _, b, c, d in pieces:
        text += f"C{pt(b)} {pt(c)} {pt(d)}"
    return text + ("Z" if closed else "")


def smooth(points, closed=True):
    """Returns the path data of the smooth curve through the points. Closed curves all get the same orientation, so that
    they unite in a clip path."""
    if closed and area(points) < 0:
        points = points[::-1]
    return path_of(cubics(points, closed), closed)


def sample(points, closed=True, steps=12):
    """Returns the smooth curve through the points as a polyline, with `steps` points per piece."""
    out = []
    for a, b, c, d in cubics(points, closed):
        for k in range(steps):
            t = k / steps
            s = 1 - t
            out.append(tuple(s**3 * a[i] + 3 * s * s * t * b[i] + 3 * s * t * t * c[i] + t**3 * d[i] for i in (0, 1)))
    if not closed:
        out.append((points[-1][0], points[-1][1]))
    return out


def limb(spine, cap_start=True, cap_end=True):
    """Returns the outline points of a limb whose spine points are (x, y, half width). The ends are rounded by default."""
    centre = [(p[0], p[1]) for p in spine]
    left, right = [], []
    n = len(spine)
    for i, (x, y, w) in enumerate(spine):
        a, b = centre[max(i - 1, 0)], centre[min(i + 1, n - 1)]
        length = math.dist(a, b) or 1
        nx, ny = -(b[1] - a[1]) / length, (b[0] - a[0]) / length
        left.append((x + nx * w, y + ny * w))
        right.append((x - nx * w, y - ny * w))

    def cap(tip, towards, w):
        length = math.dist(tip, towards) or 1
        ux, uy = (tip[0] - towards[0]) / length, (tip[1] - towards[1]) / length
        c = math.sqrt(0.5) * w
        return [(tip[0] + ux * c - uy * c, tip[1] + uy * c + ux * c), (tip[0] + ux * w, tip[1] + uy * w),
                (tip[0] + ux * c + uy * c, tip[1] + uy * c - ux * c)]

    outline = list(left)
    if cap_end:
        outline += cap(centre[-1], centre[-2], spine[-1][2])
    outline += right[::-1]
    if cap_start:
        outline += cap(centre[0], centre[1], spine[0][2])
    return outline


def inside(p, polygon):
    x, y = p
    result = False
    j = len(polygon) - 1
    for i in range(len(polygon)):
        (xi, yi), (xj, yj) = polygon[i], polygon[j]
        if (yi > y) != (yj > y) and x < (xj - xi) * (y - yi) / (yj - yi) + xi:
            result = not result
        j = i
    return result


def distance_to(p, polygon):
    best = 1e9
    for i in range(len(polygon)):
        a, b = polygon[i - 1], polygon[i]
        dx, dy = b[0] - a[0], b[1] - a[1]
        t = max(0, min(1, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy or 1)))
        best = min(best, math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy))
    return best


def scatter(box, radius, keep, seed, tries=6000):
    """Returns Poisson-disk points in the box where keep(p) is true, with the local spacing radius(p)."""
    rng = random.Random(seed)
    out = []
    for _ in range(tries):
        p = (rng.uniform(box[0], box[2]), rng.uniform(box[1], box[3]))
        if not keep(p):
            continue
        r = radius(p)
        if all(math.dist(p, q) > 0.5 * (r + s) for q, s in out):
            out.append((p, r))
    return [p for p, _ in out]


def _clip(polygon, point, normal):
    """Returns the part of a convex polygon with (x - point)·normal <= 0."""
    out = []
    for i in range(len(polygon)):
        a, b = polygon[i - 1], polygon[i]
        da = (a[0] - point[0]) * normal[0] + (a[1] - point[1]) * normal[1]
        db = (b[0] - point[0]) * normal[0] + (b[1] - point[1]) * normal[1]
        if (da <= 0) != (db <= 0):
            t = da / (da - db)
            out.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))
        if db <= 0:
            out.append(b)
    return out


def cells(seeds, gap, reach):
    """Returns the Voronoi cells of the seeds, within reach(seed), shrunk so that a joint of width gap(seed) remains between neighbours."""
    out = []
    for s in seeds:
        r = reach(s)
        polygon = [(s[0] + r * math.cos(k * math.pi / 8), s[1] + r * math.sin(k * math.pi / 8)) for k in range(16)]
        for o in seeds:
            d = math.dist(s, o)
            if o is s or d > 2.2 * r:
                continue
            normal = ((o[0] - s[0]) / d, (o[1] - s[1]) / d)
            half = d / 2 - gap(s) / 2
            polygon = _clip(polygon, (s[0] + normal[0] * half, s[1] + normal[1] * half), normal)
        if len(polygon) > 2:
            out.append(polygon)
    return out


def area(polygon):
    return 0.5 * sum(polygon[i - 1][0] * polygon[i][1] - polygon[i][0] * polygon[i - 1][1] for i in range(len(polygon)))


def rounded(polygon, radius):
    """Returns the path data of a polygon with rounded corners."""
    short = [p for i, p in enumerate(polygon) if math.dist(p, polygon[i - 1]) > 4]
    if len(short) < 3:
        return ""
    text = ""
    n = len(short)
    for i in range(n):
        a, b, c = short[i - 1], short[i], short[(i + 1) % n]
        ra, rc = min(radius, math.dist(a, b) * 0.48), min(radius, math.dist(b, c) * 0.48)
        la, lc = math.dist(a, b), math.dist(b, c)
        p = (b[0] + (a[0] - b[0]) * ra / la, b[1] + (a[1] - b[1]) * ra / la)
        q = (b[0] + (c[0] - b[0]) * rc / lc, b[1] + (c[1] - b[1]) * rc / lc)
        text += ("L" if text else "M") + pt(p) + f"Q{pt(b)} {pt(q)}"
    return text + "Z"


def mirrored(points, axis):
    return [(2 * axis - p[0],) + tuple(p[1:]) for p in points]


class Picture:
    """An SVG picture, which collects the lines of its defs and of its body separately."""

    def __init__(self, width, height, title):
        self.size, self.title = (width, height), title
        self.defs, self.body = [], []

    def gradient(self, name, kind, geometry, stops):
        inner = "".join(
            f'<stop offset="{o}" stop-color="{c}"' + (f' stop-opacity="{a}"' if a != 1 else "") + "/>"
            for o, c, a in [(s + (1,))[:3] for s in stops])
        self.defs.append(f'<{kind}Gradient id="{name}" gradientUnits="userSpaceOnUse" {geometry}>{inner}</{kind}Gradient>')

    def clip(self, name, *paths):
        self.defs.append(f'<clipPath id="{name}">' + "".join(f'<path d="{p}"/>' for p in paths) + "</clipPath>")

    def blur(self, name, radius):
        self.defs.append(f'<filter id="{name}" filterUnits="userSpaceOnUse" x="0" y="0" '
                         f'width="{self.size[0]}" height="{self.size[1]}">'
                         f'<feGaussianBlur stdDeviation="{radius}"/></filter>')

    def path(self, d, **style):
        attributes = "".join(f' {k.replace("_", "-")}="{v}"' for k, v in style.items())
        self.body.append(f'<path d="{d}"{attributes}/>')

    def circle(self, x, y, r, **style):
        self.ellipse(x, y, r, r, **style)

    def ellipse(self, x, y, rx, ry, turn=0, **style):
        attributes = "".join(f' {k.replace("_", "-")}="{v}"' for k, v in style.items())
        turned = f' transform="rotate({fmt(turn)} {pt((x, y))})"' if turn else ""
        self.body.append(f'<ellipse cx="{fmt(x)}" cy="{fmt(y)}" rx="{fmt(rx)}" ry="{fmt(ry)}"{turned}{attributes}/>')

    def open(self, **style):
        self.body.append("<g" + "".join(f' {k.replace("_", "-")}="{v}"' for k, v in style.items()) + ">")

    def close(self):
        self.body.append("</g>")

    def outline(self, paths, colour, width):
        """Draws one common outline around shapes that are filled afterwards: the fills hide the inner half of the strokes."""
        for d in paths:
            self.path(d, fill=colour, stroke=colour, stroke_width=2 * width, stroke_linejoin="round")

    def write(self, name):
        w, h = self.size
        with open(name, "w", encoding="utf-8") as file:
            file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" viewBox="0 0 {w} {h}">\n'
                       f"<title>{self.title}</title>\n<defs>\n" + "\n".join(self.defs) + "\n</defs>\n" +
                       "\n".join(self.body) + "\n</svg>\n")
