// OpenFOAM's polyMesh: the files points, faces, owner, neighbour and boundary of a folder. Only the points
// are written, into their own file again.

#include <zlib.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/base/input_file.h"
#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/foam_text.h"
#include "core/mesh/formats/mesh_format.h"

namespace wend::formats {
namespace {

namespace fs = std::filesystem;
using FaceVertices = std::vector<long>;

/// A face of a cell, whose vertices run so that its normal points into the cell.
using InwardFace = std::vector<int>;

std::string gunzipped(const std::string& path) {
    readInput(path);  // requires a regular file
    const gzFile file = gzopen(path.c_str(), "rb");
    if (!file) throw InputError(path, "cannot be read");
    std::string bytes;
    std::vector<char> buffer(1 << 16);
    int count = 0;
    while ((count = gzread(file, buffer.data(), static_cast<unsigned>(buffer.size()))) > 0)
        bytes.append(buffer.data(), static_cast<std::size_t>(count));
    gzclose(file);
    if (count < 0) throw InputError(path, "is damaged");
    return bytes;
}

class PolyMesh {
  public:
    explicit PolyMesh(const MeshSource& source) {
        const fs::path path(source.path);
        m_folder =
            path.filename() == "points" ? path.parent_path() : path.parent_path() / "constant" / "polyMesh";
        if (path.filename() == "points")
            m_points = source.bytes;
        else
            m_points = textOf("points");
    }

    MeshFile read() {
        MeshFile file;
        file.points = FoamText(pathOf("points"), m_points).points();
        readFaces(file.points.cols());
        addCells(file);
        addPatches(file);
        addInner(file);
        addZones(file);
        file.deck = std::make_shared<const std::string>(m_points);
        file.deckFormat = ".foam";
        finishCells(file, [](int cell) { return "cell " + std::to_string(cell); });
        return file;
    }

  private:
    std::string pathOf(const char* name) const { return (m_folder / name).string(); }
    /// Returns the content of a file, which may be compressed.
    std::string textOf(const char* name) const {
        const std::string packed = pathOf(name) + ".gz";
        return !fs::exists(pathOf(name)) && fs::exists(packed) ? gunzipped(packed) : readInput(pathOf(name));
    }
    bool has(const char* name) const { return fs::exists(pathOf(name)) || fs::exists(pathOf(name) + ".gz"); }

    void readFaces(Eigen::Index points) {
        m_faces = FoamText(pathOf("faces"), textOf("faces")).faces();
        for (std::size_t f = 0; f < m_faces.size(); ++f)
            for (const long v : m_faces[f])
                if (v < 0 || v >= points || m_faces[f].size() < 3)
                    throw InputError(pathOf("faces"), "face " + std::to_string(f) + " names vertex " +
                                                          std::to_string(v) + ", but there are only " +
                                                          std::to_string(points));
        const std::vector<long> owner = FoamText(pathOf("owner"), textOf("owner")).numbers(),
                                neighbour = FoamText(pathOf("neighbour"), textOf("neighbour")).numbers();
        if (owner.size() != m_faces.size() || neighbour.size() > owner.size())
            throw InputError(pathOf("owner"), "has " + std::to_string(owner.size()) + " entries for " +
                                                  std::to_string(m_faces.size()) + " faces");
        for (const auto* side : {&owner, &neighbour})
            for (std::size_t f = 0; f < side->size(); ++f) addToCell((*side)[f], f, side == &owner);
    }
    /// A face's normal points out of its owner.
    void addToCell(long cell, std::size_t face, bool owns) {
        if (cell < 0 && !owns) return;  // older files list the faces of the border as well
        if (cell < 0 || cell >= std::ssize(m_faces))
            throw InputError(pathOf(owns ? "owner" : "neighbour"),
                             "face " + std::to_string(face) + " names cell " + std::to_string(cell));
        if (cell >= std::ssize(m_cells)) m_cells.resize(static_cast<std::size_t>(cell) + 1);
        InwardFace own(m_faces[face].begin(), m_faces[face].end());
        if (owns) std::ranges::reverse(own);
        m_cells[static_cast<std::size_t>(cell)].push_back(std::move(own));
        m_facesOf.resize(m_cells.size());
        m_facesOf[static_cast<std::size_t>(cell)].push_back(face);
    }

    void addCells(MeshFile& file) {
        for (std::size_t c = 0; c < m_cells.size(); ++c) {
            m_first.push_back(file.cells.size());
            const auto& faces = m_cells[c];
            const auto triangles = std::ranges::count(faces, 3U, &InwardFace::size),
                       quads = std::ranges::count(faces, 4U, &InwardFace::size);
            const bool isPlain = triangles + quads == std::ssize(faces);
            const auto is = [&](int three, int four) {
                return isPlain && triangles == three && quads == four;
            };
            if (is(4, 0))
                addPrism(c, 3, CellKind::Tetrahedron, file);
            else if (is(4, 1))
                addPrism(c, 4, CellKind::Pyramid, file);
            else if (is(2, 3))
                addPrism(c, 3, CellKind::Wedge, file);
            else if (is(0, 6))
                addPrism(c, 4, CellKind::Hexahedron, file);
            else
                addPolyhedron(c, file);
        }
        m_first.push_back(file.cells.size());
    }
    [[noreturn]] void failAt(std::size_t cell, const std::string& what) const {
        throw InputError(pathOf("faces"), "cell " + std::to_string(cell) + " " + what);
    }

