#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "app/project/part.h"
#include "core/base/message.h"
#include "warp/atlas.h"

namespace wend {

/// A part that is cut out of another one's picture.
struct CutPictures {
    Sheet taken;                        // the part, in a picture that is hardly larger than the cut
    std::shared_ptr<const Image> left;  // what remains of the other one
};

/// Cuts a part out of a picture. At rest, both over one another give the picture again. Without
/// PicturePart::fill, pixels that the part does not hide at rest remain below it, and the others become
/// transparent. With it, the area that the part hides is inpainted, and the ground's colours are removed from
/// the part's soft edge (see separated()); `notices` says if that is not possible. Throws InputError and
/// Cancelled.
CutPictures cutOut(const PicturePart& part, const Sheet& from, std::vector<Message>* notices,
                   const std::stop_token& stop);

}  // namespace wend
