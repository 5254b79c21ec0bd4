#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace wend {

/// A request to wend-tetgen.
struct TetgenRequest {
    std::string switches;
    std::vector<double> points;   // 3 per vertex
    std::vector<int> triangles;   // 3 per facet
    std::vector<int> labels;      // 1 per facet
    std::vector<double> sizes;    // empty, or: maximum volume, grid's low corner, its spacing, its factors
    std::vector<int> sizeCounts;  // of the grid's nodes along x, y, z
};
/// The answer to a request.
struct TetgenReply {
    std::int32_t error = 0;      // 0, or TetGen's own code
    std::vector<double> points;  // 3 per vertex, the input's first
    std::vector<int> cells;      // 4 per tetrahedron
    std::vector<int> regions;    // 1 per tetrahedron
    std::vector<int> boundary;   // 3 per facet
    std::vector<int> labels;     // 1 per facet
};

/// Return the bytes of all members, one after another (see array_bytes.h).
std::string pack(const TetgenRequest& request);
std::string pack(const TetgenReply& reply);
/// Read a message. Return false if the bytes are too few or too many.
bool unpack(const std::string& bytes, TetgenRequest& request);
bool unpack(const std::string& bytes, TetgenReply& reply);

}  // namespace wend
