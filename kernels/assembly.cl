// These kernels compute, from a shape, the values of the matrix of the generalized metric energy (ARCHITECTURE.md; docs/method.md). Built with
//   -DDIM=2|3, -DANISOTROPIC if any cell has B ≠ I, and -DPAPER for the paper's smoothness: jumps of stress.
// matrices.cl precedes it. Corner = cell · (DIM + 1) + local index.
// Every sum runs in the plan's fixed order: no atomics, no local memory, the same bits whatever the device's parallelism.

#define CORNERS (DIM + 1)

// --- energy ---------------------------------------------------------------------------------------------------------

// Stress of a strain S = J + Jᵀ: P = 2 w_q (SB + BS) + w_r (d / Tr B) Tr(BS) B; for B = I 4 w_q S + w_r Tr(S) I.
mat stressOf(mat S, double2 weights, mat b) {
#ifdef ANISOTROPIC
    const mat SB = product(S, b);
    return add(scaled(2 * weights.x, add(SB, 1.0, transposed(SB))), weights.y * (DIM / trace(b)) * frobenius(b, S), b);
#else
    return add(scaled(4 * weights.x, S), weights.y * trace(S), identity(1.0));
#endif
}

// B of a cell, and the mean of two.
mat anisotropyOf(global const double* B, int cell) {
#ifdef ANISOTROPIC
    return loadMat(B, cell);
#else
    return identity(1.0);
#endif
}
mat meanAnisotropy(global const double* B, int i, int j) {
#ifdef ANISOTROPIC
    return scaled(0.5, add(loadMat(B, i), 1.0, loadMat(B, j)));
#else
    return identity(1.0);
#endif
}

// The weights of q between two cells: their means, without a positive part of dilation.
double2 jumpWeights(double2 i, double2 j) {
    return (double2)(0.5 * (i.x + j.x), fmin(0.5 * (i.y + j.y), 0.0));
}

// The edges x_k − x_0 of a cell as rows.
mat edgesOf(global const int* cells, global const double* shape, int cell) {
    const vec origin = load(shape, cells[CORNERS * cell]);
    const vec a = load(shape, cells[CORNERS * cell + 1]) - origin;
    const vec b = load(shape, cells[CORNERS * cell + 2]) - origin;
#if DIM == 3
    const vec c = load(shape, cells[CORNERS * cell + 3]) - origin;
    return rows(a, b, c);
#else
    return rows(a, b, ZERO);
#endif
}

// The rotation of the polar decomposition, by Newton's iteration X ← (X + X⁻ᵀ) / 2 with scaling by the determinant.
mat polarRotation(mat F) {
    mat X = F;
    for (int k = 0; k < 24; ++k) {
        const double det = determinant(X);
        const double scale = k < 4 ? pow(fabs(det), -1.0 / DIM) : 1.0;
        const mat inverse = scaled(1.0 / (det * scale), transposed(adjugate(X)));
        const mat next = scaled(0.5, add(scaled(scale, X), 1.0, inverse));
        const mat change = add(next, -1.0, X);
        X = next;
        if (frobenius(change, change) < 1e-31) break;
    }
    return X;
}

// --- a shape --------------------------------------------------------------------------------------------------------

// Hat gradients of all corners, measures, B(t) = R B₀ Rᵀ. bad[cell] = 1 for a cell that is not oriented as at rest.
kernel void setCells(int count, global const int* cells, global const double* shape, global const double* restMeasure,
                     global const double* restInverse, global const double* restB, global double* gradients,
                     global double* measure, global double* B, global int* bad) {
    const int cell = get_global_id(0);
    if (cell >= count) return;
    const mat E = edgesOf(cells, shape, cell);
    const double det = determinant(E);
    const double signedMeasure = det / (DIM == 2 ? 2.0 : 6.0);
    measure[cell] = fabs(signedMeasure);
    bad[cell] = !(signedMeasure * restMeasure[cell] > 0.0) || isinf(signedMeasure);
    // Columns of E⁻¹ are the gradients of the corners 1 … DIM; that of corner 0 makes their sum zero.
    const mat G = scaled(1.0 / det, transposed(adjugate(E)));
    vec sum = G.r0 + G.r1;
    store(gradients, CORNERS * cell + 1, G.r0);
    store(gradients, CORNERS * cell + 2, G.r1);
#if DIM == 3
    sum += G.r2;
    store(gradients, CORNERS * cell + 3, G.r2);
#endif
    store(gradients, CORNERS * cell, -sum);
#ifdef ANISOTROPIC
    // Rows of E are edges: F = Eᵀ E₀⁻ᵀ.
    const mat F = product(transposed(E), transposed(loadMat(restInverse, cell)));
    const mat R = polarRotation(F);
    storeMat(B, cell, product(product(R, loadMat(restB, cell)), transposed(R)));
#endif
}

