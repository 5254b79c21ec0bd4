#!/usr/bin/env python3
"""Writes the layered pictures in this folder with Python's standard library: OpenRaster, Krita, Photoshop and TIFF files of 8 x 6 pixels.

The picture of all layers has the pixel (20 x + 5, 40 y + 3, 7 x y, 255 - 30 x) at (x, y); that of layers.psb has no
transparency. Krita 5.1.5 has written by_krita.kra: it is layers.ora, converted by `krita --export`.
tests/warp/test_layered_files.cpp states what Wend reads from the files.
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
 <layer name="words" nodetype="shapelayer" filename="layer1" x="0" y="0" opacity="255" compositeop="normal" visible="1"/>
 <layer name="group" nodetype="grouplayer" x="0" y="0" opacity="255" compositeop="screen" visible="0"><layers>
  <layer name="arm" nodetype="paintlayer" filename="layer2" colorspacename="COLOURS" x="2" y="2" opacity="51" compositeop="multiply"
   visible="1"><masks><mask nodetype="filtermask" filename="mask9" x="0" y="0"/></masks></layer></layers></layer>
 <layer name="ink" nodetype="paintlayer" filename="layer5" colorspacename="CMYKA" x="0" y="0" opacity="255" compositeop="normal"/>
 <layer name="masked" nodetype="paintlayer" filename="layer3" colorspacename="COLOURS" x="0" y="0" opacity="255" compositeop="add"
   channelflags="1110">
  <masks><mask nodetype="transparencymask" filename="mask4" x="1" y="0" visible="1"/></masks></layer>
 <layer name="K\u00f6rper" nodetype="paintlayer" filename="layer3" colorspacename="COLOURS" x="0" y="0" opacity="255" compositeop="normal"/>
</layers></IMAGE></DOC>"""


def lzf(data):
    """Returns the data compressed by LZF: runs of one byte become references to the byte before, all other bytes are literals."""
    packed, at, literal = b"", 0, b""
    while at < len(data):
        run = 0
        while at > 0 and run < 264 and at + run < len(data) and data[at + run] == data[at - 1]:
            run += 1
        if run >= 3 or (len(literal) == 32):
            packed += bytes([len(literal) - 1]) + literal if literal else b""
            literal = b""
        if run >= 3:
            packed += bytes([run - 2 << 5, 0]) if run < 9 else bytes([7 << 5, run - 9, 0])
            at += run
        else:
            literal += data[at:at + 1]
            at += 1
    return packed + (bytes([len(literal) - 1]) + literal if literal else b"")


def tiles(boxes, pixel_bytes, sample):
    """Returns pixels in Krita's format: tiles of 4 x 3, every second one compressed, with the bytes sorted by their place in a pixel."""
    data = f"VERSION 2\nTILEWIDTH 4\nTILEHEIGHT 3\nPIXELSIZE {pixel_bytes}\nDATA {len(boxes)}\n".encode()
    for number, (left, top) in enumerate(boxes):
        pixels = [sample(left + x, top + y) for y in range(3) for x in range(4)]
        content = b"\0" + b"".join(pixels)
        if number % 2 == 0:
            content = b"\1" + lzf(b"".join(pixel[k:k + 1] for k in range(pixel_bytes) for pixel in pixels))
        data += f"{left},{top},LZF,{len(content)}\n".encode() + content
    return data


def krita(name, kind, pack):
    """Writes a Krita file whose pixels are encoded by `pack`. The layer "arm" is at (-2, -1): its tile is left of and
    above its origin (2, 2)."""
    size = len(pack((0, 0, 0, 0)))
    whole = [(0, 0), (4, 0), (0, 3), (4, 3)]
    archive(name, "application/x-krita", [
        ("maindoc.xml", MAINDOC.replace("COLOURS", kind)), ("mergedimage.png", png(WIDTH, HEIGHT, pixel)),
        ("a/layers/layer2", tiles([(-4, -3)], size, lambda x, y: pack(pixel(x + 4, y + 3)))),
        ("a/layers/layer2.defaultpixel", bytes(size)),
        ("a/layers/layer3", tiles(whole, size, lambda x, y: pack(pixel(x, y)))),
        ("a/layers/layer3.defaultpixel", pack((0, 0, 0, 255))),
        ("a/layers/mask4.pixelselection", tiles([(0, 0)], 1, lambda x, y: bytes([51 * x]))),
        ("a/layers/mask4.pixelselection.defaultpixel", b"\xff")])


def packed_row(row):
    """Returns a row packed by PackBits, as one run of literal bytes."""
    return bytes([len(row) - 1]) + row


