#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "app/engine/shape/material_picture.h"
#include "app/output/layer_export.h"
#include "app/output/output_set.h"
#include "app/output/point_file.h"
#include "app/output/rig_files.h"
#include "app/output/run.h"
#include "app/output/shape_file.h"
#include "app/output/svg_export.h"
#include "app/project/domain.h"
#include "app/project/options/options.h"
#include "app/project/project.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/base/number_text.h"
#include "warp/film_format.h"

namespace wend {
namespace {

void requirePicture(const Project& project, const std::string& path) {
    const Domain& domain = domainOf(project);
    if (dimensionOf(project) == 3)
        throw InputError(path,
                         "a picture of a solid is written by the window only; here its mesh can be, with "
                         "--mesh or --frames");
    if (domain.kind == DomainKind::Mesh && domain.texture.empty())
        throw InputError(path, "there is no picture to warp: the project's domain has none");
}

void requireMaterialPicture(const Project& project, const std::string& path) {
    if (dimensionOf(project) == 3)
        throw InputError(path, "a solid's material goes with its mesh, as values of cells: --mesh FILE.vtu");
    if (path != "-" && !canWriteImage(path))
        throw InputError(path, "is in no picture format that can be written");
}

bool isOneOf(const std::string& word, std::initializer_list<const char*> words) {
    return std::ranges::any_of(words, [&](const char* one) { return word == one; });
}

void requireFilm(const Project& project, const std::string& path) {
    if (dimensionOf(project) == 3)
        throw InputError(path,
                         "a film of a solid is made by the window only (Export, View); here its animation "
                         "can be written with --frames FILE.glb");
    const Domain& domain = domainOf(project);
    if (domain.kind == DomainKind::Mesh && domain.texture.empty())
        throw InputError(path, "there is no picture for a film: the project's domain has none");
    requireFilmFormat(path);
}

void requireFrames(const Project& project, const std::string& path) {
    const bool pictures = canWriteImage(path) || isSvgFile(path);
    if (isLayeredFile(path)) throw InputError(path, "files with layers are written by --image alone");
    if (!isAnimation(path) && path.find('#') == std::string::npos)
        throw InputError(path, std::string("the name of a sequence needs #### in the place of the number") +
                                   (filmFormatOf(path) ? "; for a film take --film" : ""));
    if (pictures || (isRigFile(path) && dimensionOf(project) == 2)) return requirePicture(project, path);
    requireShapeFormat(path, lowerExtension(path), dimensionOf(project));
}

}  // namespace

bool isAnimation(const std::string& frames) {
    return isRigFile(frames) || (lowerExtension(frames) == ".webp" && frames.find('#') == std::string::npos);
}

std::string collectionName(const std::string& pattern) {
    if (lowerExtension(pattern) != ".vtu") return {};
    std::string stem = std::filesystem::path(pattern).stem().string();
    const auto last = stem.find_last_of('#');
    auto first = last;
    while (first > 0 && stem[first - 1] == '#') --first;
    stem.erase(first, last - first + 1);
    while (!stem.empty() && std::string_view("_-. ").find(stem.back()) != std::string_view::npos)
        stem.pop_back();
    const std::string name = (stem.empty() ? "frames" : stem) + ".pvd";
    return (std::filesystem::path(pattern).parent_path() / name).string();
}

FileNames RunOutputs::singleFiles() const {
    FileNames all;
    for (const FileNames* names :
         {&image, &mesh, &velocity, &stMap, &report, &states, &material[0], &material[1], &material[2]})
        all.insert(all.end(), names->begin(), names->end());
    for (const PointsOutput& one : points) all.push_back(one.out);
    all.insert(all.end(), films.begin(), films.end());
    for (const std::string& path : frames) {
        if (const std::string file = isAnimation(path) ? path : collectionName(path); !file.empty())
            all.push_back(file);
        if (isRigFile(path)) std::ranges::copy(filesBesideRig(path), std::back_inserter(all));
    }
    return all;
}

FileNames RunOutputs::numberedFrames() const {
    FileNames all;
    std::ranges::copy_if(frames, std::back_inserter(all),
                         [](const std::string& path) { return !isAnimation(path); });
    return all;
}

FileNames RunOutputs::filmFiles() const {
    FileNames all = films;
    std::ranges::copy_if(frames, std::back_inserter(all),
                         [](const std::string& path) { return isAnimation(path) && canWriteImage(path); });
    return all;
}

FrameSpan frameSpan(const Project& project, double end, const RunOutputs& outputs) {
    if (outputs.loop && project.cycle) return {project.cycle->at(0), std::min(project.cycle->at(1), end)};
    return {0, end};
}

int frameCount(const FrameSpan& span, double framesPerSecond, bool loop) {
    const double frames = std::round((span.to - span.from) * framesPerSecond) + (loop ? 0 : 1);
    return static_cast<int>(std::clamp(frames, 2.0, 1e6));
}

bool RunOutputs::any() const {
    return !singleFiles().empty() || !frames.empty();
}

void requirePossible(const Project& project, const RunOutputs& outputs) {
    const auto extensionOf = [](const std::string& path, const char* standard) {
        return path == "-" ? std::string(standard) : lowerExtension(path);
    };
    for (const std::string& path : outputs.image) {
        requirePicture(project, path);
        if (path != "-" && !canWriteImage(path) && !isLayeredFile(path) && !isSvgFile(path))
            throw InputError(path, "is in no picture format that can be written");
    }
    for (const std::string& path : outputs.mesh)
        requireShapeFormat(path, extensionOf(path, ".vtu"), dimensionOf(project));
    for (const std::string& path : outputs.velocity)
        if (!isOneOf(extensionOf(path, ".csv"), {".csv", ".vtu"}))
            throw InputError(path, "a velocity field is written as .csv or .vtu");
    for (const std::string& path : outputs.stMap) {
        requirePicture(project, path);
        if (!isOneOf(extensionOf(path, ".exr"), {".exr", ".tif", ".tiff"}))
            throw InputError(path, "an ST map needs a format with floating-point pixels: .exr or .tif");
    }
    for (const FileNames& pictures : outputs.material)
        for (const std::string& path : pictures) requireMaterialPicture(project, path);
    for (const std::string& path : outputs.frames) requireFrames(project, path);
    for (const PointsOutput& one : outputs.points) {
        requirePointFormat(one.in, false);
        requirePointFormat(one.out, true);
    }
    for (const std::string& path : outputs.films) requireFilm(project, path);
    requirePlaces(outputs.singleFiles());
    requirePlaces(outputs.numberedFrames());
}

namespace {

/// Returns the size in pixels of the output, each of which is `scale` pixels of the plane wide.
Vec2 scaled(const Vec2& size, const CanvasChoice& canvas, double& scale) {
    if (!canvas.isScaled()) return size;
    const double factor = canvas.width > 0 ? canvas.width / size.x() : canvas.scale;
    const double unit = canvas.even ? 2 : 1;
    const Vec2 pixels = ((size * factor / unit).array().round() * unit).max(unit);
    scale = size.x() / pixels.x();
    return pixels;
}

}  // namespace

View canvasView(const std::array<int, 2>& canvasSize, const Extent<2>& shape, const CanvasChoice& canvas) {
    View view{canvasSize[0], canvasSize[1], Vec2::Zero(), 1};
    if (canvas.kind == Canvas::Picture && !canvas.isScaled()) return view;
    const bool fits = canvas.kind == Canvas::Fit;
    const PixelRect& part = canvas.part;
    if (canvas.kind == Canvas::Part) view.origin = Vec2(part.x, part.y);
    if (fits) view.origin = shape.low.array().floor();
    Vec2 size(canvasSize[0], canvasSize[1]);
    if (canvas.kind == Canvas::Part) size = Vec2(part.width, part.height);
    if (fits) size = (shape.high.array().ceil().matrix() - view.origin).cwiseMax(1);
    if (fits && canvas.even) size = (size / 2).array().ceil() * 2;
    size = scaled(size, canvas, view.scale);
    if (!(size.maxCoeff() <= 1e6 && size.prod() <= 1e6 * kMaxMegapixels)) {
        const auto rounded = [](double x) { return shortNumber(std::min(x, 1e15)); };
        throw InputError((fits ? "the shape spans " : "the canvas has ") + rounded(size.x()) + " x " +
                         rounded(size.y()) + " pixels, more than " + shortNumber(kMaxMegapixels) +
                         " million");
    }
    view.width = static_cast<int>(size.x());
    view.height = static_cast<int>(size.y());
    return view;
}

template <int Dim>
std::string velocityTable(const Points<Dim>& pose, const Points<Dim>& velocity) {
    std::string text = Dim == 2 ? "x,y,vx,vy\n" : "x,y,z,vx,vy,vz\n";
    for (Eigen::Index i = 0; i < pose.cols(); ++i) {
        for (int a = 0; a < Dim; ++a) {
            appendNumber(text, pose(a, i));
            text += ',';
        }
        for (int a = 0; a < Dim; ++a) {
            appendNumber(text, velocity(a, i));
            text += a + 1 < Dim ? ',' : '\n';
        }
    }
    return text;
}

template std::string velocityTable<2>(const Points2&, const Points2&);
template std::string velocityTable<3>(const Points3&, const Points3&);

}  // namespace wend
