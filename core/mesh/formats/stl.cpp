// Stereolithography: facets with their three corners' coordinates, as text or as 50 bytes each behind 84
// bytes of header.

#include <Eigen/Geometry>
#include <map>

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
    file.triangles.push_back(corners);
}

/// One or more "solid NAME … endsolid NAME".
MeshFile readText(std::string_view bytes) {
    Scanner scanner(bytes);
    VertexMerger vertices;
    MeshFile file;
    while (!scanner.atEnd()) {
        expect(scanner, "solid");
        scanner.line();
        for (;;) {
            const auto word = scanner.word("facet or endsolid");
            if (sameWord(word, "endsolid")) break;
            if (!sameWord(word, "facet"))
                scanner.fail(inQuotes(word) + " where 'facet' or 'endsolid' is expected");
            readFacetText(scanner, vertices, file);
        }
        scanner.line();
    }
    file.points = vertices.points();
    return file;
}

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
    file.triangles.resize(count);
    for (auto& triangle : file.triangles) {
        scanner.raw(12, "a normal");
        for (int& corner : triangle) {
            std::array<double, 3> p;
            for (double& coordinate : p) coordinate = numbers.finite(Scalar::Float32, "a coordinate");
            corner = vertices.add(p);
        }
        scanner.raw(2, "an attribute");
    }
    file.points = vertices.points();
    return file;
}

/// Programs begin binary files with "solid" too; only the length tells.
bool hasBinaryLength(std::string_view bytes) {
    if (bytes.size() < headerSize) return false;
    const auto count = decodeInteger(bytes.substr(headerSize - 4), Scalar::UInt32, std::endian::little);
    return bytes.size() == headerSize + static_cast<std::size_t>(count) * facetSize;
}

Eigen::Vector3d normalOf(const MeshFile& mesh, const std::array<int, 3>& t) {
    const Eigen::Vector3d a = mesh.points.col(t[0]), b = mesh.points.col(t[1]), c = mesh.points.col(t[2]);
    return (b - a).cross(c - a).stableNormalized();
}

std::string printText(const MeshFile& mesh) {
    TextWriter out;
    out << "solid wend\n";
    for (const auto& triangle : mesh.triangles) {
        const auto n = normalOf(mesh, triangle);
        out << "facet normal " << n.x() << ' ' << n.y() << ' ' << n.z() << "\n outer loop\n";
        for (int v : triangle) {
            const auto p = mesh.points.col(v);
            out << "  vertex " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
        }
        out << " endloop\nendfacet\n";
    }
    out << "endsolid wend\n";
    return std::move(out.text());
}

std::string printBinary(const MeshFile& mesh) {
    std::string out = "binary STL";  // must not begin with "solid"
    out.resize(headerSize - 4, ' ');
    appendInteger(out, static_cast<std::int64_t>(mesh.triangles.size()), Scalar::UInt32, std::endian::little);
    const auto append = [&](const Eigen::Vector3d& p) {
        for (double value : p) appendReal(out, value, Scalar::Float32, std::endian::little);
    };
    for (const auto& triangle : mesh.triangles) {
        append(normalOf(mesh, triangle));
        for (int v : triangle) append(mesh.points.col(v));
        appendInteger(out, 0, Scalar::UInt16, std::endian::little);
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
