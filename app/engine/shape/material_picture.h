#pragma once

#include "app/project/design.h"
#include "app/project/project_fwd.h"
#include "warp/image.h"

namespace wend {

/// The meaning of the grey values of a material picture. Keep: φ, black Area, one third Length, two thirds
/// Rigid, white Angle, linear in φ between them. Stiffness: black ×1 to white ×1000, logarithmic. Direction:
/// the counter-clockwise angle to the horizontal, black 0°, mid grey 90°, white 180° (equal to 0°). Values
/// are read without gamma or profile. Transparent pixels keep the existing material.
enum class MaterialPart { Keep, Stiffness, Direction };
inline constexpr double kStiffestGray = 1000;

inline constexpr std::array kMaterialParts{MaterialPart::Keep, MaterialPart::Stiffness,
                                           MaterialPart::Direction};

/// Returns the member that names the file of a part.
std::string MaterialPictures::*fileOf(MaterialPart part);

/// Placement of material pictures: over the shape's picture pixel by pixel, or around its mesh.
struct PictureFrame {
    Box<2> box{Vec2::Zero(), Vec2::Zero()};
    bool up = false;  // the first row has the largest y
    int width = 0, height = 0;
};
/// Returns the frame of the picture of `width` × `height` pixels that is the domain; 0: that of a mesh.
PictureFrame pictureFrame(int width, int height, const SimplicialMesh<2>& rest);
/// Does the same without a scene; reads the picture's header or the mesh. Throws InputError.
PictureFrame pictureFrame(const Domain& domain, const std::string& folder);

/// Returns gray and alpha in 16 bits, transparent beside the shape.
Image materialPicture(MaterialPart part, const PictureFrame& frame, const SimplicialMesh<2>& rest,
                      const Material<2>& material);

/// Applies such pictures to a material: every cell takes the mean of the pixels in it. Throws InputError.
void layPictures(const MaterialRegion& region, const SimplicialMesh<2>& rest, const std::string& folder,
                 Material<2>& material);

}  // namespace wend
