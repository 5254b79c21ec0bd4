#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/project/design.h"
#include "app/project/project_fwd.h"

namespace wend {

/// Material values of a region.
template <int Dim>
struct MaterialPaint {
    std::optional<double> phi;
    std::optional<Stiffness<Dim>> stiffness;
};

/// Regions of one name: the strokes of a layer, or regions from a file. Values are those of the first region
/// that paints unless noted.
template <int Dim>
struct RegionGroup {
    std::string name;
    int count = 0;  // of those that paint
    double feather = 0;
    MaterialPaint<Dim> paint = {};
    MaterialPictures pictures = {};
    bool hidden = false;
    std::optional<Vec<Dim>> axis = {};  // of the first that is stiff
    bool oneAxis = true;                // all that are stiff are so along it
};
template <int Dim>
std::vector<RegionGroup<Dim>> regionGroups(const Design<Dim>& design);

/// Returns how many regions from the first on belong to one layer: those of the same name.
template <int Dim>
std::size_t layerEnd(std::span<const MaterialRegion<Dim>> regions);
/// Returns the index of a layer's first region, of the topmost layer if several match; past the end if there
/// is none.
template <int Dim>
std::size_t layerBegin(const Design<Dim>& design, const std::string& name);
/// Adds regions on top of their layer; a new layer is added on top of all.
template <int Dim>
Design<Dim> withStroke(const Design<Dim>& design, const std::string& layer,
                       std::vector<MaterialRegion<Dim>> regions);
/// Returns the design with another material in the group of that name. `keepAxes`: stiff regions keep their
/// direction.
template <int Dim>
Design<Dim> withGroupPaint(const Design<Dim>& design, const std::string& name,
                           const MaterialPaint<Dim>& paint, bool keepAxes = false);
AnyDesign withGroupFeather(const AnyDesign& design, const std::string& name, double feather);
bool isGroupHidden(const AnyDesign& design, const std::string& name);
AnyDesign withGroupHidden(const AnyDesign& design, const std::string& name, bool hidden);
/// Pictures of the material over a box, as a layer on top, named as that.
AnyDesign withPictures(const AnyDesign& design, const std::string& name, const Box<2>& box,
                       const MaterialPictures& pictures);
/// The group's pictures are read again from their files.
AnyDesign withPicturesReread(const AnyDesign& design, const std::string& name);
/// Returns the wanted name, with a number appended if another group has it.
std::string freeGroupName(const AnyDesign& design, const std::string& name, const std::string& wish);
AnyDesign withGroupName(const AnyDesign& design, const std::string& name, const std::string& next);
/// The group by that many groups further up, where it wins over more of the others; down if negative.
AnyDesign withGroupMoved(const AnyDesign& design, const std::string& name, int by);
/// Merges the group into the one below. Returns nothing if that would change the result: if the upper one
/// erases, one is hidden, or one consists of pictures.
std::optional<AnyDesign> withGroupMergedDown(const AnyDesign& design, const std::string& name);
/// Returns the design without the group and its regions.
AnyDesign withoutGroup(const AnyDesign& design, const std::string& name);
/// Sets or removes the file of values per cell.
AnyDesign withCellsFile(const AnyDesign& design, const std::string& file);
AnyDesign withoutCells(const AnyDesign& design);
AnyDesign withAllHidden(const AnyDesign& design);
/// Returns whether the material of any place differs from that of the whole.
bool isPainted(const AnyDesign& design);

}  // namespace wend
