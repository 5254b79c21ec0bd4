#include "core/solver/welded_components.h"

#include <algorithm>

#include "core/base/disjoint_sets.h"
#include "core/mesh/decompositions.h"

namespace wend {
namespace {

// Thresholds above rounding: relative to an eigenvector's length, and to the sum of all eigenvalues.
constexpr double kPartOfVector = 1e-6, kLeastPart = 1e-14;

/// Returns the form S of some components, in their order.
template <int Dim>
Eigen::MatrixXd weldedSquare(const std::vector<int>& group, const std::vector<SimilaritySquare<Dim>>& squares,
                             const std::vector<WeldedPoint<Dim>>& welded) {
    constexpr int kModes = SimilarityVelocities<Dim>::ColsAtCompileTime;
    const auto size = static_cast<Eigen::Index>(group.size()) * kModes;
    Eigen::MatrixXd S = Eigen::MatrixXd::Zero(size, size);
    for (std::size_t i = 0; i < group.size(); ++i)
        S.block<kModes, kModes>(static_cast<Eigen::Index>(i) * kModes,
                                static_cast<Eigen::Index>(i) * kModes) =
            squares[static_cast<std::size_t>(group[i])];
    const auto placeOf = [&](int component) -> Eigen::Index {
        return kModes * (std::ranges::lower_bound(group, component) - group.begin());
    };
    for (const auto& [components, place] : welded) {
        if (!std::ranges::binary_search(group, components[0])) continue;
        const SimilarityVelocities<Dim> M = similarityVelocities<Dim>(place);
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j)
                S.block<kModes, kModes>(placeOf(components[i]), placeOf(components[j])) +=
                    (i == j ? 1 : -1) * M.transpose() * M;
    }
    return S;
}

}  // namespace

template <int Dim>
SimilarityVelocities<Dim> similarityVelocities(const Vec<Dim>& p) {
    SimilarityVelocities<Dim> velocities;
    velocities.setZero();
    velocities.template leftCols<Dim>().setIdentity();
    int mode = Dim;
    for (int a = 0; a < Dim; ++a)
        for (int b = a + 1; b < Dim; ++b, ++mode) velocities(a, mode) = -p[b], velocities(b, mode) = p[a];
    velocities.col(mode) = p;
    return velocities;
}

/// Considers the groups of components that welds connect, one after another.
template <int Dim>
void holdWelded(const std::vector<SimilaritySquare<Dim>>& squares,
                const std::vector<WeldedPoint<Dim>>& welded, double distinct, std::vector<bool>& held) {
    constexpr int kModes = SimilarityVelocities<Dim>::ColsAtCompileTime;
    DisjointSets sets(static_cast<int>(squares.size()));
    for (const auto& weld : welded) sets.join(weld.components[0], weld.components[1]);
    std::vector<std::vector<int>> groups(squares.size());
    for (int c = 0; c < static_cast<int>(squares.size()); ++c)
        groups[static_cast<std::size_t>(sets.root(c))].push_back(c);
    for (const std::vector<int>& group : groups) {
        if (group.size() < 2) continue;
        const Eigen::MatrixXd S = weldedSquare<Dim>(group, squares, welded);
        const EigenPairs modes = eigenPairs(S);
        const double least = std::max(distinct * distinct, kLeastPart * S.trace());
        std::vector<bool> isFree(group.size(), false);
        for (Eigen::Index k = 0; k < S.cols() && modes.values[k] <= least; ++k)
            for (std::size_t i = 0; i < group.size(); ++i)
                if (modes.vectors.col(k).segment<kModes>(static_cast<Eigen::Index>(i) * kModes).norm() >
                    kPartOfVector)
                    isFree[i] = true;
        for (std::size_t i = 0; i < group.size(); ++i) held[static_cast<std::size_t>(group[i])] = !isFree[i];
    }
}

#define WEND_INSTANTIATE(Dim)                                                      \
    template SimilarityVelocities<Dim> similarityVelocities<Dim>(const Vec<Dim>&); \
    template void holdWelded<Dim>(const std::vector<SimilaritySquare<Dim>>&,       \
                                  const std::vector<WeldedPoint<Dim>>&, double, std::vector<bool>&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)
#undef WEND_INSTANTIATE

}  // namespace wend
