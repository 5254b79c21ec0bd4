#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <span>
#include <string>
#include <vector>

#include "wend/handles.h"

namespace wend::python {

namespace py = pybind11;

/// An array of NumPy in the order of C; others are converted once.
template <typename T>
using Array = py::array_t<T, py::array::c_style | py::array::forcecast>;

/// Throws InvalidInput: "points: an array of shape (n, 2) is needed, not (3,)".
[[noreturn]] void refuseShape(const std::string& name, const std::string& needed, const py::array& array);

/// Rows of `Columns` numbers each, as they are in the array.
template <std::size_t Columns, typename T>
std::span<const std::array<T, Columns>> rowsOf(const Array<T>& array, const std::string& name) {
    static_assert(sizeof(std::array<T, Columns>) == Columns * sizeof(T));
    if (array.ndim() != 2 || array.shape(1) != static_cast<py::ssize_t>(Columns))
        refuseShape(name, "(n, " + std::to_string(Columns) + ")", array);
    return {reinterpret_cast<const std::array<T, Columns>*>(array.data()),
            static_cast<std::size_t>(array.shape(0))};
}

/// Does the same for one point.
template <int Dim>
Coordinates<Dim> coordinatesIn(const Array<double>& array, const std::string& name) {
    if (array.ndim() != 1 || array.shape(0) != Dim)
        refuseShape(name, "(" + std::to_string(Dim) + ",)", array);
    Coordinates<Dim> p;
    std::copy(array.data(), array.data() + Dim, p.begin());
    return p;
}

/// Returns 2 or 3, the number of columns or, of one point, of numbers. Throws InvalidInput.
int dimensionIn(const py::array& array, const std::string& name);

/// An array that owns the rows.
template <typename T, std::size_t Columns>
py::array_t<T> arrayOf(std::vector<std::array<T, Columns>> rows) {
    auto* owned = new std::vector<std::array<T, Columns>>(std::move(rows));
    const py::capsule owner(owned,
                            [](void* p) { delete static_cast<std::vector<std::array<T, Columns>>*>(p); });
    const auto count = static_cast<py::ssize_t>(owned->size());
    return py::array_t<T>({count, static_cast<py::ssize_t>(Columns)},
                          reinterpret_cast<const T*>(owned->data()), owner);
}
template <typename T, std::size_t Columns>
py::array_t<T> arrayOf(std::span<const std::array<T, Columns>> rows) {
    return arrayOf(std::vector<std::array<T, Columns>>(rows.begin(), rows.end()));
}
template <typename T>
py::array_t<T> arrayOf(std::vector<T> numbers) {
    auto* owned = new std::vector<T>(std::move(numbers));
    const py::capsule owner(owned, [](void* p) { delete static_cast<std::vector<T>*>(p); });
    return py::array_t<T>(static_cast<py::ssize_t>(owned->size()), owned->data(), owner);
}

}  // namespace wend::python
