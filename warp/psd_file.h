#pragma once

#include "core/base/input_file.h"
#include "warp/layered_file.h"

namespace wend {

/// Reads a Photoshop file (PSD, PSB): its layers, without groups, and a PSD file of the picture of all layers
/// alone. This is necessary because OpenImageIO decodes all layers when it opens a file, refuses those that
/// are packed as Photoshop packs 16 bits, and reports neither opacity nor blend mode. Adobe's "Photoshop File
/// Formats Specification" describes the format. Throws InputError(path, reason).
LayeredFile readPsdFile(const InputFile& file);

/// Returns a PNG file of one layer, whose mask is applied. Throws InputError(path, reason), also for colours
/// other than RGB and grey.
std::string readPsdLayer(const InputFile& file, const std::string& name);

}  // namespace wend
