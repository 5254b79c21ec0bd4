#include "app/engine/shape/pose_faults.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "app/engine/shape/shape.h"
#include "app/project/options/options.h"
#include "core/base/disjoint_sets.h"
#include "core/base/number_text.h"
#include "core/mesh/used_vertices.h"
#include "core/meshing/outline_check.h"
#include "core/meshing/surface.h"

namespace wend {
namespace {

template <int Dim>
using Facets = std::vector<std::array<int, Dim>>;

struct Crossed {
    std::array<int, 2> facets;  // increasing
    Eigen::VectorXd place;
    bool operator<(const Crossed& other) const { return facets < other.facets; }
};

constexpr int kMostPairs = 1000000;  // of a shape that is crumpled beyond counting

std::vector<Crossed> crossedIn(const Points2& points, const Facets<2>& edges) {
    std::vector<Segment> segments;
    segments.reserve(edges.size());
    for (const auto& [a, b] : edges) segments.push_back({points.col(a), points.col(b)});
    std::vector<Crossed> crossed;
    for (const SegmentCrossing& one : crossingsOf(segments)) crossed.push_back({one.segments, one.place});
    return crossed;
}

std::vector<Crossed> crossedIn(const Points3& points, const Facets<3>& triangles) {
    std::vector<Crossed> crossed;
    for (const auto& pair : checkSurface({points, triangles, {}}, kMostPairs).intersecting) {
        Vec3 middle = Vec3::Zero();
        for (const int t : pair)
            for (const int v : triangles[t]) middle += points.col(v) / 6;
        crossed.push_back({pair, middle});
    }
    return crossed;
}

template <int Dim>
Facets<Dim> borderOf(const Shape<Dim>& shape) {
    Facets<Dim> border;
    const auto add = [&](const std::vector<Facet<Dim>>& facets) {
        for (const Facet<Dim>& facet : facets)
            if (!facet.interior()) border.push_back(facet.vertices);
    };
    shape.facets ? add(*shape.facets) : add(facetsOf<Dim>(*shape.rest));
    return border;
}

/// Returns the border at rest; `faults` receives the border of the pose.
template <int Dim>
Points<Dim> takeBorder(const Shape<Dim>& shape, const Points<Dim>& pose, PoseFaults<Dim>& faults) {
    if constexpr (Dim == 3)
        if (shape.cage && shape.skin && shape.embedding) {
            faults.points = shape.embedding->carry(*shape.rest, pose);
            faults.border = shape.skin->triangles;
            return shape.skin->points;
        }
    faults.points = pose;
    faults.border = borderOf(shape);
    return shape.rest->points;
}

/// Connects facets at a seam, whose vertices coincide.
template <int Dim>
Facets<Dim> sewn(const Facets<Dim>& border, const Points<Dim>& rest) {
    const std::vector<int> first = firstAtPlace<Dim>(rest);
    Facets<Dim> result = border;
    for (auto& facet : result)
        for (int& v : facet) v = first[v];
    return result;
}

/// Returns the index of the part that a vertex belongs to.
int partOfVertex(const std::vector<MeshPart>& parts, int vertex) {
    return static_cast<int>(std::ranges::find_if(parts,
                                                 [&](const MeshPart& part) {
                                                     return part.firstVertex <= vertex &&
                                                            vertex < part.endVertex;
                                                 }) -
                            parts.begin());
}

template <int Dim>
std::vector<Crossed> newCrossings(const PoseFaults<Dim>& faults, const Facets<Dim>& sewnBorder,
                                  const Points<Dim>& rest, const std::vector<MeshPart>& parts) {
    std::vector<Crossed> now = crossedIn(faults.points, faults.border);
    if (!parts.empty())
        std::erase_if(now, [&](const Crossed& one) {
            return partOfVertex(parts, faults.border[one.facets[0]][0]) !=
                   partOfVertex(parts, faults.border[one.facets[1]][0]);
        });
    std::erase_if(now, [&](const Crossed& one) {
        const auto &a = sewnBorder[one.facets[0]], &b = sewnBorder[one.facets[1]];
        return std::ranges::find_first_of(a, b) != a.end();
    });
    if (now.empty()) return now;
    const std::vector<Crossed> before = crossedIn(rest, faults.border);
    std::vector<Crossed> result;
    std::ranges::set_difference(now, before, std::back_inserter(result), std::less<>());
    return result;
}

/// Groups items that are connected by common vertices, in order of the first member of each group.
template <class Item, class Join>
std::vector<std::vector<Item>> connected(const std::vector<Item>& items, int vertices, const Join& vertexOf) {
    DisjointSets sets(vertices);
    for (const Item& item : items)
        vertexOf(item, [&, first = -1](int v) mutable { first < 0 ? void(first = v) : sets.join(first, v); });
    std::map<int, std::vector<Item>> places;
    for (const Item& item : items) {
        int any = 0;
        vertexOf(item, [&](int v) { any = v; });
        places[sets.root(any)].push_back(item);
    }
    std::vector<std::vector<Item>> result;
    for (auto& [root, place] : places) result.push_back(std::move(place));
    return result;
}

template <int Dim>
void findCrossings(const Shape<Dim>& shape, const Points<Dim>& pose, PoseFaults<Dim>& faults) {
    const Points<Dim> rest = takeBorder(shape, pose, faults);
    const Facets<Dim> border = sewn<Dim>(faults.border, rest);
    const auto vertices = [&](const Crossed& one, auto&& take) {
        for (const int f : one.facets)
            for (const int v : border[f]) take(v);
    };
    std::vector<std::vector<Crossed>> places;
    if (const auto all = newCrossings<Dim>(faults, border, rest, shape.rest->parts); Dim == 3)
        places = connected(all, static_cast<int>(rest.cols()), vertices);
    else
        for (const Crossed& one : all) places.push_back({one});
    for (const auto& crossed : places) {
        PosePlace<Dim>& place = faults.crossings.emplace_back();
        place.count = static_cast<int>(crossed.size());
        place.at = crossed.front().place;
        for (const Crossed& one : crossed)
            place.members.insert(place.members.end(), one.facets.begin(), one.facets.end());
        std::ranges::sort(place.members);
        place.members.erase(std::ranges::unique(place.members).begin(), place.members.end());
    }
    std::ranges::stable_sort(faults.crossings, std::ranges::greater(), &PosePlace<Dim>::count);
}

/// Returns the size ratio as a factor of at least 1.
double excess(double ratio) {
    return ratio > 0 ? std::max(ratio, 1 / ratio) : std::numeric_limits<double>::infinity();
}

template <int Dim>
void findBlown(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose, PoseFaults<Dim>& faults) {
    std::vector<double> ratio;
    for (const Cell<Dim>& cell : rest.cells)
        ratio.push_back(cellMeasure<Dim>(pose, cell) / cellMeasure<Dim>(rest.points, cell));
    std::vector<int> cells;
    for (int c = 0; c < rest.cellCount(); ++c)
        if (excess(ratio[c]) > kBlownUp) cells.push_back(c);
    const auto vertices = [&](int cell, auto&& take) { std::ranges::for_each(rest.cells[cell], take); };
    for (auto& blown : connected(cells, rest.vertexCount(), vertices)) {
        PosePlace<Dim>& place = faults.blown.emplace_back();
        place.count = static_cast<int>(blown.size());
        place.worstCell = *std::ranges::max_element(blown, {}, [&](int c) { return excess(ratio[c]); });
        place.ratio = ratio[place.worstCell];
        place.at.setZero();
        for (const int v : rest.cells[place.worstCell]) place.at += pose.col(v) / (Dim + 1);
        place.members = std::move(blown);
    }
    std::ranges::stable_sort(faults.blown, std::ranges::greater(),
                             [](const PosePlace<Dim>& place) { return excess(place.ratio); });
}

template <int Dim>
int countOf(const std::vector<PosePlace<Dim>>& places) {
    return std::accumulate(places.begin(), places.end(), 0,
                           [](int sum, const PosePlace<Dim>& place) { return sum + place.count; });
}

std::string counted(int count, const std::string& one, const std::string& many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

}  // namespace

template <int Dim>
int PoseFaults<Dim>::pairs() const {
    return countOf(crossings);
}

template <int Dim>
int PoseFaults<Dim>::cells() const {
    return countOf(blown);
}

template <int Dim>
PoseFaults<Dim> faultsOf(const Shape<Dim>& shape, const Points<Dim>& pose) {
    PoseFaults<Dim> faults;
    findCrossings(shape, pose, faults);
    findBlown(*shape.rest, pose, faults);
    return faults;
}

template <int Dim>
std::string crossingText(const PoseFaults<Dim>& faults) {
    if (faults.crossings.empty()) return {};
    const int places = static_cast<int>(faults.crossings.size());
    return std::string(Dim == 3 ? "the surface passes through itself in "
                                : "the outline crosses itself in ") +
           counted(places, "place", "places") + " (" + counted(faults.pairs(), "pair of ", "pairs of ") +
           (Dim == 3 ? "triangles" : "edges") + (places > 1 ? "), the first near " : ") near ") +
           placeName<Dim>(faults.crossings.front().at);
}

template <int Dim>
std::string blownText(const PoseFaults<Dim>& faults) {
    if (faults.blown.empty()) return {};
    const auto& worst = faults.blown.front();
    return counted(faults.cells(), "cell has", "cells have") + " grown or shrunk more than " +
           shortNumber(kBlownUp) + " times, in " +
           counted(static_cast<int>(faults.blown.size()), "place", "places") + ": the worst to " +
           shortNumber(worst.ratio) + " of its size near " + placeName<Dim>(worst.at);
}

template struct PoseFaults<2>;
template struct PoseFaults<3>;
template PoseFaults<2> faultsOf<2>(const Shape<2>&, const Points2&);
template PoseFaults<3> faultsOf<3>(const Shape<3>&, const Points3&);
template std::string crossingText<2>(const PoseFaults<2>&);
template std::string crossingText<3>(const PoseFaults<3>&);
template std::string blownText<2>(const PoseFaults<2>&);
template std::string blownText<3>(const PoseFaults<3>&);

}  // namespace wend
