#include <cmath>
#include <numbers>

#include "bench/body.h"
#include "bench/paper_scenes.h"
#include "core/meshing/planar_mesher.h"
#include "core/meshing/volume_mesher.h"

namespace wend {
namespace {

constexpr double kThickness = 0.5;

/// Returns the outline of five arms of length 1.45, the first upwards.
std::vector<Vec2> starOutline(int points) {
    std::vector<Vec2> outline;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points, radius = 1 + 0.45 * std::cos(5 * angle);
        outline.push_back(radius * Vec2(-std::sin(angle), std::cos(angle)));
    }
    return outline;
}

/// Bottom and top are fans around the middle.
Surface thickStar(int points) {
    const std::vector<Vec2> outline = starOutline(points);
    Surface surface;
    surface.points.setZero(3, 2 * points + 2);
    surface.points(2, 2 * points + 1) = kThickness;
    for (int i = 0; i < points; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const int next = (i + 1) % points;
        surface.points.col(i) << outline[at], 0;
        surface.points.col(points + i) << outline[at], kThickness;
        surface.triangles.push_back({2 * points, next, i});
        surface.triangles.push_back({2 * points + 1, points + i, points + next});
        surface.triangles.push_back({i, next, points + next});
        surface.triangles.push_back({i, points + next, points + i});
    }
    return surface;
}

}  // namespace

SimplicialMesh<2> flatShape(const std::string& name, int vertices) {
    if (name == "strip") return meshBox(Vec2(4, 1), vertices);
    if (name == "square") return meshBox(Vec2(1, 1), vertices);
    PlanarMeshOptions options;
    options.vertices = vertices;
    return meshOutline(Outline{{starOutline(200)}}, options);
}

SimplicialMesh<3> solidShape(const std::string& name, int vertices) {
    if (name == "bar") return meshBox(Vec3(4, 1, 1), vertices);
    if (name == "cube") return meshBox(Vec3(1, 1, 1), vertices);
    VolumeMeshOptions options;
    options.vertices = vertices;
    options.keepSurface = false;
    return meshVolume(thickStar(60), options).mesh;
}

}  // namespace wend
