#include "app/engine/shape/mesh_verdict.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "core/mesh/quality.h"
#include "core/mesh/used_vertices.h"

namespace wend {
namespace {

constexpr double kRounding = 1e-6;  // of the ratio asked for
constexpr double kUsual = 8;        // times the ratio asked for
constexpr std::size_t kNamed = 5;

/// The triangles at each edge and at each vertex of a surface.
class Surroundings {
  public:
    explicit Surroundings(const Surface& surface) {
        const std::vector<int> first = firstAtPlace<3>(surface.points);
        for (int t = 0; t < surface.triangleCount(); ++t)
            for (int k = 0; k < 3; ++k) {
                const int a = first[surface.triangles[t][k]], b = first[surface.triangles[t][(k + 1) % 3]];
                m_atVertex[a].push_back(t);
                m_atEdge[std::minmax(a, b)].push_back(t);
            }
    }
    std::vector<int> of(const Cell<3>& cell) const {
        std::vector<int> found;
        const auto take = [&found](const auto& map, const auto& key) {
            const auto at = map.find(key);
            if (at != map.end()) found.insert(found.end(), at->second.begin(), at->second.end());
        };
        for (int j = 0; j < 4; ++j)
            for (int k = 0; k < j; ++k) take(m_atEdge, std::pair<int, int>(std::minmax(cell[j], cell[k])));
        for (int k = 0; found.empty() && k < 4; ++k) take(m_atVertex, cell[k]);
        return found;
    }

  private:
    std::map<int, std::vector<int>> m_atVertex;
    std::map<std::pair<int, int>, std::vector<int>> m_atEdge;
};

/// Four digits are enough to read.
std::string rounded(double value) {
    if (!std::isfinite(value)) return "∞";
    std::array<char, 32> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 4);
    return {digits.data(), end.ptr};
}

}  // namespace

MeshVerdict verdictOn(const SimplicialMesh<3>& mesh, const Surface& surface, double asked, bool kept) {
    MeshVerdict verdict;
    verdict.asked = asked;
    std::vector<std::pair<double, int>> bad;  // ratio and cell
    for (int c = 0; c < mesh.cellCount(); ++c) {
        const double ratio = cellQuality<3>(mesh.points, mesh.cells[c]).radiusEdgeRatio;
        if (ratio > verdict.got) verdict.worstCell = c;
        verdict.got = std::max(verdict.got, ratio);
        if (!(ratio <= asked * (1 + kRounding))) bad.emplace_back(-ratio, c);
    }
    verdict.cellsAbove = static_cast<int>(bad.size());
    if (!kept || bad.empty()) return verdict;
    std::ranges::sort(bad);
    const Surroundings around(surface);
    std::vector<bool> taken(surface.triangles.size(), false);
    for (const auto& [ratio, cell] : bad)
        for (const int facet : around.of(mesh.cells[cell])) {
            if (!taken[facet]) verdict.facets.push_back(facet);
            taken[facet] = true;
        }
    return verdict;
}

Message MeshVerdict::text() const {
    if (got <= kUsual * asked) return {};
    const Message worst(
        cellsAbove == 1
            ? sentence("Core",
                       "the worst cell has a ratio of radius to edge of %1, where %2 was asked for (%3 "
                       "cell is above it)")
            : sentence("Core",
                       "the worst cell has a ratio of radius to edge of %1, where %2 was asked for (%3 "
                       "cells are above it)"),
        rounded(got), rounded(asked), cellsAbove);
    if (facets.empty()) return worst;
    std::string named;
    for (std::size_t i = 0; i < std::min(kNamed, facets.size()); ++i)
        named += (i == 0 ? "" : ", ") + std::to_string(facets[i]);
    if (facets.size() <= kNamed)
        return {sentence("Core", "%1: the surface is kept as it is and forces it, at its triangles %2"),
                worst, named};
    return {
        sentence("Core", "%1: the surface is kept as it is and forces it, at its triangles %2 and %3 more"),
        worst, named, facets.size() - kNamed};
}

}  // namespace wend
