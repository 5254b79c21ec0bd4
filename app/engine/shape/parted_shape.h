#pragma once

#include <stop_token>

#include "app/engine/shape/part_pictures.h"
#include "app/engine/shape/shape.h"
#include "app/project/project_fwd.h"

namespace wend {

/// Pictures, outlines in domain coordinates, and atlas of the newest shape, for the next one.
struct PartedCache {
    PartPictures pictures;
    std::vector<Sheet> outlinesOf;
    std::vector<PartOutline> outlinesFrom;
    std::vector<Outline> outlines;
    std::vector<Sheet> atlasOf;
    std::shared_ptr<const Image> atlas;
    std::vector<Vec2> places;  // of the sheets in it
};

/// Returns the shape of a picture of parts, without material. Each part has an outline and a mesh of its own;
/// one mesh holds them all, from the back to the front (SimplicialMesh::parts), with the welds of their
/// joints. Its picture is the parts' atlas. A part that is attached to another is drawn, but is not in that
/// mesh: its points are embedded in the mesh of the part at the end of the chain. Throws InputError:
/// "domain.parts[1]: …".
Shape<2> loadPartedShape(const Domain& domain, const Design& design, const std::string& folder,
                         PartedCache& cache, std::stop_token stop);

}  // namespace wend
