#pragma once

#include <array>

namespace wend {

/// The maps of many cells side by side, so that one instruction serves several of them.
template <int Dim>
struct Stretches {
    static constexpr int kCells = 64;
    using Lane = std::array<double, kCells>;

    std::array<Lane, Dim * Dim> maps;  // F, column by column
    std::array<Lane, Dim> sigma;       // its singular values
    Lane determinant;                  // of F
    std::array<bool, kCells> isExact;  // false where F is so far from rigid that σ lost digits
};

/// From the maps all else.
void computeStretches(Stretches<2>& cells);
void computeStretches(Stretches<3>& cells);

}  // namespace wend
