#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <vector>

namespace wend {

/// Whether an ICC profile is one of a picture with so many channels of colour: one for other colours than the
/// pixels' (the CMYK one of a converted JPEG) or a broken one is not the picture's.
bool profileFits(const OIIO::ParamValue& profile, int colours);

/// Whether its header and its table of tags keep the rules of ICC.1, section 7, as far as libpng asks for
/// them: otherwise it prints a line of its own, and does not write the file.
bool profileIsStrict(const OIIO::ParamValue& profile);

/// A profile of colours with the curve of a grey one, and the colorants of BT.709: so equal colours stay the
/// grey that they were. Empty if the grey profile has no curve.
std::vector<std::byte> colouredProfile(const OIIO::ParamValue& grey);

}  // namespace wend
