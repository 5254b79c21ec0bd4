#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/document/design.h"
#include "app/document/project_fwd.h"

namespace wend {

/// What a region makes of the material.
template <int Dim>
struct MaterialPaint {
    std::optional<double> phi;
    std::optional<Stiffness<Dim>> stiffness;
};

/// Regions of one name belong together: strokes, or what was read. Of the first of them that paints, unless
/// told otherwise.
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

/// How many of the regions, from the first on, are one layer: of one name.
template <int Dim>
std::size_t layerEnd(std::span<const MaterialRegion<Dim>> regions);
/// Where the regions of a layer begin, of the topmost if there are several; past the end if there is none.
template <int Dim>
std::size_t layerBegin(const Design<Dim>& design, const std::string& name);
/// Regions on top of the others of their layer; a new layer lies on top of all.
template <int Dim>
Design<Dim> withStroke(const Design<Dim>& design, const std::string& layer,
                       std::vector<MaterialRegion<Dim>> regions);
/// The group of that name with another material; `keepAxes`: what is stiff stays so along its own direction.
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
/// What a group can be called: the wish, with a number behind it if another group is called so already.
std::string freeGroupName(const AnyDesign& design, const std::string& name, const std::string& wish);
AnyDesign withGroupName(const AnyDesign& design, const std::string& name, const std::string& next);
/// The group by that many groups further up, where it wins over more of the others; down if negative.
AnyDesign withGroupMoved(const AnyDesign& design, const std::string& name, int by);
/// The group as the upper part of that below it; nothing where that would look otherwise: what is erased in
/// the upper one would be erased in both, one is hidden, or one is made of pictures.
std::optional<AnyDesign> withGroupMergedDown(const AnyDesign& design, const std::string& name);
/// The group without its regions.
AnyDesign withoutGroup(const AnyDesign& design, const std::string& name);
/// With what a file says cell by cell, or nothing.
AnyDesign withCellsFile(const AnyDesign& design, const std::string& file);
AnyDesign withoutCells(const AnyDesign& design);
AnyDesign withAllHidden(const AnyDesign& design);
/// Whether any place of the shape is to be other than the whole.
bool isPainted(const AnyDesign& design);

}  // namespace wend
