#include "app/output/picture_output.h"

#include <algorithm>
#include <filesystem>

#include "app/engine/shape/material_picture.h"
#include "app/output/layer_export.h"
#include "app/output/output_set.h"
#include "app/output/run_options.h"
#include "app/project/domain.h"
#include "app/project/file/named_files.h"
#include "app/project/file/text_file.h"
#include "core/base/error.h"
#include "warp/image.h"
#include "warp/image_formats.h"
#include "warp/layered_exr.h"
#include "warp/warp.h"
#include "warp/warped_picture.h"

namespace wend {

Film& FilmOutputs::filmAt(const std::string& path) {
    if (const auto known = m_films.find(path); known != m_films.end()) return known->second;
    return m_films.try_emplace(path, path, m_files.begin(path), m_options).first->second;
}

void FilmOutputs::add(const std::vector<std::string>& paths, const WarpedPicture& picture) {
    if (paths.empty()) return;
    Image frame = picture.header();
    frame.makePixels();
    if (!picture.paint(0, frame)) throw Cancelled();
    for (const std::string& path : paths) {
        Film& film = filmAt(path);
        m_files.extend(path, [&] { film.add(frame); });
    }
}

void FilmOutputs::finish() {
    for (auto& [path, film] : m_films) m_files.extend(path, [&] { film.finish(); });
}

namespace fs = std::filesystem;

namespace {

std::string folderOfFile(const std::string& path) {
    const fs::path parent = fs::path(path).parent_path();
    return parent.empty() ? "." : parent.string();
}

}  // namespace

PoseFile::PoseFile(const std::string& path)
    : m_path(path),
      m_folder(folderOfFile(path)),
      m_stream((fs::path(m_folder.path()) / "poses").string(),
               std::ios::binary | std::ios::in | std::ios::out | std::ios::trunc) {}

void PoseFile::add(const Points2& pose) {
    m_columns = pose.cols();
    m_stream.write(reinterpret_cast<const char*>(pose.data()),
                   static_cast<std::streamsize>(sizeof(double)) * pose.size());
    if (!m_stream)
        throw InputError(m_path, {sentence("Core", "cannot be written: %1"),
                                  Message(sentence("Core", "the disk may be full"))});
    ++m_count;
}

Points2 PoseFile::read(int k) {
    Points2 pose(2, m_columns);
    const auto bytes = static_cast<std::streamsize>(sizeof(double)) * pose.size();
    m_stream.seekg(k * bytes);  // which writes what is still buffered
    m_stream.read(reinterpret_cast<char*>(pose.data()), bytes);
    if (!m_stream)
        throw InputError(m_path, {sentence("Core", "cannot be written: %1"),
                                  Message(sentence("Core", "the disk may be full"))});
    return pose;
}

PictureOutput::PictureOutput(const Project& project, const std::string& path, const Shape<2>& shape,
                             const RunOptions& options, const RunWatch& watch, const SharedDevice& device,
                             OutputSet& files, FilmOptions film)
    : m_project(project),
      m_path(path),
      m_shape(shape),
      m_options(options),
      m_watch(watch),
      m_device(device),
      m_files(files),
      m_films(files, std::move(film)) {}

void PictureOutput::write(double time, const Points2& pose) {
    const RunOutputs& outputs = m_options.outputs;
    if (outputs.image.empty() && outputs.stMap.empty()) return;
    const Points2 pixels = inPixels(m_shape, pose);
    const auto size = canvasSize(m_shape);
    const View view = canvasView(size, extent(pixels), m_options.canvas);
    m_canvas = view;
    const double count = static_cast<double>(outputs.image.size());
    for (std::size_t k = 0; k < outputs.image.size(); ++k) {
        const double done = static_cast<double>(k);
        m_files.add(outputs.image[k], ".png", [&](const std::string& file) {
            if (isSvgFile(file)) return writeSvg(file, time, pixels, view);
            if (isLayeredFile(file) || getsPartChannels(file, m_shape))
                return writeParts(file, time, pixels, view);
            writePicture(file, warped(time, pixels, view, warping(done / count, (done + 1) / count)));
        });
    }
    for (const std::string& path : outputs.stMap)
        m_files.add(path, ".exr", [&](const std::string& file) {
            const Image map = stMap(sourceRest(m_shape), pixels, view, size[0], size[1], depths(time));
            if (!getsPartChannels(file, m_shape)) return writeImage(file, map);
            writeLayeredExr(file, map, stMapsOfParts(m_shape, pixels, view, depths(time)), map.type);
        });
}

void PictureOutput::writeMaterial() {
    const bool isPicture = domainOf(m_project).kind == DomainKind::Image;
    const auto size = isPicture ? canvasSize(m_shape) : std::array{0, 0};
    for (const MaterialPart part : kMaterialParts)
        for (const std::string& path : m_options.outputs.material[static_cast<std::size_t>(part)])
            m_files.add(path, ".png", [&](const std::string& file) {
                const PictureFrame frame = pictureFrame(size[0], size[1], *m_shape.rest);
                writeImage(file, materialPicture(part, frame, *m_shape.rest, *m_shape.material));
            });
}

void PictureOutput::takeFrame(int number, double time, const Points2& pose) {
    const Points2 pixels = inPixels(m_shape, pose);
    const Extent<2> shape = extent(pixels);
    if (m_options.canvas.kind != Canvas::Fit)
        return writeFrame(number, time, pixels,
                          canvasView(canvasSize(m_shape), shape, m_options.canvas.forFrames()), {});
    if (!m_waiting) {
        const FileNames films = m_options.outputs.filmFiles();
        m_waiting.emplace(films.empty() ? m_options.outputs.numberedFrames().front() : films.front());
        m_allFrames = shape;
    }
    m_allFrames.low = m_allFrames.low.cwiseMin(shape.low);
    m_allFrames.high = m_allFrames.high.cwiseMax(shape.high);
    m_waiting->add(pixels);
    m_times.push_back(time);
}

void PictureOutput::writeWaitingFrames() {
    if (!m_waiting) return;
    const View view = canvasView(canvasSize(m_shape), m_allFrames, m_options.canvas.forFrames());
    const double count = m_waiting->count();
    for (int k = 0; k < m_waiting->count(); ++k) {
        if (m_share && (k < m_share->first || k >= m_share->second)) continue;
        tell("warping", k / count);
        writeFrame(k, m_times[static_cast<std::size_t>(k)], m_waiting->read(k), view,
                   warping(k / count, (k + 1) / count));
    }
}

void PictureOutput::writeFilms() {
    if (m_films.any()) tell("encoding", 0);
    m_films.finish();
}

const std::vector<float>& PictureOutput::depths(double time) {
    const auto mesh = drawnRest(m_shape);
    return *m_depths.of(depthOf(m_project), mesh, partLevels(domainOf(m_project).parts, *mesh, time));
}

WarpOptions PictureOutput::warpOptions(double time, const std::function<void(double)>& progress) {
    if (!m_painters) m_painters = cellPainters(m_options.backEnd, {}, m_watch.notice, m_device);
    WarpOptions options = warpOptionsOf(m_project, m_options);
    options.depth = depths(time);
    if (m_shape.texture) options.blends = m_shape.texture->blends();
    const auto [width, height] = canvasSize(m_shape);
    options.frameWidth = width, options.frameHeight = height;
    options.makePainter = m_painters;
    options.stop = m_watch.stop;
    options.progress = progress;
    return options;
}

/// Returns the picture at a time in the pixels of `view`.
WarpedPicture PictureOutput::warped(double time, const Points2& pixels, const View& view,
                                    const std::function<void(double)>& progress) {
    WarpOptions options = warpOptions(time, progress);
    if (view.scale != 1) options.restMargin = 0;  // in pixels of the picture in its own size
    return {*m_shape.picture, restInPixels(m_shape), pixels, view, options};
}

/// Reports what is between the fractions `from` and `to` of the warping.
std::function<void(double)> PictureOutput::warping(double from, double to) const {
    if (!m_watch.progress) return {};
    return [this, from, to](double done) { m_watch.progress("warping", from + (to - from) * done); };
}

Extent<2> PictureOutput::extent(const Points2& pixels) const {
    return extentOf<2>(pixels, restInPixels(m_shape).cells);
}

void PictureOutput::writeParts(const std::string& file, double time, const Points2& pixels,
                               const View& view) {
    const WarpOptions options = warpOptions(time, {});
    const auto levels = partLevels(domainOf(m_project).parts, *drawnRest(m_shape), time);
    const auto layers = warpedLayers(m_shape, pixels, levels, view, options);
    const Image merged = warpImage(*m_shape.picture, restInPixels(m_shape), pixels, view, options);
    writeLayers(file, layers, merged, m_options.depth);
}

void PictureOutput::writeSvg(const std::string& file, double time, const Points2& pixels, const View& view) {
    if (!m_svg) m_svg.emplace(m_project, folderOf(m_path), m_watch.notice);
    const auto levels = partLevels(domainOf(m_project).parts, *drawnRest(m_shape), time);
    writeTextFile(file, m_svg->text(m_shape, pixels, levels, view, warpOptions(time, {})));
}

void PictureOutput::writePicture(const std::string& file, const WarpedPicture& picture) const {
    writeWarped(file, picture, m_options.depth, m_options.lossy);
}

void PictureOutput::writeFrame(int number, double time, const Points2& pixels, const View& view,
                               const std::function<void(double)>& progress) {
    m_canvas = view;
    const FileNames numbered = m_options.outputs.numberedFrames();
    for (const std::string& pattern : numbered)
        if (isSvgFile(pattern))
            m_files.add(frameName(pattern, number), "",
                        [&](const std::string& file) { writeSvg(file, time, pixels, view); });
    if (m_options.outputs.filmFiles().empty() && std::ranges::none_of(numbered, canWriteImage)) return;
    const WarpedPicture picture = warped(time, pixels, view, progress);
    for (const std::string& pattern : numbered)
        if (canWriteImage(pattern))
            m_files.add(frameName(pattern, number), "",
                        [&](const std::string& file) { writePicture(file, picture); });
    m_films.add(m_options.outputs.filmFiles(), picture);
}

void PictureOutput::tell(const std::string& work, double fraction) const {
    if (m_watch.stop.stop_requested()) throw Cancelled();
    if (m_watch.progress) m_watch.progress(work, fraction);
}

}  // namespace wend
