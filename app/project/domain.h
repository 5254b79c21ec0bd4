#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/project/layer.h"
#include "app/project/part.h"
#include "core/meshing/outline.h"
#include "core/meshing/shell_spaces.h"
#include "core/meshing/surface_fixes.h"
#include "warp/alpha_outline_options.h"

namespace wend {

enum class DomainKind { Image, Mesh, Surface };
/// The place of the cut-out whose holes are filled in the list of outlines, behind those kinds.
inline constexpr int kFilledCutOut = 3;
/// Selects what carries a surface: its own volume or a cage around it. `Automatic` takes the cage if the
/// exact surface cannot be meshed or has far more vertices than the target.
enum class Fit { Automatic, Exact, Cage };
/// Selects whether the border of a picture moves with the rest of it, is fixed, or slides along the sides of
/// the frame.
enum class Border { Free, Fixed, Slide };

/// The domain that a project deforms, as its file describes it.
struct Domain {
    DomainKind kind = DomainKind::Image;
    std::string path;                // of the image, mesh or surface, relative to the project file
    std::string texture;             // Mesh: an optional image
    std::array<int, 2> size{0, 0};   // Image: of the picture that coordinates refer to; 0: as the file has it
    int readings = 0;                // of the picture: increases when the file was rewritten; not stored
    std::vector<PicturePart> parts;  // Image: from front to back, in the place of `path`
    OutlineKind outline = OutlineKind::Frame;
    AlphaOutlineOptions alpha;
    Outline polygons;
    Border border = Border::Free;  // Image
    int vertices = 5000;
    double edge = 0;                    // > 0: wins over vertices
    double quality = 1.414;             // Surface
    double maxVolume = 0;               // Surface; > 0: wins over vertices
    bool refineSurface = false;         // Surface: its triangles may be split
    Shells shells = Shells::Automatic;  // Surface
    std::vector<SurfaceFix> fixes;      // Surface: single faults that are fixed before anything else
    bool repair = false;                // Surface: the simple repairs are made first
    int largestHole = 30;               // edges of a hole that the repair closes
    std::string sizesFile;              // Surface: a factor per vertex, painted
    std::vector<ValueLayer> sizes;      // Image, Surface: factors of the lengths of edges
    std::string detail;                 // Surface, Mesh in space: a surface embedded in the solid
    Fit fit = Fit::Automatic;           // Surface
    double cageDetail = 0;              // Surface: see CageOptions; 0: as fine as the cells
    double cageOffset = 1.0 / 15;       // Surface: see CageOptions
};

}  // namespace wend
