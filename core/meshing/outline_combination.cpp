#include "core/meshing/outline_combination.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <cmath>
#include <functional>
#include <map>

#include "core/base/error.h"
#include "core/mesh/segments.h"
#include "core/meshing/outline_check.h"

namespace wend {
namespace {

constexpr double kGrid = 4096;  // corners per unit
constexpr int kRoundings = 6;   // until no two edges cross: one is enough as a rule

enum Inside : unsigned { InBase = 1, InPiece = 2 };

struct FaceMark {
    unsigned inside = 0;  // of both outlines
    bool reached = false;
    unsigned walked = 0;  // edges, bit by bit
};

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoint = ExactKernel::Point_2;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<FaceMark, ExactKernel,
                                              CGAL::Constrained_triangulation_face_base_2<ExactKernel>>;
using PieceStructure =
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<ExactKernel>, FaceBase>;
using PieceTriangulation = CGAL::Constrained_triangulation_plus_2<
    CGAL::Constrained_Delaunay_triangulation_2<ExactKernel, PieceStructure, CGAL::Exact_intersections_tag>>;
using PieceFace = PieceTriangulation::Face_handle;
using Loop = std::vector<Vec2>;

/// The plane partitioned by both outlines, with the membership of each piece.
class Pieces {
  public:
    Pieces(const Outline& base, const Outline& piece) {
        insert(base, InBase);
        insert(piece, InPiece);
        if (m_triangulation.dimension() == 2) flood();
    }

    /// Returns the loops around the faces that `isWanted` (of Inside), these on their left.
    Outline around(const std::function<bool(unsigned)>& isWanted) {
        Outline outline;
        if (m_triangulation.dimension() < 2) return outline;
        const auto wanted = [&](const PieceFace& face) { return isWanted(face->info().inside); };
        for (const PieceFace face : m_triangulation.finite_face_handles())
            for (int i = 0; i < 3; ++i)
                if (wanted(face) && !wanted(face->neighbor(i)) && (face->info().walked >> i & 1U) == 0)
                    outline.loops.push_back(walk(face, i, wanted));
        return outline;
    }

  private:
    /// Inserts the loops of an outline as constraints that belong to it.
    void insert(const Outline& outline, Inside which) {
        for (const Loop& loop : outline.loops) {
            std::vector<ExactPoint> line;
            for (const Vec2& p : loop) line.emplace_back(p.x(), p.y());
            if (line.size() < 2) continue;
            line.push_back(line.front());
            // Inserts edge by edge, so that a line that retraces itself is valid, too.
            for (std::size_t k = 0; k + 1 < line.size(); ++k)
                if (line[k] != line[k + 1])
                    m_owner[m_triangulation.insert_constraint(line[k], line[k + 1])] = which;
        }
    }

    /// Returns which insides an edge changes.
    unsigned change(const PieceFace& face, int i) const {
        if (!face->is_constrained(i)) return 0;
        const auto a = face->vertex(PieceTriangulation::cw(i)), b = face->vertex(PieceTriangulation::ccw(i));
        unsigned parity = 0;
        for (auto context = m_triangulation.contexts_begin(a, b);
             context != m_triangulation.contexts_end(a, b); ++context)
            parity ^= m_owner.at(context->id());
        return parity;
    }

    /// Determines for every face which outlines contain it, by crossing their constraints from outside.
    void flood() {
        std::vector<PieceFace> front{m_triangulation.infinite_face()};
        front[0]->info().reached = true;
        while (!front.empty()) {
            const PieceFace face = front.back();
            front.pop_back();
            for (int i = 0; i < 3; ++i) {
                const PieceFace next = face->neighbor(i);
                if (std::exchange(next->info().reached, true)) continue;
                next->info().inside = face->info().inside ^ change(face, i);
                front.push_back(next);
            }
        }
    }

