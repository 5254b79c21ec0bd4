#include "core/integration/orientation.h"

#include <algorithm>
#include <cmath>

namespace wend {

namespace {

// Relative to the flatness at rest: cells flatter than this are useless.
constexpr double kCrushed = 1e-9;
// Rounding of the coordinates' differences and products is a tenth of this (see isFlat()).
constexpr double kRounding = 1e-14;

/// Returns the measure of a square or cube on the cell's longest edge.
template <int Dim>
double cubeOnLongestEdge(const Points<Dim>& points, const Cell<Dim>& cell) {
    double longest = 0;  // squared
    for (int i = 0; i <= Dim; ++i)
        for (int j = 0; j < i; ++j)
            longest = std::max(longest, (points.col(cell[i]) - points.col(cell[j])).squaredNorm());
    return Dim == 2 ? longest : longest * std::sqrt(longest);
}

}  // namespace

template <int Dim>
Orientation<Dim>::Orientation(std::shared_ptr<const SimplicialMesh<Dim>> rest)
    : m_rest(std::move(rest)), m_sign(cellMeasure<Dim>(m_rest->points, m_rest->cells.front()) > 0 ? 1 : -1) {
    m_minimum.reserve(m_rest->cells.size());
    for (const Cell<Dim>& cell : m_rest->cells) {
        const double flatness =
            std::abs(cellMeasure<Dim>(m_rest->points, cell)) / cubeOnLongestEdge<Dim>(m_rest->points, cell);
        m_minimum.push_back(std::max(kCrushed * flatness, std::min(kRounding, 0.5 * flatness)));
    }
}

template <int Dim>
int Orientation<Dim>::firstInverted(const Points<Dim>& shape) const {
    for (int c = 0; c < m_rest->cellCount(); ++c) {
        const Cell<Dim>& cell = m_rest->cells[c];
        if (!(m_sign * cellMeasure<Dim>(shape, cell) > m_minimum[c] * cubeOnLongestEdge<Dim>(shape, cell)))
            return c;
    }
    return -1;
}

/// Compares the measure of every cell with that at rest.
template <int Dim>
int Orientation<Dim>::mostShrunk(const Points<Dim>& shape) const {
    int worst = 0;
    double minimum = 1e300;
    for (int c = 0; c < m_rest->cellCount(); ++c) {
        const double ratio =
            cellMeasure<Dim>(shape, m_rest->cells[c]) / cellMeasure<Dim>(m_rest->points, m_rest->cells[c]);
        if (ratio >= minimum) continue;
        minimum = ratio;
        worst = c;
    }
    return worst;
}

template class Orientation<2>;
template class Orientation<3>;

}  // namespace wend
