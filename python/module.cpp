#include "python/module.h"

#include "kernels/opencl_devices.h"

namespace wend::python {

PYBIND11_MODULE(wend, module) {
    prepareOpenClEnvironment();
    module.doc() = "Warps pictures and bends solids by letting them flow.";
    module.attr("__version__") = WEND_VERSION;
    const auto& invalid = py::register_exception<InvalidInput>(module, "InvalidInput", PyExc_ValueError);
    invalid.attr("__doc__") = "Input that makes no sense, or a file that cannot be read or written.";
    const auto& memory =
        py::register_exception<InsufficientMemory>(module, "InsufficientMemory", PyExc_MemoryError);
    memory.attr("__doc__") = "The machine has not the memory.";
    const auto& interrupted = py::register_exception<Interrupted>(module, "Interrupted", PyExc_RuntimeError);
    interrupted.attr("__doc__") = "Work was stopped.";
    const py::object incomplete = py::reinterpret_steal<py::object>(PyErr_NewExceptionWithDoc(
        "wend.Incomplete", "A deformation could not be completed.", PyExc_RuntimeError, nullptr));
    module.attr("Incomplete") = incomplete;
    addHandles(module);
    addMeshes(module);
    addPictures(module);
    addFlow(module);
    addProjects(module);
}

}  // namespace wend::python
