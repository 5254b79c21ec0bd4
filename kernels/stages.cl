// This file sums vectors that are kept on the device. All vectors are in one buffer, in slots of `count`
// numbers. It is built with -DDIM=2|3.

#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

// The i-th of up to eight terms; `terms` and the weights are the same for all work items.
#define ADD(i, sum, k) \
    if (terms > i) sum += weights.s##i * slots[(size_t)slot.s##i * count + (k)]
#define ADD_ALL(sum, k) \
    ADD(0, sum, k);     \
    ADD(1, sum, k);     \
    ADD(2, sum, k);     \
    ADD(3, sum, k);     \
    ADD(4, sum, k);     \
    ADD(5, sum, k);     \
    ADD(6, sum, k);     \
    ADD(7, sum, k)

// target = y + Σ weight · vector, by coordinates: 1 work item does 1 number.
kernel void combine(int count, int terms, global const double* slots, int y, int8 slot, double8 weights,
                    global double* target) {
    const int k = get_global_id(0);
    if (k >= count) return;
    double sum = slots[(size_t)y * count + k];
    ADD_ALL(sum, k);
    target[k] = sum;
}

// The largest |Σ weight · vector|² of the vertices of every chunk.
kernel void maximum(int chunks, int count, int chunk, int terms, global const double* slots, int8 slot,
                    double8 weights, global double* parts) {
    const int c = get_global_id(0);
    if (c >= chunks) return;
    double most = 0.0;
    const int end = min(count, (c + 1) * chunk * DIM);
    for (int v = c * chunk * DIM; v < end; v += DIM) {
        double square = 0.0;
        for (int a = 0; a < DIM; ++a) {
            double sum = 0.0;
            ADD_ALL(sum, v + a);
            square += sum * sum;
        }
        most = square > most || isnan(square) ? square : most;
    }
    parts[c] = most;
}

// The largest |a − b| of the numbers of every chunk, b being a slot.
kernel void farthest(int chunks, int count, int chunk, global const double* a, global const double* slots,
                     int b, global double* parts) {
    const int c = get_global_id(0);
    if (c >= chunks) return;
    double most = 0.0;
    const int end = min(count, (c + 1) * chunk * DIM);
    for (int k = c * chunk * DIM; k < end; ++k) {
        const double difference = fabs(a[k] - slots[(size_t)b * count + k]);
        most = difference > most || isnan(difference) ? difference : most;
    }
    parts[c] = most;
}
