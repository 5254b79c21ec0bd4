#include "app/engine/applied_motion.h"

#include "app/engine/shape/held_border.h"
#include "app/engine/shape/shape_builder.h"
#include "app/project/design.h"
#include "app/project/edits/scaled_project.h"
#include "app/project/file/named_files.h"
#include "app/project/file/project_reader.h"
#include "core/base/error.h"

namespace wend {
namespace {

template <int Dim>
std::vector<Pin> ownHandles(const Project& project, const Shape<Dim>& shape) {
    std::vector<Pin> handles;
    for (const Handle<Dim>& handle : heldHandles<Dim>(project, shape)) handles.push_back(inSpace(handle));
    handles.resize(designOf(project).handles.size());
    return handles;
}

}  // namespace

TransferredMotion withMotionOf(const std::string& source, const Project& target, const std::string& folder,
                               std::stop_token stop) {
    const LoadedProject other = readProject(source);
    fitToPicture(*other.project, folderOf(source));
    if (dimensionOf(*other.project) != dimensionOf(target))
        throw InputError(source, dimensionOf(target) == 2
                                     ? sentence("Core", "moves a solid: its motion does not fit a picture")
                                     : sentence("Core", "moves a picture: its motion does not fit a solid"));
    const AnyShape shape = loadShape(target, folder, stop);
    const auto transfer = [&]<int Dim>(const Shape<Dim>& own) {
        const auto theirs = std::get<Shape<Dim>>(loadShape(*other.project, folderOf(source), stop));
        return withMotionOf<Dim>({*other.project, *theirs.rest, ownHandles(*other.project, theirs)},
                                 {target, *own.rest, ownHandles(target, own)}, folder);
    };
    try {
        return std::visit(transfer, shape);
    } catch (const InputError& error) {
        throw error.named(source);
    }
}

}  // namespace wend
