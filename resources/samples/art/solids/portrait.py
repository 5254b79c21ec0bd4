"""A picture of a surface for the start page: shaded triangles, the far ones first, as SVG.
Usage: portrait.py IN.obj OUT.svg ANGLE TILT R,G,B     angles in degrees: about z, and from above"""
import math
import sys

SIZE = 960, 720


def read_obj(path):
    points, triangles = [], []
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                points.append(tuple(float(x) for x in words[1:4]))
            elif words[:1] == ["f"]:
                triangles.append(tuple(int(w.split("/")[0]) - 1 for w in words[1:4]))
    return points, triangles


def turned(p, angle, tilt):
    x, y, z = p
    x, y = x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle)
    y, z = y * math.cos(tilt) - z * math.sin(tilt), y * math.sin(tilt) + z * math.cos(tilt)
    return x, -z, y  # right, down, away


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


def portrait(points, triangles, angle, tilt, colour):
    seen = [turned(p, angle, tilt) for p in points]
    low = [min(p[k] for p in seen) for k in range(2)]
    high = [max(p[k] for p in seen) for k in range(2)]
    scale = 0.86 * min(SIZE[k] / (high[k] - low[k]) for k in range(2))
    at = [tuple(SIZE[k] / 2 + scale * (p[k] - (low[k] + high[k]) / 2) for k in range(2)) for p in seen]
    normals = normals_of(seen, triangles)
    light = (-0.42, -0.74, -0.53)
    shapes = []
    for t in triangles:
        (ax, ay), (bx, by), (cx, cy) = (at[i] for i in t)
        if (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) >= 0:
            continue  # seen from behind
        n = [sum(normals[i][k] for i in t) / 3 for k in range(3)]
        shade = 0.30 + 0.70 * max(0.0, sum(n[k] * light[k] for k in range(3)))
        rim = max(0.0, 1 + n[2]) ** 3 * 0.25
        rgb = [min(255, round(255 * (c * shade + rim))) for c in colour]
        fill = "#%02x%02x%02x" % tuple(rgb)
        path = f"M{ax:.1f} {ay:.1f}L{bx:.1f} {by:.1f} {cx:.1f} {cy:.1f}Z"
        shapes.append((-sum(seen[i][2] for i in t), f'<path d="{path}" fill="{fill}" stroke="{fill}"/>'))
    shapes.sort()
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{SIZE[0]}" height="{SIZE[1]}" stroke-width="0.8" '
        'stroke-linejoin="round">\n' + "\n".join(shape for _, shape in shapes) + "\n</svg>\n"
    )


if __name__ == "__main__":
    source, target, about, above, colour = sys.argv[1:]
    text = portrait(*read_obj(source), math.radians(float(about)), math.radians(float(above)),
                    [float(c) for c in colour.split(",")])
    with open(target, "w", encoding="utf-8") as file:
        file.write(text)
