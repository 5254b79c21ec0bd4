"""Draws walker.svg, whose groups are the layers of walker.ora (layers.py), and writes the walk to walker.wend beside it.

The picture shows the start of the walk: the near leg is in front, with its heel on the ground, and the far leg is behind."""
import json
import math
import os
import sys

from draw import Picture, limb, smooth

INK, LINE = "#33263f", 9
COAT, COAT_LIGHT, COAT_DARK = "#f4bd3a", "#ffdd74", "#cf8f22"
CLOTH, CLOTH_FAR, BOOT, BOOT_FAR = "#4d6fb3", "#3c5690", "#c8473f", "#98343a"
SKIN, SKIN_LIGHT, HAIR = "#f2b98f", "#ffd9b8", "#6d3d2a"
GROUND, RISE = 1090, 34  # y of the soles on the ground; rise of the body
SCALE = 2  # pixels of the picture per unit of this drawing
HIP, SHOULDER, NECK = (560, 770), (562, 540), (585, 440)


def foot(phase):
    """Returns the middle of a boot's sole and its angle (positive: heel up) at a phase of its step: 0 to 0.5 on the
    ground, then in the air."""
    keys = [(0, 150, 0, -0.32), (0.08, 102, 0, 0), (0.38, -78, 0, 0), (0.5, -150, -24, 0.5), (0.62, -120, -92, 0.9), (0.78, 20, -78, 0.35),
            (0.9, 130, -40, -0.3), (1, 150, 0, -0.32)]
    for a, b in zip(keys, keys[1:]):
        if a[0] <= phase <= b[0]:
            s = (phase - a[0]) / (b[0] - a[0])
            x, y, angle = (p + s * (q - p) for p, q in zip(a[1:], b[1:]))
            return HIP[0] + x, GROUND + y, angle
    raise ValueError(phase)


def sole(phase, along, up=0):
    """Returns the point of the boot at the distance `along` towards its toe and `up` above its sole."""
    x, y, angle = foot(phase)
    lift = max(0, 52 * math.sin(angle), 40 * math.sin(-angle))  # the boot rotates about its toe or heel, not into the ground
    c, s = math.cos(angle), math.sin(angle)
    return x + along * c + up * s, y - lift + along * s - up * c


def hand(phase):
    """Returns the position of a hand at a phase of the leg on the same side, which the arm opposes."""
    swing = -math.cos(2 * math.pi * phase)
    angle = 0.8 * swing + 0.12
    length = 252 - 26 * (swing + 1)
    return SHOULDER[0] + length * math.sin(angle), SHOULDER[1] + length * math.cos(angle)


def leg(p, name, phase, cloth, boot, knee):
    ankle = sole(phase, -22, 84)
    spine = [(HIP[0], HIP[1] - 20, 66), (*((HIP[i] + knee[i]) / 2 for i in (0, 1)), 60), (*knee, 52),
             (*((knee[i] + ankle[i]) / 2 for i in (0, 1)), 46), (*ankle, 42)]
    d = smooth(limb(spine))
    shoe = [(-66, 4), (-70, 60), (-62, 120), (18, 122), (22, 84), (60, 66), (92, 44), (92, 6), (20, 0)]
    b = smooth([sole(phase, *place) for place in shoe])
    p.open(id=name)
    p.outline([d, b], INK, LINE)
    p.path(d, fill=cloth)
    p.path(b, fill=boot)
    p.path(smooth([sole(phase, *place) for place in [(-70, 100), (-66, 128), (24, 130), (22, 104)]]), fill="#f3e6d2", stroke=INK, stroke_width=6)
    heel, toe = sole(phase, -66, 12), sole(phase, 92, 12)
    p.path(f"M{heel[0]:.1f} {heel[1]:.1f}L{toe[0]:.1f} {toe[1]:.1f}", fill="none", stroke=INK, stroke_width=12, stroke_linecap="round", opacity=0.45)
    p.close()


