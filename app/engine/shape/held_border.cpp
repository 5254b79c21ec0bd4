#include "app/engine/shape/held_border.h"

#include <algorithm>
#include <array>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "core/base/error.h"

namespace wend {

namespace {

constexpr double kOnSide = 1e-9;  // of the frame's size
enum BorderSide : unsigned { Inside = 0, LeftOrRight = 1, TopOrBottom = 2, Corner = 3 };

unsigned sideOf(const Vec2& p, const Vec2& frame) {
    const double tolerance = kOnSide * frame.norm();
    unsigned side = Inside;
    for (int k = 0; k < 2; ++k)
        if (std::abs(p[k]) <= tolerance || std::abs(p[k] - frame[k]) <= tolerance) side |= 1U << k;
    return side;
}

bool takes(const Placement<2>& at, int vertex, const Vec2& p, double tolerance) {
    if (const auto* ids = std::get_if<std::vector<int>>(&at))
        return std::ranges::find(*ids, vertex) != ids->end();
    if (const auto* region = std::get_if<Region<2>>(&at)) return signedDistance<2>(*region, p) <= tolerance;
    return std::ranges::any_of(std::get<std::vector<Vec2>>(at),
                               [&](const Vec2& q) { return (p - q).norm() <= tolerance; });
}

/// Returns for each BorderSide the vertices that no handle holds.
std::array<std::vector<int>, 4> freeBorder(const std::vector<Handle<2>>& handles,
                                           const SimplicialMesh<2>& rest, const Vec2& frame) {
    std::array<std::vector<int>, 4> border;
    for (int v = 0; v < rest.vertexCount(); ++v) {
        const Vec2 p = rest.points.col(v);
        const unsigned side = sideOf(p, frame);
        const bool taken = side != Inside && std::ranges::any_of(handles, [&](const Handle<2>& handle) {
                               return takes(handle.at, v, p, kOnSide * frame.norm());
                           });
        if (side != Inside && !taken) border[side].push_back(v);
    }
    return border;
}

void add(std::vector<Handle<2>>& handles, const std::vector<int>& vertices, unsigned slides) {
    if (vertices.empty()) return;
    Handle<2> handle;
    handle.name = "the picture's border";
    handle.at = vertices;
    handle.slides = slides;
    handles.push_back(std::move(handle));
}

std::vector<Vec3> placesOf(const std::vector<int>& vertices, const Skin& skin) {
    std::vector<Vec3> places;
    for (const int v : vertices) {
        if (v < 0 || v >= skin.vertexCount())
            throw InputError("handles: the surface has no vertex " + std::to_string(v));
        places.emplace_back(skin.points.col(v));
    }
    return places;
}

}  // namespace

template <>
std::vector<Handle<2>> heldHandles<2>(const Project& project, const Shape<2>& shape) {
    std::vector<Handle<2>> handles = handlesIn<2>(designOf(project).handles);
    const Border kind = domainOf(project).border;
    if (kind == Border::Free || domainOf(project).kind != DomainKind::Image) return handles;
    const auto [width, height] = canvasSize(shape);
    const Vec2 frame(width, height);
    const auto border = freeBorder(handles, *shape.rest, frame);
    const bool slide = kind == Border::Slide;
    add(handles, border[Corner], 0);
    add(handles, border[LeftOrRight], slide ? unsigned{TopOrBottom} : 0U);  // along the other coordinate
    add(handles, border[TopOrBottom], slide ? unsigned{LeftOrRight} : 0U);
    return handles;
}

template <>
std::vector<Handle<3>> heldHandles<3>(const Project& project, const Shape<3>& shape) {
    std::vector<Handle<3>> handles = handlesIn<3>(designOf(project).handles);
    if (!shape.cage) return handles;
    for (Handle<3>& handle : handles)
        if (const auto* vertices = std::get_if<std::vector<int>>(&handle.at))
            handle.at = placesOf(*vertices, *shape.skin);
    return handles;
}

}  // namespace wend