// The first bad cell of each chunk, or count.
kernel void firstBad(int count, int chunk, global const int* bad, global int* first) {
    const int item = get_global_id(0);
    const int begin = item * chunk, end = min(count, begin + chunk);
    int found = count;
    for (int cell = end - 1; cell >= begin; --cell)
        if (bad[cell]) found = cell;
    first[item] = found;
}

vec centroid(global const int* cells, global const double* shape, int cell) {
    vec sum = ZERO;
    for (int k = 0; k < CORNERS; ++k) sum += load(shape, cells[CORNERS * cell + k]);
    return sum / (double)CORNERS;
}

// Weight of the jump per interior facet: factor · B_ij / h_ij (invariant) or factor · B_ij (paper).
kernel void setFacets(int count, global const int* cells, global const int* facets, global const double* shape,
                      double factor, global double* weight) {
    const int facet = get_global_id(0);
    if (facet >= count) return;
    global const int* f = facets + (DIM + 2) * facet;  // vertices, then the two cells
    const vec a = load(shape, f[1]) - load(shape, f[0]);
#if DIM == 2
    const double size = length(a);
#else
    const double size = 0.5 * length(cross(a, load(shape, f[2]) - load(shape, f[0])));
#endif
#ifdef PAPER
    weight[facet] = factor * size;
#else
    weight[facet] = factor * size / length(centroid(cells, shape, f[DIM + 1]) - centroid(cells, shape, f[DIM]));
#endif
}

int across(global const int* facets, int facet, int cell) {
    global const int* sides = facets + (DIM + 2) * facet + DIM;
    return sides[0] == cell ? sides[1] : sides[0];
}

// Returns for a cell the sum over its facets of weight or, with B = I except for the paper's kind, of weight
// · (q, r) of the jump.
kernel void setBeta(int count, global const int* facetOfCorner, global const int* facets, global const double2* weights,
                    global const double* weight, global double2* beta) {
    const int cell = get_global_id(0);
    if (cell >= count) return;
    double2 sum = 0;
    for (int k = 0; k < CORNERS; ++k) {
        const int facet = facetOfCorner[CORNERS * cell + k];
        if (facet < 0) continue;
#ifdef PAPER
        sum.x += weight[facet];
#else
        sum += weight[facet] * jumpWeights(weights[cell], weights[across(facets, facet, cell)]);
#endif
    }
    beta[cell] = sum;
}

// --- the matrix -----------------------------------------------------------------------------------------------------

// Column j of a block, 2 R g for R = the stress that e_j at the right corner brings to the left corner's cell:
// scale · 4 w_q ((Bh) gᵀ + (g·h) B + (g·Bh) I + h (Bg)ᵀ) + scale · 4 w_r (d / Tr B) (Bg) (Bh)ᵀ.
vec blockColumn(int j, vec g, vec h, double scale, double2 w, mat b) {
    const vec bg = times(b, g), bh = times(b, h);
    const vec shear = GET(g, j) * bh + dot(g, h) * times(b, UNIT(j)) + dot(g, bh) * UNIT(j) + GET(bg, j) * h;
    return 4 * scale * (w.x * shear + w.y * (DIM / trace(b)) * GET(bh, j) * bg);
}
// The paper's kind: the stress of a stress.
mat strainOf(int j, vec h) { const mat m = outer(UNIT(j), h); return add(m, 1.0, transposed(m)); }
vec twiceColumn(int j, vec g, vec h, double weight, double2 wl, mat bl, double2 wr, mat br) {
    return 2 * weight * times(stressOf(stressOf(strainOf(j, h), wr, br), wl, bl), g);
}
// 2 a ((g·h) e_j + h g_j) + 4 b g h_j, the same in closed form for B = I: D = α I + ρ 1 1ᵀ with α = 4 w_q, ρ = w_r.
vec closedColumn(int j, vec g, vec h, double a, double b) {
    return 2 * a * (dot(g, h) * UNIT(j) + GET(g, j) * h) + 4 * b * GET(h, j) * g;
}

