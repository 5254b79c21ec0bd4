#!/usr/bin/python3
"""Measures how far settled and elastic shapes are from minima that are computed here independently. Needs python3-scipy.

    scripts/comparison/minimum.py [WEND] [CASE…]        (build/release/wend, all flat cases that bend)

Minimizes W of docs/method.md, (19) and (20), for each energy, starting from the end of Wend's flow. The stresses follow
their formula, and their derivatives are finite differences. Newton's method clamps the non-positive eigenvalues of cells
until it is near the minimum. Prints the largest distance of a vertex, in units of the shape's size.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

CASES = sys.argv[2:] or ["strip_5k_bend180", "giraffe_5k_drink", "giraffe_5k_back"]
import run as cases  # noqa: E402  (run.py reads WEND from the arguments, too)
import numpy as np  # noqa: E402
import scipy.sparse  # noqa: E402
import scipy.sparse.linalg  # noqa: E402

PHI = {"equia": math.atan(2 ** -9), "metr": math.atan(0.5), "akvf": math.pi / 2, "conf": math.pi - math.atan(0.5)}
STEP = 1e-6  # step of the finite differences


def edges(points, cells):
    return np.stack([points[cells[:, k]] - points[cells[:, 0]] for k in (1, 2)], 2)


def size(points, cells):
    """Returns √(12 Tr C), where C is the covariance of the domain."""
    area = np.linalg.det(edges(points, cells)) / 2
    corners = points[cells] - ((area[:, None] * points[cells].mean(1)).sum(0) / area.sum())
    second = (corners.sum(1) ** 2).sum(1) + (corners ** 2).sum((1, 2))
    return math.sqrt(12 * (area / 12 * second).sum() / area.sum())


class Energy:
    def __init__(self, rest, cells, phi):
        inverse = np.linalg.inv(edges(rest, cells))
        self.cells, self.area = cells, np.linalg.det(edges(rest, cells)) / 2
        self.gradients = np.stack([-inverse.sum(1), inverse[:, 0], inverse[:, 1]], 1)
        self.shear, self.growth = 2 * math.sin(phi), 2 * math.sin(phi) + math.cos(phi)
        self.rows = (2 * cells[:, :, None] + np.arange(2)).reshape(len(cells), 6)
        self.lift = np.zeros((len(cells), 4, 6))  # maps a cell's corners to F, row by row
        for a in range(2):
            for b in range(2):
                for k in range(3):
                    self.lift[:, 2 * a + b, 2 * k + a] = self.gradients[:, k, b]

    def maps(self, points):
        return np.einsum("cka,ckb->cab", points[self.cells], self.gradients)

    def value(self, points):
        F = self.maps(points)
        J = np.linalg.det(F)
        if J.min() <= 0:
            return math.inf
        return (self.area * (self.shear * ((F ** 2).sum((1, 2)) / J - 2) + self.growth * (J + 1 / J - 2))).sum()

    def stress(self, F):
        J, n = np.linalg.det(F)[:, None, None], (F ** 2).sum((1, 2))[:, None, None]
        cofactors = np.stack([F[:, 1, 1], -F[:, 1, 0], -F[:, 0, 1], F[:, 0, 0]], 1).reshape(-1, 2, 2)
        return self.shear * (2 * F / J - n / J ** 2 * cofactors) + self.growth * (1 - 1 / J ** 2) * cofactors

    def gradient(self, points):
        result = np.zeros_like(points)
        np.add.at(result, self.cells, np.einsum("c,cab,ckb->cka", self.area, self.stress(self.maps(points)), self.gradients))
        return result.ravel()

    def hessian(self, points, clamped):
        F, blocks = self.maps(points), np.empty((len(self.cells), 4, 4))
        for k in range(4):
            by = np.zeros(4)
            by[k] = STEP
            by = by.reshape(2, 2)
            blocks[:, :, k] = ((self.stress(F + by) - self.stress(F - by)) / (2 * STEP)).reshape(-1, 4)
        blocks = (blocks + blocks.transpose(0, 2, 1)) / 2
        if clamped:
            values, modes = np.linalg.eigh(blocks)
            blocks = np.einsum("cpk,ck,cqk->cpq", modes, np.maximum(values, 1e-9), modes)
        own = np.einsum("c,cpi,cpq,cqj->cij", self.area, self.lift, blocks, self.lift)
        places = np.repeat(self.rows, 6, 1).ravel(), np.tile(self.rows, (1, 6)).ravel()
        return scipy.sparse.csc_matrix((own.ravel(), places), shape=(points.size, points.size))


def minimum(energy, points, held):
    free = np.ones(points.shape, bool)
    free[held] = False
    free = np.flatnonzero(free.ravel())
    first = np.linalg.norm(energy.gradient(points)[free])
    for _ in range(200):
        force = energy.gradient(points)[free]
        for clamped in ([False, True] if np.linalg.norm(force) < 1e-4 * first else [True]):
            step = np.zeros(points.size)
            step[free] = -scipy.sparse.linalg.spsolve(energy.hessian(points, clamped)[free][:, free], force)
            if step[free] @ force <= 0:
                break
        step, part, before = step.reshape(points.shape), 1.0, energy.value(points)
        while part > 1e-12 and not energy.value(points + part * step) <= before + 1e-4 * part * (step.ravel()[free] @ force) + 1e-15 * before:
            part /= 2
        points = points + part * step
        if np.abs(part * step).max() < 1e-13 * np.ptp(points):
            break
    return points


def main():
    print("| case | energy | flow | settled | elastic |\n| --- | --- | --- | --- | --- |")
    for name in CASES:
        case = json.loads((cases.HERE / "cases" / f"{name}.json").read_text())
        mesh = cases.HERE / "cases" / case["mesh"]
        rest, cells = (np.array(part) for part in cases.read_mesh(mesh))
        rest = rest.astype(float)[:, :2]
        held = sorted(set(case["fixed"]).union(*(one["vertices"] for one in case["handles"])))
        for energy in cases.ENERGIES:
            project = {"format": "wend", "version": 1, "domain": {"mesh": str(mesh)}, "material": {"phi": energy},
                       "handles": cases.handles_of(case, rest), "time": {"end": 1}}
            ends = {}
            with tempfile.TemporaryDirectory() as folder:
                file = pathlib.Path(folder, "case.wend")
                file.write_text(json.dumps(project))
                for way in ("flow", "settled", "elastic"):
                    out = pathlib.Path(folder, f"{way}.obj")
                    subprocess.run([cases.WEND, "run", file, "--mesh", out, "--quiet", *cases.WAYS[way]], check=True)
                    ends[way] = np.array(cases.read_mesh(out)[0], float)[:, :2]
            best = minimum(Energy(rest, cells, PHI[energy]), ends["flow"], held)
            off = [np.linalg.norm(end - best, axis=1).max() / size(rest, cells) for end in ends.values()]
            print(f"| {name} | {energy.upper()} |", " | ".join(f"{x:.1e}" for x in off), "|", flush=True)


if __name__ == "__main__":
    main()
