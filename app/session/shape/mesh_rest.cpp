#include "app/session/shape/mesh_rest.h"

#include <algorithm>

#include "core/mesh/hanging_parts.h"
#include "core/mesh/joined_parts.h"
#include "core/mesh/number_text.h"
#include "core/mesh/used_vertices.h"

namespace wend {
namespace {

/// Reports unused vertices of a file; the cells keep their numbers in outputs.
template <int Dim>
void tellOfUnused(const SimplicialMesh<Dim>& mesh, const std::vector<int>& carried,
                  std::vector<std::string>& notices) {
    auto used = usedVertices<Dim>(mesh.vertexCount(), mesh.cells);
    for (const int v : carried) used[static_cast<std::size_t>(v)] = true;
    const auto unused = std::ranges::count(used, false);
    if (unused == 0) return;
    const std::size_t twins = twinsOf<Dim>(mesh).size();
    if (unused == 1) {
        notices.push_back(std::string("1 vertex belongs to no cell") +
                          (twins > 0 ? "; it lies at the place of another and moves with it" : "") +
                          ". It stays in what is written: some solvers want it taken out first");
        return;
    }
    notices.push_back(
        std::to_string(unused) + " vertices belong to no cell" +
        (twins > 0 ? "; " + std::to_string(twins) + " of them lie at the place of another and move with it"
                   : "") +
        ". They stay in what is written: some solvers want them taken out first");
}

std::string jointName(const std::vector<int>& joint) {
    if (joint.size() == 1) return "vertex " + std::to_string(joint[0]);
    return "the edge " + std::to_string(joint.front()) + "–" + std::to_string(joint.back());
}

}  // namespace

template <int Dim>
std::string hangingNotice(const SimplicialMesh<Dim>& rest) {
    const auto parts = hangingParts<Dim>(rest);
    if (parts.empty()) return {};
    const HangingPart& first = parts.front();
    const std::string one = std::to_string(first.cells) + (first.cells == 1 ? " cell" : " cells"),
                      joint =
                          jointName(first.joint) + " near " + placeName<Dim>(rest.points.col(first.joint[0]));
    return (parts.size() == 1
                ? "a part of " + one + " hangs only on " + joint
                : std::to_string(parts.size()) + " parts hang only on a vertex or an edge, the first, of " +
                      one + ", on " + joint) +
           ": what turns freely there may be flung far away unless handles hold it";
}

template <int Dim>
void tellOfHanging(const SimplicialMesh<Dim>& rest, std::vector<std::string>& notices) {
    if (std::string notice = hangingNotice<Dim>(rest); !notice.empty()) notices.push_back(std::move(notice));
}

template <int Dim>
std::shared_ptr<const SimplicialMesh<Dim>> joinedRest(const SimplicialMesh<Dim>& mesh,
                                                      std::vector<std::string>& notices,
                                                      const std::vector<int>& carried) {
    tellOfUnused<Dim>(mesh, carried, notices);
    JoinedParts<Dim> joined = joinedParts<Dim>(mesh);
    if (joined.vertices > 0)
        notices.push_back("parts that touch vertex to vertex are connected: " +
                          std::to_string(joined.vertices) + " vertices move with others at the same place");
    return std::make_shared<const SimplicialMesh<Dim>>(std::move(joined.mesh));
}

template std::shared_ptr<const SimplicialMesh<2>> joinedRest<2>(const SimplicialMesh<2>&,
                                                                std::vector<std::string>&,
                                                                const std::vector<int>&);
template std::shared_ptr<const SimplicialMesh<3>> joinedRest<3>(const SimplicialMesh<3>&,
                                                                std::vector<std::string>&,
                                                                const std::vector<int>&);

template std::string hangingNotice<2>(const SimplicialMesh<2>&);
template std::string hangingNotice<3>(const SimplicialMesh<3>&);
template void tellOfHanging<2>(const SimplicialMesh<2>&, std::vector<std::string>&);
template void tellOfHanging<3>(const SimplicialMesh<3>&, std::vector<std::string>&);

}  // namespace wend
