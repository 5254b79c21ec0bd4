#include "app/engine/shape/parted_shape.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/engine/shape/flat_shape.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/file/named_files.h"
#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/mesh/segments.h"
#include "core/motion/handle_points.h"

namespace wend {
namespace {

constexpr int kFewestVertices = 12;  // of a part that is given its share

std::string keyOf(std::size_t part) {
    return "domain.parts[" + std::to_string(part) + "]";
}

/// Returns the domain of one part alone.
Domain domainOf(const Domain& whole, const PicturePart& part) {
    Domain own = whole;
    own.parts.clear();
    own.path = part.path;
    for (ValueLayer& layer : own.sizes)
        std::erase_if(layer.regions, [&](const SoftRegion& region) {
            return !region.part.empty() && region.part != part.name;
        });
    if (!part.outline) return own;
    own.outline = part.outline->kind;
    own.alpha = part.outline->alpha;
    own.polygons = part.outline->polygons;
    return own;
}

double enclosedArea(const Outline& outline) {
    double area = 0;
    for (const auto& loop : outline.loops) area += loopArea(loop);
    return std::abs(area);
}

/// Makes the shape of a picture of parts.
class PartedShape {
  public:
    PartedShape(const Domain& domain, const Design& design, const std::string& folder, PartedCache& cache)
        : m_domain(domain), m_design(design), m_folder(folder), m_cache(cache) {}

    Shape<2> make(std::stop_token stop) {
        m_cache.pictures =
            loadParts(m_domain.parts, m_folder, m_cache.pictures, &m_shape.notices, m_domain.size, stop);
        findOutlines();
        shareVertices();
        meshParts(stop);
        if (stop.stop_requested()) return {};
        weldJoints();
        drawOnAtlas();
        tellOfMany();
        return std::move(m_shape);
    }

  private:
    const std::vector<PicturePart>& parts() const { return m_domain.parts; }
    std::size_t placeOf(const std::string& name) const {
        return static_cast<std::size_t>(std::ranges::find(parts(), name, &PicturePart::name) -
                                        parts().begin());
    }

    /// Finds the outlines in domain coordinates that are not known yet.
    void findOutlines() {
        std::vector<PartOutline> from;
        std::vector<Outline> outlines;
        for (std::size_t i = 0; i < parts().size(); ++i) {
            const Domain own = domainOf(m_domain, parts()[i]);
            from.push_back({own.outline, own.alpha, own.polygons});
            const Outline* known = knownOutline(m_cache.pictures.sheets[i], from.back());
            outlines.push_back(known ? *known : outlineOf(i, own));
        }
        m_cache.outlinesOf = m_cache.pictures.sheets;
        m_cache.outlinesFrom = std::move(from);
        m_cache.outlines = std::move(outlines);
    }

    const Outline* knownOutline(const Sheet& sheet, const PartOutline& from) const {
        for (std::size_t i = 0; i < m_cache.outlines.size(); ++i)
            if (m_cache.outlinesOf[i].picture == sheet.picture && m_cache.outlinesOf[i].at == sheet.at &&
                m_cache.outlinesFrom[i] == from)
                return &m_cache.outlines[i];
        return nullptr;
    }

    Outline outlineOf(std::size_t part, const Domain& own) const try {
        const Sheet& sheet = m_cache.pictures.sheets[part];
        Outline outline = domainOutline(own, *sheet.picture);
        if (own.outline == OutlineKind::Polygons) return outline;
        for (auto& loop : outline.loops)
            for (Vec2& p : loop) p += sheet.at;
        return outline;
    } catch (const InputError& error) {
        throw InputError(keyOf(part) + ": " + error.message());
    }

    /// Those without a number of their own share the domain's by their areas.
    void shareVertices() {
        double area = 0;
        for (std::size_t i = 0; i < parts().size(); ++i)
            if (parts()[i].vertices == 0) area += enclosedArea(m_cache.outlines[i]);
        for (std::size_t i = 0; i < parts().size(); ++i) {
            const double share = enclosedArea(m_cache.outlines[i]) / area;
            m_vertices.push_back(
                parts()[i].vertices > 0
                    ? parts()[i].vertices
                    : std::max(kFewestVertices, static_cast<int>(std::lround(share * m_domain.vertices))));
        }
    }