// Column j of what a cell brings to the block of two of its corners: ¼ V D, and of its facets.
vec ownColumn(int j, vec g, vec h, int cell, double quarter, double2 w, double2 beta, global const double* B,
              global const int* facetOfCorner, global const int* facets, global const double* facetWeight,
              global const double2* weights) {
#ifdef ANISOTROPIC
    const mat b = loadMat(B, cell);
    vec column = blockColumn(j, g, h, quarter, w, b);
#ifdef PAPER
    return column + twiceColumn(j, g, h, beta.x, w, b, w, b);
#else
    for (int k = 0; k < CORNERS; ++k) {
        const int facet = facetOfCorner[CORNERS * cell + k];
        if (facet < 0) continue;
        const int other = across(facets, facet, cell);
        column += blockColumn(j, g, h, 0.25 * facetWeight[facet], jumpWeights(w, weights[other]),
                              meanAnisotropy(B, cell, other));
    }
    return column;
#endif
#else
    const double alpha = 4 * w.x, rho = w.y;
#ifdef PAPER
    return closedColumn(j, g, h, quarter * alpha + beta.x * alpha * alpha,
                        quarter * rho + beta.x * (2 * alpha * rho + DIM * rho * rho));
#else
    return closedColumn(j, g, h, quarter * alpha + beta.x, quarter * rho + 0.25 * beta.y);
#endif
#endif
}

// Column j of what a facet brings to the block of corners of its two cells.
vec crossColumn(int j, vec g, vec h, double weight, int left, int right, global const double* B,
                global const double2* weights) {
    const double2 wl = weights[left], wr = weights[right];
#ifdef PAPER
#ifdef ANISOTROPIC
    return twiceColumn(j, g, h, -weight, wl, loadMat(B, left), wr, loadMat(B, right));
#else
    const double al = 4 * wl.x, ar = 4 * wr.x, rl = wl.y, rr = wr.y;
    return closedColumn(j, g, h, -weight * al * ar, -weight * (al * rr + rl * ar + DIM * rl * rr));
#endif
#else
    const double2 w = jumpWeights(wl, wr);
#ifdef ANISOTROPIC
    return blockColumn(j, g, h, -0.25 * weight, w, meanAnisotropy(B, left, right));
#else
    return closedColumn(j, g, h, -weight * w.x, -0.25 * weight * w.y);
#endif
#endif
}

// Blocks (column-major) of the lower triangle, each gathered from its contributions.
kernel void assemble(int count, global const int* ownStart, global const int2* own, global const int* crossStart,
                     global const int* crossContributions, global const int* facetOfCorner, global const int* facets,
                     global const double* gradients, global const double* measure, global const double2* weights,
                     global const double2* beta, global const double* facetWeight, global const double* massRegularization,
                     global const double* B, global double* values) {
    const int block = get_global_id(0);
    if (block >= count) return;
    vec c0 = ZERO, c1 = ZERO, c2 = ZERO;
    for (int k = ownStart[block]; k < ownStart[block + 1]; ++k) {
        const int2 corners = own[k];
        const int cell = corners.x / CORNERS;
        const vec g = load(gradients, corners.x), h = load(gradients, corners.y);
        const double quarter = 0.25 * measure[cell];
        const double2 w = weights[cell], b = beta[cell];
        const double mass = massRegularization[cell] * measure[cell] * (corners.x == corners.y ? 2.0 : 1.0) / ((DIM + 1) * (DIM + 2));
        c0 += ownColumn(0, g, h, cell, quarter, w, b, B, facetOfCorner, facets, facetWeight, weights) + mass * UNIT(0);
        c1 += ownColumn(1, g, h, cell, quarter, w, b, B, facetOfCorner, facets, facetWeight, weights) + mass * UNIT(1);
#if DIM == 3
        c2 += ownColumn(2, g, h, cell, quarter, w, b, B, facetOfCorner, facets, facetWeight, weights) + mass * UNIT(2);
#endif
    }
    for (int k = crossStart[block]; k < crossStart[block + 1]; ++k) {
        const int left = crossContributions[3 * k], right = crossContributions[3 * k + 1];
        const double weight = facetWeight[crossContributions[3 * k + 2]];
        const vec g = load(gradients, left), h = load(gradients, right);
        c0 += crossColumn(0, g, h, weight, left / CORNERS, right / CORNERS, B, weights);
        c1 += crossColumn(1, g, h, weight, left / CORNERS, right / CORNERS, B, weights);
#if DIM == 3
        c2 += crossColumn(2, g, h, weight, left / CORNERS, right / CORNERS, B, weights);
#endif
    }
    store(values, DIM * block, c0);
    store(values, DIM * block + 1, c1);
#if DIM == 3
    store(values, DIM * block + 2, c2);
#endif
}

