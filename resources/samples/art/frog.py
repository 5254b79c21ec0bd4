"""Draws frog.svg: a frog from above, with elbows and knees nearly touching and narrow gaps between thigh, shank and body."""
import math
import sys

from draw import Picture, fmt, limb, mirrored, rounded, sample, smooth

INK = "#173f2b"
LINE = 11
AXIS = 1200

BODY = [(1200, 470), (1330, 492), (1450, 566), (1528, 690), (1532, 800), (1508, 900), (1522, 1040), (1500, 1210), (1430, 1390), (1330, 1530),
        (1200, 1585)]
BODY = BODY + [(2 * AXIS - x, y) for x, y in BODY[-2:0:-1]]
UPPER_ARM = [(960, 880, 84), (860, 968, 84), (770, 1046, 74), (700, 1104, 64)]
FOREARM = [(700, 1104, 64), (640, 1010, 66), (588, 890, 56), (560, 790, 45)]
THIGH = [(1090, 1440, 110), (930, 1408, 126), (770, 1350, 116), (640, 1294, 88), (590, 1270, 78)]
SHANK = [(590, 1270, 78), (640, 1402, 84), (740, 1540, 74), (830, 1640, 54), (870, 1690, 46)]
FOOT = [(870, 1690, 46), (800, 1776, 46), (716, 1852, 46), (650, 1900, 50)]
FINGERS = [(-158, 178, 0), (-118, 200, 0), (-84, 206, 0), (-44, 176, 0)]
TOES = [(176, 205), (150, 262), (122, 268), (92, 220), (58, 168)]


def digits(root, fan, width):
    """Returns the paths and the pad centres of slightly bent fingers or toes, given as (angle in degrees, length) from the root."""
    bones, pads = [], []
    for entry in fan:
        a, length = math.radians(entry[0]), entry[1]
        ux, uy = math.cos(a), math.sin(a)
        tip = (root[0] + ux * length, root[1] + uy * length)
        bend = 0.06 * length * (1 if math.cos(a) < -0.2 else -0.4)
        middle = (root[0] + ux * length * 0.55 - uy * bend, root[1] + uy * length * 0.55 + ux * bend)
        bones.append(smooth(limb([(root[0], root[1], width * 1.25), (middle[0], middle[1], width), (tip[0], tip[1], width * 0.92)])))
        pads.append((tip[0] + ux * 6, tip[1] + uy * 6))
    return bones, pads


def circle(x, y, r):
    k = 8
    return smooth([(x + r * math.cos(2 * math.pi * i / k), y + r * math.sin(2 * math.pi * i / k)) for i in range(k)])


def extremity(p, root, fan, width, pad, limbs):
    """Draws a hand or foot with its digits. `limbs` are pairs (path, fill) that share its outline."""
    bones, pads = digits(root, fan, width)
    discs = [circle(x, y, pad) for x, y in pads]
    p.outline(bones + discs + [d for d, _ in limbs], INK, LINE)
    for d in bones:
        p.path(d, fill="url(#toe)")
    for (x, y), d in zip(pads, discs):
        p.path(d, fill="url(#toe)")
        p.ellipse(x - pad * 0.26, y - pad * 0.3, pad * 0.4, pad * 0.28, -25, fill="#ffe0b0", opacity=0.85)
    for d, fill in limbs:
        p.path(d, fill=fill)


def gleam(p, spine, shift, width, opacity):
    """Draws a soft highlight along a limb."""
    line = [(x + shift[0] * w, y + shift[1] * w) for x, y, w in spine]
    p.path(smooth(line, closed=False), fill="none", stroke="#d9f59a", stroke_width=width, stroke_linecap="round", opacity=opacity, filter="url(#soft)")


def shade(p, spine, shift, width, opacity):
    line = [(x + shift[0] * w, y + shift[1] * w) for x, y, w in spine]
    p.path(smooth(line, closed=False), fill="none", stroke="#0d4a3c", stroke_width=width, stroke_linecap="round", opacity=opacity, filter="url(#soft)")


def bars(p, spine, places, colour, side):
    """Draws cross bars on a limb, like those on a tree frog's thigh."""
    for place in places:
        i = min(int(place), len(spine) - 2)
        t = place - i
        a, b = spine[i], spine[i + 1]
        x, y, w = (a[k] + t * (b[k] - a[k]) for k in range(3))
        length = math.hypot(b[0] - a[0], b[1] - a[1])
        ux, uy = (b[0] - a[0]) / length, (b[1] - a[1]) / length
        n = (-uy, ux) if side == "left" else (uy, -ux)
        points = [(x + n[0] * s * w + ux * d, y + n[1] * s * w + uy * d) for s, d in
                  ((-1.1, -16), (-0.2, -20), (0.28, 0), (-0.2, 22), (-1.1, 18))]
        p.path(rounded(points, 22), fill=colour, opacity=0.55)


