#pragma once

#include "app/document/design.h"
#include "app/document/project_fwd.h"
#include "warp/image.h"

namespace wend {

/// What a picture of the material shows, in gray:
/// Keep: φ, black Area, a third of white Length, two thirds Rigid, white Angle, and evenly in φ between them.
/// Stiffness: how many times stiffer, black ×1, white ×1000, evenly in the logarithm.
/// Direction: that of what is stiff, as an angle against the horizontal, counter-clockwise as one sees it:
/// black 0°, middle gray 90°, white 180°, which is 0° again.
/// Numbers are taken as they stand in the file, without gamma or profile. Transparent: as it is there.
enum class MaterialPart { Keep, Stiffness, Direction };
inline constexpr double kStiffestGray = 1000;

inline constexpr std::array kMaterialParts{MaterialPart::Keep, MaterialPart::Stiffness,
                                           MaterialPart::Direction};

/// Where the file of a part stands.
std::string MaterialPictures::*fileOf(MaterialPart part);

/// Where pictures of a shape's material lie: over its picture, pixel by pixel, or around its mesh.
struct PictureFrame {
    Box<2> box{Vec<2>::Zero(), Vec<2>::Zero()};
    bool up = false;  // the first row lies where y is largest
    int width = 0, height = 0;
};
/// `width` and `height`: of the picture that is the domain; 0: of a mesh.
PictureFrame pictureFrame(int width, int height, const SimplicialMesh<2>& rest);
/// The same without a scene; reads the picture's header or the mesh. Throws InputError.
PictureFrame pictureFrame(const Domain& domain, const std::string& folder);

/// Gray and alpha in 16 bits; transparent where the shape is not.
Image materialPicture(MaterialPart part, const PictureFrame& frame, const SimplicialMesh<2>& rest,
                      const Material<2>& material);

/// Such pictures upon a material: every cell takes the mean of the pixels in it. Throws InputError.
void layPictures(const MaterialRegion<2>& region, const SimplicialMesh<2>& rest, const std::string& folder,
                 Material<2>& material);

}  // namespace wend
