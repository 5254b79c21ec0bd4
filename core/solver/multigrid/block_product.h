#pragma once

namespace wend {

/// Computes y_i = Σ_k A_k x_column[k], k in [start[i], start[i + 1]), for the rows i of [begin, end), with
/// y_begin first. The blocks A are of size 2, 3, 6 or 12, column-major, in single precision; one float after
/// the last may be read. Sums are in double precision and run in the order of the blocks.
template <int Size>
void multiplyBlocks(const int* start, const int* column, const float* blocks, const double* x, int begin,
                    int end, double* y);

}  // namespace wend