def leg(p, side):
    flip = (lambda s: s) if side == "left" else (lambda s: mirrored(s, AXIS))
    thigh, shank, foot = flip(THIGH), flip(SHANK), flip(FOOT)
    dt, ds, df = smooth(limb(thigh)), smooth(limb(shank)), smooth(limb(foot))
    root = (foot[-1][0], foot[-1][1])
    fan = TOES if side == "left" else [(180 - a, n) for a, n in TOES]
    extremity(p, root, fan, 23, 42, [(df, f"url(#foot-{side})")])
    p.outline([ds], INK, LINE)
    p.path(ds, fill="url(#limb)")
    p.clip(f"shank-{side}", ds)
    p.open(clip_path=f"url(#shank-{side})")
    bars(p, shank, (0.9, 1.7, 2.5), "#1f7a4a", side)
    shade(p, shank, (-0.4, 0.9) if side == "left" else (0.4, 0.9), 40, 0.5)
    gleam(p, shank, (-0.35, -0.2), 34, 0.55)
    p.close()
    p.outline([dt], INK, LINE)
    p.path(dt, fill="url(#limb)")
    p.clip(f"thigh-{side}", dt)
    p.open(clip_path=f"url(#thigh-{side})")
    bars(p, thigh, (0.9, 1.6, 2.3, 3.1), "#1f7a4a", side)
    shade(p, thigh, (0.1, 0.95), 56, 0.5)
    gleam(p, thigh, (-0.05, -0.45), 48, 0.6)
    p.close()


def arm(p, side):
    flip = (lambda s: s) if side == "left" else (lambda s: mirrored(s, AXIS))
    upper, fore = flip(UPPER_ARM), flip(FOREARM)
    du, df = smooth(limb(upper)), smooth(limb(fore))
    root = (fore[-1][0] , fore[-1][1] - 12)
    fan = FINGERS if side == "left" else [(180 - a, n, 0) for a, n, _ in FINGERS]
    extremity(p, root, fan, 24, 43, [(du, "url(#limb)"), (df, "url(#arm)")])
    p.clip(f"arm-{side}", du, df)
    p.open(clip_path=f"url(#arm-{side})")
    shade(p, upper, (0.1, 0.95), 40, 0.5)
    shade(p, fore, (0.95 if side == "left" else -0.95, 0.1), 34, 0.4)
    bars(p, fore, (0.8, 1.5), "#1f7a4a", side)
    gleam(p, upper, (-0.1, -0.4), 34, 0.6)
    gleam(p, fore, (-0.4, 0), 30, 0.6)
    p.close()


def back(p, body):
    p.open(clip_path="url(#body)")
    # Flanks: a blue band with cream bars, visible at the edge
    for side in (-1, 1):
        band = [(AXIS + side * x, y) for x, y in ((345, 905), (290, 985), (268, 1120), (276, 1270), (244, 1420), (120, 1590), (420, 1640), (480, 1000))]
        p.path(smooth(band), fill="url(#flank)")
        for k, y in enumerate((1010, 1095, 1180, 1265, 1350, 1432)):
            x0 = (278, 266, 266, 270, 266, 236)[k]
            p.path(smooth(limb([(AXIS + side * (x0 + 4), y + 10, 15), (AXIS + side * (x0 + 34), y - 4, 15), (AXIS + side * (x0 + 90), y - 16, 16)])), fill="#f4e7a1")
        p.path(smooth([(AXIS + side * x, y) for x, y in ((345, 905), (290, 985), (268, 1120), (276, 1270), (244, 1420), (120, 1590))], closed=False),
               fill="none", stroke="#f4e7a1", stroke_width=13, stroke_linecap="round")
    # Light from above, shade at the rump and the sides
    p.ellipse(1130, 700, 250, 190, -12, fill="#e4fba0", opacity=0.6, filter="url(#softer)")
    p.ellipse(1150, 1130, 120, 290, 2, fill="#dcf89a", opacity=0.42, filter="url(#softer)")
    p.path("M1530 640L1560 1300L1200 1660L840 1400L1000 1480Q1200 1600 1360 1400Q1500 1180 1440 880Z", fill="#0d4a3c", opacity=0.3, filter="url(#softer)")
    # Spots in rows along the back
    spots = [(1092, 935, 40, 30, 10), (1308, 935, 40, 30, -10), (1050, 1062, 46, 36, 14), (1350, 1062, 46, 36, -14), (1200, 1010, 36, 30, 0),
             (1140, 1160, 38, 32, -8), (1262, 1160, 38, 32, 8), (1046, 1230, 38, 34, 10), (1356, 1230, 38, 34, -10), (1200, 1278, 34, 34, 0),
             (1110, 1360, 36, 32, 0), (1290, 1360, 36, 32, 0), (1200, 1440, 34, 28, 0), (1200, 870, 26, 20, 0)]
    for x, y, rx, ry, turn in spots:
        p.ellipse(x, y, rx, ry, turn, fill="#1f7a4a", opacity=0.8)
        p.ellipse(x - rx * 0.2, y - ry * 0.28, rx * 0.5, ry * 0.34, turn, fill="#62bf5c", opacity=0.6)
    p.close()


