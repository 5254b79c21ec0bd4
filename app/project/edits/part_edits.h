#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/project/part.h"
#include "app/project/project_fwd.h"
#include "core/mesh/region.h"
#include "core/meshing/outline.h"

namespace wend {

/// Returns the parts of a picture with the one at `from` moved to the place `to`.
std::vector<PicturePart> withPartMoved(std::vector<PicturePart> parts, int from, int to);

/// Returns the project with another name of a part, also in joints, riders, cuts and handles.
std::shared_ptr<const Project> withPartName(const Project& project, int part, const std::string& name);

/// An area of a part that becomes a part of its own.
struct NewPart {
    std::string name;
    std::string from;  // the part, or the name that the whole picture gets if it has no parts yet
    Outline cut;
    double feather = 0;                // of its edge
    std::optional<Vec2> joint;         // where it is welded to the other one
    std::optional<Box<3>> heldGround;  // what a new handle holds of the other one
};

/// Returns the project with a new part in front of the one that it is cut from, which is filled behind it.
std::shared_ptr<const Project> withNewPart(const Project& project, const NewPart& made);

int partCount(const Project& project);

/// Returns whether the part of that name may not be edited by tools: it is locked, or hidden.
bool isProtected(const std::vector<PicturePart>& parts, const std::string& name);

/// Returns the project with the outline of a part, and the vertices that are set for it, in the place of
/// those of the whole picture: the settings of its domain are the part's.
std::shared_ptr<Project> asWhole(const Project& project, int part);

/// Returns a project in which a part has an outline of its own, or a number of vertices.
std::shared_ptr<const Project> withPartOutline(const Project& project, int part, PartOutline outline);
std::shared_ptr<const Project> withPartVertices(const Project& project, int part, int vertices);

/// Returns whether a part has an outline or vertices of its own, and a project in which it has those of all
/// again, or of what is cut out.
bool hasOwnOutline(const PicturePart& part);
std::shared_ptr<const Project> withoutOwnOutline(const Project& project, int part);

/// Returns a project in which a part is in front of all others from a time on, or behind all.
std::shared_ptr<const Project> withPartInFront(const Project& project, int part, double time, bool front);

/// Returns a project of the picture in that file, in place of its parts.
std::shared_ptr<const Project> withoutParts(const Project& project, const std::string& path);

/// Returns whether a part may be attached to another one: the chain must end at a part with a mesh, and
/// joints need one.
bool mayRide(const std::vector<PicturePart>& parts, int part, int on);

/// Sets the user's outline of a picture. Removes points of pins outside it, and pins without points. Returns
/// the number of removed pins.
int setOutline(Project& project, Outline outline);

/// Returns a project in which a part of the picture has that outline, with the number of removed pins: those
/// that name the part.
std::shared_ptr<const Project> withDrawnOutline(const Project& project, int part, Outline outline,
                                                int& pinsGone);

}  // namespace wend
