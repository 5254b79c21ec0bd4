// Stereolithography: facets with their three corners' coordinates, as text or as 50 bytes each behind 84
// bytes of header.

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/text_writer.h"

namespace wend::formats {
namespace {

constexpr std::size_t headerSize = 84, facetSize = 50;

/// Facets without shared vertices → shared ones, numbered by first use.
class VertexMerger {
  public:
    int add(const std::array<double, 3>& p) {
        // −0 equals 0 as a key, and the first of both is what stays
        const auto [entry, isNew] = m_known.try_emplace(p, static_cast<int>(m_known.size()));
        if (isNew) m_points.insert(m_points.end(), p.begin(), p.end());
        return entry->second;
    }
    Eigen::Matrix3Xd points() const {
        return Eigen::Map<const Eigen::Matrix3Xd>(m_points.data(), 3,
                                                  static_cast<Eigen::Index>(m_points.size() / 3));
    }

  private:
    std::map<std::array<double, 3>, int> m_known;
    std::vector<double> m_points;
};

void expect(Scanner& scanner, std::string_view wanted) {
    const auto word = scanner.word(wanted.data());
    if (!sameWord(word, wanted)) scanner.fail(inQuotes(word) + " where " + inQuotes(wanted) + " is expected");
}

/// Reads "facet normal … outer loop … vertex … endloop endfacet". The normal is ignored.
void readFacetText(Scanner& scanner, VertexMerger& vertices, MeshFile& file) {
    expect(scanner, "normal");
    for (int k = 0; k < 3; ++k) scanner.real("a normal");
    expect(scanner, "outer");
    expect(scanner, "loop");
    std::array<int, 3> corners;
    for (int& corner : corners) {
        expect(scanner, "vertex");
        std::array<double, 3> p;
        for (double& coordinate : p) coordinate = scanner.finite("a coordinate");
        corner = vertices.add(p);
    }
    expect(scanner, "endloop");
    expect(scanner, "endfacet");
    file.cells.add(CellKind::Triangle, corners);
}

/// A group for a solid, if it has a name or is not the only one.
void addSolids(const std::vector<std::pair<std::string, int>>& solids, MeshFile& file) {
    if (solids.size() < 2 && (solids.empty() || solids[0].first.empty())) return;
    int first = 0;
    for (std::size_t i = 0; i < solids.size(); ++i) {
        MeshGroup group{solids[i].first, 2, 0, {}, {}, false};
        if (group.name.empty()) group.name = "solid " + std::to_string(i + 1);
        for (; first < solids[i].second; ++first) group.cells.push_back(first);
        if (!group.cells.empty()) file.groups.push_back(std::move(group));
    }
}

/// Reads one or more "solid NAME … endsolid NAME".
MeshFile readText(std::string_view bytes) {
    Scanner scanner(bytes);
    VertexMerger vertices;
    MeshFile file;
    std::vector<std::pair<std::string, int>> solids;  // names, and where their triangles end
    while (!scanner.atEnd()) {
        expect(scanner, "solid");
        auto name = scanner.line();
        name.remove_prefix(std::min(name.find_first_not_of(" \t"), name.size()));
        for (;;) {
            const auto word = scanner.word("facet or endsolid");
            if (sameWord(word, "endsolid")) break;
            if (!sameWord(word, "facet"))
                scanner.fail(inQuotes(word) + " where 'facet' or 'endsolid' is expected");
            readFacetText(scanner, vertices, file);
        }
        scanner.line();
        solids.emplace_back(name, file.cells.size());
    }
    addSolids(solids, file);
    file.points = vertices.points();
    finishCells(file);
    return file;
}

/// Reads a binary file: 80 bytes, the number of facets, and 50 bytes for each.
MeshFile readBinary(std::string_view bytes) {
    Scanner scanner(bytes);
    scanner.placesAreOffsets();
    scanner.seek(headerSize - 4);
    NumberReader numbers(scanner, true, std::endian::little);
    const int count = numbers.count(Scalar::UInt32, "facets", facetSize, Scalar::UInt8);
    if (scanner.remaining() != count * facetSize)
        scanner.fail("there should be " + std::to_string(count) +
                     " facets, but the file's length does not fit");
    VertexMerger vertices;
    MeshFile file;
    MeshField attribute{"attribute", true, 1, {}, {}, Scalar::UInt16};
    for (int t = 0; t < count; ++t) {
        scanner.raw(12, "a normal");
        std::array<int, 3> triangle;
        for (int& corner : triangle) {
            std::array<double, 3> p;
            for (double& coordinate : p) coordinate = numbers.finite(Scalar::Float32, "a coordinate");
            corner = vertices.add(p);
        }
        file.cells.add(CellKind::Triangle, triangle);
        attribute.values.push_back(numbers.real(Scalar::UInt16, "an attribute"));
    }
    file.points = vertices.points();
    const bool none = std::ranges::all_of(attribute.values, [](double value) { return value == 0; });
    if (!none) file.fields.push_back(std::move(attribute));
    finishCells(file);
    return file;
}

/// Returns whether the length is that of a binary file. Some programs begin binary files with "solid" too, so
/// only the length is reliable.
bool hasBinaryLength(std::string_view bytes) {
    if (bytes.size() < headerSize) return false;
    const auto count = decodeInteger(bytes.substr(headerSize - 4), Scalar::UInt32, std::endian::little);
    return bytes.size() == headerSize + static_cast<std::size_t>(count) * facetSize;
}

Eigen::Vector3d normalOf(const MeshFile& mesh, const std::array<int, 3>& t) {
    const Eigen::Vector3d a = mesh.points.col(t[0]), b = mesh.points.col(t[1]), c = mesh.points.col(t[2]);
    return (b - a).cross(c - a).stableNormalized();
}

void printFacet(const MeshFile& mesh, const std::array<int, 3>& triangle, TextWriter& out) {
    const auto n = normalOf(mesh, triangle);
    out << "facet normal " << n.x() << ' ' << n.y() << ' ' << n.z() << "\n outer loop\n";
    for (const int v : triangle) {
        const auto p = mesh.points.col(v);
        out << "  vertex " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    }
    out << " endloop\nendfacet\n";
}

std::array<int, 3> triangleOf(const MeshFile& mesh, int c) {
    const auto nodes = mesh.cells[c];
    return {nodes[0], nodes[1], nodes[2]};
}

/// Prints a solid for each run of triangles of one group.
std::string printText(const MeshFile& mesh) {
    const std::vector<int> groups = mainGroups(mesh);
    const auto nameOf = [&](int group) {
        if (group < 0) return std::string("wend");
        const MeshGroup& one = mesh.groups[static_cast<std::size_t>(group)];
        return one.name.empty() ? std::to_string(one.tag) : one.name;
    };
    TextWriter out;
    for (int c = 0; c < mesh.cells.size(); ++c) {
        const int group = groups[static_cast<std::size_t>(c)];
        const bool first = c == 0 || groups[static_cast<std::size_t>(c) - 1] != group;
        if (first && c > 0) out << "endsolid " << nameOf(groups[static_cast<std::size_t>(c) - 1]) << '\n';
        if (first) out << "solid " << nameOf(group) << '\n';
        printFacet(mesh, triangleOf(mesh, c), out);
    }
    out << "endsolid " << nameOf(groups.empty() ? -1 : groups.back()) << '\n';
    return std::move(out.text());
}

/// Prints binary STL, in single precision and with the triangles' own normals.
std::string printBinary(const MeshFile& mesh) {
    std::string out = "binary STL";  // must not begin with "solid"
    out.resize(headerSize - 4, ' ');
    appendInteger(out, mesh.cells.size(), Scalar::UInt32, std::endian::little);
    const auto append = [&](const Eigen::Vector3d& p) {
        for (double value : p) appendReal(out, value, Scalar::Float32, std::endian::little);
    };
    const MeshField* attribute = cellField(mesh, {"attribute"});
    for (int c = 0; c < mesh.cells.size(); ++c) {
        const auto triangle = triangleOf(mesh, c);
        append(normalOf(mesh, triangle));
        for (const int v : triangle) append(mesh.points.col(v));
        const double value = attribute ? attribute->ofCells[static_cast<std::size_t>(c)] : 0;
        appendInteger(out, value >= 0 && value < 65536 ? std::lround(value) : 0, Scalar::UInt16,
                      std::endian::little);
    }
    return out;
}

}  // namespace

MeshFile readStl(std::span<const MeshSource> files) {
    const std::string_view bytes = files[0].bytes;
    if (hasBinaryLength(bytes)) return readBinary(bytes);
    Scanner scanner(bytes);
    if (bytes.size() < headerSize || sameWord(scanner.word("the word solid"), "solid"))
        return readText(bytes);
    return readBinary(bytes);
}

std::vector<std::string> printStl(const MeshFile& mesh, const MeshWriteOptions& options) {
    return {options.binary() ? printBinary(mesh) : printText(mesh)};
}

}  // namespace wend::formats
