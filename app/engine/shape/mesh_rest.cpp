#include "app/engine/shape/mesh_rest.h"

#include <algorithm>

#include "core/base/number_text.h"
#include "core/mesh/hanging_parts.h"
#include "core/mesh/joined_parts.h"
#include "core/mesh/used_vertices.h"

namespace wend {
namespace {

/// Reports unused vertices of a file; the cells keep their numbers in outputs.
template <int Dim>
void tellOfUnused(const SimplicialMesh<Dim>& mesh, const std::vector<int>& carried,
                  std::vector<Message>& notices) {
    auto used = usedVertices<Dim>(mesh.vertexCount(), mesh.cells);
    for (const int v : carried) used[static_cast<std::size_t>(v)] = true;
    const auto unused = std::ranges::count(used, false);
    if (unused == 0) return;
    const std::size_t twins = twinsOf<Dim>(mesh).size();
    if (unused == 1)
        notices.push_back(
            twins > 0
                ? sentence("Core",
                           "1 vertex belongs to no cell; it lies at the place of another and moves with it. "
                           "It stays "
                           "in what is written: some solvers want it taken out first")
                : sentence(
                      "Core",
                      "1 vertex belongs to no cell. It stays in what is written: some solvers want it taken "
                      "out first"));
    else if (twins > 0)
        notices.emplace_back(sentence("Core",
                                      "%1 vertices belong to no cell; %2 of them lie at the place of another "
                                      "and move with it. They "
                                      "stay in what is written: some solvers want them taken out first"),
                             unused, twins);
    else
        notices.emplace_back(
            sentence(
                "Core",
                "%1 vertices belong to no cell. They stay in what is written: some solvers want them taken "
                "out first"),
            unused);
}

Message jointName(const std::vector<int>& joint) {
    if (joint.size() == 1) return {sentence("Core", "vertex %1"), joint[0]};
    return {sentence("Core", "the edge %1"),
            std::to_string(joint.front()) + "–" + std::to_string(joint.back())};
}

}  // namespace

template <int Dim>
Message hangingNotice(const SimplicialMesh<Dim>& rest) {
    const auto parts = hangingParts<Dim>(rest);
    if (parts.empty()) return {};
    const HangingPart& first = parts.front();
    const Message cells(first.cells == 1 ? sentence("Core", "%1 cell") : sentence("Core", "%1 cells"),
                        first.cells),
        joint = jointName(first.joint);
    const std::string place = placeName<Dim>(rest.points.col(first.joint[0]));
    if (parts.size() == 1)
        return {
            sentence("Core",
                     "a part of %1 hangs only on %2 near %3: what turns freely there may be flung far away "
                     "unless handles hold it"),
            cells, joint, place};
    return {
        sentence(
            "Core",
            "%1 parts hang only on a vertex or an edge, the first, of %2, on %3 near %4: what turns freely "
            "there may be flung far away unless handles hold it"),
        parts.size(), cells, joint, place};
}

template <int Dim>
void tellOfHanging(const SimplicialMesh<Dim>& rest, std::vector<Message>& notices) {
    if (Message notice = hangingNotice<Dim>(rest); !notice.isEmpty()) notices.push_back(std::move(notice));
}

template <int Dim>
std::shared_ptr<const SimplicialMesh<Dim>> joinedRest(const SimplicialMesh<Dim>& mesh,
                                                      std::vector<Message>& notices,
                                                      const std::vector<int>& carried) {
    tellOfUnused<Dim>(mesh, carried, notices);
    JoinedParts<Dim> joined = joinedParts<Dim>(mesh);
    if (joined.vertices > 0)
        notices.emplace_back(
            sentence("Core",
                     "parts that touch vertex to vertex are connected: %1 vertices move with others "
                     "at the same place"),
            joined.vertices);
    return std::make_shared<const SimplicialMesh<Dim>>(std::move(joined.mesh));
}

template std::shared_ptr<const SimplicialMesh<2>> joinedRest<2>(const SimplicialMesh<2>&,
                                                                std::vector<Message>&,
                                                                const std::vector<int>&);
template std::shared_ptr<const SimplicialMesh<3>> joinedRest<3>(const SimplicialMesh<3>&,
                                                                std::vector<Message>&,
                                                                const std::vector<int>&);

template Message hangingNotice<2>(const SimplicialMesh<2>&);
template Message hangingNotice<3>(const SimplicialMesh<3>&);
template void tellOfHanging<2>(const SimplicialMesh<2>&, std::vector<Message>&);
template void tellOfHanging<3>(const SimplicialMesh<3>&, std::vector<Message>&);

}  // namespace wend
