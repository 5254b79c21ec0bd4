#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/project/design.h"
#include "app/project/edits/layer_edits.h"

namespace wend {

/// Material values of a region.
struct MaterialPaint {
    std::optional<double> phi;
    std::optional<Stiffness> stiffness;
};

/// The values of a layer: those of the first region that paints unless noted.
struct LayerValues {
    double feather = 0;
    MaterialPaint paint = {};
    MaterialPictures pictures = {};
    std::optional<Vec3> axis = {};  // of the first that is stiff
    bool oneAxis = true;            // all that are stiff are so along it
};
LayerValues valuesOf(const MaterialLayer& layer);

/// The layer that a stroke is for, which may be a new one.
struct PaintedLayer {
    Id id = newId();
    std::string name;
};
/// Adds regions on top of their layer; a new layer is added on top of all.
Design withStroke(const Design& design, const PaintedLayer& layer, std::vector<MaterialRegion> regions);

/// Paints all regions of a layer but its erasers. `keepAxes`: stiff regions keep their direction.
void setLayerPaint(MaterialLayer& layer, const MaterialPaint& paint, bool keepAxes = false);
void setLayerFeather(MaterialLayer& layer, double feather);
void setLayerHidden(MaterialLayer& layer, bool hidden);
/// Reads the pictures of a layer again from their files.
void rereadPictures(MaterialLayer& layer);

/// Pictures of the material over a box, as a layer on top, named as that.
Design withPictures(const Design& design, const std::string& name, const Box<2>& box,
                    const MaterialPictures& pictures);
/// Merges the layer into the one below. Returns nothing if that would change the result: if the upper one
/// erases, one is hidden, or one consists of pictures.
std::optional<std::vector<MaterialLayer>> withLayerMergedDown(std::vector<MaterialLayer> layers, Id id);
Design withAllHidden(const Design& design);
/// Sets or removes the file of values per cell.
Design withCellsFile(const Design& design, const std::string& file);
Design withoutCells(const Design& design);
/// Returns whether the material of any place differs from that of the whole.
bool isPainted(const Design& design);

}  // namespace wend
