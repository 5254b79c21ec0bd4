#pragma once

namespace wend {

struct ShapeInputs;

/// Returns whether the same mesh serves for both inputs, so that only the motion is to be computed.
bool sameMesh(const ShapeInputs& a, const ShapeInputs& b);

}  // namespace wend
