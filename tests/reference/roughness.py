#!/usr/bin/env python3
"""Measures how rough the outlines of a deformed triangle mesh are, in degrees; needs python3-numpy.

usage: tests/reference/roughness.py REST.obj POSE.obj

Takes the turning angle at every vertex of the boundary, subtracts that at rest and then the mean over the five vertices
around it, which removes smooth bends, and prints the root of the mean square over all boundary vertices.
"""
import sys

import numpy as np


def read(path):
    x, cells = [], []
    for line in open(path):
        words = line.split()
        if words[:1] == ['v']:
            x.append([float(w) for w in words[1:3]])
        elif words[:1] == ['f']:
            cells.append([int(w.split('/')[0]) - 1 for w in words[1:4]])
    return np.array(x), cells


def loops(cells):
    edges = {(c[k], c[(k + 1) % 3]) for c in cells for k in range(3)}
    after = {a: b for a, b in edges if (b, a) not in edges}
    result = []
    while after:
        start, at = next(iter(after.items()))
        del after[start]
        loop = [start]
        while at != start:
            loop.append(at)
            at = after.pop(at)
        result.append(loop)
    return result


def turning(p):
    e = np.roll(p, -1, axis=0) - p
    before = np.roll(e, 1, axis=0)
    return np.arctan2(before[:, 0] * e[:, 1] - before[:, 1] * e[:, 0], (before * e).sum(axis=1))


def roughness(rest, pose, cells, width=5):
    squares = []
    for loop in loops(cells):
        change = turning(pose[loop]) - turning(rest[loop])
        change = (change + np.pi) % (2 * np.pi) - np.pi
        mean = sum(np.roll(change, k) for k in range(-(width // 2), width // 2 + 1)) / width
        squares.append((change - mean) ** 2)
    return np.degrees(np.sqrt(np.concatenate(squares).mean()))


if __name__ == '__main__':
    rest, cells = read(sys.argv[1])
    pose, _ = read(sys.argv[2])
    print('%.2f' % roughness(rest, pose, cells))