    /// Adds a cell from its first face with that many corners: these, and where the edges lead that leave
    /// them.
    void addPrism(std::size_t c, std::size_t corners, CellKind kind, MeshFile& file) const {
        const auto& faces = m_cells[c];
        const InwardFace& base = *std::ranges::find(faces, corners, &InwardFace::size);
        std::map<int, std::vector<int>> upwards;  // from the corners of the base
        for (const InwardFace& face : faces)
            for (std::size_t k = 0; k < face.size(); ++k) {
                const int a = face[k], b = face[(k + 1) % face.size()];
                if (std::ranges::count(base, a) > 0 && std::ranges::count(base, b) == 0)
                    upwards[a].push_back(b);
            }
        std::vector<int> nodes(base.begin(), base.end());
        for (const int corner : base) {
            const std::vector<int>& ends = upwards[corner];
            if (ends.empty() || std::ranges::count(ends, ends.front()) != std::ssize(ends))
                failAt(c, "has faces that do not close it");
            if (std::ranges::count(nodes, ends.front()) == 0) nodes.push_back(ends.front());
        }
        if (std::ssize(nodes) != factsOf(kind).corners) failAt(c, "has faces that do not close it");
        file.cells.add(kind, nodes);
    }

    /// Adds a vertex that the case does not have, and returns its number.
    int addVertex(const Eigen::Vector3d& place, const MeshFile& file) {
        m_inner.push_back(place);
        return static_cast<int>(file.points.cols()) + static_cast<int>(m_inner.size()) - 1;
    }
    Eigen::Vector3d pointOf(int vertex, const MeshFile& file) const {
        const auto count = static_cast<int>(file.points.cols());
        return vertex < count ? Eigen::Vector3d(file.points.col(vertex))
                              : m_inner[static_cast<std::size_t>(vertex - count)];
    }
    /// Returns the triangles of a face as its cells on both sides have them: a quadrilateral's from its
    /// vertex of the smallest number, as splitCell does, and those around a vertex within of more corners.
    std::vector<std::array<int, 3>> split(std::size_t face, InwardFace corners, const MeshFile& file) {
        if (corners.size() <= 4) {
            std::ranges::rotate(corners, std::ranges::min_element(corners));
            std::vector<std::array<int, 3>> triangles{{corners[0], corners[1], corners[2]}};
            if (corners.size() == 4) triangles.push_back({corners[0], corners[2], corners[3]});
            return triangles;
        }
        auto [centre, isNew] = m_centres.try_emplace(face, 0);
        if (isNew) {
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            for (const int v : corners) sum += file.points.col(v);
            centre->second = addVertex(sum / static_cast<double>(corners.size()), file);
        }
        std::vector<std::array<int, 3>> triangles;
        for (std::size_t k = 0; k < corners.size(); ++k)
            triangles.push_back({corners[k], corners[(k + 1) % corners.size()], centre->second});
        return triangles;
    }
    /// Throws InputError unless every edge of a cell has a face on both sides.
    void requireClosed(std::size_t c) const {
        std::set<std::array<int, 2>> sides;
        bool isClosed = true;
        for (const InwardFace& face : m_cells[c])
            for (std::size_t k = 0; k < face.size(); ++k)
                isClosed = sides.insert({face[k], face[(k + 1) % face.size()]}).second && isClosed;
        for (const auto& [a, b] : sides) isClosed = isClosed && sides.contains({b, a});
        if (!isClosed) failAt(c, "has faces that do not close it");
    }
    /// Fills a polyhedron with tetrahedra between the triangles of its faces and a vertex within.
    void addPolyhedron(std::size_t c, MeshFile& file) {
        requireClosed(c);
        std::set<int> corners;
        for (const InwardFace& face : m_cells[c]) corners.insert(face.begin(), face.end());
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        for (const int v : corners) centre += file.points.col(v) / static_cast<double>(corners.size());
        std::vector<std::array<int, 3>> skin;
        for (std::size_t k = 0; k < m_cells[c].size(); ++k)
            for (const auto& triangle : split(m_facesOf[c][k], m_cells[c][k], file)) skin.push_back(triangle);
        const int inner = addVertex(centre, file);
        for (const auto& [a, b, d] : skin) {
            const Eigen::Vector3d p = pointOf(a, file), q = pointOf(b, file), r = pointOf(d, file);
            if (!((q - p).cross(r - p).dot(centre - p) > 0))
                failAt(c, "is a polyhedron of " + std::to_string(m_cells[c].size()) +
                              " faces that its middle does not see all of: it cannot be split");
            file.cells.add(CellKind::Tetrahedron, std::array{a, b, d, inner});
        }
        ++file.polyhedra;
    }
    /// Puts the vertices within faces and polyhedra behind those of the case.
    void addInner(MeshFile& file) const {
        const Eigen::Index first = file.points.cols();
        file.points.conservativeResize(3, first + std::ssize(m_inner));
        for (std::size_t i = 0; i < m_inner.size(); ++i)
            file.points.col(first + static_cast<Eigen::Index>(i)) = m_inner[i];
    }