    /// Walks from the edge opposite of corner i around wanted faces only: pieces that touch at a point get
    /// separate loops. Collinear corners are left out.
    template <typename IsWanted>
    static Loop walk(PieceFace face, int i, const IsWanted& isWanted) {
        std::vector<ExactPoint> corners;
        while ((face->info().walked >> i & 1U) == 0) {
            face->info().walked |= 1U << i;
            corners.push_back(face->vertex(PieceTriangulation::cw(i))->point());
            for (i = PieceTriangulation::ccw(i); isWanted(face->neighbor(i));
                 i = PieceTriangulation::ccw(i)) {
                const PieceFace next = face->neighbor(i);
                i = next->index(face);
                face = next;
            }
        }
        return rounded(corners);
    }

    /// Rounds the corners of a loop to the grid, and drops those that are on the line between their
    /// neighbours.
    static Loop rounded(const std::vector<ExactPoint>& corners) {
        Loop loop;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const ExactPoint &before = corners[(k + corners.size() - 1) % corners.size()], &p = corners[k],
                             &after = corners[(k + 1) % corners.size()];
            if (CGAL::are_strictly_ordered_along_line(before, p, after)) continue;
            const auto onGrid = [](const ExactKernel::FT& x) {
                return std::round(CGAL::to_double(x) * kGrid) / kGrid;
            };
            const Vec2 rough(onGrid(p.x()), onGrid(p.y()));
            const bool exact = ExactPoint(CGAL::to_double(p.x()), CGAL::to_double(p.y())) == p;
            loop.push_back(exact ? Vec2(CGAL::to_double(p.x()), CGAL::to_double(p.y())) : rough);
        }
        return loop;
    }

    PieceTriangulation m_triangulation;
    std::map<PieceTriangulation::Constraint_id, unsigned> m_owner;
};

double signedArea(const Loop& loop) {
    double twice = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec2 &a = loop[k], &b = loop[(k + 1) % loop.size()];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return twice / 2;
}

void requireFinitePoints(const Outline& outline) {
    for (const Loop& loop : outline.loops)
        for (const Vec2& p : loop)
            if (!p.allFinite()) throw InputError("the outline has a point that is not finite");
}

/// Removes loops that are too small or empty after rounding.
Outline withoutSpecks(Outline outline, double smallest) {
    std::erase_if(outline.loops, [&](const Loop& loop) {
        return loop.size() < 3 || !(std::abs(signedArea(loop)) > std::max(smallest, 2 / (kGrid * kGrid)));
    });
    return outline;
}

bool crosses(const Outline& outline) {
    try {
        requireNoCrossing(outline);
        return false;
    } catch (const InputError&) {
        return true;
    }
}

}  // namespace

/// Partitions the plane by the edges of both outlines with exact intersections, marks every piece by the
/// outlines that contain it, and walks around the wanted ones. Rounded corners may cross other edges again;
/// the union of the result with itself is then taken, which as a rule is needed once at most.
Outline combined(const Outline& base, const Outline& piece, OutlineOperation operation, double smallest) {
    requireFinitePoints(base);
    requireFinitePoints(piece);
    const auto isWanted = [operation](unsigned inside) {
        if (operation == OutlineOperation::Add) return inside != 0;
        return inside == (operation == OutlineOperation::TakeAway ? InBase : InBase | InPiece);
    };
    Outline result = withoutSpecks(Pieces(base, piece).around(isWanted), smallest);
    // Rounding may have moved corners over other edges.
    for (int k = 0; k < kRoundings && crosses(result); ++k)
        result =
            withoutSpecks(Pieces(result, {}).around([](unsigned inside) { return inside != 0; }), smallest);
    return result;
}

double areaOf(const Outline& outline) {
    double area = 0;
    for (const Loop& loop : Pieces(outline, {}).around([](unsigned inside) { return inside != 0; }).loops)
        area += signedArea(loop);
    return area;
}

bool isInside(const Outline& outline, const Vec2& p) {
    bool inside = false;
    for (const Loop& loop : outline.loops)
        for (std::size_t k = 0; k < loop.size(); ++k)
            if (crossesRay(loop[k], loop[(k + 1) % loop.size()], p)) inside = !inside;
    return inside;
}

}  // namespace wend
