#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/project/design.h"
#include "app/project/project_fwd.h"

namespace wend {

/// Material values of a region.
struct MaterialPaint {
    std::optional<double> phi;
    std::optional<Stiffness> stiffness;
};

/// Regions of one name: the strokes of a layer, or regions from a file. Values are those of the first region
/// that paints unless noted.
struct RegionGroup {
    std::string name;
    int count = 0;  // of those that paint
    double feather = 0;
    MaterialPaint paint = {};
    MaterialPictures pictures = {};
    bool hidden = false;
    std::optional<Vec3> axis = {};  // of the first that is stiff
    bool oneAxis = true;            // all that are stiff are so along it
};
std::vector<RegionGroup> regionGroups(const Design& design);

/// Returns how many regions from the first on belong to one layer: those of the same name.
std::size_t layerEnd(std::span<const MaterialRegion> regions);
/// Returns the index of a layer's first region, of the topmost layer if several match; past the end if there
/// is none.
std::size_t layerBegin(const Design& design, const std::string& name);
/// Adds regions on top of their layer; a new layer is added on top of all.
Design withStroke(const Design& design, const std::string& layer, std::vector<MaterialRegion> regions);
/// Returns the design with another material in the group of that name. `keepAxes`: stiff regions keep their
/// direction.
Design withGroupPaint(const Design& design, const std::string& name, const MaterialPaint& paint,
                      bool keepAxes = false);
Design withGroupFeather(const Design& design, const std::string& name, double feather);
bool isGroupHidden(const Design& design, const std::string& name);
Design withGroupHidden(const Design& design, const std::string& name, bool hidden);
/// Pictures of the material over a box, as a layer on top, named as that.
Design withPictures(const Design& design, const std::string& name, const Box<2>& box,
                    const MaterialPictures& pictures);
/// The group's pictures are read again from their files.
Design withPicturesReread(const Design& design, const std::string& name);
/// Returns the wanted name, with a number appended if another group has it.
std::string freeGroupName(const Design& design, const std::string& name, const std::string& wish);
Design withGroupName(const Design& design, const std::string& name, const std::string& next);
/// The group by that many groups further up, where it wins over more of the others; down if negative.
Design withGroupMoved(const Design& design, const std::string& name, int by);
/// Merges the group into the one below. Returns nothing if that would change the result: if the upper one
/// erases, one is hidden, or one consists of pictures.
std::optional<Design> withGroupMergedDown(const Design& design, const std::string& name);
/// Returns the design without the group and its regions.
Design withoutGroup(const Design& design, const std::string& name);
/// Sets or removes the file of values per cell.
Design withCellsFile(const Design& design, const std::string& file);
Design withoutCells(const Design& design);
Design withAllHidden(const Design& design);
/// Returns whether the material of any place differs from that of the whole.
bool isPainted(const Design& design);

}  // namespace wend
