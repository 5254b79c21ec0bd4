#include "app/output/frame_export.h"

#include <QDir>
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/engine/motion/velocity_probe.h"
#include "app/engine/shape/depth.h"
#include "app/engine/shape/flat_shape.h"
#include "app/output/layer_export.h"
#include "app/output/run_options.h"
#include "app/output/shape_file.h"
#include "app/output/svg_export.h"
#include "app/project/domain.h"
#include "app/project/file/named_files.h"
#include "app/project/file/text_file.h"
#include "app/project/project.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "warp/layered_exr.h"
#include "warp/warp.h"
#include "warp/warped_picture.h"

namespace wend {
namespace {

/// Returns the velocity field at a frame; empty, with a remark, if it cannot be computed.
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
    if (m_picture) m_size = canvasSize(*flat->built);
    m_source = flat->built->texture && flat->built->texture->drawn ? flat->built->texture->drawn : m_rest;
    const auto drawn = drawnRest(*flat->built);
    if (flat->built->texture) m_blends = flat->built->texture->blends();
    m_levels = partLevels(document.domain().parts, *drawn, flat->time);
    m_depths = *CellDepths().of(document.depth(), drawn, m_levels);
}

bool FrameExport::hasDrawing() const {
    return m_picture && wend::hasDrawing(domainOf(*m_project), folderOf(m_name));
}

double FrameExport::frameRate() const {
    return m_project->frameRate;
}

FrameSpan FrameExport::span(bool loop) const {
    RunOutputs outputs;
    outputs.loop = loop;
    return frameSpan(*m_project, m_seconds, outputs);
}

/// Includes the frames on both sides of a span's ends.
Extent<2> FrameExport::extent(ExportKind kind, bool loop) const {
    if (!isMotion(kind)) return extentOf<2>(m_pose, m_rest->cells);
    const auto [from, to] = span(loop);
    std::optional<Extent<2>> all;
    for (std::size_t k = 0; k < m_motion.size(); ++k) {
        const bool isBefore = k + 1 < m_motion.size() && m_motion[k + 1]->time <= from;
        const auto flat = posed<2>(m_motion[k]);
        if (isBefore || !flat) continue;
        const Extent<2> one = extentOf<2>(inPixels(*flat->built, flat->pose), m_rest->cells);
        if (!all) all = one;
        all->low = all->low.cwiseMin(one.low);
        all->high = all->high.cwiseMax(one.high);
        if (m_motion[k]->time >= to) break;
    }
    return all ? *all : extentOf<2>(m_pose, m_rest->cells);
}

View FrameExport::view(ExportKind kind, const CanvasChoice& canvas, bool loop) const {
    return canvasView(m_size, extent(kind, loop), isMotion(kind) ? canvas.forFrames() : canvas);
}

/// Returns the overhang. The outline is grown beyond what is visible, so whatever of it is outside at rest is
/// no loss.
Overhang FrameExport::overhang(ExportKind kind, bool loop) const {
    if (!m_picture) return {};
    const Extent<2> shape = extent(kind, loop), rest = extentOf<2>(m_source->points, m_source->cells);
    const auto beyond = [](double by, double free) {
        return by > std::max(free, 0.0) + 0.5 ? static_cast<int>(std::ceil(std::min(by, 1e9))) : 0;
    };
    return {beyond(-shape.low.x(), -rest.low.x()), beyond(-shape.low.y(), -rest.low.y()),
            beyond(shape.high.x() - m_size[0], rest.high.x() - m_size[0]),
            beyond(shape.high.y() - m_size[1], rest.high.y() - m_size[1])};
}

WarpOptions FrameExport::warpOptions(const RunOptions& options) const {
    requireNothingOutside(*m_project, options);
    WarpOptions warp = warpOptionsOf(*m_project, options);
    warp.depth = m_depths;
    warp.blends = m_blends;
    warp.frameWidth = m_size[0], warp.frameHeight = m_size[1];
    return warp;
}

void FrameExport::writePicture(const std::string& path, const View& view, const RunOptions& options,
                               const RunWatch& watch) const {
    WarpOptions warp = warpOptions(options);
    warp.stop = watch.stop;
    if (watch.progress) warp.progress = [&watch](double done) { watch.progress("warping", done); };
    if (view.scale != 1) warp.restMargin = 0;  // in pixels of the picture in its own size
    requireDepth(path, options);
    if (isSvgFile(path)) {
        const std::string folder = folderOf(m_name);
        requireDrawing(path, *m_project, folder, options);
        SvgExport svg(*m_project, folder, watch.notice);
        return writeTextFile(path, svg.text(*posed<2>(m_frame)->built, m_pose, m_levels, view, warp));
    }
    if (isLayeredFile(path) || getsPartChannels(path, *posed<2>(m_frame)->built)) {
        const auto layers = warpedLayers(*posed<2>(m_frame)->built, m_pose, m_levels, view, warp);
        const Image merged = warpImage(*m_picture, *m_rest, m_pose, view, warp);
        return writeLayers(path, layers, merged, options.depth);
    }
    writeWarped(path, WarpedPicture(*m_picture, *m_rest, m_pose, view, warp), options.depth, options.lossy);
}

Image FrameExport::stMapOf(const View& view) const {
    return stMap(*m_source, m_pose, view, m_size[0], m_size[1], m_depths);
}

void FrameExport::writeStMap(const std::string& path, const View& view) const {
    const Shape<2>& shape = *posed<2>(m_frame)->built;
    const Image map = stMapOf(view);
    if (!getsPartChannels(path, shape)) return writeImage(path, map);
    writeLayeredExr(path, map, stMapsOfParts(shape, m_pose, view, m_depths), map.type);
}

template <int Dim>
void FrameExport::writeMesh(const std::string& path, const RunOptions& options, const RunWatch& watch,
                            std::string& remark) const {
    const auto frame = posed<Dim>(m_frame);
    std::vector<MeshField> fields;
    if (options.fields && holdsFields(path)) {
        fields =
            fieldsFor<Dim>(path, *frame->built, frame->pose, velocityAt<Dim>(*m_project, *frame, remark));
    }
    if (watch.stop.stop_requested()) throw Cancelled();
    const std::string lost = lostInShape<Dim>(path, *frame->built, options.meshes);
    if (!lost.empty() && watch.notice) watch.notice(lost);
    writeShape<Dim>(path, *frame->built, frame->pose, fields, options.meshes);
}

/// Tetrahedra with all fields, or their surface where the format has only triangles.
void FrameExport::writeMesh(const std::string& path, const RunOptions& options, const RunWatch& watch,
                            std::string& remark) const {
    if (dimension() == 3)
        writeMesh<3>(path, options, watch, remark);
    else
        writeMesh<2>(path, options, watch, remark);
}

int FrameExport::vertexCount(const std::string& extension) const {
    const auto solid = posed<3>(m_frame);
    if (!solid) return m_frame->vertices;
    if (isSkinFile("mesh" + extension)) return solid->built->exported().vertexCount();
    return static_cast<int>(writtenPart<3>(*solid->built, solid->pose).cols());
}

void FrameExport::writeFrames(ExportKind kind, const std::string& path, const RunOptions& options,
                              const RunWatch& watch) const {
    RunOptions all = options;
    (kind == ExportKind::Film ? all.outputs.films : all.outputs.frames) = {path};
    const AdvanceResult result = dimension() == 3
                                     ? runShape(*m_project, m_name, *posed<3>(m_frame)->built, all, watch)
                                     : runShape(*m_project, m_name, *posed<2>(m_frame)->built, all, watch);
    if (result.outcome != Outcome::Done) throw InputError(result.message);
}

void FrameExport::write(ExportKind kind, const std::string& path, const RunOptions& options,
                        const RunWatch& watch, std::string& remark) const {
    if (kind == ExportKind::Mesh) {
        requireShapeFormat(path, lowerExtension(path), dimension());
        writeMesh(path, options, watch, remark);
    } else if (isMotion(kind)) {
        writeFrames(kind, path, options, watch);
    } else if (kind == ExportKind::StMap) {
        writeStMap(path, view(kind, options.canvas));
    } else {
        writePicture(path, view(kind, options.canvas), options, watch);
    }
}

}  // namespace wend
