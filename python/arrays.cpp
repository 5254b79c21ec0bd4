#include "python/arrays.h"

namespace wend::python {

void refuseShape(const std::string& name, const std::string& needed, const py::array& array) {
    const auto shape = py::str(array.attr("shape")).cast<std::string>();
    throw InvalidInput(name + ": an array of shape " + needed + " is needed, not " + shape);
}

int dimensionIn(const py::array& array, const std::string& name) {
    const auto last = array.ndim() > 0 ? array.shape(array.ndim() - 1) : 0;
    if (array.ndim() > 2 || (last != 2 && last != 3)) refuseShape(name, "(n, 2) or (n, 3)", array);
    return static_cast<int>(last);
}

}  // namespace wend::python
