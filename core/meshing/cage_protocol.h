#pragma once

#include <string>

#include "core/meshing/cage.h"

namespace wend {

/// Messages between the program and wend-cage, without a version because both are built together (see
/// array_bytes.h). Request: points, triangles, {vertices}, {maxVolume, detail, offset}. Reply: error, points
/// and cells of the mesh, {aimMet, bodies, parts, apart}, {edge, openEdge, openDetail}, gaps.
struct CageRequest {
    Surface surface;  // without labels
    CageOptions options;
};
struct CageReply {
    std::string error;  // why there is no cage, or empty
    Cage cage;
};

std::string pack(const CageRequest& request);
std::string pack(const CageReply& reply);
/// Returns false if the bytes are too few or too many.
bool unpack(const std::string& bytes, CageRequest& request);
bool unpack(const std::string& bytes, CageReply& reply);

}  // namespace wend
