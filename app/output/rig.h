#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/engine/shape/shape.h"

namespace wend {

/// A part of a rig: triangles of its own vertices, those in front last. The vertices of its longest outline
/// come first, in their order around it.
struct RigPart {
    std::string name;           // unlike those of the others
    std::vector<int> vertices;  // of the mesh that is drawn
    int hull = 0;               // the number of vertices of the outline
    std::vector<Cell<2>> triangles;
    BlendMode blend = BlendMode::Normal;
};

/// A deforming picture for programs that play 2D animations: parts of one texture, and their vertices over
/// time. Coordinates are pixels, y down.
struct Rig {
    std::shared_ptr<const Image> texture;
    Points2 texturePoints;  // of all vertices, in pixels of the texture
    int width = 0, height = 0;
    std::vector<RigPart> parts;            // the hindmost first, as in the first frame
    std::vector<std::vector<int>> orders;  // per frame: the parts, the hindmost first
    Points2 rest;                          // of all vertices
    std::vector<Points2> poses;            // per frame
    double framesPerSecond = 24;
};

/// Returns the rig of a shape with a picture. `poses` are in domain coordinates. `depth` are those of cells
/// (see WarpOptions), and `levels` those of parts in each frame (see partLevels()).
Rig makeRig(const Shape<2>& shape, const std::vector<Points2>& poses, const std::vector<float>& depth,
            const std::vector<std::vector<int>>& levels, double framesPerSecond);

/// Returns the frames at which the order of the parts changes, after the first.
std::vector<std::size_t> changesOfOrder(const Rig& rig);

/// Returns by how many places each part that is not in its place of the first frame is moved in an order, by
/// part.
std::vector<std::pair<int, int>> offsetsOf(const std::vector<int>& order);

}  // namespace wend
