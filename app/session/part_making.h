#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/project/project_fwd.h"
#include "core/meshing/outline.h"
#include "warp/atlas.h"

namespace wend {

class ShapeSession;

/// Makes a part of what is in an area, in one undo step: it is cut out of the frontmost part that fills the
/// area, or of the whole picture, which is filled behind it, and welded where it hangs on the rest. A
/// photograph that fills its frame and has no pins is held. Says what has been made, or why it cannot be.
void makePart(ShapeSession& session, const Outline& area);

/// Does the same for the outline that the user has drawn in a picture; the rest of the picture becomes the
/// ground. Returns false if nothing is drawn.
bool makePartOfOutline(ShapeSession& session);

/// A piece of a picture without a pin, where other pieces have pins: it stays in place when they move.
struct StrayPart {
    std::string name;     // of a part of the picture; empty: it is an island of a picture without parts
    std::string host;     // the part that it could follow; empty: the rest of the picture
    Outline island = {};  // its border at rest
};

/// Returns them, without parts that cannot follow another one or are larger; none if nothing is held.
std::vector<StrayPart> strayParts(const ShapeSession& session);

/// Returns a project in which they follow their hosts; islands are cut out as parts of their own.
std::shared_ptr<const Project> withRiders(const Project& project, const std::vector<StrayPart>& strays);

/// The place where a limb that is cut out is connected to the rest.
struct PartSeam {
    Vec2 middle;
    double radius = 0;  // half the distance between its ends
};

/// Returns how much of an area a sheet covers: its pixels of at least half opacity.
double coveredArea(const Outline& area, const Sheet& sheet);

/// Returns the only stretch of an area's border at which the picture continues on both sides, if it is a
/// small part of the border; none for an area inside a picture, or with several such stretches.
std::optional<PartSeam> seamOf(const Outline& area, const Sheet& sheet);

/// Returns the area with a disc around the seam, which covers the joint however the limb is rotated.
Outline withCap(const Outline& area, const PartSeam& seam);

}  // namespace wend
