#pragma once

#include "core/mesh/hdf5/hdf5_tree.h"

namespace wend {

/// Returns the content of a file's bytes, by the HDF5 library, in this process. Throws runtime_error.
Hdf5Node treeOfFile(std::string& bytes);

/// Returns the bytes of a file with that content, likewise.
std::string fileOfTree(const Hdf5Node& root, bool compressed);

}  // namespace wend
