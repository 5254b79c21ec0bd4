#!/usr/bin/env python3
"""Compares `wend run` with an independent computation: velocities, errors, size and rest energy of small random cases.

usage: tests/reference/check.py [path of wend] [number of rounds]; needs python3-numpy.
The exit code is 1 if a case is off by more than 1e-8.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

import method

TOLERANCE = 1e-8


def grid(dim, counts, random):
    """Returns a box of Kuhn simplices whose points are jittered, as a whole rotated, scaled and moved."""
    shape = [c + 1 for c in counts]
    x = np.stack(np.meshgrid(*[np.arange(s) for s in shape], indexing='ij'), -1).reshape(-1, dim).astype(float)
    x += random.uniform(-0.15, 0.15, x.shape)
    index = np.arange(len(x)).reshape(shape)
    cells = []
    from itertools import permutations
    for corner in np.ndindex(*counts):
        for order in permutations(range(dim)):
            at, cell = list(corner), [index[corner]]
            for axis in order:
                at[axis] += 1
                cell.append(index[tuple(at)])
            cells.append(cell)
    cells = np.array(cells)
    x = x @ np.linalg.qr(random.normal(size=(dim, dim)))[0].T * random.uniform(0.1, 50) + random.uniform(-5, 5, dim)
    flip = method.measures(x, cells) < 0
    cells[flip] = cells[flip][:, [1, 0, *range(2, dim + 1)]]
    return x, cells


def write_mesh(path, x, cells):
    if x.shape[1] == 2:
        lines = ['v %.17g %.17g 0' % tuple(p) for p in x] + ['f ' + ' '.join(str(v + 1) for v in c) for c in cells]
    else:
        lines = ['MeshVersionFormatted 2', 'Dimension 3', 'Vertices', str(len(x))]
        lines += ['%.17g %.17g %.17g 0' % tuple(p) for p in x]
        lines += ['Tetrahedra', str(len(cells))] + [' '.join(str(v + 1) for v in c) + ' 0' for c in cells] + ['End']
    path.write_text('\n'.join(lines) + '\n')


def random_B(dim, random):
    a = random.normal(size=dim)
    a /= np.linalg.norm(a)
    return np.eye(dim) * random.uniform(0.5, 2) + random.uniform(0, 20) * np.outer(a, a)


def case(dim, kind, random):
    """Returns a random project and the data about it that the reference computation needs."""
    x, cells = grid(dim, [6, 4] if dim == 2 else [3, 2, 2], random)
    phis = {'equia': math.atan(2 ** -9), 'metr': math.atan(0.5), 'akvf': math.pi / 2, 'conf': method.conformal(dim)}
    name = random.choice(list(phis))
    material = {'phi': str(name)}
    phi, B = np.full(len(cells), phis[name]), np.array([np.eye(dim)] * len(cells))
    if 'cells' in kind:
        phi = random.uniform(0.05, method.conformal(dim), len(cells))
        material['cells'] = {'phi': phi.tolist()}
    if 'B' in kind:
        B = np.array([random_B(dim, random) for _ in cells])
        B[::3] = np.eye(dim)
        material.setdefault('cells', {})['B'] = B.reshape(len(cells), -1).tolist()
    scale = method.size(x, cells)
    centroids = x[cells].mean(axis=1)
    if 'region' in kind:
        # The disc and the half-space cover the cells whose centroids they contain; the later region wins.
        axis, ratio, radius = random.normal(size=dim), 12.0, 0.25 * scale
        centre, normal = x.mean(axis=0), random.normal(size=dim)
        material['regions'] = [
            {'shape': {'circle' if dim == 2 else 'sphere': {'centre': centre.tolist(), 'radius': radius}},
             'stiffness': {'axis': axis.tolist(), 'ratio': ratio}},
            {'shape': {'halfspace': {'point': centre.tolist(), 'normal': normal.tolist()}}, 'phi': 1.1}]
        a = axis / np.linalg.norm(axis)
        B[np.linalg.norm(centroids - centre, axis=1) < radius] = np.eye(dim) + (ratio - 1) * np.outer(a, a)
        signed = (centroids - centre) @ normal
        phi = np.where(signed > 0, 1.1, phi)  # the normal points inwards
    smoothing = {'kind': 'invariant'}
    if 'paper' in kind:
        smoothing = {'kind': 'paper', 'lambda': 0.07}
    elif 'long' in kind:
        smoothing = {'kind': 'invariant', 'length': 0.1}
    elif 'none' in kind:
        smoothing = {'kind': 'none'}
    if smoothing != {'kind': 'invariant'}:
        material['smoothing'] = smoothing
    if 'memory' in kind:
        material['memory'] = 7.5
    # Some vertices at one end are held, some at the other are rotated, and a point inside a cell in the middle is pulled.
    order = np.argsort(x @ (x[-1] - x[0]))
    held, turned = order[:5].tolist(), order[-4:].tolist()
    free = [c for c in range(len(cells)) if not set(cells[c]) & set(held + turned)]
    middle = free[int(random.integers(len(free)))]
    weights = random.dirichlet([5] * (dim + 1))
    by, centre, angle = random.uniform(-0.04, 0.04, dim) * scale, x.mean(axis=0), 0.3
    axis = random.normal(size=3)
    rotate = {'kind': 'rotate', 'centre': centre.tolist(), 'angle': angle, 'time': [0, 1]}
    if dim == 3:
        rotate['axis'] = axis.tolist()
    project = {
        'format': 'wend', 'version': 1, 'domain': {'mesh': 'rest.obj' if dim == 2 else 'rest.mesh'}, 'material': material,
        'handles': [{'name': 'held', 'at': {'vertices': held}},
                    {'name': 'turned', 'at': {'vertices': turned}, 'motion': [rotate]},
                    {'name': 'pulled', 'at': {'points': [(weights @ x[cells[middle]]).tolist()]},
                     'motion': [{'kind': 'translate', 'by': by.tolist(), 'time': [0, 1]}]}],
        'time': {'end': 1}, 'integration': {'method': 'dopri5', 'tolerance': 1e-6}}
    if 'settle' in kind:
        project['settle'] = [{'time': [0.5, 1.5]}]

    def spin(p):
        if dim == 2:
            return angle * np.array([-(p - centre)[1], (p - centre)[0]])
        return np.cross(angle * axis / np.linalg.norm(axis), p - centre)

    def constraints(now):
        rows, values = [], []
        d = dim
        for v in held + turned:
            for a in range(d):
                row = np.zeros(len(x) * d)
                row[v * d + a] = 1
                rows.append(row)
            values += list(np.zeros(d) if v in held else spin(now[v]))
        for a in range(d):
            row = np.zeros(len(x) * d)
            for k, v in enumerate(cells[middle]):
                row[v * d + a] = weights[k]
            rows.append(row)
        return np.array(rows), np.array(values + list(by))

    return x, cells, phi, B, smoothing, material.get('memory', 0), project, constraints


def check(wend, dim, kind, seed):
    random = np.random.default_rng(seed)
    x, cells, phi, B, smoothing, memory, project, constraints = case(dim, kind, random)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        write_mesh(folder / project['domain']['mesh'], x, cells)
        (folder / 'p.wend').write_text(json.dumps(project))
        done = subprocess.run([wend, 'run', 'p.wend', '--at', '0.8', '--velocity', 'v.csv', '--report', 'r.json', '--backend', 'cpu', '--quiet'],
                              cwd=folder, capture_output=True, text=True)
        if done.returncode:
            return 'exit code %d: %s' % (done.returncode, done.stderr.strip())
        table = np.loadtxt(folder / 'v.csv', delimiter=',', skiprows=1)
        report = json.loads((folder / 'r.json').read_text())
    now, v = table[:, :dim], table[:, dim:]
    s = method.size(x, cells)
    rows, values = constraints(now)
    A = method.energy_matrix(x / s, now / s, cells, phi, B, smoothing)
    speed = max(np.linalg.norm(u) for u in values.reshape(-1, dim)) / s
    rate = 30 if 'settle' in kind else memory * speed
    g = method.rest_gradient(x / s, now / s, cells, phi, B)
    expected = s * method.velocity(A, rate * g.reshape(-1), rows, values / s).reshape(-1, dim)
    W, errors = method.rest_energy(x / s, now / s, cells, phi, B), method.distortion(x, now, cells)
    hold = np.linalg.qr(rows.T)[0]
    force = np.linalg.norm(g.reshape(-1) - hold @ (hold.T @ g.reshape(-1)))
    off = {'velocity': np.abs(v - expected).max() / np.abs(expected).max(),
           'energy': abs(report['energy'] / (v.reshape(-1) @ A @ v.reshape(-1) / s ** 2) - 1),
           'rest energy': abs(report['restEnergy'] / W - 1), 'rest force': abs(report['restForce'] / force - 1),
           'errors': max(abs(report['errors'][k] / e - 1) for k, e in zip(('angle', 'volume', 'metric'), errors))}
    bad = {k: e for k, e in off.items() if not e < TOLERANCE}
    return 'off by ' + ', '.join('%s %.2g' % item for item in bad.items()) if bad else None


def main():
    wend = str(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else 'build/release/wend').resolve())
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 2
    kinds = ['', 'cells', 'B', 'cells B', 'region', 'paper', 'paper cells B', 'long cells', 'none B', 'memory', 'memory cells',
             'memory cells B', 'memory region', 'settle', 'settle cells B']
    failed = 0
    for seed in range(rounds):
        for dim in (2, 3):
            for number, kind in enumerate(kinds):
                problem = check(wend, dim, kind, 100 * seed + number)
                if problem:
                    failed += 1
                    print('%dD, "%s", seed %d: %s' % (dim, kind, 100 * seed + number, problem))
    print('%d cases, %d off' % (2 * rounds * len(kinds), failed))
    return failed > 0


if __name__ == '__main__':
    sys.exit(main())