    /// Adds a face of a patch to the cells, as a triangle for each of its parts if it was split.
    void addFace(std::size_t f, MeshFile& file, MeshGroup& group) {
        const InwardFace corners(m_faces[f].begin(), m_faces[f].end());
        if (!m_centres.contains(f)) {
            group.cells.push_back(file.cells.size());
            return file.cells.addFace(corners);
        }
        for (const auto& triangle : split(f, corners, file)) {
            group.cells.push_back(file.cells.size());
            file.cells.addFace(triangle);
        }
    }
    /// Adds a group of its name for the faces of every patch.
    void addPatches(MeshFile& file) {
        FoamText text(pathOf("boundary"), textOf("boundary"));
        const long patches = text.number();
        text.expect("(");
        for (long p = 0; p < patches; ++p) {
            MeshGroup group;
            group.name = std::string(text.word());
            const std::map<std::string, long> entries = numbersOf(text);
            const auto at = [&](const char* key) { return entries.contains(key) ? entries.at(key) : -1; };
            const long first = at("startFace"), count = at("nFaces");
            if (first < 0 || count < 0 || first + count > std::ssize(m_faces))
                text.fail("patch " + group.name + " has faces that are not there");
            for (long f = first; f < first + count; ++f) addFace(static_cast<std::size_t>(f), file, group);
            if (!group.cells.empty()) file.groups.push_back(std::move(group));
        }
    }
    /// Reads a dictionary, and returns its entries that are whole numbers.
    static std::map<std::string, long> numbersOf(FoamText& text) {
        std::map<std::string, long> entries;
        text.expect("{");
        for (std::string key; (key = std::string(text.word())) != "}";) {
            if (key == "nFaces" || key == "startFace") {
                entries[key] = text.number();
                text.expect(";");
            } else {
                text.skipEntry();
            }
        }
        return entries;
    }

    void addZones(MeshFile& file) const {
        if (has("cellZones")) addCellZones(file);
        for (const char* other : {"faceZones", "pointZones"}) {
            if (!has(other)) continue;
            FoamText text(pathOf(other), textOf(other));
            if (const long zones = text.atEnd() ? 0 : text.number(); zones > 0)
                file.notices.push_back("its " + std::to_string(zones) + " " + other);
        }
    }
    void addCellZones(MeshFile& file) const {
        FoamText text(pathOf("cellZones"), textOf("cellZones"));
        const long zones = text.atEnd() ? 0 : text.number();
        if (zones > 0) text.expect("(");
        for (long z = 0; z < zones; ++z) {
            MeshGroup group;
            group.name = std::string(text.word());
            group.dimension = 3;
            text.expect("{");
            for (std::string key; (key = std::string(text.word())) != "}";) {
                if (key != "cellLabels") {
                    text.skipEntry();
                    continue;
                }
                if (text.next().starts_with("List")) text.word();
                for (const long cell : text.numbers()) {
                    if (cell < 0 || cell >= std::ssize(m_cells))
                        text.fail("zone " + group.name + " has cells that are not there");
                    for (int own = m_first[static_cast<std::size_t>(cell)];
                         own < m_first[static_cast<std::size_t>(cell) + 1]; ++own)
                        group.cells.push_back(own);
                }
                text.expect(";");
            }
            std::ranges::sort(group.cells);
            if (!group.cells.empty()) file.groups.push_back(std::move(group));
        }
    }

    fs::path m_folder;
    std::string m_points;
    std::vector<FaceVertices> m_faces;
    std::vector<std::vector<InwardFace>> m_cells;
    std::vector<std::vector<std::size_t>> m_facesOf;  // the numbers of the faces of each cell
    std::vector<int> m_first;                         // of the file's cells that each is, and their end
    std::map<std::size_t, int> m_centres;             // the vertices within faces
    std::vector<Eigen::Vector3d> m_inner;             // vertices that the case does not have
};

}  // namespace

/// An error in one of the other files follows the name of the one that was asked for.
MeshFile readFoam(std::span<const MeshSource> files) {
    try {
        return PolyMesh(files.front()).read();
    } catch (const InputError& error) {
        if (error.file().empty() || error.file() == files.front().path) throw;
        throw InputError(files.front().path, error.what());
    }
}

std::vector<std::string> printFoam(const MeshFile& mesh, const MeshWriteOptions&) {
    if (!mesh.deck || mesh.deckFormat != ".foam")
        throw InputError("only a mesh that was read from an OpenFOAM case is written for one");
    return {FoamText::withPoints(*mesh.deck, mesh.points)};
}

}  // namespace wend::formats
