// The Object File Format has "OFF", the numbers of vertices, faces and edges, then the vertices and the
// faces. Vertices may have normals, colours and texture coordinates (STCNOFF, with any of ST, C and N), and
// faces colours: bytes, or numbers from 0 to 1. What geomview may write first is skipped: "appearance { … }".
// The word OFF may be missing. Faces beyond the stated number are read.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <span>

#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/colours.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/text_writer.h"
#include "core/mesh/turned_normals.h"

namespace wend::formats {
namespace {

/// How a shape is to look, with blocks in blocks.
void passAppearance(Scanner& scanner) {
    if (!scanner.nextIs("appearance")) return;
    int depth = 0;
    do {
        for (const char c : scanner.word("the end of the appearance")) depth += (c == '{') - (c == '}');
    } while (depth > 0 || scanner.nextIs("{"));
}

bool beginsWithNumber(Scanner& scanner) {
    if (scanner.atEnd()) return false;
    const auto rest = scanner.bytes().substr(scanner.offset());
    const auto end = rest.find_first_not_of("0123456789");
    return end != 0 && end != rest.npos && std::isspace(static_cast<unsigned char>(rest[end]));
}

/// Says which of these vertices have beside their position; a line has them in this order.
struct OffHeader {
    bool normals = false, colours = false, texture = false;
};

OffHeader readHeader(Scanner& scanner) {
    OffHeader header;
    passAppearance(scanner);
    if (beginsWithNumber(scanner)) return header;
    auto word = scanner.word("the word OFF");
    const auto whole = word;
    for (const auto& [prefix, has] : {std::pair<std::string_view, bool*>{"ST", &header.texture},
                                      {"C", &header.colours},
                                      {"N", &header.normals}})
        if (word.starts_with(prefix)) {
            word.remove_prefix(prefix.size());
            *has = true;
        }
    if (word == "4OFF" || word == "nOFF")
        scanner.fail(
            {word == "4OFF"
                 ? sentence("Core",
                            "%1: its points have four coordinates; only points in space, which have three, "
                            "are read")
                 : sentence("Core",
                            "%1: its points have any number of coordinates; only points in space, which "
                            "have three, are read"),
             inQuotes(whole)});
    if (word != "OFF") scanner.fail("begins with " + inQuotes(whole) + " instead of OFF: no OFF file");
    if (scanner.nextIs("BINARY")) scanner.fail("a binary OFF file is not read");
    return header;
}

int readVertexNumber(Scanner& scanner, int vertexCount) {
    const auto index = scanner.integer("a vertex number");
    if (index < 0 || index >= vertexCount)
        scanner.fail("vertex " + std::to_string(index) + " is named, but there are only " +
                     std::to_string(vertexCount) + " (counted from 0)");
    return static_cast<int>(index);
}

/// Returns the numbers on the rest of a line.
std::vector<double> numbersOnLine(Scanner& scanner, const char* what) {
    std::vector<double> numbers;
    while (!scanner.atLineEnd()) numbers.push_back(scanner.real(what));
    return numbers;
}

/// Collects colours of vertices or faces, which are all bytes or all numbers from 0 to 1.
class ColourList {
  public:
    /// Takes three or four components; less are no colour, but an entry of a list that is not in the file.
    void take(std::span<const double> parts) {
        ++m_count;
        if (parts.size() < 3) return;
        Colour& colour = m_colours.emplace_back(Colour{0, 0, 0, -1});
        for (std::size_t k = 0; k < std::min<std::size_t>(parts.size(), 4); ++k) {
            colour[k] = parts[k];
            m_inBytes = m_inBytes || parts[k] > 1;
        }
    }
    void addTo(MeshFile& file, bool perCell) {
        if (m_colours.empty()) return;
        if (m_colours.size() != m_count) {
            file.notices.push_back("the colours of " + std::to_string(m_colours.size()) + " of its " +
                                   std::to_string(m_count) + (perCell ? " faces" : " vertices"));
            return;
        }
        for (Colour& colour : m_colours) {
            if (colour[3] < 0) colour[3] = m_inBytes ? 255 : 1;
            if (m_inBytes)
                for (double& part : colour) part /= 255;
        }
        addColours(file, m_colours, perCell);
    }

