// How far every cell of a pose is from rest (core/energy/distortion). Built with -DDIM=2|3.
// One item does one cell, then one item one chunk of cells in their order: no atomics, the same bits every time.

#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

#if DIM == 2
// (σ₁ ± σ₂)² = |F|² ± 2 |det F| as sums of two squares, without cancellation; the greater one is the sum's.
void measures(double2 a, double2 b, double* angle, double* volume, double* metric) {
    const double det = a.x * b.y - a.y * b.x;
    const double conformal = (a.x + b.y) * (a.x + b.y) + (a.y - b.x) * (a.y - b.x);
    const double reflected = (a.x - b.y) * (a.x - b.y) + (a.y + b.x) * (a.y + b.x);
    const double difference = fmin(conformal, reflected), product = fabs(det);
    const double sum = sqrt(fmax(conformal, reflected)) - 2.0;
    *angle = difference / product;
    *volume = (product - 1.0) * (product - 1.0) / product;
    // Σ (σ − 1)² = ((σ₁ + σ₂ − 2)² + (σ₁ − σ₂)²) / 2
    *metric = (sum * sum + difference) / 2.0 - difference / 4.0;
}
#else
double pairOf(double a, double b) { return (a - b) * (a - b); }

// Turns two rows until they are orthogonal (Hestenes 1958).
void orthogonalize(double3* p, double3* q) {
    const double pq = dot(*p, *q);
    if (pq == 0.0) return;
    const double zeta = (dot(*q, *q) - dot(*p, *p)) / (2.0 * pq);
    const double t = (zeta < 0.0 ? -1.0 : 1.0) / (fabs(zeta) + sqrt(1.0 + zeta * zeta));
    const double c = 1.0 / sqrt(1.0 + t * t), s = c * t;
    const double3 turned = c * *p - s * *q;
    *q = s * *p + c * *q;
    *p = turned;
}

void measures(double3 a, double3 b, double3 c, double* angle, double* volume, double* metric) {
    for (int sweep = 0; sweep < 8; ++sweep) {
        orthogonalize(&a, &b);
        orthogonalize(&a, &c);
        orthogonalize(&b, &c);
    }
    const double x = sqrt(dot(a, a)), y = sqrt(dot(b, b)), z = sqrt(dot(c, c)), product = x * y * z;
    const double xy = pairOf(x, y), yz = pairOf(y, z), zx = pairOf(z, x);
    *angle = xy / (x * y) + yz / (y * z) + zx / (z * x);
    *volume = (product - 1.0) * (product - 1.0) / product;
    *metric = (x - 1.0) * (x - 1.0) + (y - 1.0) * (y - 1.0) + (z - 1.0) * (z - 1.0) - (xy + yz + zx) / 5.0;
}
#endif

// values: angle, volume, metric and det F, one after the other for all cells. restInverse: E₀⁻¹ by rows, E₀ the rest
// edges as rows; F maps rest edges to posed ones, and its rows here are those of E₀⁻¹ E, which is Fᵀ.
kernel void cellDistortion(int count, global const int* cells, global const double* pose,
                           global const double* restInverse, global double* values) {
    const int cell = get_global_id(0);
    if (cell >= count) return;
    double angle, volume, metric, det;
#if DIM == 2
    global const double* r = restInverse + 4 * (size_t)cell;
    const double2 o = vload2(cells[3 * cell], pose);
    const double2 e = vload2(cells[3 * cell + 1], pose) - o, f = vload2(cells[3 * cell + 2], pose) - o;
    const double2 a = r[0] * e + r[1] * f, b = r[2] * e + r[3] * f;
    det = a.x * b.y - a.y * b.x;
    measures(a, b, &angle, &volume, &metric);
#else
    global const double* r = restInverse + 9 * (size_t)cell;
    const double3 o = vload3(cells[4 * cell], pose);
    const double3 e = vload3(cells[4 * cell + 1], pose) - o, f = vload3(cells[4 * cell + 2], pose) - o,
                  g = vload3(cells[4 * cell + 3], pose) - o;
    const double3 a = r[0] * e + r[1] * f + r[2] * g, b = r[3] * e + r[4] * f + r[5] * g,
                  c = r[6] * e + r[7] * f + r[8] * g;
    det = dot(a, cross(b, c));
    measures(a, b, c, &angle, &volume, &metric);
#endif
    values[cell] = angle;
    values[count + cell] = volume;
    values[2 * count + cell] = metric;
    values[3 * count + cell] = det;
}

// sums: Σ weight · angle, volume, metric of every chunk of cells.
kernel void sumDistortion(int chunks, int count, int chunk, global const double* values, global const double* weights,
                          global double* sums) {
    const int k = get_global_id(0);
    if (k >= chunks) return;
    double angle = 0.0, volume = 0.0, metric = 0.0;
    const int end = min(count, (k + 1) * chunk);
    for (int cell = k * chunk; cell < end; ++cell) {
        angle += weights[cell] * values[cell];
        volume += weights[cell] * values[count + cell];
        metric += weights[cell] * values[2 * count + cell];
    }
    sums[3 * k] = angle;
    sums[3 * k + 1] = volume;
    sums[3 * k + 2] = metric;
}
