"""Writes the groups of a drawing as an OpenRaster file, each as a layer with the group's id: layers.py DRAWING.svg OUT.ora

Needs rsvg-convert."""
import re
import subprocess
import sys
import zipfile


def png(svg):
    return subprocess.run(["rsvg-convert"], input=svg.encode(), stdout=subprocess.PIPE, check=True).stdout


def main(drawing, out):
    with open(drawing, encoding="utf-8") as file:
        whole = file.read()
    width, height = re.search(r'width="(\d+)" height="(\d+)"', whole).groups()
    groups = re.findall(r'<g id="([^"]+)">\n.*?\n</g>', whole, re.S)
    files, lines = [], []
    for number, name in enumerate(reversed(groups)):  # from front to back
        alone = re.sub(r'<g id="(?!' + re.escape(name) + r'")[^"]+">\n.*?\n</g>', "", whole, flags=re.S)
        files.append((f"data/layer{number}.png", png(alone)))
        lines.append(f'<layer name="{name}" src="data/layer{number}.png" x="0" y="0" opacity="1"/>')
    stack = (f'<?xml version="1.0" encoding="UTF-8"?>\n<image version="0.0.3" w="{width}" h="{height}"><stack>\n' + "\n".join(lines) +
             "\n</stack></image>\n")
    files += [("mergedimage.png", png(whole)), ("Thumbnails/thumbnail.png", png(whole.replace(f'width="{width}" height="{height}"', 'width="256" height="256"', 1)))]
    with zipfile.ZipFile(out, "w") as archive:
        for name, data in [("mimetype", b"image/openraster"), ("stack.xml", stack.encode()), *files]:
            archive.writestr(zipfile.ZipInfo(name, (2026, 1, 1, 0, 0, 0)), data,
                             zipfile.ZIP_DEFLATED if name == "stack.xml" else zipfile.ZIP_STORED)


main(sys.argv[1], sys.argv[2])
