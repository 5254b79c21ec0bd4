#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Bends shapes in Inkscape with the sample strip.wend and checks that the results,
mapped back by `wend run --points --inverse`, are on the original shapes.

Usage: in_inkscape.py WEND PLUGIN_FOLDER SAMPLES [PICTURE]"""

import math
import os
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, "/usr/share/inkscape/extensions")
import inkex

wend, plugin, samples = (os.path.abspath(one) for one in sys.argv[1:4])
project = os.path.join(samples, "strip.wend")
PRECISION = 0.05
UNIT = 5  # pixels of the picture per unit of the drawing, which has the same extent


def star(x, y, r):
    corners = [(x + d * math.sin(k * math.pi / 5), y - d * math.cos(k * math.pi / 5))
               for k in range(10) for d in [r if k % 2 == 0 else 0.45 * r]]
    return "M " + " L ".join("%.4f %.4f" % one for one in corners) + " Z"


def drawing():
    waves = "".join(" C %g 238 %g 262 %g 250" % (x + 10, x + 20, x + 30) for x in range(55, 350, 30))
    stars = "".join('<path d="%s" style="fill:#d9822b" id="star%d"/>' % (star(75 + 62 * k, 250, 14), k) for k in range(5))
    return f"""<svg xmlns="http://www.w3.org/2000/svg" width="800" height="600" viewBox="0 0 400 300">
<rect id="band" x="48" y="228" width="326" height="44" rx="10" style="fill:#e8eef0;stroke:#22304a;stroke-width:1.5"/>
<g id="group" transform="translate(5 10) scale(1.02 .96) rotate(.5)"><path id="wave" d="M 55 250{waves}"
 style="fill:none;stroke:#0f8b8d;stroke-width:2.5"/><ellipse id="ring" cx="340" cy="250" rx="14" ry="16"
 style="fill:none;stroke:#d8497f;stroke-width:3"/></g>
{stars}</svg>"""


def bend(folder, source, result, ids):
    profile = os.path.join(folder, "profile")
    os.makedirs(profile + "/extensions", exist_ok=True)
    for name in os.listdir(plugin):
        if name.endswith((".py", ".inx")):
            shutil.copy(os.path.join(plugin, name), profile + "/extensions")
    with open(profile + "/preferences.xml", "w") as file:
        file.write('<inkscape version="1" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape">'
                   '<group id="options"><group id="boot" enabled="0" shown="1"/></group><group id="extensions" '
                   f'org.wend.bend.project="{project}" org.wend.bend.place="page" org.wend.bend.at="-1" '
                   f'org.wend.bend.precision="{PRECISION}"/></inkscape>')
    actions = f"select-by-id:{ids};org.wend.bend.noprefs;export-filename:{result};export-do"
    subprocess.run(["xvfb-run", "-a", "inkscape", "--with-gui", "--batch-process", "--actions=" + actions, source],
                   env=dict(os.environ, INKSCAPE_PROFILE_DIR=profile, WEND=wend, PATH="/usr/bin:/bin"), check=True,
                   timeout=250, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def curves(element):
    """Returns the cubics of a shape in the drawing as tuples of four complex numbers, with None between subpaths."""
    path = element.path.to_absolute().transform(element.composed_transform())
    result = []
    for piece in path.proxy_iterator():
        begin = complex(*piece.previous_end_point)
        if piece.letter in "Mm":
            result.append(None)
        elif piece.letter in "Zz":
            end = complex(*piece.end_point)
            if abs(end - begin) > 1e-9:
                result.append((begin, begin + (end - begin) / 3, end - (end - begin) / 3, end))
        else:
            for one in piece.to_curves():
                a, b, c = (complex(one.args[k], one.args[k + 1]) for k in (0, 2, 4))
                result.append((begin, a, b, c))
                begin = c
    return result


def sampled(chain, count):
    for a, b, c, d in filter(None, chain):
        for k in range(count + 1):
            u = k / count
            v = 1 - u
            yield v ** 3 * a + 3 * v * v * u * b + 3 * v * u * u * c + u ** 3 * d


def at_rest(folder, points):
    bent, rest = folder + "/bent.csv", folder + "/rest.csv"
    with open(bent, "w") as file:
        file.write("x,y\n" + "".join(f"{UNIT * p.real!r},{UNIT * p.imag!r}\n" for p in points))
    subprocess.run([wend, "run", project, "--quiet", "--points", bent, rest, "--inverse"], check=True)
    with open(rest) as file:
        return [complex(*map(float, line.split(","))) / UNIT for line in list(file)[1:]]


def turns(chain):
    """Yields the angles at the nodes of open chains."""
    for before, after in zip(chain, chain[1:]):
        if before and after:
            a, b = before[3] - before[2], after[1] - after[0]
            yield abs(math.atan2((b * a.conjugate()).imag, (b * a.conjugate()).real))


with tempfile.TemporaryDirectory() as folder:
    source, result = folder + "/drawing.svg", folder + "/bent.svg"
    with open(source, "w") as file:
        file.write(drawing())
    before = inkex.load_svg(source).getroot()
    bend(folder, source, result, "band,group," + ",".join("star%d" % k for k in range(5)))
    after = inkex.load_svg(result).getroot()
    for name in ("band", "wave", "ring", "star0", "star4"):
        old, new = before.getElementById(name), after.getElementById(name)
        assert new.tag_name == "path", name
        assert new.style.get("stroke-width") == old.style.get("stroke-width"), name
        rest = list(sampled(curves(old), 40000 // len(curves(old))))
        back = at_rest(folder, list(sampled(curves(new), 6)))
        worst = max(min(abs(p - q) for q in rest) for p in back)
        moved = max(abs(p - q) for p, q in zip(back, sampled(curves(new), 6)))
        # The precision applies to the bent drawing, and the shape is stretched by some per cent; samples are 0.1 apart.
        assert worst < 2 * PRECISION + 0.1, (name, worst)
        assert name == "star0" or moved > 10, (name, moved)
        assert len(curves(new)) < 12 * len(curves(old)), (name, len(curves(new)))
        if name in ("wave", "ring"):
            assert max(turns(curves(new))) < 0.01, (name, max(turns(curves(new))))
    corners = sum(turn > 0.3 for turn in turns(curves(after.getElementById("star2"))))
    assert corners == 9, corners
    if len(sys.argv) > 4:
        for name, picture in ((source, "/a.png"), (result, "/b.png")):
            subprocess.run(["inkscape", name, "-w", "400", "-b", "#fff", "-o", folder + picture], check=True,
                           stderr=subprocess.DEVNULL)
        subprocess.run(["convert", folder + "/a.png", folder + "/b.png", "+append", sys.argv[4]], check=True)
print("the drawing bent in Inkscape")