def arm(p, name, phase, sleeve, skin, elbow):
    h = hand(phase)
    wrist = tuple(h[i] + 0.16 * (elbow[i] - h[i]) for i in (0, 1))
    d = smooth(limb([(*SHOULDER, 56), (*((SHOULDER[i] + elbow[i]) / 2 for i in (0, 1)), 50), (*elbow, 44), (*wrist, 38)]))
    palm = smooth([(h[0] + 36 * math.cos(k * math.pi / 4), h[1] + 40 * math.sin(k * math.pi / 4)) for k in range(8)])
    p.open(id=name)
    p.outline([d, palm], INK, LINE)
    p.path(palm, fill=skin)
    p.path(d, fill=sleeve)
    p.close()


def body(p):
    coat = smooth([(500, 470), (560, 440), (635, 462), (672, 540), (684, 660), (712, 800), (690, 838), (560, 852), (430, 838), (410, 800),
                   (440, 660), (452, 540)])
    p.open(id="body")
    p.outline([coat], INK, LINE)
    p.path(coat, fill="url(#coat)")
    p.path("M640 500Q668 640 684 800", fill="none", stroke=COAT_DARK, stroke_width=9, stroke_linecap="round")
    for y in (560, 650, 740):
        p.circle(644 + (y - 560) * 0.13, y, 12, fill=COAT_LIGHT, stroke=INK, stroke_width=6)
    p.path("M470 720Q510 738 560 726L556 790Q512 800 474 786Z", fill=COAT, stroke=COAT_DARK, stroke_width=8, stroke_linejoin="round")
    p.close()


def head(p):
    face = smooth([(470, 330), (500, 210), (610, 160), (720, 205), (752, 290), (792, 322), (786, 350), (752, 360), (738, 420), (650, 470), (540, 452)])
    hood = smooth([(446, 350), (452, 210), (560, 112), (690, 128), (742, 200), (690, 190), (600, 226), (560, 330), (566, 430), (610, 478),
                   (560, 500), (480, 460)])
    p.open(id="head")
    p.outline([face, hood], INK, LINE)
    p.path(face, fill="url(#skin)")
    p.path("M600 226Q650 188 716 206Q700 250 640 262Q600 272 580 300Z", fill=HAIR)
    p.path(hood, fill="url(#hood)")
    p.ellipse(682, 306, 22, 32, 0, fill="#fffaf0", stroke=INK, stroke_width=7)
    p.ellipse(690, 310, 11, 18, 0, fill=INK)
    p.circle(686, 302, 5, fill="#ffffff")
    p.path("M652 252Q680 236 708 250", fill="none", stroke=HAIR, stroke_width=11, stroke_linecap="round")
    p.path("M746 398Q706 424 668 398", fill="none", stroke=INK, stroke_width=9, stroke_linecap="round")
    p.ellipse(644, 370, 30, 20, 0, fill="#e8836a", opacity=0.5)
    p.close()


def draw(target):
    p = Picture(1200, 1200, "Walker")
    p.gradient("coat", "linear", 'x1="420" y1="460" x2="700" y2="850"', [(0, COAT_LIGHT), (0.45, COAT), (1, "#e0a32c")])
    p.gradient("hood", "linear", 'x1="450" y1="120" x2="620" y2="490"', [(0, COAT_LIGHT), (0.5, COAT), (1, "#e0a32c")])
    p.gradient("skin", "linear", 'x1="560" y1="180" x2="720" y2="470"', [(0, SKIN_LIGHT), (1, SKIN)])
    p.open(id="shadow")
    p.ellipse(560, 1120, 330, 34, 0, fill="#27324f", opacity=0.28)
    p.close()
    arm(p, "far arm", 0.5, COAT_DARK, "#d99a72", (650, 655))
    leg(p, "far leg", 0.5, CLOTH_FAR, BOOT_FAR, (545, 915))
    leg(p, "near leg", 0, CLOTH, BOOT, (655, 905))
    body(p)
    head(p)
    arm(p, "near arm", 0, "url(#coat)", SKIN, (470, 650))
    p.write(target)
    with open(target, encoding="utf-8") as file:
        text = file.read()
    with open(target, "w", encoding="utf-8") as file:
        file.write(text.replace('width="1200" height="1200"', f'width="{1200 * SCALE}" height="{1200 * SCALE}"', 1))


