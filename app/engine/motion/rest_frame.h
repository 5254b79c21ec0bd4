#pragma once

#include "app/engine/motion/frame.h"

namespace wend {

/// The same shape before it was bent.
template <int Dim>
PosedPtr<Dim> atRest(const PosedPtr<Dim>& frame) {
    auto rest = std::make_shared<PosedFrame<Dim>>(*frame);
    rest->pose = frame->rest->points;
    return rest;
}

}  // namespace wend
