#include "app/engine/motion_transfer.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/engine/shape/held_border.h"
#include "app/engine/shape/shape_builder.h"
#include "app/project/design.h"
#include "app/project/edits/carried_motion.h"
#include "app/project/edits/scaled_project.h"
#include "app/project/file/named_files.h"
#include "app/project/file/named_places.h"
#include "app/project/file/project_reader.h"
#include "app/project/project.h"
#include "core/base/error.h"
#include "core/mesh/point_locator.h"
#include "core/mesh/shape_size.h"
#include "core/motion/handle_points.h"
#include "core/motion/normalization.h"

namespace wend {

namespace {

/// The map between the bounding boxes of two shapes, axis by axis, and the ratio of the shapes' sizes.
struct Proportion {
    Vec3 from, to, factors;
    double scale = 1;

    template <int Dim>
    Proportion(const SimplicialMesh<Dim>& source, const SimplicialMesh<Dim>& target) {
        const ShapeSize<Dim> a = shapeSize<Dim>(source.points, source.cells),
                             b = shapeSize<Dim>(target.points, target.cells);
        scale = b.size / a.size;
        const auto [lowA, highA] = cornersOf(source);
        const auto [lowB, highB] = cornersOf(target);
        from = inSpace(lowA), to = inSpace(lowB);
        factors = Vec3::Ones();
        factors.head<Dim>() = (highB - lowB).cwiseQuotient(highA - lowA);
    }
    Vec3 operator()(const Vec3& p) const { return to + factors.cwiseProduct(p - from); }

  private:
    /// Returns the corners of the box around the vertices of cells.
    template <int Dim>
    static std::pair<Vec<Dim>, Vec<Dim>> cornersOf(const SimplicialMesh<Dim>& mesh) {
        Vec<Dim> low = mesh.points.col(mesh.cells.front()[0]), high = low;
        for (const Cell<Dim>& cell : mesh.cells)
            for (const int v : cell) {
                low = low.cwiseMin(mesh.points.col(v));
                high = high.cwiseMax(mesh.points.col(v));
            }
        return {low, high};
    }
};

Region<3> inProportion(Region<3> region, const Proportion& proportion) {
    const auto carry = [&](Vec3& p) { p = proportion(p); };
    std::visit(
        [&]<class Shape>(Shape& shape) {
            if constexpr (std::is_same_v<Shape, Polygon>) {
                for (Vec2& p : shape.points) p = inPlane(proportion(inSpace(p)));
            } else if constexpr (std::is_same_v<Shape, Ball<3>>) {
                carry(shape.centre);
                shape.radius *= proportion.scale;
            } else if constexpr (std::is_same_v<Shape, Box<3>>) {
                carry(shape.min), carry(shape.max);
            } else if constexpr (std::is_same_v<Shape, HalfSpace<3>>) {
                carry(shape.point);
                shape.normal = (shape.normal * proportion.scale).cwiseQuotient(proportion.factors).eval();
            } else {
                carry(shape.from), carry(shape.to);
            }
        },
        region);
    return region;
}

/// Returns the middle of a region that has one.
std::optional<Vec3> middleOf(const Region<3>& region) {
    return std::visit(
        []<class Shape>(const Shape& shape) -> std::optional<Vec3> {
            if constexpr (std::is_same_v<Shape, Polygon>) {
                Vec2 sum = Vec2::Zero();
                for (const Vec2& p : shape.points) sum += p;
                return inSpace(
                    Vec2(sum / static_cast<double>(std::max<std::size_t>(shape.points.size(), 1))));
            } else if constexpr (std::is_same_v<Shape, Ball<3>>) {
                return shape.centre;
            } else if constexpr (std::is_same_v<Shape, Box<3>>) {
                return Vec3((shape.min + shape.max) / 2);
            } else {
                return std::nullopt;
            }
        },
        region);
}

/// Finds places of handles in a rest shape, in its own coordinates.
template <int Dim>
class Places {
  public:
    explicit Places(const SimplicialMesh<Dim>& rest) : m_rest(rest), m_placer(rest, m_units) {}

