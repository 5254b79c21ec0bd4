#pragma once

#include <pybind11/functional.h>
#include <pybind11/pybind11.h>

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace wend::python {

namespace py = pybind11;

/// Tells how far the work is; from the thread that does it.
using Report = std::function<void(double)>;
using Work = std::function<void(const std::stop_token&, const Report&)>;

/// Does the work in a thread of its own while the calling one, which has the interpreter, waits: it lets
/// other threads of Python run, calls `progress` (or none) with the newest number, and sees Ctrl-C, which
/// stops the work and is raised. Rethrows what the work throws.
void runInterruptibly(const std::function<void(double)>& progress, const Work& work);

}  // namespace wend::python
