#!/usr/bin/env python3
"""Prints the contents of a layered Photoshop file (PSD), read after Adobe's specification with Python's standard library.

Any length that does not fit, and any byte that is left over, is an error.
"""
import struct
import sys


class Bytes:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, size):
        assert self.at + size <= len(self.data), "truncated"
        self.at += size
        return self.data[self.at - size:self.at]

    def number(self, kind):
        return struct.unpack(">" + kind, self.take(struct.calcsize(kind)))[0]

    def section(self):
        return Bytes(self.take(self.number("I")))

    def finish(self, most=0):
        rest = self.data[self.at:]
        assert len(rest) <= most and not any(rest), "bytes are left over"


def unpacked(data, size):
    """Returns a row unpacked by PackBits, and checks its size."""
    row, at = b"", 0
    while at < len(data):
        n = data[at]
        assert n != 128
        row += data[at + 1:at + 2 + n] if n < 128 else data[at + 1:at + 2] * (257 - n)
        at += n + 2 if n < 128 else 2
    assert at == len(data) and len(row) == size, "a row of another length"
    return row


def planes(data, count, width, height, size):
    assert data.number("H") == 1, "not packed by runs"
    lengths = [data.number("H") for _ in range(count * height)]
    rows = [unpacked(data.take(length), width * size) for length in lengths]
    return [b"".join(rows[k * height:(k + 1) * height]) for k in range(count)]


def pixels(channels, size):
    """Returns the channels interleaved, in hexadecimal digits."""
    return b"".join(c[k:k + size] for k in range(0, len(channels[0]), size) for c in channels).hex()


def read_layers(info, colours, size):
    count = info.number("h")
    layers = []
    for _ in range(abs(count)):
        top, left, bottom, right = (info.number("i") for _ in range(4))
        channels = [(info.number("h"), info.number("I")) for _ in range(info.number("H"))]
        assert [kind for kind, _ in channels] == list(range(-1, colours))
        assert info.take(4) == b"8BIM"
        blend, opacity, clipping, flags, filler = info.take(4).decode(), *info.take(4)
        assert filler == 0 and clipping == 0
        extras = info.section()
        assert extras.at == 0 and extras.number("I") == 0 and extras.number("I") == 0
        short = extras.take(extras.number("B"))
        extras.take(-extras.at % 4)
        assert extras.take(8) == b"8BIMluni"
        block = extras.section()
        assert len(block.data) % 4 == 0
        name = block.take(2 * block.number("I")).decode("utf-16-be")
        block.finish(2)
        extras.finish()
        layers.append((name, short.decode("ascii"), left, top, right, bottom, blend, opacity, flags, channels))
    for name, short, left, top, right, bottom, blend, opacity, flags, channels in layers:
        read = []
        for _, length in channels:
            data = Bytes(info.take(length))
            read += planes(data, 1, right - left, bottom - top, size)
            data.finish()
        print(name, short, left, top, right, bottom, blend, opacity, flags, pixels(read[1:] + read[:1], size), sep="|")
    info.finish(3)
    return count


def read(file):
    assert file.take(4) == b"8BPS" and file.number("H") == 1 and not any(file.take(6))
    channels, height, width, depth, mode = (file.number(kind) for kind in "HIIHH")
    print(width, height, channels, depth, mode, sep="|")
    colours, size = 1 if mode == 1 else 3, depth // 8
    file.section().finish()
    resources = file.section()
    while resources.at < len(resources.data):
        assert resources.take(4) == b"8BIM"
        kind, _ = resources.number("H"), resources.take(2)
        print(kind, resources.section().data.hex(), sep="|")
        resources.take(resources.at % 2)
    both = file.section()
    assert len(both.data) % 4 == 0
    info = both.section()
    assert both.number("I") == 0
    assert len(info.data) % 4 == 0
    both.finish()
    count = read_layers(info, colours, size)
    assert (count < 0) == (channels > colours)
    print(pixels(planes(file, channels, width, height, size), size))
    file.finish()


with open(sys.argv[1], "rb") as opened:
    read(Bytes(opened.read()))
