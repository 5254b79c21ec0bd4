"""Draws giraffe.svg."""
import sys

from draw import (Picture, area, cells, distance_to, inside, limb, rounded, sample, scatter, smooth)

INK, COAT_TOP, COAT, COAT_LOW = "#5a3220", "#f9d58b", "#f4c272", "#fbe6bd"
PATCH_TOP, PATCH, PATCH_LOW = "#a9572b", "#b9652f", "#d08a4c"
LINE = 11

TORSO = [(470, 1330), (520, 1235), (640, 1180), (790, 1150), (930, 1085), (1040, 1010), (1150, 1010), (1225, 1110), (1240, 1260),
         (1190, 1420), (1070, 1515), (900, 1560), (720, 1545), (560, 1530), (470, 1450)]
NECK = [(1060, 1260, 205), (1110, 1110, 165), (1170, 940, 128), (1225, 770, 108), (1270, 600, 97), (1308, 440, 90), (1345, 330, 96)]
HEAD = [(1290, 385), (1262, 300), (1290, 215), (1370, 172), (1460, 190), (1545, 240), (1630, 285), (1705, 318), (1748, 362),
        (1742, 425), (1690, 458), (1600, 462), (1510, 458), (1430, 470), (1350, 455)]
NEAR_FRONT = [(1085, 1330, 125), (1096, 1500, 100), (1104, 1640, 74), (1106, 1770, 58), (1106, 1850, 60), (1100, 1930, 47), (1098, 2080, 42),
              (1102, 2190, 48)]
NEAR_HIND = [(590, 1390, 165), (556, 1540, 128), (522, 1680, 86), (488, 1790, 60), (476, 1865, 56), (488, 1950, 45), (500, 2080, 42),
             (508, 2190, 48)]
FAR_FRONT = [(960, 1400, 105), (944, 1560, 86), (926, 1690, 64), (918, 1780, 54), (916, 1850, 56), (912, 1930, 44), (910, 2060, 39),
             (914, 2160, 45)]
FAR_HIND = [(720, 1420, 125), (718, 1570, 98), (704, 1690, 70), (682, 1790, 54), (674, 1855, 51), (684, 1940, 42), (692, 2060, 39),
            (698, 2160, 45)]
TAIL = [(505, 1300, 30), (440, 1350, 25), (395, 1450, 21), (372, 1570, 19), (362, 1680, 18)]
TUFT = [(340, 1668), (384, 1668), (398, 1740), (392, 1820), (352, 1905, "c"), (322, 1830), (318, 1740)]


def hoof(x, y):
    return [(x - 44, y - 56), (x + 44, y - 56), (x + 54, y - 10), (x + 66, y + 50), (x + 52, y + 60), (x - 46, y + 60), (x - 56, y + 50),
            (x - 50, y - 10)]


def hooves(picture, x, y, colour):
    picture.path(smooth(hoof(x, y)), fill=colour)
    picture.path(f"M{x + 12} {y + 10}Q{x + 20} {y + 36} {x + 20} {y + 60}", fill="none", stroke="#2c1710", stroke_width=8, stroke_linecap="round")
    picture.path(f"M{x - 36} {y - 40}Q{x} {y - 30} {x + 36} {y - 42}", fill="none", stroke="#8b5a42", stroke_width=9, stroke_linecap="round",
                 opacity=0.8)


def patches(body, neck):
    """Returns the cells of the coat pattern, which get smaller up the neck and down the legs."""
    polygons = [sample(s) for s in body]

    def size(p):
        if p[1] < 1100 and p[0] > 1000:
            return 62 + 44 * max(0, min(1, (p[1] - 380) / 720))
        return 112 if p[1] < 1480 else max(62, 112 - (p[1] - 1480) * 0.17)

    def keep(p):
        return any(inside(p, q) for q in polygons) or min(distance_to(p, q) for q in polygons) < 25

    seeds = scatter((380, 330, 1330, 2020), size, keep, seed=11, tries=9000)
    return [c for c in cells(seeds, gap=lambda p: 13 + size(p) * 0.075, reach=lambda p: size(p) * 0.78) if abs(area(c)) > 900]


def leg(picture, spine, x, y, colours, name):
    d = smooth(limb(spine))
    picture.outline([d, smooth(hoof(x, y))], INK, LINE)
    picture.path(d, fill=f"url(#{colours})")
    return d


