"""Draws strip.svg: a measuring tape with ticks and figures (length), squares (area) and rings (angle)."""
import sys

from draw import Picture, fmt

INK = "#22304a"
LEFT, RIGHT, TOP, BOTTOM = 100, 1900, 1120, 1380
UNIT = 100
FIGURES = {  # strokes in a box of 20 by 30
    "0": "M10 0C2 0 0 7 0 15C0 23 2 30 10 30C18 30 20 23 20 15C20 7 18 0 10 0Z", "1": "M3 6L12 0V30", "2": "M1 7C2 -2 19 -3 19 8C19 16 6 20 1 30H20",
    "3": "M1 3C8 -3 19 0 18 8C17 14 11 14 8 14C13 14 20 16 19 23C17 32 5 32 0 26", "4": "M14 30V0L0 21H20",
    "5": "M18 0H3L2 13C9 9 19 11 19 20C19 31 5 32 0 26", "6": "M17 1C6 3 0 11 0 20C0 34 20 33 20 20C20 9 4 9 1 17", "7": "M0 0H20L8 30",
    "8": "M10 14C-2 12 -1 0 10 0C21 0 22 12 10 14C-3 16 -3 30 10 30C23 30 23 16 10 14Z",
    "9": "M3 29C14 27 20 19 20 10C20 -4 0 -3 0 10C0 21 16 21 19 13"}


def figure(p, x, y, text, scale):
    left = x - scale * (len(text) * 20 + (len(text) - 1) * 8) / 2
    for k, c in enumerate(text):
        p.body.append(f'<path transform="translate({fmt(left + k * 28 * scale)} {fmt(y)}) scale({scale})" d="{FIGURES[c]}" fill="none" stroke="{INK}" '
                      f'stroke-width="4.6" stroke-linecap="round" stroke-linejoin="round"/>')


def outline(inset):
    """Returns the path data of a tape with round ends and a hole at the left, drawn in by `inset`."""
    l, r, t, b = LEFT + inset, RIGHT - inset, TOP + inset, BOTTOM - inset
    k = 70 - inset
    hole = 36 + inset
    cx, cy = LEFT + 80, (TOP + BOTTOM) / 2
    return (f"M{l + k} {t}H{r - k}Q{r} {t} {r} {t + k}V{b - k}Q{r} {b} {r - k} {b}H{l + k}Q{l} {b} {l} {b - k}V{t + k}Q{l} {t} {l + k} {t}Z"
            f"M{cx - hole} {cy}A{hole} {hole} 0 0 0 {cx + hole} {cy}A{hole} {hole} 0 0 0 {cx - hole} {cy}Z")


def ticks(p):
    first, last = LEFT + 150, RIGHT - 50
    text = {5: 32, 10: 74}
    for k in range((last - first) // 10 + 1):
        x = first + 10 * k
        long = text[10] if k % 10 == 0 else text[5] if k % 5 == 0 else 20
        p.path(f"M{x} {TOP + 12}V{TOP + 12 + long}", stroke=INK, stroke_width=5 if k % 10 == 0 else 3, stroke_linecap="butt")
    for k in range(1, (last - first) // UNIT + 1):
        figure(p, first + UNIT * k - (32 if k < 10 else 38), TOP + 52, str(k), 1.15 if k < 10 else 1.05)


def squares(p):
    side, top = 25, TOP + 96
    columns = (RIGHT - 50 - LEFT - 150) // side
    d = ""
    for row in range(4):
        for column in range(columns):
            if (row + column) % 2 == 0:
                d += f"M{LEFT + 150 + column * side} {top + row * side}h{side}v{side}h-{side}z"
    p.path(d, fill="url(#band)")
    p.path(f"M{LEFT + 150} {top}H{RIGHT - 50}M{LEFT + 150} {top + 100}H{RIGHT - 50}", stroke=INK, stroke_width=4)


def rings(p):
    y = BOTTOM - 34
    for k in range((RIGHT - 50 - LEFT - 150) // 50):
        x = LEFT + 175 + 50 * k
        p.circle(x, y, 18, fill="url(#band)")
        p.circle(x, y, 10, fill="#fff9ea")
        p.circle(x, y, 4.5, fill=INK)


def main(target):
    p = Picture(2000, 1500, "Strip")
    p.gradient("paper", "linear", f'x1="0" y1="{TOP}" x2="0" y2="{BOTTOM}"', [(0, "#fffdf4"), (0.5, "#fff8e4"), (1, "#f6e7c4")])
    p.gradient("band", "linear", f'x1="{LEFT}" y1="0" x2="{RIGHT}" y2="0"',
               [(0, "#0f8b8d"), (0.3, "#2f7fc1"), (0.55, "#7a5bc0"), (0.8, "#d8497f"), (1, "#f2743e")])
    p.path(outline(0), fill=INK, fill_rule="evenodd")
    p.path(outline(10), fill="url(#paper)", fill_rule="evenodd")
    p.defs.append(f'<clipPath id="tape"><path d="{outline(10)}" clip-rule="evenodd"/></clipPath>')
    p.open(clip_path="url(#tape)")
    # Coloured ends
    p.path(f"M{LEFT} {TOP}H{LEFT + 138}V{BOTTOM}H{LEFT}Z", fill="#0f8b8d")
    p.path(f"M{RIGHT - 38} {TOP}H{RIGHT}V{BOTTOM}H{RIGHT - 38}Z", fill="#f2743e")
    p.path(f"M{LEFT + 138} {TOP}V{BOTTOM}M{RIGHT - 38} {TOP}V{BOTTOM}", stroke=INK, stroke_width=6)
    p.circle(LEFT + 80, (TOP + BOTTOM) / 2, 55, fill="none", stroke="#bfe3dc", stroke_width=8)
    p.close()
    ticks(p)
    squares(p)
    rings(p)
    p.open(clip_path="url(#tape)")
    p.path(f"M{LEFT} {TOP}H{RIGHT}V{TOP + 22}H{LEFT}Z", fill="#ffffff", opacity=0.45)
    p.path(f"M{LEFT} {BOTTOM - 20}H{RIGHT}V{BOTTOM}H{LEFT}Z", fill="#6b4a1d", opacity=0.14)
    p.close()
    p.write(target)


main(sys.argv[1])
