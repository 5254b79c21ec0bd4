#!/usr/bin/env python3
"""Writes the layered pictures beside it with nothing but Python: OpenRaster, Krita and Photoshop files of 8 x 6 pixels.

The picture of all layers has the pixel (20 x + 5, 40 y + 3, 7 x y, 255 - 30 x) at (x, y); layers.psb has none of its
transparency. What Wend reads of them is in tests/warp/test_layered_files.cpp.
"""
import pathlib
import struct
import zipfile
import zlib

WIDTH, HEIGHT = 8, 6
HERE = pathlib.Path(__file__).parent


def pixel(x, y):
    return (20 * x + 5, 40 * y + 3, 7 * x * y, 255 - 30 * x)


def png(width, height, colour):
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    rows = b"".join(b"\0" + b"".join(bytes(colour(x, y)) for x in range(width)) for y in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def archive(name, kind, files):
    with zipfile.ZipFile(HERE / name, "w", zipfile.ZIP_DEFLATED) as out:
        for path, data in [("mimetype", kind), *files]:
            entry = zipfile.ZipInfo(path, (2026, 1, 1, 0, 0, 0))
            out.writestr(entry, data, zipfile.ZIP_STORED if path == "mimetype" else zipfile.ZIP_DEFLATED)


STACK = """<?xml version='1.0' encoding='UTF-8'?>
<image version="0.0.3" w="8" h="6"><stack>
 <layer name="head" src="data/0.png" x="3" y="1" opacity="0.5" composite-op="svg:multiply" visibility="visible"/>
 <stack name="limbs">
  <layer name="arm &amp; hand" src="data/1.png" x="-2" y="0" visibility="hidden"/>
 </stack>
 <layer name="Körper" src="data/2.png"/>
</stack></image>"""

MAINDOC = """<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE DOC PUBLIC '-//KDE//DTD krita 2.0//EN' 'http://www.calligra.org/DTD/krita-2.0.dtd'>
<DOC xmlns="http://www.calligra.org/DTD/krita"><IMAGE name="a" width="8" height="6"><layers>
 <layer name="group" nodetype="grouplayer" x="0" y="0" opacity="255" compositeop="normal" visible="1"><layers>
  <layer name="ink" nodetype="paintlayer" x="4" y="2" opacity="51" compositeop="multiply" visible="0"/></layers></layer>
 <layer name="ground" nodetype="paintlayer" x="0" y="0" opacity="255" compositeop="normal" visible="1"/>
</layers></IMAGE></DOC>"""


def packed_row(row):
    """PackBits: runs of literal bytes."""
    return bytes([len(row) - 1]) + row


def psd(name, depth, large, transparent):
    """Two layers in a group, whose pixels are packed as Photoshop packs them: runs for 8 bits, zip for 16."""
    size = ">Q" if large else ">I"
    scale = 257 if depth == 16 else 1
    sample = ">H" if depth == 16 else ">B"

    def plane(channel, width, height):
        return [b"".join(struct.pack(sample, scale * pixel(x, y)[channel]) for x in range(width)) for y in range(height)]

    def channel_data(rows):
        if depth == 16:
            return struct.pack(">H", 2) + zlib.compress(b"".join(rows))
        packed = [packed_row(row) for row in rows]
        counts = b"".join(struct.pack(">I" if large else ">H", len(row)) for row in packed)
        return struct.pack(">H", 1) + counts + b"".join(packed)

    def block(key, data):
        data += b"\0" * (-len(data) % 4)
        return b"8BIM" + key + struct.pack(">I", len(data)) + data

    def record(label, left, top, width, height, blend, opacity, flags, divider):
        pixels = [] if divider else [(c, channel_data(plane(max(c, 0) if c >= 0 else 3, width, height))) for c in (-1, 0, 1, 2)]
        name8 = label.encode("ascii", "replace")
        name8 = bytes([len(name8)]) + name8
        extras = struct.pack(">II", 0, 0) + name8 + b"\0" * (-len(name8) % 4)
        extras += block(b"luni", struct.pack(">I", len(label)) + label.encode("utf-16-be"))
        if divider:
            extras += block(b"lsct", struct.pack(">I", divider))
        head = struct.pack(">iiiiH", top, left, top + height, left + width, len(pixels))
        head += b"".join(struct.pack(">h" + size[1], c, len(data)) for c, data in pixels)
        head += b"8BIM" + blend + bytes([opacity, 0, flags, 0]) + struct.pack(">I", len(extras)) + extras
        return head, b"".join(data for _, data in pixels)

    layers = [record("</Layer group>", 0, 0, 0, 0, b"norm", 255, 0, 3), record("Körper", 0, 0, 8, 6, b"norm", 255, 0, 0),
              record("arm", -2, 1, 4, 3, b"mul ", 51, 2, 0), record("limbs", 0, 0, 0, 0, b"pass", 255, 0, 1)]
    info = struct.pack(">h", -len(layers) if transparent else len(layers))
    info += b"".join(head for head, _ in layers) + b"".join(data for _, data in layers)
    info += b"\0" * (-len(info) % 4)
    if depth == 16:
        section = struct.pack(size, 0) + struct.pack(">I", 0) + b"8BIMLr16" + struct.pack(size, len(info)) + info
    else:
        section = struct.pack(size, len(info)) + info + struct.pack(">I", 0)
    channels = 4 if transparent else 3
    version = struct.pack(">IB", 1, 1) + b"\0" * 12
    resources = b"8BIM" + struct.pack(">HHI", 1057, 0, len(version)) + version + b"\0" * (len(version) % 2)

    def over_white(channel, x, y):
        """Photoshop keeps the picture of all layers over white where it is transparent."""
        colour, alpha = pixel(x, y)[channel], pixel(x, y)[3]
        return scale * colour if channel == 3 or not transparent else round(scale * (colour * alpha + 255 * (255 - alpha)) / 255)

    merged = struct.pack(">H", 0) + b"".join(struct.pack(sample, over_white(c, x, y)) for c in range(channels)
                                             for y in range(HEIGHT) for x in range(WIDTH))
    header = b"8BPS" + struct.pack(">H6xHIIHH", 2 if large else 1, channels, HEIGHT, WIDTH, depth, 3)
    (HERE / name).write_bytes(header + struct.pack(">I", 0) + struct.pack(">I", len(resources)) + resources
                              + struct.pack(size, len(section)) + section + merged)


if __name__ == "__main__":
    merged = png(WIDTH, HEIGHT, pixel)
    part = png(4, 3, pixel)
    archive("layers.ora", "image/openraster", [("stack.xml", STACK), ("mergedimage.png", merged), ("data/0.png", part),
                                               ("data/1.png", part), ("data/2.png", merged)])
    archive("layers.kra", "application/x-krita", [("maindoc.xml", MAINDOC), ("mergedimage.png", merged)])
    psd("layers.psd", 8, False, True)
    psd("layers16.psd", 16, False, True)
    psd("layers.psb", 8, True, False)
