#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "python/arrays.h"
#include "python/interruptible.h"
#include "python/module.h"
#include "python/picture_arrays.h"

namespace wend::python {
namespace {

using Numbers = Array<double>;

template <int Dim>
py::tuple tupleOf(Mesh<Dim> mesh) {
    return py::make_tuple(arrayOf(std::move(mesh.points)), arrayOf(std::move(mesh.cells)));
}

/// Calls make(stop) while the interpreter is free.
template <int Dim, typename Make>
py::tuple meshed(Make make) {
    Mesh<Dim> mesh;
    runInterruptibly({}, [&](const std::stop_token& stop, const Report&) { mesh = make(stop); });
    return tupleOf(std::move(mesh));
}

py::tuple readMesh(const std::filesystem::path& path, std::optional<int> dimension) {
    if (dimension && *dimension != 2 && *dimension != 3) throw InvalidInput("dimension: 2 or 3");
    const bool isPlane = dimension ? *dimension == 2 : meshDimension(path.string()) == 2;
    if (isPlane) return meshed<2>([&](const std::stop_token&) { return loadMesh<2>(path.string()); });
    return meshed<3>([&](const std::stop_token&) { return loadMesh<3>(path.string()); });
}

template <int Dim>
void write(const std::filesystem::path& path, const Numbers& points, const Array<int>& cells) {
    const auto x = rowsOf<Dim, double>(points, "points");
    const auto c = rowsOf<Dim + 1, int>(cells, "cells");
    const Mesh<Dim> mesh{{x.begin(), x.end()}, {c.begin(), c.end()}};
    const py::gil_scoped_release released;
    saveMesh<Dim>(path.string(), mesh);
}

PolygonMeshing meshingOf(int vertices, double edge, double minAngle, const std::optional<Numbers>& points) {
    PolygonMeshing options;
    options.vertices = vertices;
    options.edge = edge;
    options.minAngle = minAngle;
    if (points) {
        const auto rows = rowsOf<2, double>(*points, "points");
        options.points.assign(rows.begin(), rows.end());
    }
    return options;
}

py::tuple meshThePolygons(const std::vector<Numbers>& arrays, int vertices, double edge, double minAngle,
                          const std::optional<Numbers>& points) {
    std::vector<std::vector<Coordinates<2>>> polygons;
    for (const Numbers& array : arrays) {
        const auto rows = rowsOf<2, double>(array, "polygons");
        polygons.emplace_back(rows.begin(), rows.end());
    }
    PolygonMeshing options = meshingOf(vertices, edge, minAngle, points);
    return meshed<2>([&](const std::stop_token& stop) {
        options.stop = stop;
        return meshPolygons(polygons, options);
    });
}

py::tuple meshThePicture(const py::array& image, const std::string& outline, double threshold, double margin,
                         int vertices, double edge, double minAngle, const std::optional<Numbers>& points) {
    const Picture picture = pictureFrom(image, false);
    PictureMeshing options;
    options.fromAlpha = choice<bool>("outline", outline, {{"frame", false}, {"alpha", true}});
    options.threshold = threshold;
    options.margin = margin;
    options.mesh = meshingOf(vertices, edge, minAngle, points);
    return meshed<2>([&](const std::stop_token& stop) {
        options.mesh.stop = stop;
        return meshPicture(picture, options);
    });
}

py::tuple fill(const Numbers& points, const Array<int>& triangles, int vertices, double maxVolume,
               double quality, bool keepSurface) {
    SurfaceFilling options{vertices, maxVolume, quality, keepSurface};
    const auto x = rowsOf<3, double>(points, "points");
    const auto t = rowsOf<3, int>(triangles, "triangles");
    return meshed<3>([&](const std::stop_token& stop) {
        options.stop = stop;
        return fillSurface(x, t, options);
    });
}

}  // namespace

void addMeshes(py::module_& module) {
    using namespace py::literals;
    module.def("read_mesh", &readMesh, "path"_a, "dimension"_a = py::none(),
               "Returns (points, cells) of a mesh file: (n, 2) and (m, 3), or (n, 3) and (m, 4) if it holds "
               "tetrahedra. The order is the file's.");
    module.def(
        "write_mesh",
        [](const std::filesystem::path& path, const Numbers& points, const Array<int>& cells) {
            dimensionIn(points, "points") == 2 ? write<2>(path, points, cells)
                                               : write<3>(path, points, cells);
        },
        "path"_a, "points"_a, "cells"_a,
        "Writes a mesh, whole or not at all; the extension decides the format.");
    module.def("mesh_polygons", &meshThePolygons, "polygons"_a, py::kw_only(), "vertices"_a = 5000,
               "edge"_a = 0.0, "min_angle"_a = 25.0, "points"_a = py::none(),
               "Returns (points, cells) of triangles inside closed polygons, a list of arrays (n, 2); an odd "
               "number of them encloses what is inside.");
    module.def("mesh_picture", &meshThePicture, "image"_a, py::kw_only(), "outline"_a = "frame",
               "threshold"_a = 0.1, "margin"_a = 2.0, "vertices"_a = 5000, "edge"_a = 0.0,
               "min_angle"_a = 25.0, "points"_a = py::none(),
               "Returns (points, cells) of a picture, in pixels: of its frame, or with outline=\"alpha\" of "
               "its opaque parts.");
    module.def("fill_surface", &fill, "points"_a, "triangles"_a, py::kw_only(), "vertices"_a = 0,
               "max_volume"_a = 0.0, "quality"_a = 1.414, "keep_surface"_a = true,
               "Returns (points, cells) of tetrahedra inside a closed surface.");
}

}  // namespace wend::python