def motion(times, place, ease=None):
    """Returns straight moves between the positions place(t) at the given times. `ease` lists the eases of the moves and repeats."""
    moves = []
    for i, (a, b) in enumerate(zip(times, times[1:])):
        by = [round(SCALE * (q - p), 2) for p, q in zip(place(a), place(b))]
        move = {"kind": "translate", "by": by, "time": [a, b]}
        if ease:
            move["ease"] = ease[i % len(ease)]
        moves.append(move)
    for k in (0, 1):  # the last move absorbs the rounding errors, so that the cycle closes exactly
        moves[-1]["by"][k] = round(-sum(m["by"][k] for m in moves[:-1]), 2) + 0.0
    return moves


def pin(name, part, points, moves=()):
    handle = {"name": name, "at": {"part": part, "points": [[round(SCALE * x, 1) for x in q] for q in points]}}
    if moves:
        handle["motion"] = moves
    return handle


def walk():
    step = [0, 0.08, 0.38, 0.5, 0.62, 0.78, 0.9, 1]
    other = [0, 0.12, 0.28, 0.4, 0.5, 0.58, 0.88, 1]
    swing, swings = [0, 0.25, 0.5, 0.75, 1], ["in", "out"]

    def feet(side, part, phase, times):
        pins = []
        for name, along in (("heel", -52), ("toe", 66)):
            def place(t, along=along):
                at = (t + phase) % 1 if (t + phase) % 1 or t + phase == 0 else 0
                return sole(at, along, 20)
            pins.append(pin(f"{side} {name}", part, [place(0)], motion(times, place)))
        return pins

    def bob(amount, lean):
        return lambda t: (lean * (1 - math.cos(4 * math.pi * t)) / 2, -amount * (1 - math.cos(4 * math.pi * t)) / 2)

    hands = [pin(f"{side} hand", f"{side} arm", [hand(phase)],
                 motion(swing, lambda t, phase=phase: hand((t + phase) % 1), swings)) for side, phase in (("near", 0), ("far", 0.5))]
    return [pin("chest", "body", [(560, 560), (560, 700)], motion(swing, bob(RISE, 0), ["inOut"])),
            pin("head", "head", [(600, 210)], motion(swing, bob(RISE - 6, 9), ["inOut"])),
            *hands, *feet("near", "near leg", 0, step), *feet("far", "far leg", 0.5, other),
            pin("shadow", "shadow", [(400, 1120), (720, 1120)])]


def write_project(target):
    def part(name, joint=None):
        one = {"layer": {"file": "walker.ora", "name": name}}
        if joint:
            one["joints"] = [{"to": "body", "at": [SCALE * x for x in joint[0]], "radius": SCALE * joint[1]}]
        return one

    parts = [part("near arm", (SHOULDER, 12)), part("head", (NECK, 30)), part("body"), part("near leg", ((HIP[0], HIP[1] + 10), 12)),
             part("far leg", ((HIP[0], HIP[1] + 10), 12)), part("far arm", (SHOULDER, 12)), part("shadow")]
    lines = ['{', '  "format": "wend",', '  "version": 1,', '  "domain": {', '    "parts": [',
             ",\n".join("      " + json.dumps(one) for one in parts), '    ],', '    "outline": {"from": "alpha", "margin": 2},',
             '    "vertices": 3000', '  },', '  "material": {"phi": "metr", "memory": "elastic"},', '  "handles": [']
    handles = []
    for handle in walk():
        moves = handle.pop("motion", [])
        text = "    " + json.dumps(handle)
        if moves:
            text = text[:-1] + ', "motion": [\n' + ",\n".join("      " + json.dumps(m) for m in moves) + "\n    ]}"
        handles.append(text)
    lines += [",\n".join(handles), '  ],', '  "time": {"end": 1, "frameRate": 24, "cycle": [0, 1]}', '}', '']
    with open(target, "w", encoding="utf-8") as file:
        file.write("\n".join(lines))


draw(sys.argv[1])
write_project(os.path.splitext(sys.argv[1])[0] + ".wend")