    /// Returns the frontmost part with its own mesh that contains the place, or the number of parts if none
    /// does.
    std::size_t frontmostAt(const Vec2& p) const {
        std::size_t i = 0;
        while (i < parts().size() && !(parts()[i].ridesOn.empty() && isInOutline(m_cache.outlines[i], p)))
            ++i;
        return i;
    }

    /// Returns the design of one part alone: its joints, and handles with the points that are in it.
    Design designOf(std::size_t part) const {
        Design own;
        const auto add = [&](const std::vector<Vec3>& points, double from) {
            Pin handle;
            handle.at = points;
            handle.activeFrom = from;
            if (!points.empty()) own.handles.push_back(std::move(handle));
        };
        if (!parts()[part].ridesOn.empty()) return own;
        for (const Pin& handle : m_design.handles) {
            const auto* places = std::get_if<std::vector<Vec3>>(&handle.at);
            if (!places) continue;
            std::vector<Vec3> points;
            for (const Vec3& p : *places)
                if (handle.part.empty() ? frontmostAt(inPlane(p)) == part : handle.part == parts()[part].name)
                    points.push_back(p);
            add(points, handle.activeFrom);
        }
        for (const PicturePart& other : parts())
            for (const Joint& joint : other.joints)
                if (other.name == parts()[part].name || joint.to == parts()[part].name)
                    add({inSpace(joint.at)}, 0);
        return own;
    }

    SimplicialMesh<2> meshOf(std::size_t part, std::stop_token stop) const try {
        Domain own = domainOf(m_domain, parts()[part]);
        own.vertices = m_vertices[part];
        if (parts()[part].vertices > 0) own.edge = 0;
        return *meshPicture(own, designOf(part), m_cache.outlines[part], stop);
    } catch (const InputError& error) {
        throw InputError(keyOf(part) + ": " + error.message());
    }

    /// Appends a mesh, and returns its range.
    static MeshPart append(const std::string& name, const SimplicialMesh<2>& mesh, SimplicialMesh<2>& all) {
        const int vertices = all.vertexCount(), cells = all.cellCount();
        all.points.conservativeResize(2, vertices + mesh.vertexCount());
        all.points.rightCols(mesh.vertexCount()) = mesh.points;
        for (Cell<2> cell : mesh.cells) {
            for (int& v : cell) v += vertices;
            all.cells.push_back(cell);
        }
        return {name, vertices, all.vertexCount(), cells, all.cellCount()};
    }

    void meshParts(std::stop_token stop) {
        SimplicialMesh<2> all;
        all.points.resize(2, 0);
        m_meshes.resize(parts().size());
        for (std::size_t i = parts().size(); i-- > 0;) {
            m_meshes[i] = meshOf(i, stop);
            if (stop.stop_requested()) return;
            if (parts()[i].ridesOn.empty()) all.parts.push_back(append(parts()[i].name, m_meshes[i], all));
        }
        m_rest = std::move(all);
    }

    // --- Joints ---

    void weldJoints() {
        const Normalization<2> units;
        const HandlePlacer<2> placer(m_rest, units);
        std::vector<Weld> welds;
        for (std::size_t i = 0; i < parts().size(); ++i)
            for (std::size_t k = 0; k < parts()[i].joints.size(); ++k) {
                const std::string key = keyOf(i) + ".joints[" + std::to_string(k) + "]";
                try {
                    weld(parts()[i].name, parts()[i].joints[k], placer, welds);
                } catch (const InputError& error) {
                    throw InputError(key + ": " + error.message());
                }
            }
        m_rest.welds = std::move(welds);
        m_shape.rest = std::make_shared<const SimplicialMesh<2>>(std::move(m_rest));
    }

    std::vector<Vec2> placesOf(const std::string& name, const Joint& joint) const {
        std::vector<Vec2> places{joint.at};
        const auto own = std::ranges::find(m_rest.parts, name, &MeshPart::name);
        const Outline& other = m_cache.outlines[placeOf(joint.to)];
        for (int v = own->firstVertex; joint.radius > 0 && v < own->endVertex; ++v) {
            const Vec2 p = m_rest.points.col(v);
            if (p != joint.at && (p - joint.at).norm() <= joint.radius && isInOutline(other, p))
                places.push_back(p);
        }
        return places;
    }

