#pragma once

#include <string>

#include "core/base/message.h"
#include "core/meshing/cage.h"

namespace wend {

/// A request to wend-cage. Messages between the program and wend-cage have no version, because both are built
/// together (see array_bytes.h). Request: points, triangles, {vertices}, {maxVolume, detail, offset}. Reply:
/// error, points and cells of the mesh, {aimMet, bodies, parts, apart}, {edge, openEdge, openDetail}, gaps.
struct CageRequest {
    Surface surface;  // without labels
    CageOptions options;
};
/// The answer to a request.
struct CageReply {
    Message error;  // why there is no cage, or empty
    Cage cage;
};

/// Return the bytes of a message: its arrays in the order above, each as its number of elements (8 bytes) and
/// these in native byte order. The stop token and labels are not sent.
std::string pack(const CageRequest& request);
std::string pack(const CageReply& reply);
/// Read a message. Return false if the bytes are too few or too many, and then leave the result undefined.
/// Numbers in it, such as vertex indices, are not checked. The second throws InputError for an error that is
/// no message.
bool unpack(const std::string& bytes, CageRequest& request);
bool unpack(const std::string& bytes, CageReply& reply);

}  // namespace wend
