#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <vector>

namespace wend {

/// Returns whether an ICC profile matches the number of colour channels: a broken one, or one for other
/// colours (the CMYK profile of a converted JPEG), does not belong to the picture.
bool profileFits(const OIIO::ParamValue& profile, int colours);

/// Returns whether its header and tag table obey ICC.1, section 7, as far as libpng checks: otherwise it
/// prints a message and does not write the file.
bool profileIsStrict(const OIIO::ParamValue& profile);

/// Returns a profile of colours with the curve of a grey one and the colorants of BT.709, so that equal
/// colours stay the same grey. Empty if the grey profile has no curve.
std::vector<std::byte> colouredProfile(const OIIO::ParamValue& grey);

}  // namespace wend
