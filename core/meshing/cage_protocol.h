#pragma once

#include <string>

#include "core/meshing/cage.h"

namespace wend {

/// What goes through the pipes between the program and wend-cage (see array_bytes.h).
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
/// False if the bytes are too few or too many.
bool unpack(const std::string& bytes, CageRequest& request);
bool unpack(const std::string& bytes, CageReply& reply);

}  // namespace wend
