#pragma once

/// @file
/// Pictures: read, meshed, carried by the map of a mesh, and written.

#include <cstddef>
#include <memory>

#include "wend/mesh.h"

namespace wend {

/// The numbers of a picture.
enum class Depth { UInt8, UInt16, Half, Float };

/// A picture in memory: rows from top to bottom, channels interleaved; gray, gray and alpha, RGB, or RGBA.
/// Coordinates are pixels, x to the right and y down; the centre of the first pixel is (0.5, 0.5).
struct Picture {
    int width = 0;               ///< In pixels.
    int height = 0;              ///< In pixels.
    int channels = 0;            ///< 1 to 4.
    Depth depth = Depth::UInt8;  ///< Of the numbers.
    bool premultiplied = false;  ///< Whether colours are multiplied with alpha, the channel of 2 or 4.
    std::vector<std::byte> pixels = {};         ///< width · height · channels numbers of the depth
    std::shared_ptr<const void> metadata = {};  ///< Metadata of its file, for savePicture().

    /// Returns whether the last channel is alpha.
    bool hasAlpha() const { return channels == 2 || channels == 4; }
};

/// Reads PNG, TIFF, EXR, JPEG, WebP and others, upright, in a process of its own.
/// @throws InvalidInput with the name of the file.
WEND_API Picture loadPicture(const std::string& path);
/// Writes a picture, whole or not at all; the extension decides the format.
/// @throws InvalidInput for an unknown extension, and if the file cannot be written.
WEND_API void savePicture(const std::string& path, const Picture& picture);

/// How pixels are looked up between those of the source.
enum class Lookup { Nearest, Bilinear, Bicubic, Ewa };
/// Selects what is shown where the shape is not: nothing, the nearest colour of the shape, or the source.
enum class Beyond { Transparent, Clamp, Source };

/// How warpPicture() paints.
struct PictureWarp {
    Lookup lookup = Lookup::Ewa;          ///< Between the pixels of the source.
    Beyond beyond = Beyond::Transparent;  ///< Where the shape is not.
    bool antialias = true;                ///< Coverage of pixels along the outline counts.
    Coordinates<2> origin = {0, 0};       ///< The corner of the first pixel that is painted.
    int width = 0;                        ///< Of the part of the plane that is painted; 0: as the source.
    int height = 0;                       ///< See `width`.
    int threads = 0;                      ///< 0: all cores.
    std::stop_token stop = {};            ///< Ends the call.
};

/// The picture carried by the piecewise linear map rest ↦ pose: every pixel of the result looks up the source
/// through the inverse of the affine map of the triangle that covers it.
/// @param source the picture
/// @param rest the mesh in pixels of the source
/// @param pose its vertices after the deformation, as many as rest.points
/// @param options how it is painted
/// @returns a picture with the depth and channels of the source, and alpha if some pixel is not covered
/// @throws InvalidInput for a picture or mesh that makes no sense; Interrupted.
WEND_API Picture warpPicture(const Picture& source, const Mesh<2>& rest, std::span<const Coordinates<2>> pose,
                             const PictureWarp& options = {});

/// How meshPicture() finds the outline of a picture's opaque parts.
struct PictureMeshing {
    bool fromAlpha = false;    ///< The opaque parts; otherwise the whole frame.
    double threshold = 0.1;    ///< Of alpha, in ]0, 1[.
    double margin = 2;         ///< Pixels that the outline is grown by, 0 to 100.
    PolygonMeshing mesh = {};  ///< How the outline is meshed.
};

/// Returns a mesh of a picture, in pixels.
/// @throws InvalidInput for a picture without opaque parts, and as meshPolygons().
WEND_API Mesh<2> meshPicture(const Picture& picture, const PictureMeshing& options = {});

}  // namespace wend
