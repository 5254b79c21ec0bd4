#include "core/integration/orientation.h"

namespace wend {

template <int Dim>
Orientation<Dim>::Orientation(std::shared_ptr<const SimplicialMesh<Dim>> rest)
    : m_rest(std::move(rest)), m_sign(cellMeasure<Dim>(m_rest->points, m_rest->cells.front()) > 0 ? 1 : -1) {}

template <int Dim>
int Orientation<Dim>::firstInverted(const Points<Dim>& shape) const {
    for (int c = 0; c < m_rest->cellCount(); ++c) {
        if (!(m_sign * cellMeasure<Dim>(shape, m_rest->cells[c]) > 0)) return c;
    }
    return -1;
}

template <int Dim>
int Orientation<Dim>::mostShrunk(const Points<Dim>& shape) const {
    int worst = 0;
    double least = 1e300;
    for (int c = 0; c < m_rest->cellCount(); ++c) {
        const double ratio =
            cellMeasure<Dim>(shape, m_rest->cells[c]) / cellMeasure<Dim>(m_rest->points, m_rest->cells[c]);
        if (ratio >= least) continue;
        least = ratio;
        worst = c;
    }
    return worst;
}

template class Orientation<2>;
template class Orientation<3>;

}  // namespace wend
