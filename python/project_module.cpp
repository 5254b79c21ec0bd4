#include <pybind11/stl.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "api/boundary.h"
#include "api/flow_impl.h"
#include "app/cli/run_preparation.h"
#include "app/engine/shape/held_border.h"
#include "app/engine/shape/shape_builder.h"
#include "app/project/file/project_reader.h"
#include "app/project/file/project_writer.h"
#include "app/project/file/text_file.h"
#include "app/project/project.h"
#include "core/base/error.h"
#include "core/base/temporary_folder.h"
#include "python/flow_module.h"
#include "python/module.h"

namespace wend::python {
namespace {

/// A project that Python has as a dict, or as the name of a file.
struct Given {
    LoadedProject loaded;
    std::string path;  // of the file; of a dict one that is not there, in its folder
};

std::string textOf(const py::dict& project) {
    return py::module_::import("json").attr("dumps")(project).cast<std::string>();
}

void warn(const std::vector<std::string>& texts) {
    for (const std::string& text : texts)
        if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 1) != 0) throw py::error_already_set();
}

/// Reads a project. Unknown keys become warnings of Python.
Given projectFrom(const py::object& project, const std::string& folder) {
    Given given;
    documented([&] {
        if (py::isinstance<py::dict>(project)) {
            given.path = (std::filesystem::path(folder) / "project.wend").string();
            given.loaded = parseProject(textOf(project), given.path);
        } else {
            given.path = py::str(py::module_::import("os").attr("fspath")(project));
            given.loaded = readProject(given.path);
        }
    });
    warn(given.loaded.warnings);
    return given;
}

/// Throws what a wrong line throws as InvalidInput, too.
template <typename F>
void checked(F&& f) try {
    documented(f);
} catch (const UsageError& error) {
    throw InvalidInput(error.what());
} catch (const NoticeError& error) {
    throw InvalidInput(error.what());
}

py::dict dictOf(const std::string& json) {
    return py::module_::import("json").attr("loads")(json);
}

py::dict read(const py::object& path) {
    const Given given = projectFrom(path, {});
    return dictOf(documented([&] { return toJson(*given.loaded.project); }));
}

void write(const py::object& path, const py::dict& project, const std::string& folder) {
    const Given given = projectFrom(project, folder);
    const std::string name = py::str(py::module_::import("os").attr("fspath")(path));
    documented([&] { writeProject(name, *given.loaded.project, folder); });
}

template <int Dim>
Flow<Dim> flowOf(const Project& project, const std::string& folder, const std::stop_token& stop) {
    const Shape<Dim> shape = std::get<Shape<Dim>>(loadShape(project, folder, stop));
    if (!shape.rest) throw Cancelled();
    return FlowMaker<Dim>::make(shape.rest, shape.material, heldHandles<Dim>(project, shape),
                                integrationOf(project), endOf(project));
}

AnyFlow load(const py::object& project, const std::string& folder) {
    const Given given = projectFrom(project, folder);
    const std::string files = std::filesystem::path(given.path).parent_path().string();
    std::optional<AnyFlow> flow;
    runInterruptibly({}, [&](const std::stop_token& stop, const Report&) {
        documented([&] {
            if (given.loaded.project->dimension() == 2)
                flow.emplace(flowOf<2>(*given.loaded.project, files, stop));
            else
                flow.emplace(flowOf<3>(*given.loaded.project, files, stop));
        });
    });
    return std::move(*flow);
}

/// `mesh=["a.obj", "b.obj"], tolerance=1e-6, quiet=True, points=("in.csv", "out.csv")` is `--mesh=a.obj
/// --mesh=b.obj --tolerance=1e-06 --quiet --points=in.csv out.csv`.
std::vector<std::string> wordsOf(const py::kwargs& options) {
    std::vector<std::string> words;
    const auto add = [&](const std::string& flag, const py::handle& value) {
        if (py::isinstance<py::bool_>(value)) {
            if (value.cast<bool>()) words.push_back(flag);
        } else if (py::isinstance<py::tuple>(value)) {
            std::string before = flag + "=";
            for (const py::handle one : value)
                words.push_back(std::exchange(before, "") + std::string(py::str(one)));
        } else {
            words.push_back(flag + "=" + std::string(py::str(value)));
        }
    };
    for (const auto& [key, value] : options) {
        std::string flag = "--" + key.cast<std::string>();
        std::replace(flag.begin(), flag.end(), '_', '-');
        if (!py::isinstance<py::list>(value)) {
            add(flag, value);
            continue;
        }
        for (const py::handle one : value) add(flag, one);
    }
    return words;
}

/// Runs a project as `wend run` does, and returns the report.
py::dict run(const py::object& project, const std::string& folder,
             const std::function<void(double)>& progress, const py::kwargs& options) {
    const Given given = projectFrom(project, folder);
    const std::vector<std::string> words = wordsOf(options);
    std::string report;
    AdvanceResult result;
    runInterruptibly(progress, [&](const std::stop_token& stop, const Report& tell) {
        checked([&] {
            const Arguments arguments("run", words);
            const TemporaryFolder temporary(scratchFolder());
            const std::string file = temporary.path() + "/report.json";
            RunOptions run = runOptionsOf(arguments);
            run.outputs.report.push_back(file);
            run.notices = given.loaded.warnings;
            std::ranges::copy(takeLine(arguments, given.path, run, *given.loaded.project),
                              std::back_inserter(run.notices));
            RunWatch watch;
            watch.stop = stop;
            watch.progress = [&](const std::string& work, double fraction) {
                if (work == "deforming") tell(fraction);
            };
            result = runProject(*given.loaded.project, given.path, run, watch);
            report = readTextFile(file);
        });
    });
    if (result.outcome != Outcome::Done) {
        const py::object incomplete = py::module_::import("wend").attr("Incomplete");
        PyErr_SetString(incomplete.ptr(), result.message.text().c_str());
        throw py::error_already_set();
    }
    return dictOf(report);
}

}  // namespace

void addProjects(py::module_& module) {
    using namespace py::literals;
    module.def("read_project", &read, "path"_a, "Returns a project as a dict, checked.");
    module.def("write_project", &write, "path"_a, "project"_a, py::kw_only(), "folder"_a = ".",
               "Writes a project from a dict, checked; its relative paths are those of `folder`.");
    module.def("load", &load, "project"_a, py::kw_only(), "folder"_a = ".",
               "Returns the Flow of a project, a dict or the name of a file, with its mesh, material and "
               "handles. Relative paths of a dict are those of `folder`.");
    module.def(
        "run", &run, "project"_a, py::kw_only(), "folder"_a = ".", "progress"_a = py::none(),
        "Runs a project, a dict or the name of a file, as `wend run` does, and returns its report. "
        "Every option of `wend run` is a keyword: mesh=\"out.vtu\", image=[\"a.png\", \"b.exr\"], at=0.5, "
        "tolerance=1e-6, settle=True. progress(part) gets the part that is done. Raises Incomplete if "
        "the deformation could not be completed.");
}

}  // namespace wend::python
