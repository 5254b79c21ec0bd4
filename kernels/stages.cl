// Vectors of a Runge–Kutta step, kept on the device: 1 work item does 1 vertex. Built with -DDIM=2|3.

#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

// target = y + Σ weights[i] · slopes[i], by coordinates; slope i begins at number i · count.
kernel void combine(int count, int stages, global const double* y, global const double* slopes,
                    global const double* weights, global double* target) {
    const int k = get_global_id(0);
    if (k >= count) return;
    double sum = 0.0;
    for (int i = 0; i < stages; ++i) sum += weights[i] * slopes[(size_t)i * count + k];
    target[k] = y[k] + sum;
}

// The greatest |Σ weights[i] · slopes[i]|² of the vertices of every chunk.
kernel void greatestError(int chunks, int vertices, int chunk, int stages, global const double* slopes,
                          global const double* weights, global double* greatest) {
    const int c = get_global_id(0);
    if (c >= chunks) return;
    double most = 0.0;
    const int end = min(vertices, (c + 1) * chunk);
    for (int v = c * chunk; v < end; ++v) {
        double square = 0.0;
        for (int a = 0; a < DIM; ++a) {
            double sum = 0.0;
            for (int i = 0; i < stages; ++i) sum += weights[i] * slopes[((size_t)i * vertices + v) * DIM + a];
            square += sum * sum;
        }
        most = square > most || isnan(square) ? square : most;
    }
    greatest[c] = most;
}
