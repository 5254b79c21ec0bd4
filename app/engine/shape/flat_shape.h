#pragma once

#include <stop_token>

#include "app/engine/shape/shape.h"
#include "app/project/project_fwd.h"
#include "core/base/message.h"
#include "core/meshing/outline.h"

namespace wend {

/// Returns the picture of the domain, or null if it has none; collects the notices of readImage().
std::shared_ptr<const Image> loadPicture(const Domain& domain, const std::string& folder,
                                         std::vector<Message>* notices = nullptr);

/// Returns the outline of the deformed part of a picture.
Outline domainOutline(const Domain& domain, const Image& picture);

/// Returns whether the mesher takes the point: inside by the even-odd rule, or on the border within rounding.
bool isInOutline(const Outline& outline, const Vec2& p);

/// Returns the mesh of an outline; points of handles that hold from the start become vertices.
std::shared_ptr<const SimplicialMesh<2>> meshPicture(const Domain& domain, const Design& design,
                                                     const Outline& outline, std::stop_token stop = {});

/// Tells of a mesh that has far more vertices than were aimed at.
void tellOfAim(const Domain& domain, const SimplicialMesh<2>& mesh, std::vector<Message>& notices);

/// Returns the shape of a file's mesh in the plane, without material. Throws InputError that names the file.
Shape<2> loadFlatMesh(const Domain& domain, const std::string& folder);

/// Returns WarpOptions::restMargin for the domain's outline: the margin that was added to an outline from
/// alpha.
int restMarginOf(const Domain& domain);

/// Places the rest mesh in the picture: with uv (one per vertex, origin at the bottom left), by them, and
/// poses through the best affine map; without uv, coordinates are pixels.
Texture textureOf(const Image& picture, std::shared_ptr<const SimplicialMesh<2>> rest,
                  const Eigen::Matrix2Xd& uv);

}  // namespace wend
