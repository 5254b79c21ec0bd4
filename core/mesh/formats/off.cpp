// The Object File Format has "OFF", the numbers of vertices, faces and edges, then the vertices and the
// faces. Colours, normals and texture coordinates (COFF, NOFF, STOFF) are skipped, and so is what geomview
// may write first: "appearance { … }". The word OFF may be missing. Faces beyond the stated number are read.

#include <cctype>

#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/text_writer.h"

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

/// Returns whether vertices have more than their position on the same line.
bool readHeader(Scanner& scanner) {
    passAppearance(scanner);
    if (beginsWithNumber(scanner)) return false;
    auto word = scanner.word("the word OFF");
    const auto whole = word;
    for (const std::string_view prefix : {"ST", "C", "N"})
        if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
    if (word == "4OFF" || word == "nOFF")
        scanner.fail(inQuotes(whole) +
                     (word == "4OFF" ? ": its points have four coordinates"
                                     : ": its points have any number of coordinates") +
                     "; only points in space, which have three, are read");
    if (word != "OFF") scanner.fail("begins with " + inQuotes(whole) + " instead of OFF: no OFF file");
    if (scanner.nextIs("BINARY")) scanner.fail("a binary OFF file is not read");
    return whole != "OFF";
}

int readVertexNumber(Scanner& scanner, int vertexCount) {
    const auto index = scanner.integer("a vertex number");
    if (index < 0 || index >= vertexCount)
        scanner.fail("vertex " + std::to_string(index) + " is named, but there are only " +
                     std::to_string(vertexCount) + " (counted from 0)");
    return static_cast<int>(index);
}

}  // namespace

/// Reads the counts, the vertices and the faces, whose colours are skipped.
MeshFile readOff(std::span<const MeshSource> files) {
    Scanner scanner(files[0].bytes, '#');
    const bool decorated = readHeader(scanner);
    const int vertexCount = scanner.count("vertices", 6);
    const int faceCount = scanner.count("faces", 2);
    if (!scanner.atLineEnd()) scanner.integer("the number of edges");

    MeshFile file;
    file.points.resize(3, vertexCount);
    for (auto p : file.points.colwise()) {
        for (double& coordinate : p) coordinate = scanner.finite("a coordinate");
        if (decorated) scanner.line();
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
        scanner.line();  // a colour may follow
    }
    finishCells(file, [&](int cell) { return scanner.placeOf(offsets[static_cast<std::size_t>(cell)]); });
    return file;
}

std::vector<std::string> printOff(const MeshFile& mesh, const MeshWriteOptions&) {
    TextWriter out;
    out << "OFF\n" << mesh.points.cols() << ' ' << mesh.cells.size() << " 0\n";
    for (const auto& p : mesh.points.colwise()) out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (int c = 0; c < mesh.cells.size(); ++c) {
        out << mesh.cells[c].size();
        for (const int v : mesh.cells[c]) out << ' ' << v;
        out << '\n';
    }
    return {std::move(out.text())};
}

}  // namespace wend::formats
