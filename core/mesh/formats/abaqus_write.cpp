#include <algorithm>
#include <array>
#include <charconv>

#include "core/mesh/formats/abaqus.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/text_writer.h"

namespace wend::formats {
namespace {

struct Plain {
    CellKind kind;
    const char* type;
};
constexpr Plain kPlain[] = {
    {CellKind::Line, "T3D2"},         {CellKind::Line3, "T3D3"},          {CellKind::Triangle, "S3"},
    {CellKind::Quad, "S4"},           {CellKind::Triangle6, "STRI65"},    {CellKind::Quad8, "S8R"},
    {CellKind::Tetrahedron, "C3D4"},  {CellKind::Pyramid, "C3D5"},        {CellKind::Wedge, "C3D6"},
    {CellKind::Hexahedron, "C3D8"},   {CellKind::Tetrahedron10, "C3D10"}, {CellKind::Wedge15, "C3D15"},
    {CellKind::Hexahedron20, "C3D20"}};

/// Families of element types, which a number of nodes follows.
constexpr std::string_view kSolids[] = {"C3D", "DC3D", "AC3D", "SC", "CSS"};
constexpr std::string_view kPlanes[] = {"CPEG", "CPE",   "CPS",  "CAX", "CGAX", "DC2D", "DCAX", "AC2D",
                                        "ACAX", "SFM3D", "STRI", "M3D", "R3D",  "DS",   "S"};
constexpr std::string_view kLines[] = {"T3D", "T2D", "R2D", "DC1D", "RAX"};

/// Returns the number right behind the family's name; 0 if the type is of another family.
int nodesIn(std::string_view type, std::string_view family) {
    if (type.size() <= family.size() || !sameWord(type.substr(0, family.size()), family)) return 0;
    int nodes = 0;
    const auto rest = type.substr(family.size());
    std::from_chars(rest.data(), rest.data() + rest.size(), nodes);
    return nodes == 65 ? 6 : nodes;
}

std::optional<CellKind> kindWith(int dimension, int nodes) {
    for (const auto& [kind, type] : kPlain)
        if (factsOf(kind).dimension == dimension && factsOf(kind).nodes == nodes) return kind;
    return dimension == 2 && nodes == 9 ? std::optional(CellKind::Quad9) : std::nullopt;
}

template <std::size_t N>
std::optional<CellKind> inFamilies(std::string_view type, const std::string_view (&families)[N],
                                   int dimension) {
    for (const auto family : families)
        if (const int nodes = nodesIn(type, family); nodes > 0)
            if (const auto kind = kindWith(dimension, nodes)) return kind;
    return std::nullopt;
}

/// Returns a deck in whose lines of nodes the coordinates are replaced by others, in their order.
std::string deckWithPoints(const std::string& deck, const Eigen::Matrix3Xd& points) {
    TextWriter out;
    bool nodes = false, goesOn = false;
    Eigen::Index v = 0;
    for (std::size_t at = 0; at < deck.size();) {
        const auto end = std::min(deck.find('\n', at), deck.size());
        const std::string_view line(deck.data() + at, end - at);
        at = end + 1;
        const auto first = line.find_first_not_of(" \t\r");
        const bool keyword = first != std::string_view::npos && line[first] == '*';
        const bool comment = keyword && line.substr(first).starts_with("**");
        const bool isNode =
            nodes && !keyword && !goesOn && first != std::string_view::npos && v < points.cols();
        if (isNode) {
            out << line.substr(0, line.find(','));
            for (int k = 0; k < 3; ++k) out << ", " << abaqusNumber(points(k, v));
            if (line.ends_with('\r')) out << '\r';
            ++v;
        } else {
            out << line;
        }
        if (end < deck.size()) out << '\n';
        if (comment || (!keyword && !goesOn)) continue;
        if (keyword) {
            const auto name = line.substr(first, line.find_first_of(", \t\r", first) - first);
            nodes = sameWord(name, "*NODE");
        }
        const auto last = line.find_last_not_of(" \t\r");
        goesOn = last != std::string_view::npos && line[last] == ',';
    }
    return std::move(out.text());
}

/// Returns the name of a set, in quotes if it would end too early otherwise.
std::string setName(const MeshGroup& group) {
    std::string name = group.name.empty()
                           ? "SET-" + std::to_string(group.dimension) + "-" + std::to_string(group.tag)
                           : group.name;
    for (char& c : name)
        if (c == ',' || c == '"' || c == '=' || static_cast<unsigned char>(c) < ' ') c = '_';
    return name.find(' ') == std::string::npos ? name : '"' + name + '"';
}

void printNumbers(TextWriter& out, const std::vector<int>& numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
        out << numbers[i] + 1 << (i % 16 == 15 || i + 1 == numbers.size() ? "\n" : ", ");
}

/// Prints the elements in blocks of one type, with lines of limited length.
void printElementBlocks(TextWriter& out, const CellList& cells) {
    for (int c = 0; c < cells.size(); ++c) {
        const CellKind kind = cells.kinds[static_cast<std::size_t>(c)];
        if (c == 0 || cells.kinds[static_cast<std::size_t>(c) - 1] != kind)
            out << "*ELEMENT, TYPE=" << abaqusType(kind) << '\n';
        out << c + 1;
        int onLine = 1;
        for (const int v : cells[c]) {
            out << (onLine % 16 == 0 ? ",\n" : ", ") << v + 1;
            ++onLine;
        }
        out << '\n';
    }
}

}  // namespace

std::optional<CellKind> abaqusKind(std::string_view type) {
    if (const auto kind = inFamilies(type, kSolids, 3)) return kind;
    if (const auto kind = inFamilies(type, kPlanes, 2)) return kind;
    if (const auto kind = inFamilies(type, kLines, 1)) return kind;
    for (const char* beam : {"B31", "B21", "B33", "B23", "F3D3", "ELBOW31"})
        if (type.size() >= 3 && sameWord(type.substr(0, std::string_view(beam).size()), beam))
            return CellKind::Line;
    return std::nullopt;
}

const char* abaqusType(CellKind kind) {
    for (const auto& [known, type] : kPlain)
        if (known == kind) return type;
    return nullptr;
}

/// Shortens the number digit by digit until it fits.
std::string abaqusNumber(double value) {
    std::array<char, 40> text;
    auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    for (int digits = 15; end - text.data() > 20 && digits > 0; --digits)
        end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific,
                            digits)
                  .ptr;
    std::string number(text.data(), end);
    if (number.find_first_of(".e") == std::string::npos) number += '.';
    return number;
}

/// Prints nodes, elements by type, and sets. A mesh from an .inp file is that file with other points.
std::vector<std::string> printAbaqus(const MeshFile& mesh, const MeshWriteOptions&) {
    if (mesh.deck && mesh.deckFormat == ".inp") return {deckWithPoints(*mesh.deck, mesh.points)};
    TextWriter out;
    out << "*HEADING\nWend\n*NODE\n";
    for (Eigen::Index v = 0; v < mesh.points.cols(); ++v) {
        out << v + 1;
        for (int k = 0; k < 3; ++k) out << ", " << abaqusNumber(mesh.points(k, v));
        out << '\n';
    }
    printElementBlocks(out, mesh.cells);
    for (const MeshGroup& group : mesh.groups) {
        if (!group.cells.empty()) out << "*ELSET, ELSET=" << setName(group) << '\n';
        printNumbers(out, group.cells);
        if (!group.vertices.empty()) out << "*NSET, NSET=" << setName(group) << '\n';
        printNumbers(out, group.vertices);
    }
    return {std::move(out.text())};
}

}  // namespace wend::formats
