#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/document/depth_region.h"
#include "app/document/solid_view.h"
#include "core/energy/material.h"
#include "core/integration/deformer.h"
#include "core/mesh/region.h"
#include "core/motion/handle.h"
#include "warp/outline.h"

namespace wend {

/// The project as the file describes it (shared contract): values only, no meshes or pictures.
enum class DomainKind { Image, Mesh, Surface };
enum class OutlineKind { Frame, Alpha, Polygons };
/// What carries a surface: its own volume or a cage around it; `Automatic` takes the cage where the exact
/// surface cannot be meshed or has far more vertices than are aimed at.
enum class Fit { Automatic, Exact, Cage };
/// What lies on the frame of a picture: moves with the rest of it, stays where it is, or slides along the
/// frame's sides.
enum class Border { Free, Fixed, Slide };

/// Where cells are to be finer or coarser than elsewhere.
template <int Dim>
struct SizeRegionIn {
    std::string name;  // regions of one name were painted together; may be empty
    Region<Dim> shape;
    double feather = 0;
    double factor = 1;  // of the length of edges
    Extras extras = {};
    bool operator==(const SizeRegionIn&) const = default;
};
using SizeRegion = SizeRegionIn<3>;

struct Domain {
    DomainKind kind = DomainKind::Image;
    std::string path;     // of the image, mesh or surface, relative to the project file
    std::string texture;  // Mesh: an optional image
    OutlineKind outline = OutlineKind::Frame;
    AlphaOutlineOptions alpha;
    Outline polygons;
    Border border = Border::Free;  // Image
    int vertices = 5000;
    double edge = 0;                         // > 0: wins over vertices
    double quality = 1.414;                  // Surface
    double maxVolume = 0;                    // Surface; > 0: wins over vertices
    bool refineSurface = false;              // Surface: its triangles may be split
    bool repair = false;                     // Surface: the simple repairs are made first
    int largestHole = 30;                    // edges of a hole that the repair closes
    std::string sizesFile;                   // Surface: a factor per vertex, painted
    std::vector<SizeRegion> sizes;           // Surface: later ones win
    std::vector<SizeRegionIn<2>> flatSizes;  // Image: the same of a picture
    std::string detail;                      // Surface, Mesh in space: a surface embedded in the solid
    Fit fit = Fit::Automatic;                // Surface
    double cageDetail = 0;                   // Surface: see CageOptions; 0: as fine as the cells
    double cageOffset = 1.0 / 15;            // Surface: see CageOptions
};

template <int Dim>
struct Stiffness {
    Vec<Dim> axis;
    double ratio = 1;  // s ≥ 1: B₀ = I + (s − 1) a aᵀ
};

/// Pictures that say what a region of the plane keeps, how stiff it is and along which direction: see
/// material_picture.h. Without one it stays as it is there.
struct MaterialPictures {
    std::string phi, stiffness, direction;
    bool up = false;   // their first row lies where y is greatest
    int readings = 0;  // other than before: they were written anew; not in the file

    bool any() const { return !(phi + stiffness + direction).empty(); }
    bool operator==(const MaterialPictures&) const = default;
};

template <int Dim>
struct MaterialRegion {
    std::string name;
    Region<Dim> shape;
    double feather = 0;
    std::optional<double> phi;
    std::optional<Stiffness<Dim>> stiffness;
    MaterialPictures pictures = {};  // in the plane only, instead of phi and stiffness; they fill a box
    bool hidden = false;             // changes nothing, as if it were not there
    Extras extras = {};
};

template <int Dim>
struct MaterialSpec {
    double phi = phi::kMetr;
    Smoothing smoothing;
    double memory = 0;                         // ρ
    std::vector<MaterialRegion<Dim>> regions;  // later ones win
    std::vector<double> cellPhi;               // material.cells, if given
    std::vector<Mat<Dim>> cellB;
    std::string cellsFile;  // where material.cells names a file
};

template <int Dim>
struct Design {
    MaterialSpec<Dim> material;
    std::vector<Handle<Dim>> handles;
};

struct Project {
    Domain domain;
    std::variant<Design<2>, Design<3>> design;
    std::vector<DepthRegion> depth;  // in the plane; later ones win, and elsewhere the order is 0
    double end = 1;
    std::vector<SettleWindow> settle;  // in the order of time; none ends after `end`
    SolidView view;                    // in space
    IntegrationOptions integration;    // end and settle are not looked at: see integrationOf()
    Extras extras = {};                // of everything but regions, handles and motions, which keep their own

    int dimension() const { return design.index() == 0 ? 2 : 3; }
};

/// Adds a window of settling, which `end` covers then.
inline void appendSettling(Project& project, double from, double length = 1) {
    project.settle.push_back({from, from + length});
    project.end = std::max(project.end, from + length);
}

/// How the project is integrated, with its end: for every deformer of it.
inline IntegrationOptions integrationOf(const Project& project) {
    IntegrationOptions options = project.integration;
    options.end = project.end;
    options.settle = project.settle;
    return options;
}

/// A loaded project and what the user should hear about it.
struct LoadedProject {
    Project project;
    std::vector<std::string> warnings;  // unknown keys …
};

/// Throws InputError(path, reason with line or key such as `handles[2].motion[0].points`). The dimension is
/// that of the domain; a mesh domain's file is opened for it, and if that fails the coordinates tell (the
/// scene reports the file).
LoadedProject readProject(const std::string& path);
LoadedProject parseProject(const std::string& text, const std::string& path);

/// UTF-8 JSON, written whole or not at all. The domain's relative paths refer to `folder` (empty: the folder
/// of `path`) and are written relative to `path`. readProject of the result is the same project. Throws
/// InputError.
void writeProject(const std::string& path, const Project& project, const std::string& folder = {});
std::string toJson(const Project& project);

/// The files that a project names, in their places.
std::vector<std::string*> filesOf(Project& project);

/// The file of material.cells, a JSON object {"phi": [one per cell], "B": [[row-major] per cell]}, or a mesh
/// file with these as values per cell (.vtu, .vtk); `path` as it is. Throws InputError(path, key and
/// reason).
template <int Dim>
void readCells(const std::string& path, MaterialSpec<Dim>& spec);

/// One number per line or separated by blanks, each a factor in range of domain.sizes[].factor; as many as
/// `count`. Throws InputError(path, place and reason).
std::vector<double> readSizes(const std::string& path, int count);

/// An outline in a file of its own: {"polygons": [outer, hole, …]}. Throws InputError(path, key and reason).
Outline readOutlineFile(const std::string& path);

/// The folder that the paths in this file are relative to.
std::string folderOf(const std::string& path);
/// `file` as the project means it: relative to the folder, unless absolute.
std::string pathIn(const std::string& folder, const std::string& file);

}  // namespace wend
