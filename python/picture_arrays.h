#pragma once

#include <pybind11/numpy.h>

#include "wend/warp.h"

namespace wend::python {

namespace py = pybind11;

/// Returns a picture of an array (height, width) or (height, width, channels) of uint8, uint16, float16 or
/// float32. Throws InvalidInput.
Picture pictureFrom(const py::array& image, bool premultiplied);
/// Does the reverse; one channel has no axis of its own.
py::array arrayOf(Picture picture);

}  // namespace wend::python
