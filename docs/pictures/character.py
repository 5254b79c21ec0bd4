#!/usr/bin/env python3
"""Draws a character in layers, using only Python's standard library: character.py OUT.ora

Every layer is a union of discs, ellipses and limbs (two discs and the cone between them) with an ink outline, antialiased
by the distance to the border. Each limb overlaps the part that it is joined to.
"""
import math
import struct
import sys
import zipfile
import zlib

WIDTH, HEIGHT = 480, 640
INK = (46, 36, 58)


def limb(ax, ay, ra, bx, by, rb):
    """Returns a function for the approximate distance to the discs about (ax, ay) and (bx, by) and the cone between them,
    negative inside."""
    dx, dy = bx - ax, by - ay
    length = dx * dx + dy * dy

    def distance(x, y):
        t = min(1, max(0, ((x - ax) * dx + (y - ay) * dy) / length))
        return math.hypot(x - ax - t * dx, y - ay - t * dy) - (ra + t * (rb - ra))
    return distance


def ellipse(cx, cy, a, b):
    def distance(x, y):
        k = math.hypot((x - cx) / a, (y - cy) / b)
        g = math.hypot((x - cx) / (a * a), (y - cy) / (b * b))
        return k * (k - 1) / g if g > 0 else -min(a, b)
    return distance


# From front to back: name, opacity, and pieces, each of one colour. Later pieces are painted over earlier ones.
LAYERS = [
    ("arm", 1, [((236, 150, 110), [limb(188, 262, 25, 150, 350, 21), limb(150, 350, 21, 164, 436, 17)]),
                ((250, 205, 170), [ellipse(166, 448, 22, 24)])]),
    ("eyes", 1, [((255, 255, 255), [ellipse(212, 138, 15, 19), ellipse(268, 138, 15, 19)]),
                 (INK, [ellipse(216, 142, 5, 8), ellipse(272, 142, 5, 8)])]),
    ("head", 1, [((250, 205, 170), [ellipse(240, 150, 74, 82)]), ((120, 70, 50), [ellipse(240, 88, 66, 28)]),
                 ((205, 95, 90), [ellipse(242, 196, 22, 7)])]),
    ("body", 1, [((236, 150, 110), [limb(240, 270, 62, 240, 400, 54)]), ((250, 222, 120), [ellipse(240, 330, 20, 20)])]),
    ("leg left", 1, [((88, 110, 170), [limb(212, 418, 30, 204, 560, 22)]), ((70, 60, 80), [ellipse(194, 584, 36, 18)])]),
    ("leg right", 1, [((88, 110, 170), [limb(270, 418, 30, 280, 560, 22)]), ((70, 60, 80), [ellipse(272, 584, 36, 18)])]),
    ("arm behind", 1, [((196, 118, 88), [limb(292, 262, 25, 330, 350, 21), limb(330, 350, 21, 320, 436, 17)]),
                       ((226, 176, 142), [ellipse(318, 448, 22, 24)])]),
    ("shadow", 0.35, [((60, 60, 90), [ellipse(240, 600, 130, 20)])]),
]


def covered(distance):
    return min(1, max(0, 0.5 - distance))


def colour(pieces, x, y, ink):
    """Returns the RGBA of a pixel with straight alpha: the pieces are painted over each other, each with an outline of width `ink`."""
    sums, alpha = [0, 0, 0], 0
    for fill, shapes in pieces:
        distance = min(shape(x, y) for shape in shapes)
        for rgb, cover in ((INK, covered(distance)), (fill, covered(distance + ink))):
            sums = [c * cover + s * (1 - cover) for c, s in zip(rgb, sums)]
            alpha = cover + alpha * (1 - cover)
    return [round(s / alpha) if alpha > 0 else 0 for s in sums] + [round(255 * alpha)]


def drawn(pieces, ink):
    """Returns the left and top of a layer's bounds and its rows of pixels within them."""
    near = [(x, y) for y in range(0, HEIGHT, 4) for x in range(0, WIDTH, 4)
            if min(shape(x, y) for _, shapes in pieces for shape in shapes) < 6]
    left, right = max(0, min(x for x, _ in near) - 4), min(WIDTH, max(x for x, _ in near) + 8)
    top, bottom = max(0, min(y for _, y in near) - 4), min(HEIGHT, max(y for _, y in near) + 8)
    rows = [[colour(pieces, x + 0.5, y + 0.5, ink) for x in range(left, right)] for y in range(top, bottom)]
    return left, top, rows


def png(rows):
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    data = b"".join(b"\0" + b"".join(bytes(pixel) for pixel in row) for row in rows)
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(data, 9)) + chunk(b"IEND", b"")


def merged(layers):
    """Returns the rows of all layers composited, with the first layer on top."""
    sums = [[[0.0, 0.0, 0.0, 0.0] for _ in range(WIDTH)] for _ in range(HEIGHT)]
    for opacity, left, top, rows in reversed(layers):
        for y, row in enumerate(rows):
            for x, pixel in enumerate(row):
                alpha = opacity * pixel[3] / 255
                below = sums[top + y][left + x]
                sums[top + y][left + x] = [alpha * c + (1 - alpha) * b
                                           for c, b in zip([c / 255 for c in pixel[:3]] + [1], below)]
    return [[[round(255 * c / p[3]) if p[3] > 0 else 0 for c in p[:3]] + [round(255 * p[3])] for p in row] for row in sums]


def main(out):
    lines, files, layers = [], [], []
    for number, (name, opacity, pieces) in enumerate(LAYERS):
        left, top, rows = drawn(pieces, 0 if name == "shadow" else 3)
        layers.append((opacity, left, top, rows))
        files.append((f"data/layer{number}.png", png(rows)))
        lines.append(f'<layer name="{name}" src="data/layer{number}.png" x="{left}" y="{top}" opacity="{opacity}"/>')
    whole = merged(layers)
    stack = f'<?xml version="1.0" encoding="UTF-8"?>\n<image version="0.0.3" w="{WIDTH}" h="{HEIGHT}"><stack>\n' + "\n".join(lines) + "\n</stack></image>\n"
    small = [row[::4] for row in whole[::4]]
    files += [("mergedimage.png", png(whole)), ("Thumbnails/thumbnail.png", png(small))]
    with zipfile.ZipFile(out, "w") as archive:
        for name, data in [("mimetype", b"image/openraster"), ("stack.xml", stack.encode()), *files]:
            archive.writestr(zipfile.ZipInfo(name, (2026, 1, 1, 0, 0, 0)), data,
                             zipfile.ZIP_DEFLATED if name == "stack.xml" else zipfile.ZIP_STORED)


main(sys.argv[1])
