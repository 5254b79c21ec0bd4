#pragma once

#include <memory>
#include <vector>

#include "app/project/layer.h"
#include "app/project/part.h"
#include "app/project/project_fwd.h"
#include "core/mesh/simplicial_mesh.h"
#include "warp/coverage.h"

namespace wend {

/// Returns the order of every cell: that of the last region that contains its centroid; empty if no region
/// changes the order. `rest` is in domain coordinates.
std::vector<float> cellOrders(const ValueLayers& layers, const SimplicialMesh<2>& rest);

/// Returns WarpOptions::depth: the orders of the regions, and within one order the limbs as limbOrder() sorts
/// them.
std::vector<float> cellDepths(const ValueLayers& layers, const SimplicialMesh<2>& rest);

/// Returns the level of every part of the mesh at a time, from 0 (behind all): see PicturePart::order. Empty
/// if the mesh has no parts.
std::vector<int> partLevels(const std::vector<PicturePart>& parts, const SimplicialMesh<2>& mesh,
                            double time);

/// Caches depths and painting plan. They are recomputed only for other regions, another mesh or other levels
/// of its parts, which are entirely over one another.
class CellDepths {
  public:
    using Values = std::shared_ptr<const std::vector<float>>;
    explicit CellDepths(std::vector<float> (&make)(const ValueLayers&, const SimplicialMesh<2>&) = cellDepths)
        : m_make(make) {}
    const Values& of(const ValueLayers& layers, const std::shared_ptr<const SimplicialMesh<2>>& rest,
                     const std::vector<int>& levels = {});
    /// Returns the plan of the last result of of().
    std::shared_ptr<const PaintingPlan> plan();

  private:
    std::vector<float> (&m_make)(const ValueLayers&, const SimplicialMesh<2>&);
    ValueLayers m_layers;
    std::shared_ptr<const SimplicialMesh<2>> m_rest;
    std::vector<int> m_levels;
    Values m_values;
    std::shared_ptr<const PaintingPlan> m_plan;  // made when it is asked for first
};

}  // namespace wend
