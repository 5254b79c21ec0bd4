#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstring>

#include "python/arrays.h"
#include "python/interruptible.h"
#include "python/module.h"
#include "python/picture_arrays.h"

namespace wend::python {
namespace {

using Numbers = Array<double>;

Depth depthOf(const py::array& image) {
    const auto type = image.dtype();
    const std::string name = std::string(1, type.kind()) + std::to_string(type.itemsize());
    return choice<Depth>(
        "image", name,
        {{"u1", Depth::UInt8}, {"u2", Depth::UInt16}, {"f2", Depth::Half}, {"f4", Depth::Float}});
}

const char* typeOf(Depth depth) {
    switch (depth) {
        case Depth::UInt16:
            return "uint16";
        case Depth::Half:
            return "float16";
        case Depth::Float:
            return "float32";
        case Depth::UInt8:
            break;
    }
    return "uint8";
}

py::array warp(const py::array& image, const Numbers& points, const Array<int>& cells, const Numbers& pose,
               const std::string& filter, const std::string& outside, bool antialias, bool premultiplied,
               const std::optional<std::array<double, 4>>& part, int threads) {
    const auto x = rowsOf<2, double>(points, "points");
    const auto c = rowsOf<3, int>(cells, "cells");
    const auto moved = rowsOf<2, double>(pose, "pose");
    PictureWarp options;
    options.lookup = choice<Lookup>("filter", filter,
                                    {{"nearest", Lookup::Nearest},
                                     {"bilinear", Lookup::Bilinear},
                                     {"bicubic", Lookup::Bicubic},
                                     {"ewa", Lookup::Ewa}});
    options.beyond = choice<Beyond>(
        "outside", outside,
        {{"transparent", Beyond::Transparent}, {"clamp", Beyond::Clamp}, {"original", Beyond::Source}});
    options.antialias = antialias;
    options.threads = threads;
    if (part) {
        options.origin = {(*part)[0], (*part)[1]};
        options.width = static_cast<int>((*part)[2]);
        options.height = static_cast<int>((*part)[3]);
        if (options.width < 1 || options.height < 1) throw InvalidInput("part: its size must be positive");
    }
    const Picture source = pictureFrom(image, premultiplied);
    Picture warped;
    runInterruptibly({}, [&](const std::stop_token& stop, const Report&) {
        options.stop = stop;
        const Mesh<2> rest{{x.begin(), x.end()}, {c.begin(), c.end()}};
        warped = warpPicture(source, rest, moved, options);
    });
    return arrayOf(std::move(warped));
}

}  // namespace

Picture pictureFrom(const py::array& image, bool premultiplied) {
    if (image.ndim() != 2 && image.ndim() != 3)
        refuseShape("image", "(height, width) or (height, width, channels)", image);
    Picture picture;
    picture.depth = depthOf(image);
    picture.height = static_cast<int>(image.shape(0));
    picture.width = static_cast<int>(image.shape(1));
    picture.channels = image.ndim() == 2 ? 1 : static_cast<int>(image.shape(2));
    picture.premultiplied = premultiplied;
    const py::array rows =
        py::module_::import("numpy").attr("ascontiguousarray")(image, typeOf(picture.depth));
    picture.pixels.resize(static_cast<std::size_t>(rows.nbytes()));
    if (!picture.pixels.empty()) std::memcpy(picture.pixels.data(), rows.data(), picture.pixels.size());
    return picture;
}

py::array arrayOf(Picture picture) {
    std::vector<py::ssize_t> shape{picture.height, picture.width};
    if (picture.channels > 1) shape.push_back(picture.channels);
    auto* pixels = new std::vector<std::byte>(std::move(picture.pixels));
    const py::capsule owner(pixels, [](void* p) { delete static_cast<std::vector<std::byte>*>(p); });
    return py::array(py::dtype(typeOf(picture.depth)), std::move(shape), pixels->data(), owner);
}

void addPictures(py::module_& module) {
    using namespace py::literals;
    module.def(
        "warp", &warp, "image"_a, "points"_a, "cells"_a, "pose"_a, py::kw_only(), "filter"_a = "ewa",
        "outside"_a = "transparent", "antialias"_a = true, "premultiplied"_a = false, "part"_a = py::none(),
        "threads"_a = 0,
        "Returns the picture carried by the map points -> pose of a mesh in its pixels (x to the right, "
        "y down, the first pixel's centre at (0.5, 0.5)).\n"
        "image: (height, width) or (height, width, channels), uint8, uint16, float16 or float32; the "
        "result has its type, and alpha if some pixel is not covered.\n"
        "filter: nearest, bilinear, bicubic, ewa; outside: transparent, clamp, original; part: (x, y, "
        "width, height) of the plane instead of the picture's own frame.");
    module.def(
        "read_picture",
        [](const std::filesystem::path& path) {
            Picture picture;
            runInterruptibly(
                {}, [&](const std::stop_token&, const Report&) { picture = loadPicture(path.string()); });
            return arrayOf(std::move(picture));
        },
        "path"_a, "Returns a picture as an array (height, width) or (height, width, channels).");
    module.def(
        "write_picture",
        [](const std::filesystem::path& path, const py::array& image, bool premultiplied) {
            const Picture picture = pictureFrom(image, premultiplied);
            const py::gil_scoped_release released;
            savePicture(path.string(), picture);
        },
        "path"_a, "image"_a, py::kw_only(), "premultiplied"_a = false,
        "Writes a picture, whole or not at all; the extension decides the format.");
}

}  // namespace wend::python