    std::vector<Vec3> pointsOf(const Pin& handle) const {
        std::vector<Vec3> points;
        for (const ConstrainedPoint& point : m_placer.place(handleIn<Dim>(handle), 0)) {
            Vec<Dim> p = Vec<Dim>::Zero();
            for (const auto& [vertex, weight] : point.terms) p += weight * m_rest.points.col(vertex);
            points.push_back(inSpace(p));
        }
        return points;
    }

    bool has(const Pin& handle) const {
        try {
            return !m_placer.place(handleIn<Dim>(handle), 0).empty();
        } catch (const InputError&) {
            return false;
        }
    }

    /// Returns the middle of what a handle holds; nothing for a half of space and the like.
    std::optional<Vec3> anchorOf(const Pin& handle) const {
        if (const auto* region = std::get_if<Region<3>>(&handle.at)) return middleOf(*region);
        const auto* own = std::get_if<std::vector<Vec3>>(&handle.at);
        const std::vector<Vec3> points = own ? *own : pointsOf(handle);
        Vec3 sum = Vec3::Zero();
        for (const Vec3& p : points) sum += p;
        return Vec3(sum / static_cast<double>(points.size()));
    }

  private:
    const SimplicialMesh<Dim>& m_rest;
    const Normalization<Dim> m_units;
    const HandlePlacer<Dim> m_placer;
};

/// A name of handles, and which of those with that name.
using Rank = std::pair<std::string, int>;

std::vector<Rank> ranksOf(const std::vector<Pin>& handles) {
    std::map<std::string, int> seen;
    std::vector<Rank> ranks;
    for (const Pin& handle : handles) ranks.emplace_back(handle.name, seen[handle.name]++);
    return ranks;
}

std::string quoted(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) {
        const std::string called = name.empty() ? "one without a name" : "\"" + name + "\"";
        text += (text.empty() ? "" : ", ") + called;
    }
    return text;
}

template <int Dim>
class Transfer {
  public:
    Transfer(const HeldShape<Dim>& source, const HeldShape<Dim>& target, const std::string& folder)
        : m_source(source),
          m_target(target),
          m_folder(folder),
          m_proportion(source.rest, target.rest),
          m_locator(target.rest.points, target.rest.cells) {}

    TransferredMotion result() {
        auto project = std::make_shared<Project>(m_target.project);
        takeTimes(*project);
        takeHandles(designOf(*project).handles);
        std::vector<Message> notices;
        const auto tell = [&](const std::vector<std::string>& names, const Sentence& what) {
            if (!names.empty()) notices.emplace_back(what, quoted(names));
        };
        tell(m_added,
             sentence("Core", "pins of the other project without a namesake here, placed in proportion: %1"));
        tell(m_lost,
             sentence("Core", "pins of the other project that find no place here and are left out: %1"));
        tell(m_still, sentence("Core", "pins without a motion in the other project, which hold still: %1"));
        return {std::move(project), std::move(notices)};
    }

  private:
    void takeTimes(Project& project) const {
        project.end = m_source.project.end;
        project.endIsGiven = m_source.project.endIsGiven;
        project.frameRate = m_source.project.frameRate;
        project.cycle = m_source.project.cycle;
        project.settle = m_source.project.settle;
        designOf(project).material.memory = designOf(m_source.project).material.memory;
    }

    void takeHandles(std::vector<Pin>& handles) {
        const auto& others = m_source.handles;
        const std::vector<Rank> ranks = ranksOf(handles), otherRanks = ranksOf(others);
        int links = 0;
        for (const Pin& handle : handles) links = std::max(links, handle.traits.link);
        for (std::size_t h = 0; h < handles.size(); ++h) {
            const auto found = std::ranges::find(otherRanks, ranks[h]);
            if (found == otherRanks.end())
                holdStill(handles[h]);
            else
                move(handles[h], m_target.handles[h],
                     others[static_cast<std::size_t>(found - otherRanks.begin())]);
        }
        for (std::size_t h = 0; h < others.size(); ++h)
            if (std::ranges::find(ranks, otherRanks[h]) == ranks.end()) add(others[h], links, handles);
    }

