#include "app/views/canvas/moving_shape.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "core/meshing/fewer_cells.h"

namespace wend {

namespace {

constexpr double kFewest = 0.2e6;  // pixels: no picture is coarser
constexpr double kUnknown = 3e6;   // and so many while nothing is known
constexpr double kTime = 14;       // milliseconds: with the rest of the pipeline 30 frames per second
constexpr double kSmall =
    1.5e6;  // pixels of a view that gets more time before it is coarser than the screen:
constexpr double kFineTime = 20;      // milliseconds
constexpr double kFinerMargin = 0.7;  // fraction of the time: hysteresis
constexpr double kNewest = 0.3;       // weight of the last picture
constexpr int kCoarsest = 4;

}  // namespace

bool DrawingPace::isInTime(double pixels, int coarseness, double margin) const {
    const double drawn = pixels / (coarseness * coarseness);
    const double time = pixels <= kSmall && coarseness == 1 ? kFineTime : kTime;
    return m_perPixel > 0 ? drawn * m_perPixel <= margin * time : drawn <= kUnknown;
}

int DrawingPace::coarseness(double pixels) {
    const int coarsest = std::clamp(static_cast<int>(std::sqrt(pixels / kFewest)), 1, kCoarsest);
    m_coarseness = std::min(m_coarseness, coarsest);
    while (m_coarseness > 1 && isInTime(pixels, m_coarseness - 1, kFinerMargin)) --m_coarseness;
    while (m_coarseness < coarsest && !isInTime(pixels, m_coarseness, 1)) ++m_coarseness;
    return m_coarseness;
}

void DrawingPace::learn(double drawnPixels, double milliseconds) {
    if (drawnPixels <= 0) return;
    const double perPixel = milliseconds / drawnPixels;
    m_perPixel = m_perPixel > 0 ? (1 - kNewest) * m_perPixel + kNewest * perPixel : perPixel;
}

namespace {

constexpr int kMany = 8000;        // number of cells above which drawing them dominates
constexpr int kFirst = 2000;       // vertices to begin with at most, the outline's not counted,
constexpr int kFirstPart = 6;      // and at most this part of them
constexpr int kWorthwhile = 3;     // a coarse mesh is not used above a third of the shape's vertices
constexpr int kRounds = 6;         // for one pose
constexpr double kAnotherTry = 2;  // times the tolerance with which all cells had to be drawn
constexpr double kAhead = 0.5;     // of the tolerance: from there on a vertex is taken along with others

}  // namespace

MovingCells::DrawnPtr MovingCells::of(const std::shared_ptr<const SimplicialMesh<2>>& rest,
                                      const std::shared_ptr<const PaintingPlan>& plan, const Points2& pose,
                                      double tolerance) {
    if (rest->cellCount() < kMany) return nullptr;
    const bool allowsMore = !m_drawn && tolerance > kAnotherTry * m_triedWith;
    if (rest != m_rest || plan != m_given || allowsMore) begin(rest, plan);
    m_triedWith = m_drawn ? tolerance : std::max(tolerance, m_triedWith);
    for (int round = 0; m_drawn && round < kRounds; ++round) {
        if (!add(pose, tolerance)) return m_drawn;
        make();
    }
    return nullptr;
}

void MovingCells::begin(const std::shared_ptr<const SimplicialMesh<2>>& rest,
                        const std::shared_ptr<const PaintingPlan>& plan) {
    m_rest = rest;
    m_given = plan;
    m_plan = plan ? plan : std::make_shared<const PaintingPlan>(*rest, std::vector<float>());
    std::set<int> used;
    for (const Cell<2>& cell : rest->cells) used.insert(cell.begin(), cell.end());
    m_used.assign(used.begin(), used.end());
    m_located.emplace(rest->points, rest->cells);
    m_place.resize(rest->cells.size());
    for (std::size_t i = 0; i < m_place.size(); ++i) m_place[m_plan->order[i]] = static_cast<int>(i);
    thinOut();
    make();
}

/// Keeps the vertices of the outline, and one other in each square of a grid.
void MovingCells::thinOut() {
    m_vertices.clear();
    m_taken.assign(static_cast<std::size_t>(m_rest->vertexCount()), false);
    const auto take = [this](int vertex) {
        if (m_taken[vertex]) return;
        m_taken[vertex] = true;
        m_vertices.push_back(vertex);
    };
    for (const auto& edge : m_plan->outline) std::ranges::for_each(edge, take);
    double area = 0;
    for (const Cell<2>& cell : m_rest->cells) area += std::abs(cellMeasure<2>(m_rest->points, cell));
    const int first = std::min<int>(kFirst, static_cast<int>(m_used.size()) / kFirstPart);
    const double side = std::sqrt(area / first);
    std::map<std::pair<long, long>, int> nearest;  // to the middle of each square
    const auto squared = [&](int vertex) {
        const Vec2 at = m_rest->points.col(vertex) / side;
        return (at - at.array().floor().matrix() - Vec2(0.5, 0.5)).squaredNorm();
    };
    for (const int v : m_used) {
        const Vec2 at = m_rest->points.col(v) / side;
        const auto [found, isNew] =
            nearest.try_emplace({std::lround(std::floor(at.x())), std::lround(std::floor(at.y()))}, v);
        if (!isNew && squared(v) < squared(found->second)) found->second = v;
    }
    for (const auto& [square, vertex] : nearest) take(vertex);
}

void MovingCells::make() {
    m_drawn.reset();
    if (static_cast<int>(m_vertices.size()) * kWorthwhile > m_rest->vertexCount()) return;
    const auto fewer = fewerCells(*m_rest, *m_located, m_vertices, m_plan->outline);
    if (!fewer) return;
    std::vector<int> order(fewer->cells.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](int c) { return m_place[fewer->cellInMesh[c]]; });
    auto drawn = std::make_shared<Drawn>();
    for (const int c : order) drawn->cells.push_back(fewer->cells[c]);
    auto plan =
        std::make_shared<PaintingPlan>(SimplicialMesh<2>{m_rest->points, drawn->cells}, std::vector<float>());
    plan->outline = m_plan->outline;
    drawn->plan = std::move(plan);
    const PointLocator<2> locator(m_rest->points, drawn->cells);
    m_where.assign(m_taken.size(), {});
    for (const int v : m_used)
        if (const auto found = m_taken[v] ? std::nullopt : locator.find(m_rest->points.col(v)))
            m_where[v] = *found;
    m_drawn = std::move(drawn);
}

/// Adds in each cell the vertex with the largest error. Returns false if none exceeds the tolerance.
bool MovingCells::add(const Points2& pose, double tolerance) {
    std::vector<std::pair<double, int>> worst(m_drawn->cells.size(), {0, -1});
    double most = 0;
    for (const int v : m_used) {
        const auto& [cell, weights] = m_where[v];
        if (cell < 0) continue;
        const Cell<2>& corners = m_drawn->cells[cell];
        const double off = (weights[0] * pose.col(corners[0]) + weights[1] * pose.col(corners[1]) +
                            weights[2] * pose.col(corners[2]) - pose.col(v))
                               .norm();
        worst[cell] = std::max(worst[cell], {off, v});
        most = std::max(most, off);
    }
    if (!(most > tolerance)) return false;
    for (const auto& [off, vertex] : worst) {
        if (off <= kAhead * tolerance) continue;
        m_taken[vertex] = true;
        m_vertices.push_back(vertex);
    }
    return true;
}

}  // namespace wend
