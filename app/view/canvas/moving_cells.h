#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/mesh/point_locator.h"
#include "warp/coverage.h"

namespace wend {

/// With which cells a shape of many is drawn while it moves: fewer of the same vertices, as many as it takes
/// for nothing to be drawn farther than a tolerance from where it is. The outline, and edges of parts that
/// lie nearer than others, are the shape's own, so nothing opens or jumps there when it rests.
class MovingCells {
  public:
    struct Drawn {
        std::vector<Cell<2>> cells;  // in the order of painting
        std::shared_ptr<const PaintingPlan> plan;
    };
    using DrawnPtr = std::shared_ptr<const Drawn>;

    /// For a pose; null where the shape's own are to be drawn. `plan`: of the shape's cells, or null as in
    /// WarpOptions. `tolerance` in the domain's units. Learns from pose to pose where more are needed.
    DrawnPtr of(const std::shared_ptr<const SimplicialMesh<2>>& rest,
                const std::shared_ptr<const PaintingPlan>& plan, const Points<2>& pose, double tolerance);

  private:
    void begin(const std::shared_ptr<const SimplicialMesh<2>>& rest,
               const std::shared_ptr<const PaintingPlan>& plan);
    void thinOut();
    void make();
    bool add(const Points<2>& pose, double tolerance);

    std::shared_ptr<const SimplicialMesh<2>> m_rest;
    std::shared_ptr<const PaintingPlan> m_given, m_plan;
    std::optional<PointLocator<2>> m_located;
    std::vector<int> m_place;          // of the shape's cells in the order of painting
    std::vector<int> m_used;           // vertices that cells have
    std::vector<int> m_vertices;       // that are drawn
    std::vector<bool> m_taken;         // by vertex
    std::vector<Location<2>> m_where;  // by vertex, in what is drawn
    DrawnPtr m_drawn;                  // null: not worth its while
    double m_triedWith = 0;            // the newest tolerance, or the greatest while it is not
};

}  // namespace wend
