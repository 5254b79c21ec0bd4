#pragma once

#include <memory>
#include <vector>

#include "app/document/depth_region.h"
#include "core/mesh/simplicial_mesh.h"
#include "warp/coverage.h"

namespace wend {

/// The order that the regions give to every cell, that of the last one which has the cell's centroid; empty
/// if nothing lies in front of anything. `rest` in the domain's coordinates.
std::vector<float> cellOrders(const std::vector<DepthRegion>& regions, const SimplicialMesh<2>& rest);

/// For WarpOptions::depth: what the regions say, and in one order the limbs as limbOrder() lays them.
std::vector<float> cellDepths(const std::vector<DepthRegion>& regions, const SimplicialMesh<2>& rest);

/// One of the two, made again only for other regions or another mesh.
class CellDepths {
  public:
    using Values = std::shared_ptr<const std::vector<float>>;
    explicit CellDepths(std::vector<float> (&make)(const std::vector<DepthRegion>&,
                                                   const SimplicialMesh<2>&) = cellDepths)
        : m_make(make) {}
    const Values& of(const std::vector<DepthRegion>& regions,
                     const std::shared_ptr<const SimplicialMesh<2>>& rest);
    /// Of what of() gave last.
    std::shared_ptr<const PaintingPlan> plan();

  private:
    std::vector<float> (&m_make)(const std::vector<DepthRegion>&, const SimplicialMesh<2>&);
    std::vector<DepthRegion> m_regions;
    std::shared_ptr<const SimplicialMesh<2>> m_rest;
    Values m_values;
    std::shared_ptr<const PaintingPlan> m_plan;  // made when it is asked for first
};

}  // namespace wend
