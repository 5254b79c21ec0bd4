#!/usr/bin/env python3
"""Writes one tetrahedron as .vtu in every layout that VTK's file format document allows, from that document alone
(struct, base64 and zlib, without code of Wend). `python3 make.py` rewrites the files in this folder."""
import base64
import os
import struct
import zlib

HEADERS = {"UInt32": "I", "UInt64": "Q"}
ARRAYS = [  # element, name, type, code, components, numbers
    ("PointData", "heat", "Float32", "f", 1, [0.5, 1.5, 2.5, 3.5]),
    ("CellData", "label", "UInt8", "B", 1, [7]),
    ("Points", "Points", "Float64", "d", 3, [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]),
    ("Cells", "connectivity", "Int64", "q", 1, [0, 1, 2, 3]),
    ("Cells", "offsets", "Int32", "i", 1, [4]),
    ("Cells", "types", "UInt8", "B", 1, [10]),
]


def raw(order, code, numbers):
    return struct.pack(order + str(len(numbers)) + code, *numbers)


def encoded(data, order, header, compressed, text, apart):
    """Returns the header and data of one array, in one piece of base64 or, with `apart`, in two; compressed data always has two."""
    wrap = base64.b64encode if text else bytes
    word = HEADERS[header]
    if not compressed:
        size = raw(order, word, [len(data)])
        return wrap(size) + wrap(data) if apart else wrap(size + data)
    block = 16  # bytes; small, so that there are several blocks
    parts = [zlib.compress(data[at:at + block]) for at in range(0, len(data), block)]
    numbers = [len(parts), block, len(data) % block] + [len(part) for part in parts]
    return wrap(raw(order, word, numbers)) + wrap(b"".join(parts))


def element(name, kind, components, more, content=""):
    tag = f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" {more}'
    return tag + (f">{content}</DataArray>\n" if content else "/>\n")


def file(order, header, form, compressed, apart=False):
    sections, appended = {}, b""
    for section, name, kind, code, components, numbers in ARRAYS:
        data = raw(order, code, numbers)
        if form == "ascii":
            part = element(name, kind, components, 'format="ascii"', " ".join(map(str, numbers)))
        elif form == "binary":
            content = encoded(data, order, header, compressed, True, apart).decode()
            part = element(name, kind, components, 'format="binary"', "\n" + content + "\n")
        else:
            part = element(name, kind, components, f'format="appended" offset="{len(appended)}"')
            appended += encoded(data, order, header, compressed, form == "base64", apart)
        sections[section] = sections.get(section, "") + part
    compressor = ' compressor="vtkZLibDataCompressor"' if compressed else ""
    endian = "LittleEndian" if order == "<" else "BigEndian"
    text = ('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" '
            f'byte_order="{endian}" header_type="{header}"{compressor}>\n<UnstructuredGrid>\n'
            '<Piece NumberOfPoints="4" NumberOfCells="1">\n')
    for section, content in sections.items():
        text += f"<{section}>\n{content}</{section}>\n"
    text += "</Piece>\n</UnstructuredGrid>\n"
    result = text.encode()
    if form in ("base64", "raw"):
        result += f'<AppendedData encoding="{form}">\n_'.encode() + appended + b"\n</AppendedData>\n"
    return result + b"</VTKFile>\n"


def main():
    folder = os.path.dirname(os.path.abspath(__file__))
    layouts = [("ascii", False, False)]
    layouts += [(form, packed, False) for form in ("binary", "base64", "raw") for packed in (False, True)]
    layouts += [(form, False, True) for form in ("binary", "base64")]
    for header in HEADERS:
        for order, end in (("<", "little"), (">", "big")):
            for form, packed, apart in layouts:
                name = f"{form}-{header}-{end}{'-zlib' if packed else ''}{'-apart' if apart else ''}.vtu"
                with open(os.path.join(folder, name), "wb") as out:
                    out.write(file(order, header, form, packed, apart))


main()