// --- products without the matrix ------------------------------------------------------------------------------------

// S and P = D S of a nodal field, per cell.
kernel void cellStress(int count, global const int* cells, global const double* gradients, global const double2* weights,
                       global const double* B, global const double* v, global double* strain, global double* stress) {
    const int cell = get_global_id(0);
    if (cell >= count) return;
    mat J = identity(0.0);
    for (int k = 0; k < CORNERS; ++k)
        J = add(J, 1.0, outer(load(v, cells[CORNERS * cell + k]), load(gradients, CORNERS * cell + k)));
    const mat S = add(J, 1.0, transposed(J));
    storeMat(strain, cell, S);
    storeMat(stress, cell, stressOf(S, weights[cell], anisotropyOf(B, cell)));
}

// R = ¼ V P + ¼ Σ weight D_facet (S − S_neighbour), and the cell's energy ¼ V S : P + half that of its facets; with the
// paper's kind R = ¼ V P + D Σ weight (P − P_neighbour).
kernel void cellForce(int count, global const int* facetOfCorner, global const int* facets, global const double* facetWeight,
                      global const double* measure, global const double2* weights, global const double* B,
                      global const double* strain, global const double* stress, global double* force,
                      global double* cellEnergy) {
    const int cell = get_global_id(0);
    if (cell >= count) return;
    const mat S = loadMat(strain, cell), P = loadMat(stress, cell);
    mat jump = identity(0.0);
    double energy = 0.25 * measure[cell] * frobenius(S, P);
    for (int k = 0; k < CORNERS; ++k) {
        const int facet = facetOfCorner[CORNERS * cell + k];
        if (facet < 0) continue;
        const int other = across(facets, facet, cell);
#ifdef PAPER
        const mat difference = add(P, -1.0, loadMat(stress, other));
        jump = add(jump, facetWeight[facet], difference);
        energy += 0.5 * facetWeight[facet] * frobenius(difference, difference);
#else
        const mat difference = add(S, -1.0, loadMat(strain, other));
        const double2 w = jumpWeights(weights[cell], weights[other]);
        const mat D = stressOf(difference, w, meanAnisotropy(B, cell, other));
        jump = add(jump, 0.25 * facetWeight[facet], D);
        energy += 0.125 * facetWeight[facet] * frobenius(difference, D);
#endif
    }
#ifdef PAPER
    jump = stressOf(jump, weights[cell], anisotropyOf(B, cell));
#endif
    storeMat(force, cell, add(jump, 0.25 * measure[cell], P));
    cellEnergy[cell] = energy;
}

// A v per vertex: Σ over its corners 2 R g + ε V Σ_b m_ab v_b.
kernel void vertexForce(int count, global const int* cornerStart, global const int* corners, global const int* cells,
                        global const double* gradients, global const double* measure, global const double* massRegularization,
                        global const double* force, global const double* v, global double* Av) {
    const int vertex = get_global_id(0);
    if (vertex >= count) return;
    vec sum = ZERO;
    for (int k = cornerStart[vertex]; k < cornerStart[vertex + 1]; ++k) {
        const int corner = corners[k], cell = corner / CORNERS;
        sum += 2 * times(loadMat(force, cell), load(gradients, corner));
        if (massRegularization[cell] == 0.0) continue;
        vec total = load(v, vertex);
        for (int j = 0; j < CORNERS; ++j) total += load(v, cells[CORNERS * cell + j]);
        sum += massRegularization[cell] * measure[cell] / ((DIM + 1) * (DIM + 2)) * total;
    }
    store(Av, vertex, sum);
}