  private:
    std::vector<Colour> m_colours;
    std::size_t m_count = 0;
    bool m_inBytes = false;
};

/// Takes what a vertex has beside its position.
class VertexLooks {
  public:
    explicit VertexLooks(OffHeader header) : m_header(header) {}
    void take(Scanner& scanner) {
        std::vector<double> numbers = numbersOnLine(scanner, "a number of a vertex");
        std::span<const double> rest(numbers);
        const auto taken = [&rest](std::size_t count) {
            const auto part = rest.first(std::min(count, rest.size()));
            rest = rest.subspan(part.size());
            return part;
        };
        if (m_header.normals)
            if (const auto normal = taken(3); normal.size() == 3)
                m_normals.insert(m_normals.end(), normal.begin(), normal.end());
        if (m_header.colours)
            m_colours.take(taken(rest.size() - std::min<std::size_t>(m_header.texture ? 2 : 0, rest.size())));
        if (m_header.texture)
            if (const auto uv = taken(2); uv.size() == 2) m_uv.insert(m_uv.end(), uv.begin(), uv.end());
    }
    void addTo(MeshFile& file) {
        const auto count = static_cast<std::size_t>(file.points.cols());
        if (m_normals.size() == 3 * count && count > 0)
            for (std::size_t k = 0; k < 3; ++k) {
                MeshField field{kNormalNames[k], false, 1, {}};
                for (std::size_t v = 0; v < count; ++v) field.values.push_back(m_normals[3 * v + k]);
                file.fields.push_back(std::move(field));
            }
        m_colours.addTo(file, false);
        if (m_uv.size() == 2 * count)
            file.uv = Eigen::Map<const Eigen::Matrix2Xd>(m_uv.data(), 2, static_cast<Eigen::Index>(count));
    }

  private:
    OffHeader m_header;
    std::vector<double> m_normals, m_uv;
    ColourList m_colours;
};

/// Prints a colour in bytes if all are whole ones, with its alpha if `whole`.
void printColour(TextWriter& out, const Colour& colour, bool inBytes, bool whole) {
    for (std::size_t k = 0; k < (whole ? 4 : 3); ++k) {
        out << ' ';
        if (inBytes)
            out << std::lround(255 * colour[k]);
        else
            out << colour[k];
    }
}

}  // namespace

/// Reads the counts, the vertices and the faces.
MeshFile readOff(std::span<const MeshSource> files) {
    Scanner scanner(files[0].bytes, '#');
    const OffHeader header = readHeader(scanner);
    const int vertexCount = scanner.count("vertices", 6);
    const int faceCount = scanner.count("faces", 2);
    if (!scanner.atLineEnd()) scanner.integer("the number of edges");

    MeshFile file;
    file.points.resize(3, vertexCount);
    const bool decorated = header.normals || header.colours || header.texture;
    VertexLooks looks(header);
    ColourList faceColours;
    for (auto p : file.points.colwise()) {
        for (double& coordinate : p) coordinate = scanner.finite("a coordinate");
        if (decorated) looks.take(scanner);
    }
    std::vector<int> polygon;
    std::vector<std::size_t> offsets;
    for (int f = 0; f < faceCount || !scanner.atEnd(); ++f) {
        polygon.resize(scanner.count("corners", 2));
        offsets.push_back(scanner.offset());
        for (int& corner : polygon) corner = readVertexNumber(scanner, vertexCount);
        if (polygon.size() >= 3)
            file.cells.addFace(polygon);
        else
            file.cells.add(polygon.size() == 2 ? CellKind::Line : CellKind::PolyVertex, polygon);
        faceColours.take(numbersOnLine(scanner, "a colour"));
    }
    looks.addTo(file);
    faceColours.addTo(file, true);
    finishCells(file, [&](int cell) { return scanner.placeOf(offsets[static_cast<std::size_t>(cell)]); });
    return file;
}

std::vector<std::string> printOff(const MeshFile& mesh, const MeshWriteOptions&) {
    const std::vector<Colour> colours = coloursOf(mesh, false), ofFaces = coloursOf(mesh, true);
    const bool bytes = areBytes(colours), bytesOfFaces = areBytes(ofFaces);
    const bool clear = std::ranges::any_of(ofFaces, [](const Colour& colour) { return colour[3] < 1; });
    const auto normals = normalFieldsOf(mesh);
    const bool hasNormals = normals[0];
    TextWriter out;
    out << (mesh.uv.cols() ? "ST" : "") << (colours.empty() ? "" : "C") << (hasNormals ? "N" : "") << "OFF\n"
        << mesh.points.cols() << ' ' << mesh.cells.size() << " 0\n";
    for (Eigen::Index v = 0; v < mesh.points.cols(); ++v) {
        const auto p = mesh.points.col(v);
        out << p.x() << ' ' << p.y() << ' ' << p.z();
        for (std::size_t k = 0; hasNormals && k < 3; ++k)
            out << ' ' << normals[k]->values[static_cast<std::size_t>(v)];
        if (!colours.empty()) printColour(out, colours[static_cast<std::size_t>(v)], bytes, true);
        if (mesh.uv.cols()) out << ' ' << mesh.uv(0, v) << ' ' << mesh.uv(1, v);
        out << '\n';
    }
    for (int c = 0; c < mesh.cells.size(); ++c) {
        out << mesh.cells[c].size();
        for (const int v : mesh.cells[c]) out << ' ' << v;
        if (!ofFaces.empty()) printColour(out, ofFaces[static_cast<std::size_t>(c)], bytesOfFaces, clear);
        out << '\n';
    }
    return {std::move(out.text())};
}

}  // namespace wend::formats
