#include "app/session/mesh_groups.h"

#include "app/project/design.h"
#include "app/project/edits/free_name.h"
#include "app/project/file/named_places.h"
#include "app/session/shape_session.h"
#include "core/base/error.h"
#include "core/mesh/group_vertices.h"
#include "core/mesh/mesh_of_file.h"

namespace wend {

std::vector<HeldGroup> heldGroups(const std::string& path) try {
    std::vector<HeldGroup> groups;
    const auto file = sharedMeshFile(path);
    for (const GroupFacts& facts : groupFacts(*file)) {
        HeldGroup group{
            facts.name.empty() ? std::to_string(facts.tag) : facts.name, facts.dimension, facts.count, {}};
        try {
            group.vertices = groupVertices(*file, group.name, group.dimension);
        } catch (const InputError&) {
            continue;  // a number that is also the name of another one
        }
        groups.push_back(std::move(group));
    }
    return groups;
} catch (const std::exception&) {
    return {};
}

void holdGroup(ShapeSession& session, const HeldGroup& group) {
    Document& document = session.document();
    const int count = session.handleCount();
    Design design = document.design();
    const std::vector<std::string> names = namesOf(design.handles);
    Pin& handle = design.handles.emplace_back();
    const bool isTaken = std::ranges::count(names, group.name) > 0;
    handle.name = isTaken ? freeName(names, group.name, 2) : group.name;
    placeOnGroup(handle, group.name, group.dimension, group.vertices);
    document.changeDesign(ShapeSession::tr("Hold %1").arg(QString::fromStdString(group.name)),
                          std::move(design));
    session.selection().set({count});
}

}  // namespace wend