    void holdStill(Pin& handle) {
        handle.motions.clear();
        handle.activeFrom = Pin().activeFrom, handle.activeTo = Pin().activeTo;
        m_still.push_back(handle.name);
    }

    /// Gives a handle, which is at the place of `held`, the motion of its namesake.
    void move(Pin& handle, const Pin& held, const Pin& other) const {
        const std::optional<Vec3> from = m_sourcePlaces.anchorOf(other), to = m_targetPlaces.anchorOf(held);
        Carrying carry{m_proportion.from, m_proportion.to, m_proportion.scale};
        if (from) carry = {*from, to ? *to : m_proportion(*from), m_proportion.scale};
        handle.activeFrom = other.activeFrom, handle.activeTo = other.activeTo;
        handle.motions.clear();
        for (const PinMotion& motion : other.motions) {
            PinMotion own = carried(motion, carry);
            if (auto* field = std::get_if<FieldMotion<3>>(&own.kind)) renumber(*field);
            handle.motions.push_back(std::move(own));
        }
    }

    static Vec3 restPoint(const HeldShape<Dim>& shape, int vertex) {
        return inSpace(Vec<Dim>(shape.rest.points.col(vertex)));
    }

    /// Gives each vertex the displacement of the nearest one in proportion, if both shapes differ.
    void renumber(FieldMotion<3>& field) const {
        if (m_source.rest.vertexCount() == m_target.rest.vertexCount() || field.values->empty()) return;
        Points<Dim> places(Dim, static_cast<Eigen::Index>(field.values->size()));
        for (Eigen::Index k = 0; k < places.cols(); ++k)
            places.col(k) =
                m_proportion(restPoint(m_source, (*field.values)[static_cast<std::size_t>(k)].first))
                    .template head<Dim>();
        const PointLocator<Dim> nearest(places, {});
        auto values = std::make_shared<Displacements<3>>();
        for (int v = 0; v < m_target.rest.vertexCount(); ++v)
            if (const int k = nearest.nearestVertex(m_target.rest.points.col(v)); k >= 0)
                values->emplace_back(v, (*field.values)[static_cast<std::size_t>(k)].second);
        field.values = std::move(values);
    }

    /// Adds a handle of the source, if there is a place for it.
    void add(const Pin& other, int links, std::vector<Pin>& handles) {
        Pin handle = other;
        handle.id = newId();
        if (handle.traits.link != 0) handle.traits.link += links;
        const auto& parts = m_target.rest.parts;
        if (std::ranges::find(parts, handle.part, &MeshPart::name) == parts.end()) handle.part.clear();
        const bool isOnFile = other.slide && !other.slide->file.empty();
        if (isOnFile || !(placeOnGroup(handle) || placeInProportion(handle, other))) {
            m_lost.push_back(other.name);
            return;
        }
        move(handle, handle, other);
        handles.push_back(std::move(handle));
        m_added.push_back(other.name);
    }

    /// Places a handle on the group of the same name, if the target's file has it.
    bool placeOnGroup(Pin& handle) const {
        const auto name = std::ranges::find(handle.extras, "/at", [](const auto& one) { return one.first; });
        if (name == handle.extras.end() || name->second.find("\"group\"") == std::string::npos) return false;
        Project trial = m_target.project;
        Pin named = handle;
        named.at = std::vector<int>();
        std::erase_if(named.extras, [](const auto& extra) { return extra.first != "/at"; });
        named.normal.reset(), named.motions.clear();
        designOf(trial).handles = {named};
        try {
            findNamedPlaces(trial, m_folder);
        } catch (const InputError&) {
            return false;
        }
        named = designOf(trial).handles.front();
        if (!m_targetPlaces.has(named)) return false;
        handle.at = named.at;
        const Extras place = named.extras;
        handle.extras = withoutNames(handle.extras);
        handle.extras.insert(handle.extras.end(), place.begin(), place.end());
        return true;
    }

