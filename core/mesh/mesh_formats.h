#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wend {

/// Properties of a mesh format for dialogs, help and messages, which use this one table in its order.
struct MeshFormatFacts {
    std::string_view name;
    std::vector<std::string_view> extensions;  // lower case, with the dot
    int together;                              // of how many files, of each extension one, a mesh is made
    bool holdsTetrahedra;                      // the others get the surface of a solid
    bool withBoundary;                         // the generated boundary of a volume is written by default
    bool holdsFields;                          // values of vertices and cells
    bool knowsBinary;                          // and not text alone
    bool writesPointsAlone = false;            // of a mesh that was read from it; the rest of its files stays
};
/// Returns the properties of all formats.
std::vector<MeshFormatFacts> meshFormatFacts();

/// Lists the extensions of files for tetrahedra, or for surfaces, as "obj, ply".
std::string meshExtensionList(bool tetrahedra);

}  // namespace wend
