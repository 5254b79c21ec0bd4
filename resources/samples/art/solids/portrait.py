"""Draws a surface for the start page with the colours and pictures of its materials, on a transparent background.

Usage: portrait.py IN.obj OUT.png ANGLE TILT R,G,B     angles in degrees: about z, and from above; the colour is that of
triangles without material"""
import math
import os
import struct
import sys
import zlib

SIZE = 960, 720
FINE = 2  # samples per pixel and direction


def read_png(path):
    """Returns the rows of RGB triples of a PNG that has 8 bits per channel and is not interlaced."""
    with open(path, "rb") as file:
        data = file.read()
    at, packed, palette = 8, b"", []
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            width, height, _, colour = struct.unpack(">IIBB", body[:10])
        elif kind == b"PLTE":
            palette = [tuple(body[i : i + 3]) for i in range(0, length, 3)]
        elif kind == b"IDAT":
            packed += body
        at += length + 12
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[colour]
    raw, step = zlib.decompress(packed), channels * width
    rows, before = [], bytearray(step)
    for y in range(height):
        kind, line = raw[y * (step + 1)], bytearray(raw[y * (step + 1) + 1 : (y + 1) * (step + 1)])
        for i in range(step):
            left = line[i - channels] if i >= channels else 0
            up, corner = before[i], before[i - channels] if i >= channels else 0
            if kind == 1:
                line[i] = (line[i] + left) & 255
            elif kind == 2:
                line[i] = (line[i] + up) & 255
            elif kind == 3:
                line[i] = (line[i] + (left + up) // 2) & 255
            elif kind == 4:
                guess = left + up - corner
                nearest = min((abs(guess - c), n) for n, c in enumerate((left, up, corner)))[1]
                line[i] = (line[i] + (left, up, corner)[nearest]) & 255
        before = line
        if palette:
            rows.append([palette[v] for v in line])
        elif channels < 3:
            rows.append([(v, v, v) for v in line[::channels]])
        else:
            rows.append([tuple(line[i : i + 3]) for i in range(0, step, channels)])
    return rows


def write_png(path, rows):
    """Writes rows of RGBA bytes as a PNG."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    head = struct.pack(">IIBBBBB", len(rows[0]) // 4, len(rows), 8, 6, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head))
        file.write(chunk(b"IDAT", zlib.compress(b"".join(b"\0" + bytes(row) for row in rows), 9)) + chunk(b"IEND", b""))


def read_materials(path):
    materials, name = {}, ""
    if not os.path.exists(path):
        return materials
    with open(path, encoding="utf-8") as file:
        for words in map(str.split, file):
            if words[:1] == ["newmtl"]:
                name = words[1]
            elif words[:1] == ["Kd"]:
                materials[name] = tuple(255 * float(x) for x in words[1:4])
            elif words[:1] == ["map_Kd"]:
                materials[name] = read_png(os.path.join(os.path.dirname(path), words[1]))
    return materials


def read_obj(path, colour):
    """Returns points, texture points, triangles, texture triangles, and the colour or picture of each triangle."""
    points, texture, triangles, corners, paints = [], [], [], [], []
    materials, paint = {}, colour
    with open(path, encoding="utf-8") as file:
        for words in map(str.split, file):
            if words[:1] == ["v"]:
                points.append(tuple(float(x) for x in words[1:4]))
            elif words[:1] == ["vt"]:
                texture.append(tuple(float(x) for x in words[1:3]))
            elif words[:1] == ["mtllib"]:
                materials = read_materials(os.path.join(os.path.dirname(path), words[1]))
            elif words[:1] == ["usemtl"]:
                paint = materials.get(words[1], colour)
            elif words[:1] == ["f"]:
                ids = [w.split("/") for w in words[1:4]]
                triangles.append(tuple(int(w[0]) - 1 for w in ids))
                corners.append(tuple(int(w[1]) - 1 if len(w) > 1 and w[1] else -1 for w in ids))
                paints.append(paint)
    return points, texture, triangles, corners, paints


def turned(p, angle, tilt):
    x, y, z = p
    x, y = x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle)
    y, z = y * math.cos(tilt) - z * math.sin(tilt), y * math.sin(tilt) + z * math.cos(tilt)
    return x, -z, y  # right, down, away from the viewer


def normals_of(points, triangles):
    normals = [[0.0, 0.0, 0.0] for _ in points]
    for a, b, c in triangles:
        u = [points[b][k] - points[a][k] for k in range(3)]
        v = [points[c][k] - points[a][k] for k in range(3)]
        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        for i in (a, b, c):
            for k in range(3):
                normals[i][k] += n[k]
    return [[x / (math.sqrt(sum(y * y for y in n)) or 1) for x in n] for n in normals]


def painted(paint, u, v):
    if isinstance(paint, tuple):
        return paint
    row = paint[min(len(paint) - 1, max(0, int((1 - v) * len(paint))))]
    return row[min(len(row) - 1, max(0, int(u * len(row))))]


def lit(colour, n):
    light = (-0.42, -0.74, -0.53)
    shade = 0.36 + 0.72 * max(0.0, sum(n[k] * light[k] for k in range(3)))
    rim = 255 * max(0.0, 1 + n[2]) ** 3 * 0.2
    return [min(255, round(c * shade + rim)) for c in colour]


def portrait(points, texture, triangles, corners, paints, angle, tilt):
    """Returns the samples row by row: the colour of the nearest triangle, or None where there is none."""
    seen = [turned(p, angle, tilt) for p in points]
    low = [min(p[k] for p in seen) for k in range(2)]
    high = [max(p[k] for p in seen) for k in range(2)]
    size = [FINE * s for s in SIZE]
    scale = 0.88 * min(size[k] / (high[k] - low[k]) for k in range(2))
    at = [tuple(size[k] / 2 + scale * (p[k] - (low[k] + high[k]) / 2) for k in range(2)) for p in seen]
    normals = normals_of(seen, triangles)
    depth = [[math.inf] * size[0] for _ in range(size[1])]
    colours = [[None] * size[0] for _ in range(size[1])]
    for t, uv, paint in zip(triangles, corners, paints):
        (ax, ay), (bx, by), (cx, cy) = (at[i] for i in t)
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if area >= 0:
            continue  # a back face
        for y in range(max(0, math.ceil(min(ay, by, cy))), min(size[1] - 1, math.floor(max(ay, by, cy))) + 1):
            for x in range(max(0, math.ceil(min(ax, bx, cx))), min(size[0] - 1, math.floor(max(ax, bx, cx))) + 1):
                wb = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area
                wc = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
                w = (1 - wb - wc, wb, wc)
                if min(w) < 0:
                    continue
                away = sum(w[k] * seen[t[k]][2] for k in range(3))
                if away >= depth[y][x]:
                    continue
                depth[y][x] = away
                u, v = (sum(w[k] * texture[uv[k]][i] for k in range(3)) if uv[0] >= 0 else 0 for i in range(2))
                n = [sum(w[k] * normals[t[k]][i] for k in range(3)) for i in range(3)]
                colours[y][x] = lit(painted(paint, u, v), n)
    return colours


def averaged(samples):
    rows = []
    for y in range(SIZE[1]):
        row = bytearray()
        for x in range(SIZE[0]):
            hits = [c for j in range(FINE) for c in samples[FINE * y + j][FINE * x : FINE * (x + 1)] if c]
            if hits:
                row += bytes(round(sum(c[k] for c in hits) / len(hits)) for k in range(3))
                row.append(round(255 * len(hits) / FINE**2))
            else:
                row += b"\0\0\0\0"
        rows.append(row)
    return rows


if __name__ == "__main__":
    source, target, about, above, plain = sys.argv[1:]
    shape = read_obj(source, tuple(255 * float(c) for c in plain.split(",")))
    write_png(target, averaged(portrait(*shape, math.radians(float(about)), math.radians(float(above)))))
