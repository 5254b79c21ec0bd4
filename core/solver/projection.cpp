#include "core/solver/projection.h"

#include <map>
#include <numeric>

namespace wend {
namespace {

/// Returns the groups of rows that share movable vertices, each ascending. They are corrected separately, by
/// dense matrices of their own size.
std::vector<std::vector<int>> clustersOf(const std::vector<ConstraintRow>& rows,
                                         const std::vector<int>& members, const std::vector<bool>& isFixed) {
    std::vector<int> parent(members.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    std::map<int, int> firstUser;
    for (std::size_t i = 0; i < members.size(); ++i)
        for (const auto& [vertex, weight] : rows[members[i]].terms) {
            if (isFixed[vertex] || weight == 0) continue;
            const auto [user, isNew] = firstUser.try_emplace(vertex, static_cast<int>(i));
            if (!isNew) parent[root(static_cast<int>(i))] = root(user->second);
        }
    std::map<int, std::vector<int>> groups;
    for (std::size_t i = 0; i < members.size(); ++i) groups[root(static_cast<int>(i))].push_back(members[i]);
    std::vector<std::vector<int>> clusters;
    clusters.reserve(groups.size());
    for (auto& [key, group] : groups) clusters.push_back(std::move(group));
    return clusters;
}

}  // namespace

/// Sorts the independent rows into those that set a vertex, and clusters that share movable vertices.
template <int Dim>
Projection<Dim>::Projection(const std::vector<ConstraintRow>& rows,
                            const std::vector<DependentRow>& dependent, int vertexCount)
    : m_rows(rows) {
    std::vector<bool> skip(rows.size(), false), isFixed(vertexCount, false);
    for (const auto& d : dependent) skip[d.row] = true;
    std::vector<int> others;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (skip[i]) continue;
        if (rows[i].terms.size() > 1) {
            others.push_back(static_cast<int>(i));
            continue;
        }
        const auto [vertex, weight] = rows[i].terms.front();
        m_fixed.push_back({vertex, static_cast<int>(i), weight});
        isFixed[vertex] = true;
    }
    for (auto& cluster : clustersOf(m_rows, others, isFixed)) addCluster(std::move(cluster), isFixed);
}

template <int Dim>
void Projection<Dim>::addCluster(std::vector<int> rows, const std::vector<bool>& isFixed) {
    std::map<int, int> column;
    for (int row : rows)
        for (const auto& [vertex, weight] : m_rows[row].terms)
            if (!isFixed[vertex] && weight != 0) column.try_emplace(vertex, static_cast<int>(column.size()));
    Eigen::MatrixXd W = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()),
                                              static_cast<Eigen::Index>(column.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (const auto& [vertex, weight] : m_rows[rows[i]].terms)
            if (!isFixed[vertex] && weight != 0) W(static_cast<Eigen::Index>(i), column.at(vertex)) += weight;
    std::vector<int> vertices(column.size());
    for (const auto& [vertex, at] : column) vertices[at] = vertex;
    m_clusters.push_back({std::move(rows), std::move(vertices), RightInverse(W)});
}

template <int Dim>
void Projection<Dim>::correct(const Cluster& cluster, Points<Dim>& values, const Points<Dim>& targets) const {
    Eigen::MatrixXd residual(cluster.rows.size(), Dim);
    for (std::size_t i = 0; i < cluster.rows.size(); ++i) {
        Vec<Dim> r = targets.col(cluster.rows[i]);
        for (const auto& [vertex, weight] : m_rows[cluster.rows[i]].terms) r -= weight * values.col(vertex);
        residual.row(static_cast<Eigen::Index>(i)) = r.transpose();
    }
    const Eigen::MatrixXd correction = cluster.inverse.times(residual);
    for (std::size_t i = 0; i < cluster.vertices.size(); ++i)
        values.col(cluster.vertices[i]) += correction.row(static_cast<Eigen::Index>(i)).transpose();
}

template <int Dim>
void Projection<Dim>::apply(Points<Dim>& values, const Points<Dim>& targets) const {
    for (const auto& fixed : m_fixed) values.col(fixed.vertex) = targets.col(fixed.row) / fixed.weight;
    for (int pass = 0; pass < 2; ++pass)  // the second takes the rounding of the first away
        for (const auto& cluster : m_clusters) correct(cluster, values, targets);
}

template class Projection<2>;
template class Projection<3>;

}  // namespace wend
