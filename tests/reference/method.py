"""Implements the method of docs/method.md and docs/energies.md with dense matrices: slow, small, and without any of the program's code."""
import math

import numpy as np


def conformal(dim):
    return math.pi - math.atan(dim / 4)


def measures(x, cells):
    d = x.shape[1]
    edges = x[cells[:, 1:]] - x[cells[:, :1]]
    return np.linalg.det(edges) / math.factorial(d)


def size(x, cells):
    """Returns √(12 Tr C), with C from the exact second moments of the simplices."""
    d = x.shape[1]
    V = np.abs(measures(x, cells))
    corners = x[cells]
    c = corners.mean(axis=1)
    mean = (V[:, None] * c).sum(axis=0) / V.sum()
    spread = ((corners - c[:, None]) ** 2).sum(axis=(1, 2)) / ((d + 1) * (d + 2))
    return math.sqrt(12 * (V * (((c - mean) ** 2).sum(axis=1) + spread)).sum() / V.sum())


def gradients(x, cells):
    """Returns the gradients of the hat functions, [cell, corner, axis]."""
    edges = x[cells[:, 1:]] - x[cells[:, :1]]  # rows are edges
    inner = np.linalg.inv(edges).transpose(0, 2, 1)
    return np.concatenate([-inner.sum(axis=1, keepdims=True), inner], axis=1)


def maps(rest, x, cells):
    """Returns the deformation gradients F."""
    return np.einsum('cka,ckb->cab', x[cells], gradients(rest, cells))


def rotation(F):
    U, _, Vt = np.linalg.svd(F)
    return U @ Vt


def jacobian_operator(g, cell, n):
    """Returns J as a linear map of the nodal velocities: [a, b, vertex · d + a]."""
    d = g.shape[1]
    op = np.zeros((d, d, n * d))
    for k, v in enumerate(cell):
        for a in range(d):
            op[a, :, v * d + a] += g[k]
    return op


def quadratic(op, wq, wr, B):
    """Returns w_q ‖S‖²_B + w_r (d / Tr B) (Tr BJ)² as a matrix of the nodal velocities."""
    d = B.shape[0]
    S = op + op.transpose(1, 0, 2)
    trace = np.einsum('ab,ban->n', B, op)
    return wq * np.einsum('abm,ac,cbn->mn', S, B, S) + wr * d / np.trace(B) * np.outer(trace, trace)


def stress(op, wq, wr, B):
    d = B.shape[0]
    S = op + op.transpose(1, 0, 2)
    trace = np.einsum('ab,ban->n', B, op)
    SB = np.einsum('abn,bc->acn', S, B)
    return 2 * wq * (SB + SB.transpose(1, 0, 2)) + 2 * wr * d / np.trace(B) * np.einsum('ab,n->abn', B, trace)


def facets(cells):
    seen = {}
    for c, cell in enumerate(cells):
        for k in range(len(cell)):
            seen.setdefault(tuple(sorted(np.delete(cell, k))), []).append(c)
    return [(f, *cs) for f, cs in seen.items() if len(cs) == 2]


def facet_measure(x, facet):
    e = x[list(facet)][1:] - x[facet[0]]
    return math.sqrt(np.linalg.det(e @ e.T)) / math.factorial(len(facet) - 1)


def energy_matrix(rest, x, cells, phi, B0, smoothing):
    """Returns the A of E(v) = vᵀ A v, in coordinates where the rest shape has size 1."""
    n, d = x.shape
    V, G, F = np.abs(measures(x, cells)), gradients(x, cells), maps(rest, x, cells)
    R = rotation(F)
    B = R @ B0 @ R.transpose(0, 2, 1)
    wq, wr = np.sin(phi), np.cos(phi)
    ops = [jacobian_operator(G[c], cells[c], n) for c in range(len(cells))]
    A = sum(V[c] * quadratic(ops[c], wq[c], wr[c], B[c]) for c in range(len(cells)))
    centre = x[cells].mean(axis=1)
    for facet, i, j in facets(cells) if smoothing['kind'] != 'none' else []:
        area = facet_measure(x, facet)
        if smoothing['kind'] == 'paper':
            jump = stress(ops[j], wq[j], wr[j], B[j]) - stress(ops[i], wq[i], wr[i], B[i])
            A += smoothing.get('lambda', 0.1) * area * np.einsum('abm,abn->mn', jump, jump)
        else:
            weight = smoothing.get('length', 1 / 75) ** 2 * area / np.linalg.norm(centre[j] - centre[i])
            A += weight * quadratic(ops[j] - ops[i], (wq[i] + wq[j]) / 2, min((wr[i] + wr[j]) / 2, 0), (B[i] + B[j]) / 2)
    return A


def rest_density(F, wq, wr, B0):
    d, J = F.shape[0], np.linalg.det(F)
    if np.array_equal(B0, np.eye(d)):
        return 2 * wq * ((F ** 2).sum() * J ** (-2 / d) - d) + (4 * wq / d + wr) * (J + 1 / J - 2)
    E, tr = F.T @ F - np.eye(d), np.trace(B0)
    return (wq * np.trace(E.T @ B0 @ E) + wr * d / tr * (np.trace(B0 @ E) / 2) ** 2 + wq * tr / d * (J - 1) ** 4 / J)


def rest_energy(rest, x, cells, phi, B0):
    V0, F = np.abs(measures(rest, cells)), maps(rest, x, cells)
    return sum(V0[c] * rest_density(F[c], math.sin(phi[c]), math.cos(phi[c]), B0[c]) for c in range(len(cells)))


def rest_gradient(rest, x, cells, phi, B0):
    """Returns the gradient of the rest energy, by complex steps in every entry of F, which are exact to rounding."""
    V0, F, G0 = np.abs(measures(rest, cells)), maps(rest, x, cells), gradients(rest, cells)
    result = np.zeros_like(x)
    d = x.shape[1]
    for c, cell in enumerate(cells):
        P = np.zeros((d, d))
        for a in range(d):
            for b in range(d):
                f = F[c].astype(complex)
                f[a, b] += 1e-30j
                P[a, b] = rest_density(f, math.sin(phi[c]), math.cos(phi[c]), B0[c]).imag / 1e-30
        for k, v in enumerate(cell):
            result[v] += V0[c] * P @ G0[c, k]
    return result


def velocity(A, load, rows, values):
    """Returns the v that minimizes vᵀ A v + load · v subject to rows · v = values, by the Lagrange system."""
    n, m = A.shape[0], len(rows)
    K = np.block([[2 * A, rows.T], [rows, np.zeros((m, m))]])
    scale = np.abs(A).max()
    K[n:] *= scale
    return np.linalg.solve(K, np.concatenate([-load, scale * values]))[:n]


def distortion(rest, x, cells):
    """Returns F_angle, F_volume and F_metric."""
    V0, d = np.abs(measures(rest, cells)), x.shape[1]
    s = np.linalg.svd(maps(rest, x, cells), compute_uv=False)
    J = s.prod(axis=1)
    pairs = [(j, k) for j in range(d) for k in range(j)]
    angle = sum(s[:, j] / s[:, k] + s[:, k] / s[:, j] - 2 for j, k in pairs)
    metric = ((s - 1) ** 2).sum(axis=1) - sum((s[:, j] - s[:, k]) ** 2 for j, k in pairs) / (d + 2)
    return [float((V0 * f).sum() / V0.sum()) for f in (angle, J + 1 / J - 2, metric)]
