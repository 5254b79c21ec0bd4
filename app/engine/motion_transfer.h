#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "app/project/pin.h"
#include "app/project/project_fwd.h"
#include "core/base/message.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// A project with the motion of another one, and messages for the user.
struct TransferredMotion {
    std::shared_ptr<Project> project;
    std::vector<Message> notices;
};

/// A project with its rest shape, and its handles with vertices in the numbers of that shape.
template <int Dim>
struct HeldShape {
    const Project& project;
    const SimplicialMesh<Dim>& rest;
    std::vector<Pin> handles;
};

/// Returns `target` with the motion of `source`: the motions of handles of the same name (of several, in
/// their order), the end, rate, cycle, settling and memory. Lengths are scaled by the ratio of the sizes of
/// both rest shapes (ShapeSize), about the handles' places at rest, which stay; angles and times are the
/// source's. A handle that the target lacks is added at the same place in proportion to both bounding boxes,
/// or left out where there is nothing; one that the source lacks holds still. `folder`: that of the target's
/// files. Throws InputError for a handle of the source without a place.
template <int Dim>
TransferredMotion withMotionOf(const HeldShape<Dim>& source, const HeldShape<Dim>& target,
                               const std::string& folder);

/// Returns the project, whose files are relative to `folder`, with the motion of the project in file
/// `source`; see withMotionOf(). Both shapes are built for that. Thread-safe. Throws InputError, and
/// Cancelled when stopped.
TransferredMotion withMotionOf(const std::string& source, const Project& target, const std::string& folder,
                               std::stop_token stop = {});

}  // namespace wend