def eye(p, side):
    x, y = AXIS + side * 246, 640
    p.outline([circle(x, y, 132)], INK, LINE)
    p.path(circle(x, y, 132), fill="url(#lid)" if side < 0 else "url(#lid2)")
    ex, ey = x + side * 16, y - 10
    p.circle(ex, ey, 104, fill=INK)
    p.circle(ex, ey, 94, fill=f"url(#iris{'L' if side < 0 else 'R'})")
    p.circle(ex, ey, 94, fill="none", stroke="#8e1f1c", stroke_width=10, opacity=0.6)
    p.ellipse(ex, ey - 2, 50, 66, side * 8, fill="#120b0d")
    p.ellipse(ex - 26, ey - 36, 24, 27, 0, fill="#ffffff")
    p.ellipse(ex + 26, ey + 38, 11, 12, 0, fill="#ffffff", opacity=0.85)
    p.path(f"M{fmt(ex - 100)} {fmt(ey - 22)}Q{fmt(ex - 70)} {fmt(ey - 104)} {fmt(ex)} {fmt(ey - 104)}Q{fmt(ex + 72)} {fmt(ey - 104)} {fmt(ex + 100)} {fmt(ey - 22)}",
           fill="none", stroke=INK, stroke_width=15, stroke_linecap="round")


def face(p):
    for side in (-1, 1):
        p.ellipse(AXIS + side * 44, 560, 13, 9, side * 24, fill=INK)
        p.ellipse(AXIS + side * 214, 838, 62, 34, side * -10, fill="#ffb36b", opacity=0.5, filter="url(#soft)")
    p.path("M1056 748Q1118 806 1200 806Q1282 806 1344 748", fill="none", stroke=INK, stroke_width=13, stroke_linecap="round")
    p.path("M1040 760Q1046 744 1066 740M1360 760Q1354 744 1334 740", fill="none", stroke=INK, stroke_width=12, stroke_linecap="round")


def main(target):
    p = Picture(2400, 2400, "Frog")
    p.gradient("skin", "radial", 'cx="1120" cy="820" r="860"', [(0, "#a4dd55"), (0.45, "#6fc84c"), (1, "#2f9a50")])
    p.gradient("limb", "radial", 'cx="1200" cy="1000" r="820"', [(0, "#5fbd4b"), (0.6, "#6cc64d"), (1, "#a4d950")])
    p.gradient("arm", "linear", 'x1="0" y1="1120" x2="0" y2="790"', [(0, "#6cc64d"), (0.55, "#a7d650"), (0.95, "#f79a3c"), (1, "#f79a3c")])
    p.gradient("foot-left", "linear", 'x1="880" y1="1680" x2="660" y2="1890"', [(0, "#93d050"), (0.5, "#dcbf49"), (1, "#f79a3c")])
    p.gradient("foot-right", "linear", 'x1="1520" y1="1680" x2="1740" y2="1890"', [(0, "#93d050"), (0.5, "#dcbf49"), (1, "#f79a3c")])
    p.gradient("toe", "radial", 'cx="1200" cy="1300" r="1150"', [(0, "#f9b04a"), (0.7, "#f79a3c"), (1, "#ee7a30")])
    p.gradient("flank", "linear", 'x1="0" y1="920" x2="0" y2="1600"', [(0, "#3d8fc9"), (1, "#2c5fa8")])
    for name, x in (("lid", 900), ("lid2", 1390)):
        p.gradient(name, "radial", f'cx="{x}" cy="580" r="230"', [(0, "#b9e868"), (0.6, "#74c94e"), (1, "#3ca552")])
    for name, x in (("irisL", 938), ("irisR", 1462)):
        p.gradient(name, "radial", f'cx="{x}" cy="660" r="110"', [(0, "#ffb13d"), (0.55, "#f4612d"), (1, "#c42a25")])
    p.blur("soft", 20)
    p.blur("softer", 50)
    body = smooth(BODY)
    p.clip("body", body)
    for side in ("left", "right"):
        leg(p, side)
    for side in ("left", "right"):
        arm(p, side)
    p.outline([body], INK, LINE)
    p.path(body, fill="url(#skin)")
    back(p, body)
    eye(p, -1)
    eye(p, 1)
    face(p)
    p.write(target)


main(sys.argv[1])
