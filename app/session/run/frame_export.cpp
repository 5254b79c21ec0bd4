#include "app/session/run/frame_export.h"

#include <QDir>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/session/motion/velocity_probe.h"
#include "app/session/run/run_options.h"
#include "app/session/run/shape_file.h"
#include "app/session/shape/depth.h"
#include "app/session/shape/flat_shape.h"
#include "core/mesh/error.h"
#include "core/mesh/file_name.h"
#include "core/mesh/safe_file.h"
#include "warp/film.h"
#include "warp/warp.h"
#include "warp/warped_picture.h"

namespace wend {
namespace {

namespace fs = std::filesystem;

constexpr double kMeasured = 2e6;  // pixels: a picture up to here is written once to tell its size
constexpr int kBands = 4;          // of a larger one, as many pixels in strips

/// Bytes of what `write` leaves in a folder of its own, which goes.
double bytesOf(const std::string& extension, const std::function<void(const std::string&)>& write) {
    const TemporaryFolder folder(scratchFolder());
    write((fs::path(folder.path()) / ("size" + extension)).string());
    double bytes = 0;
    for (const auto& entry : fs::directory_iterator(folder.path()))
        bytes += static_cast<double>(entry.file_size());
    return bytes;
}

/// Strips of the view, equally far from each other.
std::vector<View> bandsOf(const View& view) {
    std::vector<View> bands;
    const int rows = std::max(1, static_cast<int>(kMeasured / kBands / view.width));
    for (int k = 0; k < kBands; ++k) {
        View band = view;
        band.height = std::min(rows, view.height);
        band.origin.y() += std::floor((view.height - band.height) * (k + 0.5) / kBands) * view.scale;
        bands.push_back(band);
    }
    return bands;
}

/// The velocity field at a frame; empty, with a remark, where it cannot be had.
template <int Dim>
Points<Dim> velocityAt(const Project& project, const PosedFrame<Dim>& frame, std::string& remark) {
    Points<Dim> velocity;
    try {
        velocity = VelocityProbe<Dim>(*frame.built, project).at(frame.time, frame.pose);
        if (velocity.cols() == 0) remark = "the velocity field cannot be solved for";
    } catch (const InputError& error) {
        remark = error.what();
    }
    return velocity;
}

}  // namespace

FrameExport::FrameExport(const Document& document, FramePtr frame, std::vector<FramePtr> motion,
                         double seconds)
    : m_project(document.project()),
      m_name(QDir(document.folder()).filePath(document.displayName()).toStdString()),
      m_frame(std::move(frame)),
      m_motion(std::move(motion)),
      m_seconds(seconds) {
    const auto flat = posed<2>(m_frame);
    if (!flat) return;
    m_picture = flat->built->picture;
    m_rest = flat->built->texture ? flat->built->texture->rest : flat->rest;
    m_pose = inPixels(*flat->built, flat->pose);
    m_depths = cellDepths(document.depth(), *flat->rest);
}

Extent<2> FrameExport::extent(ExportKind kind) const {
    Extent<2> all = extentOf<2>(m_pose, m_rest->cells);
    if (kind != ExportKind::Frames) return all;
    for (const FramePtr& frame : m_motion)
        if (const auto flat = posed<2>(frame)) {
            const Extent<2> one = extentOf<2>(inPixels(*flat->built, flat->pose), m_rest->cells);
            all.low = all.low.cwiseMin(one.low);
            all.high = all.high.cwiseMax(one.high);
        }
    return all;
}

View FrameExport::view(ExportKind kind, const CanvasChoice& canvas) const {
    return canvasView(*m_picture, extent(kind), canvas);
}

/// The outline is grown beyond what is seen: what of it lies outside at rest is no loss.
Overhang FrameExport::overhang(ExportKind kind) const {
    if (!m_picture) return {};
    const Extent<2> shape = extent(kind), rest = extentOf<2>(m_rest->points, m_rest->cells);
    const auto beyond = [](double by, double free) {
        return by > std::max(free, 0.0) + 0.5 ? static_cast<int>(std::ceil(std::min(by, 1e9))) : 0;
    };
    return {beyond(-shape.low.x(), -rest.low.x()), beyond(-shape.low.y(), -rest.low.y()),
            beyond(shape.high.x() - m_picture->width, rest.high.x() - m_picture->width),
            beyond(shape.high.y() - m_picture->height, rest.high.y() - m_picture->height)};
}

WarpOptions FrameExport::warpOptions(const RunOptions& options) const {
    WarpOptions warp = warpOptionsOf(*m_project, options);
    warp.depth = m_depths;
    return warp;
}

void FrameExport::writePicture(const std::string& path, const View& view, const RunOptions& options,
                               const RunWatch& watch) const {
    WarpOptions warp = warpOptions(options);
    warp.stop = watch.stop;
    if (watch.progress) warp.progress = [&watch](double done) { watch.progress("warping", done); };
    requireDepth(path, options);
    writeWarped(path, WarpedPicture(*m_picture, *m_rest, m_pose, view, warp), options.depth, options.lossy);
}

void FrameExport::writeStMap(const std::string& path, const View& view) const {
    writeImage(path, stMap(*m_rest, m_pose, view, m_picture->width, m_picture->height, m_depths));
}

template <int Dim>
void FrameExport::writeMesh(const std::string& path, const RunOptions& options, bool inSequence,
                            const RunWatch& watch, std::string& remark) const {
    const auto frame = posed<Dim>(m_frame);
    std::vector<MeshField> fields;
    if (options.fields && holdsFields(path)) {
        const Points<Dim> none;
        fields = shapeFields<Dim>(*frame->built, frame->pose,
                                  inSequence ? none : velocityAt<Dim>(*m_project, *frame, remark));
    }
    if (watch.stop.stop_requested()) throw Cancelled();
    writeShape<Dim>(path, *frame->built, frame->pose, fields, options.meshes);
}

/// Tetrahedra with all fields, or their surface where the format has only triangles.
void FrameExport::writeMesh(const std::string& path, const RunOptions& options, bool inSequence,
                            const RunWatch& watch, std::string& remark) const {
    if (dimension() == 3)
        writeMesh<3>(path, options, inSequence, watch, remark);
    else
        writeMesh<2>(path, options, inSequence, watch, remark);
}

int FrameExport::vertexCount(const std::string& extension) const {
    const auto solid = posed<3>(m_frame);
    if (!solid) return m_frame->vertices;
    if (isSkinFile("mesh" + extension)) return solid->built->skin->vertexCount();
    return static_cast<int>(writtenPart<3>(*solid->built, solid->pose).cols());
}

void FrameExport::writeFrames(const std::string& path, const RunOptions& options,
                              const RunWatch& watch) const {
    RunOptions all = options;
    all.outputs.frames = path;
    const AdvanceResult result = runProject(*m_project, m_name, all, watch);
    if (result.outcome != Outcome::Done) throw InputError(result.message);
}

void FrameExport::write(ExportKind kind, const std::string& path, const RunOptions& options,
                        const RunWatch& watch, std::string& remark) const {
    if (kind == ExportKind::Mesh) {
        requireShapeFormat(path, lowerExtension(path), dimension());
        writeMesh(path, options, false, watch, remark);
    } else if (kind == ExportKind::Frames) {
        writeFrames(path, options, watch);
    } else if (kind == ExportKind::StMap) {
        writeStMap(path, view(kind, options.canvas));
    } else {
        writePicture(path, view(kind, options.canvas), options, watch);
    }
}

FileSize FrameExport::size(ExportKind kind, const std::string& extension, const RunOptions& options,
                           std::stop_token stop) const {
    const double count = kind == ExportKind::Frames ? options.outputs.count : 1;
    if (kind == ExportKind::Frames && isAnimation(options.outputs.frames))
        return {filmSize(options, stop), false};
    if (canWriteImage("size" + extension)) {
        const FileSize one = pictureSize(kind, extension, options, stop);
        return {count * one.bytes, one.measured && kind != ExportKind::Frames};
    }
    RunWatch watch;
    watch.stop = stop;
    std::string remark;
    const double one = bytesOf(extension, [&](const std::string& file) {
        writeMesh(file, options, kind == ExportKind::Frames, watch, remark);
    });
    return {count * one, kind != ExportKind::Frames};
}

FileSize FrameExport::pictureSize(ExportKind kind, const std::string& extension, const RunOptions& options,
                                  std::stop_token stop) const {
    const View whole = view(kind, options.canvas);
    const double pixels = static_cast<double>(whole.width) * whole.height;
    const bool measured = pixels <= kMeasured;
    double bytes = 0, rows = 0;
    RunWatch watch;
    watch.stop = stop;
    for (const View& part : measured ? std::vector<View>{whole} : bandsOf(whole)) {
        if (stop.stop_requested()) throw Cancelled();
        rows += part.height;
        bytes += bytesOf(extension, [&](const std::string& file) {
            if (kind == ExportKind::StMap) return writeStMap(file, part);
            writePicture(file, part, options, watch);
        });
    }
    return {bytes * whole.height / rows, measured};
}

/// A film in one file grows by about the same with every frame.
double FrameExport::filmSize(const RunOptions& options, const std::stop_token& stop) const {
    const auto bytes = [&](int count) {
        return dimension() == 3 ? solidFilmBytes(count, options) : pictureFilmBytes(count, options, stop);
    };
    const double two = bytes(2), three = bytes(3);
    return two + (options.outputs.count - 2) * (three - two);
}

double FrameExport::solidFilmBytes(int count, const RunOptions& options) const {
    const auto solid = posed<3>(m_frame);
    const std::vector<Points<3>> poses(static_cast<std::size_t>(count), solid->pose);
    return bytesOf(".glb", [&](const std::string& file) {
        writeAnimation(file, *solid->built, poses, options.outputs.framesPerSecond);
    });
}

/// So many frames from the middle of the motion on; of a large picture in strips.
double FrameExport::pictureFilmBytes(int count, const RunOptions& options,
                                     const std::stop_token& stop) const {
    const View whole = view(ExportKind::Frames, options.canvas);
    const bool small = static_cast<double>(whole.width) * whole.height <= kMeasured;
    WarpOptions warp = warpOptions(options);
    warp.stop = stop;
    double bytes = 0, rows = 0;
    for (const View& part : small ? std::vector<View>{whole} : bandsOf(whole)) {
        Film film("size.webp", options.outputs.framesPerSecond, options.lossy);
        for (int k = 0; k < count; ++k) {
            const Points<2> pose = poseAt(0.5 + double(k) / options.outputs.count);
            film.add(WarpedPicture(*m_picture, *m_rest, pose, part, warp));
        }
        rows += part.height;
        bytes += bytesOf(".webp", [&](const std::string& file) { film.write(file); });
    }
    return bytes * whole.height / rows;
}

/// In pixels, after that part of the motion, between the frames that there are.
Points<2> FrameExport::poseAt(double part) const {
    if (m_motion.empty()) return m_pose;
    const double time = part * m_motion.back()->time;
    const auto after = std::ranges::find_if(m_motion, [&](const FramePtr& one) { return one->time >= time; });
    const FramePtr& right = after == m_motion.end() ? m_motion.back() : *after;
    const FramePtr& left = after == m_motion.begin() || after == m_motion.end() ? right : *(after - 1);
    const double span = right->time - left->time, blend = span > 0 ? (time - left->time) / span : 0;
    const auto one = posed<2>(left), other = posed<2>(right);
    return inPixels(*one->built, (1 - blend) * one->pose + blend * other->pose);
}

}  // namespace wend