    void weld(const std::string& name, const Joint& joint, const HandlePlacer<2>& placer,
              std::vector<Weld>& welds) const {
        for (const Vec2& place : placesOf(name, joint)) {
            Weld& weld = welds.emplace_back();
            for (const auto& [part, sign] : {std::pair{name, 1.0}, {joint.to, -1.0}}) {
                Handle<2> point;
                point.at = std::vector<Vec2>{place};
                point.part = part;
                for (const auto& [vertex, weight] : termsOf(placer, point, part))
                    weld.terms.emplace_back(vertex, sign * weight);
            }
        }
    }

    static std::vector<std::pair<int, double>> termsOf(const HandlePlacer<2>& placer, const Handle<2>& point,
                                                       const std::string& part) try {
        return placer.place(point, 0).front().terms;
    } catch (const InputError& error) {
        throw InputError(error.message() + " \"" + part + "\"");
    }

    // --- What is drawn ---

    /// Returns the part with a mesh that a part follows.
    const MeshPart& hostOf(std::size_t part) const {
        while (!parts()[part].ridesOn.empty()) part = placeOf(parts()[part].ridesOn);
        return *std::ranges::find(m_shape.rest->parts, parts()[part].name, &MeshPart::name);
    }

    void addRiders(SimplicialMesh<2>& drawn, Texture& texture) const {
        for (std::size_t i = parts().size(); i-- > 0;) {
            if (parts()[i].ridesOn.empty()) continue;
            const MeshPart& host = hostOf(i);
            const auto begin = m_shape.rest->cells.begin();
            SimplicialMesh<2> below{m_shape.rest->points, {begin + host.firstCell, begin + host.endCell}};
            Embedding<2> embedding(below, m_meshes[i].points);
            texture.riders.push_back({std::move(below), std::move(embedding)});
            drawn.parts.push_back(append(parts()[i].name, m_meshes[i], drawn));
        }
        std::ranges::sort(drawn.parts, std::greater<>(),
                          [this](const MeshPart& part) { return placeOf(part.name); });
    }

    /// Moves each vertex to its place in the atlas.
    SimplicialMesh<2> inAtlas(SimplicialMesh<2> drawn) const {
        for (const MeshPart& part : drawn.parts) {
            const std::size_t i = placeOf(part.name);
            const Vec2 shift = m_cache.places[i] - m_cache.pictures.sheets[i].at;
            drawn.points.middleCols(part.firstVertex, part.endVertex - part.firstVertex).colwise() += shift;
        }
        drawn.welds.clear();
        return drawn;
    }

    /// Makes a new atlas only if the sheets have changed, because windows prepare each new one.
    void makeCachedAtlas() {
        if (m_cache.atlas && m_cache.atlasOf == m_cache.pictures.sheets) return;
        Atlas atlas = makeAtlas(m_cache.pictures.sheets);
        m_cache.atlasOf = m_cache.pictures.sheets;
        m_cache.atlas = std::make_shared<const Image>(std::move(atlas.picture));
        m_cache.places = std::move(atlas.places);
    }

    void drawOnAtlas() {
        makeCachedAtlas();
        Texture texture;
        SimplicialMesh<2> drawn = *m_shape.rest;
        addRiders(drawn, texture);
        texture.rest = std::make_shared<const SimplicialMesh<2>>(inAtlas(drawn));
        texture.drawn = std::make_shared<const SimplicialMesh<2>>(std::move(drawn));
        for (const MeshPart& part : texture.drawn->parts)
            texture.sheets.push_back(m_cache.pictures.sheets[placeOf(part.name)]);
        texture.width = m_cache.pictures.width, texture.height = m_cache.pictures.height;
        m_shape.picture = m_cache.atlas;
        m_shape.texture = std::make_shared<const Texture>(std::move(texture));
    }

    void tellOfMany() {
        int own = 0;
        for (const PicturePart& part : parts()) own += part.vertices;
        if (own == 0) tellOfAim(m_domain, *m_shape.rest, m_shape.notices);
    }

    const Domain& m_domain;
    const Design& m_design;
    const std::string& m_folder;
    PartedCache& m_cache;
    std::vector<int> m_vertices;              // that each part aims at
    std::vector<SimplicialMesh<2>> m_meshes;  // of each part
    SimplicialMesh<2> m_rest;
    Shape<2> m_shape;
};

}  // namespace

Shape<2> loadPartedShape(const Domain& domain, const Design& design, const std::string& folder,
                         PartedCache& cache, std::stop_token stop) {
    return PartedShape(domain, design, folder, cache).make(stop);
}

}  // namespace wend
