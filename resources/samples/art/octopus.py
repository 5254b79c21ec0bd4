"""Draws octopus.svg: an octopus whose eight arms with suckers do not touch each other."""
import math
import sys

from draw import Picture, limb, smooth

INK = "#4b1c4e"
LINE = 11
HEAD = [(1200, 250), (1400, 282), (1560, 390), (1640, 560), (1640, 740), (1580, 900), (1500, 1010), (1490, 1120), (1540, 1240), (1480, 1350),
        (1200, 1400)]
HEAD = HEAD + [(2400 - x, y) for x, y in HEAD[-2:0:-1]]
# start x, y, width, direction (degrees; 0 is right, 90 is down), length, bend of the first half, bend of the second half (degrees)
ARMS = [(1490, 1180, 92, 4, 880, -55, -340), (1490, 1260, 88, 18, 960, 24, -300), (1420, 1310, 86, 50, 1040, 36, -290), (1262, 1340, 84, 88, 800, 14, -320),
        (910, 1180, 92, 176, 840, 70, 320), (910, 1260, 88, 163, 980, -30, 290), (980, 1310, 86, 131, 1060, -38, 300), (1138, 1340, 84, 92, 860, -16, 320)]


def spine(x, y, width, direction, length, first, second):
    """Returns the points (x, y, half width) of an arm whose direction changes slowly at first and curls up at the tip."""
    steps = 26
    out = []
    angle = math.radians(direction)
    for k in range(steps + 1):
        t = k / steps
        out.append((x, y, width * (1 - t) ** 0.8 * 0.93 + width * 0.11))
        rate = math.radians(first) * 1.6 * max(0, 1 - 1.25 * t) + math.radians(second) * 3 * t * t
        angle += rate / steps
        x += math.cos(angle) * length / steps
        y += math.sin(angle) * length / steps
    return out


def side(points, k, amount):
    a, b = points[max(k - 1, 0)], points[min(k + 1, len(points) - 1)]
    length = math.dist(a[:2], b[:2]) or 1
    n = (-(b[1] - a[1]) / length, (b[0] - a[0]) / length)
    x, y, w = points[k]
    return (x + n[0] * w * amount, y + n[1] * w * amount)


def arm(p, index, entry):
    points = spine(*entry)
    d = smooth(limb(points, cap_start=False))
    p.outline([d], INK, LINE)
    p.path(d, fill="url(#skin)")
    p.clip(f"arm{index}", d)
    # The suckers are on the inner side of the curl
    inner = 1 if entry[6] > 0 else -1
    p.open(clip_path=f"url(#arm{index})")
    band = [side(points, k, inner * 0.35) for k in range(len(points))] + [side(points, k, inner * 1.2) for k in reversed(range(len(points)))]
    p.path(smooth(band), fill="#ffc9b8", opacity=0.85)
    outer = [side(points, k, -inner * 0.45) for k in range(1, len(points) - 1)]
    p.path(smooth(outer, closed=False), fill="none", stroke="#ffe3cf", stroke_width=22, stroke_linecap="round", opacity=0.45, filter="url(#soft)")
    edge = [side(points, k, inner * 1.0) for k in range(len(points))]
    p.path(smooth(edge, closed=False), fill="none", stroke="#8a2f78", stroke_width=26, opacity=0.35, filter="url(#soft)")
    p.close()
    travelled, nextSucker = 0.0, 70.0
    for k in range(1, len(points) - 2):
        travelled += math.dist(points[k][:2], points[k - 1][:2])
        if travelled < nextSucker:
            continue
        w = points[k][2]
        x, y = side(points, k, inner * 0.52)
        r = max(8, w * 0.27)
        p.circle(x, y, r, fill="#fff1ea")
        p.circle(x, y, r * 0.55, fill="#d9628c")
        nextSucker = travelled + max(34, w * 1.0)


def face(p):
    p.open(clip_path="url(#head)")
    p.ellipse(1080, 470, 330, 200, -18, fill="#fff0d8", opacity=0.55, filter="url(#softer)")
    p.path("M1660 420L1700 900L1560 1420L820 1420L840 1220Q1200 1400 1420 1120Q1580 900 1560 560Z", fill="#7d2a7c", opacity=0.34, filter="url(#softer)")
    for x, y, rx, ry, turn in ((985, 360, 34, 26, -20), (1075, 318, 22, 17, -10), (935, 452, 22, 18, -30), (1390, 420, 40, 30, 24), (1462, 506, 26, 20, 30),
                               (1330, 352, 20, 16, 10), (1200, 430, 24, 18, 0), (1500, 640, 22, 17, 60)):
        p.ellipse(x, y, rx, ry, turn, fill="#c93f80", opacity=0.55)
    for x in (890, 1510):
        p.ellipse(x, 1000, 78, 46, 0, fill="#ff6f7d", opacity=0.6, filter="url(#soft)")
    p.close()
    for s in (-1, 1):
        x, y = 1200 + s * 205, 850
        p.ellipse(x, y, 142, 158, 0, fill=INK)
        p.ellipse(x, y + 4, 130, 145, 0, fill="#fffaf4")
        p.ellipse(x - s * 16, y + 14, 98, 114, 0, fill="url(#iris)")
        p.ellipse(x - s * 18, y + 14, 66, 82, 0, fill="#1d0b22")
        p.circle(x - s * 18 - 36, y - 36, 36, fill="#ffffff")
        p.circle(x - s * 18 + 34, y + 62, 16, fill="#ffffff", opacity=0.9)
        p.path(f"M{x - 146} {y - 40}Q{x - 120} {y - 158} {x} {y - 160}Q{x + 120} {y - 158} {x + 146} {y - 40}", fill="none", stroke=INK, stroke_width=18,
               stroke_linecap="round")
    p.path("M1120 1082Q1200 1164 1280 1082Q1200 1104 1120 1082Z", fill="#8e1f4f", stroke=INK, stroke_width=12, stroke_linejoin="round")
    p.path("M1160 1122Q1200 1108 1240 1122Q1200 1146 1160 1122Z", fill="#ff8a8f")


def main(target):
    p = Picture(2400, 2400, "Octopus")
    p.gradient("skin", "radial", 'cx="1120" cy="560" r="1500"', [(0, "#ffb38a"), (0.3, "#ff8577"), (0.55, "#ee5f85"), (1, "#a83f96")])
    p.gradient("iris", "linear", 'x1="0" y1="740" x2="0" y2="980"', [(0, "#2e9db0"), (1, "#7fe0d0")])
    p.blur("soft", 16)
    p.blur("softer", 60)
    head = smooth(HEAD)
    p.clip("head", head)
    for i, entry in enumerate(ARMS):
        arm(p, i, entry)
    p.outline([head], INK, LINE)
    p.path(head, fill="url(#skin)")
    face(p)
    p.write(target)


main(sys.argv[1])
