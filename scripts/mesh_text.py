"""Reads the text meshes that Wend writes, without using Wend."""

import numpy as np


def read_mesh(path):
    """Returns the points and cells of a planar .obj or of a .mesh of tetrahedra."""
    words = [line.split() for line in path.read_text().splitlines()]
    if path.suffix == ".obj":
        points = [w[1:4] for w in words if w[:1] == ["v"]]
        cells = [[int(c.split("/")[0]) - 1 for c in w[1:4]] for w in words if w[:1] == ["f"]]
        return np.array(points, float)[:, :2], np.array(cells)
    flat = [word for line in words for word in line]
    block = lambda name, width: np.array(flat[(i := flat.index(name)) + 2:i + 2 + width * int(flat[i + 1])], float).reshape(-1, width)
    return block("Vertices", 4)[:, :3], block("Tetrahedra", 5)[:, :4].astype(int) - 1