def psd(name, depth, large, transparent, group_is_masked=False):
    """Writes a Photoshop file of three layers in a group, in which one layer or the group is masked. Pixels are packed as
    Photoshop packs them: runs for 8 bits, zip for 16."""
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

    def record(label, left, top, width, height, blend, opacity, flags, divider, mask=None):
        pixels = [] if divider else [(c, channel_data(plane(max(c, 0) if c >= 0 else 3, width, height))) for c in (-1, 0, 1, 2)]
        name8 = label.encode("ascii", "replace")
        name8 = bytes([len(name8)]) + name8
        masked = b""
        if mask:  # 2 x 3 pixels at (1, 0) with the values 51 x, white elsewhere
            masked = struct.pack(">iiiiBBH", 0, 1, 3, 3, 255, 0, 0)
            pixels.append((-2, channel_data([b"".join(struct.pack(sample, scale * 51 * x) for x in range(2))] * 3)))
        extras = struct.pack(">I", len(masked)) + masked + struct.pack(">I", 0) + name8 + b"\0" * (-len(name8) % 4)
        extras += block(b"luni", struct.pack(">I", len(label)) + label.encode("utf-16-be"))
        if divider:
            extras += block(b"lsct", struct.pack(">I", divider))
        head = struct.pack(">iiiiH", top, left, top + height, left + width, len(pixels))
        head += b"".join(struct.pack(">h" + size[1], c, len(data)) for c, data in pixels)
        head += b"8BIM" + blend + bytes([opacity, 1 if mask and not divider else 0, flags, 0]) + struct.pack(">I", len(extras)) + extras
        return head, b"".join(data for _, data in pixels)

    layers = [record("</Layer group>", 0, 0, 0, 0, b"norm", 255, 0, 3), record("Körper", 0, 0, 8, 6, b"norm", 255, 0, 0),
              record("masked", 0, 0, 8, 6, b"lddg", 255, 0, 0, not group_is_masked),
              record("arm", -2, 1, 4, 3, b"mul ", 51, 2, 0), record("limbs", 0, 0, 0, 0, b"pass", 255, 0, 1, group_is_masked)]
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
        """Returns a channel of the picture of all layers, which Photoshop keeps over white where it is transparent."""
        colour, alpha = pixel(x, y)[channel], pixel(x, y)[3]
        return scale * colour if channel == 3 or not transparent else round(scale * (colour * alpha + 255 * (255 - alpha)) / 255)

    merged = struct.pack(">H", 0) + b"".join(struct.pack(sample, over_white(c, x, y)) for c in range(channels)
                                             for y in range(HEIGHT) for x in range(WIDTH))
    header = b"8BPS" + struct.pack(">H6xHIIHH", 2 if large else 1, channels, HEIGHT, WIDTH, depth, 3)
    (HERE / name).write_bytes(header + struct.pack(">I", 0) + struct.pack(">I", len(resources)) + resources
                              + struct.pack(size, len(section)) + section + merged)


def tiff(name, pages):
    """Writes pages with names and positions, in fractions of an inch of 300 pixels, as GIMP writes layers."""
    data = b"II*\0" + struct.pack("<I", 8)
    for number, (label, left, top, width, height) in enumerate(pages):
        begin = len(data)
        pixels = b"".join(bytes(pixel(x, y)) for y in range(height) for x in range(width))
        label = label.encode() + b"\0"
        entries = [(254, 4, 1, 2), (256, 4, 1, width), (257, 4, 1, height), (258, 3, 4, struct.pack("<HHHH", 8, 8, 8, 8)), (259, 3, 1, 1),
                   (262, 3, 1, 2), (273, 4, 1, pixels), (277, 3, 1, 4), (278, 4, 1, height), (279, 4, 1, len(pixels)),
                   (282, 5, 1, struct.pack("<II", 300, 1)), (283, 5, 1, struct.pack("<II", 300, 1)), (285, 2, len(label), label),
                   (286, 5, 1, struct.pack("<II", left, 300)), (287, 5, 1, struct.pack("<II", top, 300)), (296, 3, 1, 2), (338, 3, 1, 2)]
        table, behind = b"", b""
        for tag, kind, count, value in entries:
            if isinstance(value, bytes) and len(value) <= 4:
                value = struct.unpack("<I", value + b"\0" * (4 - len(value)))[0]
            elif isinstance(value, bytes):
                place = begin + 2 + 12 * len(entries) + 4 + len(behind)
                behind += value + b"\0" * (len(value) % 2)
                value = place
            table += struct.pack("<HHII", tag, kind, count, value)
        end = begin + 2 + len(table) + 4 + len(behind)
        data += struct.pack("<H", len(entries)) + table + struct.pack("<I", 0 if number + 1 == len(pages) else end) + behind
    (HERE / name).write_bytes(data)


if __name__ == "__main__":
    merged = png(WIDTH, HEIGHT, pixel)
    part = png(4, 3, pixel)
    archive("layers.ora", "image/openraster", [("stack.xml", STACK), ("mergedimage.png", merged), ("data/0.png", part),
                                               ("data/1.png", part), ("data/2.png", merged)])
    krita("layers.kra", "RGBA", lambda c: bytes([c[2], c[1], c[0], c[3]]))
    krita("layers16.kra", "RGBA16", lambda c: struct.pack("<HHHH", *(257 * v for v in (c[2], c[1], c[0], c[3]))))
    krita("grey.kra", "GRAYA", lambda c: bytes([c[1], c[3]]))
    psd("layers.psd", 8, False, True)
    psd("layers16.psd", 16, False, True)
    psd("layers.psb", 8, True, False)
    psd("masked_group.psd", 8, False, True, True)
    psd("masked_group16.psd", 16, False, True, True)
    tiff("layers.tif", [("Körper", 0, 0, 8, 6), ("arm", 5, 4, 4, 3)])
    tiff("pages.tif", [("one", 0, 0, 8, 6), ("", 0, 0, 4, 3)])
