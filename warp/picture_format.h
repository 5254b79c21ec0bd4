#pragma once

#include <string>
#include <vector>

#include "core/base/input_file.h"

namespace wend {

/// The formats that are read: by OpenImageIO's readers, and last archives that hold a PNG, and drawings of
/// which one is made.
enum class PictureFormat {
    Png,
    Jpeg,
    Tiff,
    Exr,
    Webp,
    Hdr,
    Bmp,
    Tga,
    Pnm,
    Jpeg2000,
    Gif,
    Psd,
    Heif,
    Raw,
    Dds,
    Dpx,
    Cineon,
    Sgi,
    Iff,
    Ico,
    Fits,
    Dicom,
    OpenRaster,
    Krita,
    Svg
};

/// Returns the format of a file by its first bytes, never by its name or by trying readers. TGA has no
/// signature; its whole header must be plausible. Throws InputError(path, reason), which names the actual
/// kind of file if it is known.
PictureFormat pictureFormat(const InputFile& file);

/// Returns the usual extensions of these formats in lower case, with the dot.
const std::vector<std::string>& pictureFileExtensions();

}  // namespace wend