    bool placeInProportion(Pin& handle, const Pin& other) const {
        handle.extras = withoutNames(handle.extras);
        if (const auto* region = std::get_if<Region<3>>(&other.at))
            handle.at = inProportion(*region, m_proportion);
        else if (const auto* points = std::get_if<std::vector<Vec3>>(&other.at))
            handle.at = inside(*points, handle);
        else
            handle.at = vertices(m_sourcePlaces.pointsOf(other));
        return m_targetPlaces.has(handle);
    }

    std::vector<Vec3> inside(const std::vector<Vec3>& points, Pin handle) const {
        std::vector<Vec3> found;
        for (const Vec3& p : points) {
            handle.at = std::vector<Vec3>{m_proportion(p)};
            if (m_targetPlaces.has(handle)) found.push_back(m_proportion(p));
        }
        return found;
    }

    /// Returns the vertices that are nearest to such points: their numbers in a mesh from a file, otherwise
    /// their places.
    Placement<3> vertices(const std::vector<Vec3>& points) const {
        std::set<int> found;
        for (const Vec3& p : points)
            if (const int v = m_locator.nearestVertex(m_proportion(p).template head<Dim>()); v >= 0)
                found.insert(v);
        if (m_target.project.domain.kind == DomainKind::Mesh)
            return std::vector<int>(found.begin(), found.end());
        std::vector<Vec3> places;
        for (const int v : found) places.push_back(restPoint(m_target, v));
        return places;
    }

    const HeldShape<Dim> m_source, m_target;
    const std::string& m_folder;
    const Proportion m_proportion;
    const PointLocator<Dim> m_locator;  // in the target
    const Places<Dim> m_sourcePlaces{m_source.rest}, m_targetPlaces{m_target.rest};
    std::vector<std::string> m_added, m_lost, m_still;
};

template <int Dim>
std::vector<Pin> ownHandles(const Project& project, const Shape<Dim>& shape) {
    std::vector<Pin> handles;
    for (const Handle<Dim>& handle : heldHandles<Dim>(project, shape)) handles.push_back(inSpace(handle));
    handles.resize(designOf(project).handles.size());
    return handles;
}

}  // namespace

template <int Dim>
TransferredMotion withMotionOf(const HeldShape<Dim>& source, const HeldShape<Dim>& target,
                               const std::string& folder) {
    return Transfer<Dim>(source, target, folder).result();
}

template TransferredMotion withMotionOf<2>(const HeldShape<2>&, const HeldShape<2>&, const std::string&);
template TransferredMotion withMotionOf<3>(const HeldShape<3>&, const HeldShape<3>&, const std::string&);

TransferredMotion withMotionOf(const std::string& source, const Project& target, const std::string& folder,
                               std::stop_token stop) {
    const LoadedProject other = readProject(source);
    fitToPicture(*other.project, folderOf(source));
    if (dimensionOf(*other.project) != dimensionOf(target))
        throw InputError(source, dimensionOf(target) == 2
                                     ? sentence("Core", "moves a solid: its motion does not fit a picture")
                                     : sentence("Core", "moves a picture: its motion does not fit a solid"));
    const AnyShape shape = loadShape(target, folder, stop);
    const auto transfer = [&]<int Dim>(const Shape<Dim>& own) {
        const auto theirs = std::get<Shape<Dim>>(loadShape(*other.project, folderOf(source), stop));
        return withMotionOf<Dim>({*other.project, *theirs.rest, ownHandles(*other.project, theirs)},
                                 {target, *own.rest, ownHandles(target, own)}, folder);
    };
    try {
        return std::visit(transfer, shape);
    } catch (const InputError& error) {
        throw error.named(source);
    }
}

}  // namespace wend