def legs_behind(picture):
    shapes = [(FAR_FRONT, 918, 2206), (FAR_HIND, 702, 2206)]
    for i, (spine, x, y) in enumerate(shapes):
        d = leg(picture, spine, x, y, "far", f"far{i}")
        picture.clip(f"far{i}", d)
        outline = [limb(spine)]
        picture.open(clip_path=f"url(#far{i})")
        picture.open(mask="url(#socks)")
        polygons = [sample(s) for s in outline]
        seeds = scatter((580, 1480, 1080, 2050), lambda p: max(58, 100 - (p[1] - 1480) * 0.16),
                        lambda p: any(inside(p, q) or distance_to(p, q) < 20 for q in polygons), seed=5 + i)
        for c in cells(seeds, gap=lambda p: 17, reach=lambda p: 75):
            if abs(area(c)) > 700:
                picture.path(rounded(c, 18), fill="#935029")
        picture.close()
        picture.path("M500 1400H1150V1700Q800 1640 500 1700Z", fill="#3d1d10", opacity=0.3, filter="url(#soft)")
        picture.close()
        hooves(picture, x, y, "#3a2118")


def tail(picture):
    d, t = smooth(limb(TAIL)), smooth(TUFT)
    picture.outline([d, t], INK, LINE)
    picture.path(d, fill="#eeb766")
    picture.path(t, fill="#4a281b")
    picture.path("M352 1720Q346 1790 352 1850M372 1720Q374 1780 368 1820", fill="none", stroke="#8a573c", stroke_width=7, stroke_linecap="round")


def mane(picture):
    """Draws a tufted strip of hair behind the neck, along its back, and returns its path data."""
    outer, inner = [], []
    for k in range(23):
        t = k / 22
        y = 300 + t * 740
        x = 1252 - 265 * t ** 1.25 - (1 - t) * 4
        inner.append((x + 70, y))
        outer.append((x - (30 if k % 2 else 12) - 6, y + (18 if k % 2 else 0), "c"))
    points = outer + inner[::-1]
    d = smooth(points)
    picture.outline([d], INK, LINE)
    picture.path(d, fill="#7d4023")
    return d


def horns(picture):
    for x, dx, far in [(1418, 44, True), (1332, -8, False)]:
        stalk = smooth(limb([(x, 225, 24), (x + dx * 0.5, 150, 19), (x + dx, 92, 20)]))
        knob = smooth([(x + dx - 36, 78), (x + dx - 22, 48), (x + dx + 8, 40), (x + dx + 34, 58), (x + dx + 36, 88), (x + dx + 2, 106)])
        picture.outline([stalk, knob], INK, LINE)
        picture.path(stalk, fill="#dca45a" if far else "#f4c272")
        picture.path(knob, fill="#4a281b" if far else "#5d3321")
        if not far:
            picture.path(f"M{x + dx - 18} 66Q{x + dx - 4} 54 {x + dx + 12} 58", fill="none", stroke="#94603f", stroke_width=8, stroke_linecap="round")


def ear(picture):
    outer = smooth([(1300, 268), (1252, 236), (1190, 196), (1120, 190, "c"), (1138, 250), (1190, 306), (1262, 320)])
    picture.outline([outer], INK, LINE)
    picture.path(outer, fill="url(#coat)")
    picture.path(smooth([(1272, 276), (1225, 240), (1150, 208, "c"), (1180, 258), (1225, 292)]), fill="#d98f6e")
    picture.path(smooth([(1272, 282), (1225, 262), (1160, 216, "c"), (1190, 268), (1225, 294)]), fill="#b96a4d", opacity=0.7)


def face(picture):
    picture.open(clip_path="url(#headClip)")
    picture.ellipse(1690, 400, 150, 105, 14, fill="#fdebc8", filter="url(#soft)")
    picture.ellipse(1480, 500, 240, 60, 2, fill="#a8602c", opacity=0.35, filter="url(#soft)")
    picture.ellipse(1420, 170, 170, 40, 14, fill="#fff3d2", opacity=0.6, filter="url(#soft)")
    for c in [[(1270, 330), (1306, 318), (1330, 352), (1316, 400), (1278, 396)], [(1346, 372), (1386, 384), (1392, 424), (1350, 438), (1328, 410)],
              [(1536, 262), (1572, 272), (1580, 300), (1548, 308), (1524, 288)], [(1480, 214), (1512, 226), (1510, 250), (1482, 246)],
              [(1594, 298), (1624, 306), (1622, 328), (1596, 326)]]:
        picture.path(rounded(c, 16), fill="url(#patch)", opacity=0.9)
    picture.ellipse(1545, 408, 46, 30, 0, fill="#ee8f66", opacity=0.45, filter="url(#soft)")
    picture.close()
    # Eye: lids, white, iris, pupil, two highlights, lashes
    picture.path("M1392 300L1358 282M1402 272L1374 246M1424 252L1406 220", fill="none", stroke=INK, stroke_width=10, stroke_linecap="round")
    picture.ellipse(1446, 306, 62, 66, 8, fill=INK)
    picture.ellipse(1448, 312, 52, 55, 8, fill="#fffaf0")
    picture.ellipse(1458, 314, 42, 49, 8, fill="#6b3a1e")
    picture.ellipse(1460, 316, 30, 38, 8, fill="#21110b")
    picture.ellipse(1460, 342, 24, 14, 0, fill="#b9713c", opacity=0.55)
    picture.circle(1444, 294, 15, fill="#ffffff")
    picture.circle(1472, 336, 7, fill="#ffffff", opacity=0.9)
    picture.path("M1388 292Q1404 240 1452 240Q1496 244 1508 290", fill="none", stroke=INK, stroke_width=15, stroke_linecap="round")
    # Nostril and smile
    picture.ellipse(1704, 362, 17, 10, 38, fill=INK)
    picture.path("M1730 418Q1668 436 1604 414Q1582 404 1570 386", fill="none", stroke=INK, stroke_width=11, stroke_linecap="round")
    picture.path("M1556 396Q1570 376 1588 384", fill="none", stroke=INK, stroke_width=10, stroke_linecap="round")


