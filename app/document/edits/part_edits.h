#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/document/part.h"
#include "app/document/project_fwd.h"

namespace wend {

/// The parts of a picture in another order: the one at `from` comes to the place `to`.
std::vector<PicturePart> withPartMoved(std::vector<PicturePart> parts, int from, int to);

/// A project in which a part has another name, wherever it is named: by joints, riders, cuts and handles.
std::shared_ptr<const Project> withPartName(const Project& project, int part, const std::string& name);

/// A project of the picture in that file in the place of its parts.
std::shared_ptr<const Project> withoutParts(const Project& project, const std::string& path);

/// Returns whether a part may ride on another one: that has to end at a part with a mesh, and joints need
/// one.
bool mayRide(const std::vector<PicturePart>& parts, int part, int on);

}  // namespace wend
