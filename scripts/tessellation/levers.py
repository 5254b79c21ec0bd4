#!/usr/bin/python3
"""Measures what two changes of the discretization would achieve on the triangulations of run.py; needs python3-scipy.

    scripts/tessellation/levers.py

The script does not use the program's code: it assembles the energy of docs/method.md, sections 2 to 5, anew, in the plane
with one φ. It compares the velocities at rest, as run.py compares the displacements, and prints tables for page.md. The
changes:

trace   multiplies a facet's weight in (10) by the factor, averaged over its two vertices, by which the jumps' energy of quadratic fields is
        too small in a vertex's patch: the sum over a basis of these fields, interpolated linearly, compared with equilateral triangles.
nodal   averages the divergence in (3) over the cells around each vertex, if its weight is positive.
"""
import math

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg
from scipy.interpolate import LinearNDInterpolator

import run

PHI = {"equia": math.atan(2 ** -9), "metr": math.atan(0.5), "akvf": math.pi / 2, "conf": math.pi - math.atan(0.5)}
SMOOTHING = math.hypot(run.WIDTH, run.HEIGHT) / 75


class Mesh:
    """A triangle mesh with areas, the operators from nodal velocities (x0 y0 x1 …) to strains and divergence, and the interior facets."""

    def __init__(self, points, cells):
        edges = points[cells[:, 1:]] - points[cells[:, :1]]
        self.points, self.cells = points, np.where((np.linalg.det(edges) < 0)[:, None], cells[:, [0, 2, 1]], cells)
        edges = points[self.cells[:, 1:]] - points[self.cells[:, :1]]
        self.area = np.linalg.det(edges) / 2
        g = np.zeros((len(cells), 3, 2))
        g[:, 1:] = np.swapaxes(np.linalg.inv(edges), 1, 2)
        g[:, 0] = -g[:, 1] - g[:, 2]
        row = np.repeat(np.arange(len(cells)), 3)
        J = lambda a, b: sp.csr_matrix((g[:, :, b].ravel(), (row, (2 * self.cells + a).ravel())), (len(cells), 2 * len(points)))
        self.strains = [2 * J(0, 0), 2 * J(1, 1), math.sqrt(2) * (J(0, 1) + J(1, 0))]
        self.divergence = J(0, 0) + J(1, 1)
        sides = {}
        for c, cell in enumerate(self.cells.tolist()):
            for k in range(3):
                sides.setdefault(tuple(sorted((cell[k], cell[k - 1]))), []).append(c)
        inner = np.array([(*edge, *both) for edge, both in sides.items() if len(both) == 2])
        self.facets, i, j = inner[:, :2], inner[:, 2], inner[:, 3]
        middle = points[self.cells].mean(1)
        self.ratio = np.linalg.norm(np.diff(points[self.facets], axis=1)[:, 0], axis=1) / np.linalg.norm(middle[i] - middle[j], axis=1)
        n = np.arange(len(inner))
        self.jump = sp.csr_matrix((np.repeat([1.0, -1.0], len(inner)), (np.tile(n, 2), np.concatenate([j, i]))), (len(inner), len(cells)))

    def jumps(self, wq, wr):
        """Returns weights and operators; the weighted sum of the squares of their rows is q of the jumps (11)."""
        return [(wq, self.jump @ s) for s in self.strains] + ([(wr, self.jump @ self.divergence)] if wr < 0 else [])

    def trace(self, wq, wr):
        """Returns for every vertex the jumps' energy of quadratic fields in its patch, divided by its area."""
        x, y = self.points.T
        fields = np.zeros((6, len(x), 2))
        for k, f in enumerate((x * x / 2, y * y / 2, x * y / math.sqrt(2))):
            fields[2 * k, :, 0] = fields[2 * k + 1, :, 1] = f
        energy = self.ratio * sum(w * ((op @ fields.reshape(6, -1).T) ** 2).sum(1) for w, op in self.jumps(wq, wr))
        energies, areas = np.zeros(len(x)), np.zeros(len(x))
        for k in (0, 1):
            np.add.at(energies, self.facets[:, k], energy / 2)
        for k in (0, 1, 2):
            np.add.at(areas, self.cells[:, k], self.area / 3)
        return energies / areas


def equilateral():
    p = np.array([(i + 0.5 * (j % 2), j * 0.75 ** 0.5) for j in range(12) for i in range(12)])
    return Mesh(*run.delaunay(p)), np.argmin(((p - p.mean(0)) ** 2).sum(1))


IDEAL = equilateral()


def square(weights, op):
    return op.T @ sp.diags(weights) @ op


def energy_matrix(mesh, phi, levers):
    wq, wr = math.sin(phi), math.cos(phi)
    A = sum(square(wq * mesh.area, s) for s in mesh.strains)
    if "nodal" in levers and wr > 0:
        spread = sp.csr_matrix((np.repeat(mesh.area / 3, 3), (mesh.cells.ravel(), np.repeat(np.arange(len(mesh.cells)), 3))))
        areas = np.asarray(spread.sum(1)).ravel()
        A = A + square(wr / areas, spread @ mesh.divergence)
    else:
        A = A + square(wr * mesh.area, mesh.divergence)
    weights = SMOOTHING ** 2 * mesh.ratio
    if "trace" in levers:
        ideal, at = IDEAL
        patches = np.maximum(mesh.trace(wq, wr), 1e-300)  # a corner may have no interior facet
        weights = weights * (ideal.trace(wq, wr)[at] / patches)[mesh.facets].mean(1)
    return A + sum(square(w * weights, op) for w, op in mesh.jumps(wq, wr))


def velocity(mesh, phi, kind, levers):
    far = np.linalg.norm(mesh.points - run.HANDLE, axis=1)
    pulled = far < 1e-9 if kind == "vertex" else far <= run.RADIUS
    v = np.where(pulled[:, None], run.PULL, 0.0).ravel()
    held = np.repeat(pulled | (mesh.points[:, 0] < 1e-9), 2)
    free = np.flatnonzero(~held)
    rows = energy_matrix(mesh, phi, levers).tocsr()[free]
    factor = scipy.sparse.linalg.splu(rows[:, free].tocsc(), "MMD_AT_PLUS_A", 0.0, options={"SymmetricMode": True})
    v[free] = factor.solve(-(rows @ v))
    return v.reshape(-1, 2)


def main():
    meshes = {name: Mesh(*run.with_vertex(*mesh)) for name, mesh in run.tessellations().items()}
    first, *others = meshes
    places = np.random.default_rng(2).uniform((0.02, 0.02), (run.WIDTH - 0.02, run.HEIGHT - 0.02), (4000, 2))
    places = places[np.linalg.norm(places - run.HANDLE, axis=1) > run.RADIUS + 0.1]
    print("| pulled at | energy | |" + "".join(f" {name} |" for name in others) + "\n| --- | --- | --- |" + " --- |" * len(others))
    for kind in ("vertex", "circle"):
        for energy, phi in PHI.items():
            for levers in ("as it is", "trace", *(("nodal", "nodal and trace") if math.cos(phi) > 1e-9 else ())):
                v = {name: LinearNDInterpolator(mesh.points, velocity(mesh, phi, kind, levers))(places) for name, mesh in meshes.items()}
                off = [np.nanmax(np.linalg.norm(v[name] - v[first], axis=1)) / np.linalg.norm(run.PULL) for name in others]
                print(f"| {kind} | {energy.upper()} | {levers} |" + "".join(f" {100 * x:.1f} % |" for x in off), flush=True)


if __name__ == "__main__":
    main()
