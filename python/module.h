#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <utility>
#include <vector>

#include "wend/error.h"

namespace wend::python {

namespace py = pybind11;

/// Add their part of the module.
void addHandles(py::module_& module);
void addFlow(py::module_& module);
void addMeshes(py::module_& module);
void addPictures(py::module_& module);
void addProjects(py::module_& module);

/// Returns the value of a word. Throws InvalidInput: `ease: "fast" is not one of linear, in, out, in-out`.
template <typename T>
T choice(const std::string& name, const std::string& word,
         const std::vector<std::pair<const char*, T>>& all) {
    std::string known;
    for (const auto& [key, value] : all) {
        if (word == key) return value;
        known += (known.empty() ? "" : ", ") + std::string(key);
    }
    throw InvalidInput(name + ": \"" + word + "\" is not one of " + known);
}

}  // namespace wend::python
