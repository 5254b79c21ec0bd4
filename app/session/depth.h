#pragma once

#include <memory>
#include <vector>

#include "app/document/depth_region.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// The order of every cell, that of the last region which has the cell's centroid, for WarpOptions::depth;
/// empty if nothing lies in front of anything. `rest` in the domain's coordinates.
std::vector<float> cellDepths(const std::vector<DepthRegion>& regions, const SimplicialMesh<2>& rest);

/// The same, made again only for other regions or another mesh.
class CellDepths {
  public:
    using Values = std::shared_ptr<const std::vector<float>>;
    const Values& of(const std::vector<DepthRegion>& regions,
                     const std::shared_ptr<const SimplicialMesh<2>>& rest);

  private:
    std::vector<DepthRegion> m_regions;
    std::shared_ptr<const SimplicialMesh<2>> m_rest;
    Values m_values;
};

}  // namespace wend
