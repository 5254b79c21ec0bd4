#include "python/flow_module.h"

#include <pybind11/stl.h>

#include <limits>

#include "python/arrays.h"
#include "python/handles_module.h"
#include "python/module.h"

namespace wend::python {
namespace {

using Numbers = Array<double>;
using Names = std::vector<std::pair<const char*, Keep>>;

const Names kEnergies = {
    {"equia", Keep::Measure}, {"metr", Keep::Length}, {"akvf", Keep::Rigidity}, {"conf", Keep::Angles}};

/// φ is a name, a number, or one per cell.
template <int Dim>
void takePhi(const py::object& phi, FlowMaterial<Dim>& material) {
    if (py::isinstance<py::str>(phi)) {
        material.phi = phiOf(choice("phi", phi.cast<std::string>(), kEnergies), Dim);
    } else if (py::isinstance<py::float_>(phi) || py::isinstance<py::int_>(phi)) {
        material.phi = phi.cast<double>();
    } else {
        const auto all = Numbers::ensure(phi);
        if (!all || all.ndim() != 1) throw InvalidInput("phi: a name, a number, or one number per cell");
        material.cellPhi.assign(all.data(), all.data() + all.size());
    }
}

template <int Dim>
void takeAnisotropy(const Numbers& array, FlowMaterial<Dim>& material) {
    if (array.ndim() != 3 || array.shape(1) != Dim || array.shape(2) != Dim)
        refuseShape("anisotropy", "(m, " + std::to_string(Dim) + ", " + std::to_string(Dim) + ")", array);
    material.anisotropy.resize(static_cast<std::size_t>(array.shape(0)));
    if (array.size() > 0)
        std::copy(array.data(), array.data() + array.size(), material.anisotropy.front().data());
}

double memoryFrom(const py::object& memory) {
    if (!py::isinstance<py::str>(memory)) return memory.cast<double>();
    return choice<double>("memory", memory.cast<std::string>(),
                          {{"elastic", std::numeric_limits<double>::infinity()}});
}

/// The arguments of Python's Flow() beside the mesh.
struct Given {
    py::object phi;
    std::optional<Numbers> anisotropy;
    std::string jumps;
    double smoothing, lambda, memory;
    FlowOptions options;
};

template <int Dim>
AnyFlow flowOf(const Numbers& points, const Array<int>& cells, const Given& given) {
    FlowMaterial<Dim> material;
    takePhi(given.phi, material);
    if (given.anisotropy) takeAnisotropy(*given.anisotropy, material);
    material.jumps = choice<JumpPrice>(
        "jumps", given.jumps,
        {{"length", JumpPrice::Length}, {"paper", JumpPrice::Paper}, {"none", JumpPrice::None}});
    material.smoothing = given.smoothing;
    material.lambda = given.lambda;
    material.memory = given.memory;
    const auto x = rowsOf<Dim, double>(points, "points");
    const auto c = rowsOf<Dim + 1, int>(cells, "cells");
    const py::gil_scoped_release released;
    return AnyFlow(Flow<Dim>(x, c, material, given.options));
}

AnyFlow makeFlow(const Numbers& points, const Array<int>& cells, const py::object& phi,
                 const std::optional<Numbers>& anisotropy, const std::string& jumps, double smoothing,
                 double lambda, const py::object& memory, const std::string& method, double tolerance,
                 int steps, double end, int threads) {
    Given given{phi, anisotropy, jumps, smoothing, lambda, memoryFrom(memory), {}};
    given.options.method = choice<Stepping>("method", method,
                                            {{"adams", Stepping::Adams},
                                             {"dopri5", Stepping::DormandPrince},
                                             {"rk4", Stepping::RungeKutta4},
                                             {"midpoint", Stepping::Midpoint}});
    given.options.tolerance = tolerance;
    given.options.steps = steps;
    given.options.end = end;
    given.options.threads = threads;
    return dimensionIn(points, "points") == 2 ? flowOf<2>(points, cells, given)
                                              : flowOf<3>(points, cells, given);
}

int hold(const AnyFlow& flow, const py::object& place) {
    return flow.with([&]<int Dim>(Flow<Dim>& one) { return one.hold(placeFrom<Dim>(place)); });
}
int move(const AnyFlow& flow, const py::object& place, const py::object& movement) {
    return flow.with([&]<int Dim>(Flow<Dim>& one) {
        return one.move(placeFrom<Dim>(place), movementFrom<Dim>(movement));
    });
}
void setMovement(const AnyFlow& flow, int handle, const py::object& movement) {
    flow.with([&]<int Dim>(Flow<Dim>& one) { one.setMovement(handle, movementFrom<Dim>(movement)); });
}

RunResult run(AnyFlow& flow, std::optional<double> until, const std::function<void(double)>& progress) {
    RunResult result;
    const auto go = [&]<int Dim>(Flow<Dim>& one, const std::stop_token& stop, const Report& report) {
        RunControl control{.stop = stop};
        if (progress) control.progress = report;
        result = until ? one.run(*until, control) : one.run(control);
    };
    flow.runWith(progress,
                 [&](Flow<2>* plane, Flow<3>* space, const std::stop_token& stop, const Report& report) {
                     if (plane)
                         go(*plane, stop, report);
                     else
                         go(*space, stop, report);
                 });
    return result;
}

py::object velocity(AnyFlow& flow) {
    py::object array;
    std::vector<Coordinates<2>> inPlane;
    std::vector<Coordinates<3>> inSpace;
    flow.runWith({}, [&](Flow<2>* plane, Flow<3>* space, const std::stop_token&, const Report&) {
        if (plane)
            inPlane = plane->velocity();
        else
            inSpace = space->velocity();
    });
    if (flow.dimension() == 2) return arrayOf(std::move(inPlane));
    return arrayOf(std::move(inSpace));
}

const char* nameOf(Ending ending) {
    switch (ending) {
        case Ending::Cancelled:
            return "cancelled";
        case Ending::CellInverted:
            return "cell inverted";
        case Ending::SolverFailed:
            return "solver failed";
        case Ending::StepTooSmall:
            return "step too small";
        case Ending::Done:
            break;
    }
    return "done";
}

py::dict statisticsOf(const AnyFlow& flow) {
    const FlowStatistics s = flow.with([](auto& one) { return one.statistics(); });
    py::dict all;
    for (const auto& [name, count] : {std::pair{"steps", s.steps},
                                      {"rejected", s.rejected},
                                      {"evaluations", s.evaluations},
                                      {"factorizations", s.factorizations},
                                      {"solver_iterations", s.solverIterations}})
        all[name] = count;
    for (const auto& [name, value] : {std::pair{"analyze", s.analyze},
                                      {"assemble", s.assemble},
                                      {"factor", s.factor},
                                      {"solve", s.solve},
                                      {"constraint_error", s.constraintError}})
        all[name] = value;
    all["snaps"] = s.snaps;
    return all;
}

void addResults(py::module_& module) {
    py::class_<RunResult>(module, "RunResult", "How a run ended; true if it is done.")
        .def_property_readonly(
            "ending", [](const RunResult& result) { return nameOf(result.ending); },
            "done, cancelled, cell inverted, solver failed or step too small.")
        .def_readonly("time", &RunResult::time, "Time of the shape that the flow is at.")
        .def_readonly("cell", &RunResult::cell, "The cell that would turn over; -1: none.")
        .def_readonly("message", &RunResult::message, "What happened, when and where; empty when done.")
        .def("__bool__", &RunResult::done)
        .def("__repr__", [](const RunResult& result) {
            return "<wend.RunResult: " + (result.done() ? "done" : result.message) + ">";
        });
    py::class_<FlowDistortion>(module, "Distortion",
                               "Distances of a shape from rest: 0 is best. Arrays have a number per cell.")
        .def_property_readonly("angle", [](const FlowDistortion& d) { return arrayOf(d.angle); })
        .def_property_readonly("volume", [](const FlowDistortion& d) { return arrayOf(d.volume); })
        .def_property_readonly("metric", [](const FlowDistortion& d) { return arrayOf(d.metric); })
        .def_property_readonly(
            "ratio", [](const FlowDistortion& d) { return arrayOf(d.ratio); },
            "det F: the change of area or volume.")
        .def_readonly("total_angle", &FlowDistortion::totalAngle)
        .def_readonly("total_volume", &FlowDistortion::totalVolume)
        .def_readonly("total_metric", &FlowDistortion::totalMetric)
        .def_readonly("inverted", &FlowDistortion::inverted, "Number of cells with det F ≤ 0.");
}

}  // namespace

void AnyFlow::refuse() {
    throw InvalidInput("the flow is running: it is for one thread at a time");
}

void AnyFlow::runWith(
    const std::function<void(double)>& progress,
    const std::function<void(Flow<2>*, Flow<3>*, const std::stop_token&, const Report&)>& work) {
    if (*m_isRunning) refuse();
    struct Running {
        explicit Running(bool& is) : running(is) { running = true; }
        ~Running() { running = false; }
        bool& running;
    } const running(*m_isRunning);
    const auto* plane = std::get_if<0>(&m_flow);
    const auto* space = std::get_if<1>(&m_flow);
    runInterruptibly(progress, [&](const std::stop_token& stop, const Report& report) {
        work(plane ? plane->get() : nullptr, space ? space->get() : nullptr, stop, report);
    });
}

void addFlow(py::module_& module) {
    using namespace py::literals;
    addResults(module);
    module.def(
        "phi_of",
        [](const std::string& name, int dimension) {
            return phiOf(choice("name", name, kEnergies), dimension);
        },
        "name"_a, "dimension"_a,
        "Returns the number of a named energy, in radians: equia keeps area or volume, metr lengths, akvf "
        "is rigid, conf keeps angles.");
    py::class_<AnyFlow>(module, "Flow",
                        "A mesh that handles bend. Analysis and factors are kept from one run to the next.")
        .def(py::init(&makeFlow), "points"_a, "cells"_a, py::kw_only(), "phi"_a = "metr",
             "anisotropy"_a = py::none(), "jumps"_a = "length", "smoothing"_a = 1.0 / 75, "lambda_"_a = 0.1,
             "memory"_a = 0.0, "method"_a = "adams", "tolerance"_a = 1e-4, "steps"_a = 0, "end"_a = 1.0,
             "threads"_a = 0,
             "points: (n, 2) or (n, 3); cells: (m, 3) triangles or (m, 4) tetrahedra, counted from 0.\n"
             "phi: equia, metr, akvf, conf, a number in radians, or one per cell; anisotropy: (m, d, d).\n"
             "memory: 0 or more, or \"elastic\": the shape depends on where the handles are and not on their "
             "way.\n"
             "Raises InvalidInput for a mesh that is no partition and values out of range.")
        .def("hold", &hold, "place"_a, "Adds a handle that holds still, and returns its number.")
        .def("move", &move, "place"_a, "movement"_a,
             "Adds a handle that moves, by one piece or a list of them, and returns its number.")
        .def("set_movement", &setMovement, "handle"_a, "movement"_a,
             "Gives a handle another movement from the time of the shape on; None holds still.")
        .def(
            "clear", [](const AnyFlow& flow) { flow.with([](auto& one) { one.clear(); }); },
            "Removes all handles.")
        .def_property_readonly(
            "handle_count",
            [](const AnyFlow& flow) { return flow.with([](auto& one) { return one.handleCount(); }); })
        .def(
            "reset", [](const AnyFlow& flow) { flow.with([](auto& one) { one.reset(); }); },
            "Brings the shape back to rest, and time to 0. Handles stay.")
        .def("run", &run, "until"_a = py::none(), "progress"_a = py::none(),
             "Integrates to a time, or to the end of the last movement. progress(time) is called now and "
             "then, "
             "and may raise. Ctrl-C ends the run at a good shape. Other threads of Python run meanwhile.")
        .def("velocity", &velocity, "The velocity of every vertex at the time of the shape, (n, d).")
        .def(
            "distortion",
            [](const AnyFlow& flow) { return flow.with([](auto& one) { return one.distortion(); }); },
            "How far the shape is from rest.")
        .def(
            "min_det", [](const AnyFlow& flow) { return flow.with([](auto& one) { return one.minDet(); }); },
            "The least det F of all cells, their change of area or volume.")
        .def(
            "worst", [](const AnyFlow& flow) { return flow.with([](auto& one) { return one.worst(); }); },
            "The cell of the largest metric error.")
        .def(
            "rest_energy",
            [](const AnyFlow& flow) { return flow.with([](auto& one) { return one.restEnergy(); }); },
            "The energy of the map from rest.")
        .def("statistics", &statisticsOf, "Counts of all runs, and the seconds that they took, as a dict.")
        .def_property_readonly(
            "time", [](const AnyFlow& flow) { return flow.with([](auto& one) { return one.time(); }); })
        .def_property_readonly(
            "points",
            [](const AnyFlow& flow) {
                return flow.with([](auto& one) -> py::object { return arrayOf(one.points()); });
            },
            "The shape, a new array (n, d).")
        .def_property_readonly(
            "rest_points",
            [](const AnyFlow& flow) {
                return flow.with([](auto& one) -> py::object { return arrayOf(one.restPoints()); });
            },
            "The shape at rest, a new array (n, d).")
        .def_property_readonly("cells", [](const AnyFlow& flow) {
            return flow.with([](auto& one) -> py::object { return arrayOf(one.cells()); });
        });
}

}  // namespace wend::python
