"""Draws the eagle's plumage from above as the texture of its surface. Usage: plumage.py OUT.svg

The texture covers 6 x 4.4 units around (0, -0.2), with x to the right and y up."""
import math
import sys

from eagle import WING, spline

WIDTH, HEIGHT, SCALE = 6.0, 4.4, 200


def at(x, y):
    return (x + WIDTH / 2) * SCALE, (HEIGHT / 2 - 0.2 - y) * SCALE


def feather(x, y, angle, length, width, fill, rim):
    """Returns the SVG of a feather from its root at (x, y) along the angle: a leaf with a light rim and a shaft."""
    px, py = at(x, y)
    long, half = length * SCALE, width * SCALE / 2
    turn = -math.degrees(angle)
    leaf = f"M0 {-half * 0.5:.1f} C{long * 0.4:.1f} {-half * 1.25:.1f} {long * 0.9:.1f} {-half:.1f} {long:.1f} 0 C{long * 0.9:.1f} {half:.1f} {long * 0.4:.1f} {half * 1.25:.1f} 0 {half * 0.5:.1f} Z"
    return (
        f'<g transform="translate({px:.1f} {py:.1f}) rotate({turn:.1f})"><path d="{leaf}" fill="{fill}" stroke="{rim}" '
        f'stroke-width="2.2"/><path d="M0 0H{long * 0.9:.1f}" stroke="{rim}" stroke-width="1.2" opacity=".6"/></g>'
    )


def mixed(a, b, t):
    pair = [(int(a[i : i + 2], 16), int(b[i : i + 2], 16)) for i in (1, 3, 5)]
    return "#" + "".join(f"{round(p + t * (q - p)):02x}" for p, q in pair)


def wing(side):
    """Returns long feathers along the trailing edge and four rows of coverts over them, which get smaller towards the leading edge."""
    parts = []
    for k in range(34):
        x = 0.2 + 2.3 * k / 33
        ahead, _, chord, _ = spline(WING, min(max(x, 0.15), 2.4))
        swing = 0.1 + 0.9 * max(0.0, (x - 1.2) / 1.3)
        fill = mixed("#4a3427", "#2c2019", k / 33)
        parts.append(feather(side * x, ahead, -math.pi / 2 + side * swing * 0.8, chord + 0.5, 0.17, fill, "#6d543f"))
    for row, (down, length, fill) in enumerate(
        [(-0.12, 0.34, "#5a4030"), (0.08, 0.28, "#684a36"), (0.24, 0.24, "#75543d"), (0.38, 0.2, "#7f5d43")]
    ):
        for k in range(28):
            x = 0.15 + (2.25 - 0.15 * row) * (k + 0.5 * (row % 2)) / 28
            ahead, _, chord, _ = spline(WING, min(max(x, 0.15), 2.4))
            y = ahead + chord * (0.15 + down * 1.4)
            parts.append(feather(side * x, y, -math.pi / 2 + side * 0.25 * x / 2, length, 0.15, fill, "#9c7a5a"))
    return parts


def scales(rows, fill, rim, size):
    parts = []
    for y, half in rows:
        count = max(2, round(2 * half / (0.7 * size)))
        for k in range(count + 1):
            x = -half + 2 * half * k / count
            parts.append(feather(x, y, -math.pi / 2 + 0.5 * x, 1.7 * size, size, fill, rim))
    return parts


def plumage():
    parts = [f'<rect width="{WIDTH * SCALE:.0f}" height="{HEIGHT * SCALE:.0f}" fill="#3d2b20"/>']
    for side in (-1, 1):
        parts += wing(side)
    left, top = at(-0.34, 0.62)
    parts += scales([(-0.75 + 0.1 * k, 0.42) for k in range(16)], "#5c4231", "#8b6b4f", 0.15)
    # The tail is a white fan.
    left, top = at(-0.9, -0.95)
    parts.append(f'<rect x="{left:.0f}" y="{top:.0f}" width="{1.8 * SCALE:.0f}" height="{1.6 * SCALE:.0f}" fill="#e4ddcf"/>')
    for k in (0, 8, 1, 7, 2, 6, 3, 5, 4):
        angle = -math.pi / 2 + (k - 4) * 0.16
        parts.append(feather(0.06 * (k - 4), -0.95, angle, 1.25, 0.26, "#f4efe4", "#b9ad98"))
    parts += scales([(-0.95 + 0.08 * k, 0.3) for k in range(5)], "#5c4231", "#8b6b4f", 0.14)
    # The head is white, the beak yellow.
    left, top = at(-0.5, 2.1)
    parts.append(f'<rect x="{left:.0f}" y="{top:.0f}" width="{SCALE:.0f}" height="{1.32 * SCALE:.0f}" fill="#f6f2e8"/>')
    parts += scales([(0.84 + 0.06 * k, 0.3) for k in range(7)], "#faf7ef", "#d5ccba", 0.1)
    left, top = at(-0.5, 2.1)
    parts.append(f'<rect x="{left:.0f}" y="{top:.0f}" width="{SCALE:.0f}" height="{0.83 * SCALE:.0f}" fill="#eeb02e"/>')
    left, top = at(-0.5, 1.30)
    parts.append(f'<rect x="{left:.0f}" y="{top:.0f}" width="{SCALE:.0f}" height="{0.03 * SCALE:.0f}" fill="#c98e1c"/>')
    size = f'width="{WIDTH * SCALE:.0f}" height="{HEIGHT * SCALE:.0f}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size}>\n' + "\n".join(parts) + "\n</svg>\n"


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="utf-8", newline="\n") as file:
        file.write(plumage())
