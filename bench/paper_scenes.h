#pragma once

#include <string>
#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// A scene of the paper's figures, on shapes of our own: one shape and its handles, under several materials.
/// Handles and materials are written as in a project file, with quotes '.
struct PaperScene {
    std::string name;    // also the files'
    std::string figure;  // of the paper
    std::string shape;   // of flatShape() or solidShape()
    int dimension;
    std::string handles;
    struct Variant {
        std::string name, material;
    };
    std::vector<Variant> variants;
    bool middle = false;  // the errors of the middle third are asked for, too
};
const std::vector<PaperScene>& paperScenes();

/// Returns "strip" (4 : 1), "square" or "star" with about so many vertices.
SimplicialMesh<2> flatShape(const std::string& name, int vertices);
/// Returns "bar" (4 : 1 : 1), "cube" or "thick star" with about so many vertices.
SimplicialMesh<3> solidShape(const std::string& name, int vertices);

/// A claim of the paper: a figure of the rows grows from one result to the next ("scene/variant").
struct PaperClaim {
    std::string what, figure;
    std::vector<std::string> rising;
};
const std::vector<PaperClaim>& paperClaims();

}  // namespace wend