def main(target):
    p = Picture(2400, 2400, "Giraffe")
    p.gradient("coat", "linear", 'x1="800" y1="180" x2="800" y2="2250"', [(0, COAT_TOP), (0.4, COAT), (0.7, "#f7cf8c"), (1, COAT_LOW)])
    p.gradient("far", "linear", 'x1="800" y1="1450" x2="800" y2="2250"', [(0, "#c98d49"), (0.5, "#dcab68"), (1, "#e9c795")])
    p.gradient("patch", "linear", 'x1="800" y1="350" x2="800" y2="2000"', [(0, PATCH), (0.45, PATCH_TOP), (0.7, PATCH), (1, PATCH_LOW)])
    p.gradient("sockFade", "linear", 'x1="0" y1="1760" x2="0" y2="1990"', [(0, "#fff"), (1, "#000")])
    p.defs.append('<mask id="socks" maskUnits="userSpaceOnUse" x="0" y="0" width="2400" height="2400">'
                  '<rect width="2400" height="2400" fill="url(#sockFade)"/></mask>')
    p.blur("soft", 26)
    p.blur("softer", 48)

    torso, neck, head = smooth(TORSO), smooth(limb(NECK)), smooth(HEAD)
    front, hind = smooth(limb(NEAR_FRONT)), smooth(limb(NEAR_HIND))
    p.clip("bodyClip", torso, neck, front, hind)
    p.clip("headClip", head)

    tail(p)
    legs_behind(p)
    mane(p)
    feet = [(1108, 2232), (514, 2232)]
    horns(p)
    p.outline([torso, neck, front, hind, head] + [smooth(hoof(*f)) for f in feet], INK, LINE)
    for d in (torso, neck, front, hind):
        p.path(d, fill="url(#coat)")
    p.open(clip_path="url(#bodyClip)")
    p.open(mask="url(#socks)")
    for c in patches([TORSO, limb(NECK), limb(NEAR_FRONT), limb(NEAR_HIND)], NECK):
        p.path(rounded(c, 30), fill="url(#patch)")
    p.close()
    # Light from the upper left, shade under the belly, along the throat and behind the legs
    p.path("M520 1560Q820 1640 1080 1560L1260 1380L1280 1220Q1180 1430 1000 1470Q760 1520 470 1450Z", fill="#7a3d18", opacity=0.36, filter="url(#softer)")
    p.path("M1290 1240Q1270 1060 1330 800Q1370 600 1400 440L1360 420Q1320 600 1270 780Q1210 1000 1240 1260Z", fill="#7a3d18", opacity=0.34,
           filter="url(#soft)")
    p.path("M500 1300Q620 1170 800 1150Q980 1080 1030 1000Q1120 860 1180 640L1210 480L1240 500Q1210 760 1120 960Q1000 1160 800 1200Q640 1230 530 1320Z",
           fill="#fff2cf", opacity=0.38, filter="url(#soft)")
    for x in (1150, 540):
        p.path(f"M{x} 1560L{x - 6} 1850L{x - 12} 2200L{x + 60} 2200L{x + 80} 1560Z", fill="#7a3d18", opacity=0.3, filter="url(#soft)")
    p.close()
    for f in feet:
        hooves(p, *f, "#4a2a1e")
    p.path(head, fill="url(#coat)")
    face(p)
    ear(p)
    p.write(target)


main(sys.argv[1])
