#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/mesh/point_locator.h"
#include "warp/coverage.h"

namespace wend {

/// Adapts the resolution of a moving shape so that frames are drawn in time, based on the last ones.
class DrawingPace {
  public:
    /// Device pixels per side of a drawn one, for a view of so many device pixels.
    int coarseness(double pixels);
    /// Records how long a number of drawn pixels took.
    void learn(double drawnPixels, double milliseconds);

  private:
    bool isInTime(double pixels, int coarseness, double margin) const;

    double m_perPixel = 0;  // milliseconds; 0: not known
    int m_coarseness = 1;
};

/// A coarse mesh for drawing a large moving shape: as many of its vertices as are needed to keep every point
/// within a tolerance. Outlines and edges between depths are kept, so that nothing opens or jumps when it
/// comes to rest.
class MovingCells {
  public:
    struct Drawn {
        std::vector<Cell<2>> cells;  // in the order of painting
        std::shared_ptr<const PaintingPlan> plan;
    };
    using DrawnPtr = std::shared_ptr<const Drawn>;

    /// Returns the mesh for a pose; null if the shape's own cells are to be drawn. `plan`: of the shape's
    /// cells, or null as in WarpOptions. `tolerance` in domain units. Vertices are added from pose to pose
    /// where needed.
    DrawnPtr of(const std::shared_ptr<const SimplicialMesh<2>>& rest,
                const std::shared_ptr<const PaintingPlan>& plan, const Points2& pose, double tolerance);

  private:
    void begin(const std::shared_ptr<const SimplicialMesh<2>>& rest,
               const std::shared_ptr<const PaintingPlan>& plan);
    void thinOut();
    void make();
    bool add(const Points2& pose, double tolerance);

    std::shared_ptr<const SimplicialMesh<2>> m_rest;
    std::shared_ptr<const PaintingPlan> m_given, m_plan;
    std::optional<PointLocator<2>> m_located;
    std::vector<int> m_place;          // of the shape's cells in the order of painting
    std::vector<int> m_used;           // vertices that cells have
    std::vector<int> m_vertices;       // that are drawn
    std::vector<bool> m_taken;         // by vertex
    std::vector<Location<2>> m_where;  // per vertex its location in the drawn mesh
    DrawnPtr m_drawn;                  // null: not worth it
    double m_triedWith = 0;            // the newest tolerance, or the greatest while it is not
};

}  // namespace wend
