#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <variant>

#include "wend/handles.h"

namespace wend::python {

namespace py = pybind11;

/// A place in the plane or in space.
struct AnyPlace {
    std::variant<Place<2>, Place<3>> place;
};

/// One piece of a movement; which dimension it has is known where it is used, if its numbers do not say.
struct Piece {
    std::function<void(Movement<2>&)> inPlane;  // empty: of the other dimension
    std::function<void(Movement<3>&)> inSpace;
};

/// Returns a place that is given as one, or as vertices: whole numbers in any form. Throws InvalidInput.
template <int Dim>
Place<Dim> placeFrom(const py::object& object);
/// A piece, or several in a list; None holds still. Throws InvalidInput.
template <int Dim>
Movement<Dim> movementFrom(const py::object& object);

}  // namespace wend::python
