#pragma once

#include <string>

#include "warp/image.h"
#include "warp/picture_library.h"
#include "warp/vector_drawing.h"

namespace wend {

/// The limits of reading a picture.
struct PictureLimits {
    double megapixels = kMaxMegapixels;
    double idleSeconds = 60;  // without an answer and without computing
    DrawnSize drawn{};        // of SVG
};

/// Reads a picture by wend-picture, a process of its own, which may fail in any way, and is kept for the next
/// picture if it does not. The pixels come in strips through shared memory. Throws InputError with the reason
/// if the file or its reader fails, OutOfMemory, and Cancelled after stopReading(). Thread-safe. With the
/// name of a layer, reads that one of a file with layers.
StoredPicture readPicture(const std::string& path, const PictureLimits& limits,
                          const std::string& layer = {});

/// Does the same without the pixels.
StoredPicture readPictureHeader(const std::string& path, const DrawnSize& drawn = {});

/// Returns the paths of an SVG drawing, or of one of its layers, by the same process. Throws the same.
VectorDrawing readVectors(const std::string& path, const std::string& layer, const DrawnSize& drawn);

}  // namespace wend
