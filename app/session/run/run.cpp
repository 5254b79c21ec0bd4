#include "app/session/run/run.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <filesystem>
#include <mutex>

#include "app/document/domain.h"
#include "app/document/file/named_files.h"
#include "app/document/file/text_file.h"
#include "app/document/options/options.h"
#include "app/document/project.h"
#include "app/session/run/film_outputs.h"
#include "app/session/run/layer_export.h"
#include "app/session/run/output_set.h"
#include "app/session/run/point_file.h"
#include "app/session/run/pose_file.h"
#include "app/session/run/report.h"
#include "app/session/run/rig.h"
#include "app/session/run/rig_files.h"
#include "app/session/run/run_options.h"
#include "app/session/run/run_states.h"
#include "app/session/run/shape_file.h"
#include "app/session/run/svg_export.h"
#include "app/session/shape/depth.h"
#include "app/session/shape/held_border.h"
#include "app/session/shape/material_picture.h"
#include "app/session/shape/pose_faults.h"
#include "app/session/shape/shape_builder.h"
#include "core/energy/distortion.h"
#include "core/integration/deformer.h"
#include "core/integration/stop_message.h"
#include "core/mesh/error.h"
#include "core/mesh/file_name.h"
#include "core/mesh/input_file.h"
#include "core/mesh/mesh_of_file.h"
#include "core/system/memory.h"
#include "kernels/back_end_choice.h"
#include "warp/film_format.h"
#include "warp/image_formats.h"
#include "warp/layered_exr.h"
#include "warp/picture_library.h"
#include "warp/warp.h"
#include "warp/warped_picture.h"

namespace wend {
namespace {

using Clock = std::chrono::steady_clock;

/// Suggests what to do if a factor of the project's shape does not fit into memory.
std::string adviceOnMemory(const Project& project) {
    const Domain& domain = domainOf(project);
    const bool isMultigrid = integrationOf(project).solver == SolverKind::Multigrid;
    const std::string other = isMultigrid ? "" : " or --solver multigrid";
    if (domain.kind == DomainKind::Mesh) return "take a coarser mesh" + other;
    const bool mayCage = domain.kind == DomainKind::Surface && domain.fit != Fit::Cage;
    return "take fewer vertices (domain.vertices)" + std::string(mayCage ? ", a cage (domain.cage)" : "") +
           other;
}

std::string nameOf(FieldWork work) {
    switch (work) {
        case FieldWork::Factor:
            return "factorizing";
        case FieldWork::Levels:
            return "building levels";
        case FieldWork::Iterations:
            break;
    }
    return "iterating";
}

constexpr double kCrushed = 1e-3;  // of a cell's measure at rest: the picture is ruined there

/// One run: the shape, its deformer, and the files that are being made. Frames are written as soon as they
/// are computed, so that a long sequence needs no more memory than a short one.
template <int Dim>
class Run {
  public:
    Run(const Project& project, const std::string& path, Shape<Dim> shape, const RunOptions& options,
        const RunWatch& watch, Clock::time_point start)
        : m_project(project),
          m_path(path),
          m_shape(std::move(shape)),
          m_options(options),
          m_notices(options.notices),
          m_watch(listening(watch)),
          m_start(start),
          m_deformer(
              m_shape.rest, m_shape.material, heldHandles<Dim>(project, m_shape), integrationOf(project),
              backEndFactory<Dim>(options.backEnd, {}, m_watch.notice, m_device), options.solvers.of<Dim>()) {
        for (const FileNames* names : {&options.outputs.mesh, &options.outputs.frames})
            for (const std::string& name : *names) requireHeldBy<Dim>(name, m_shape);
        readPoints();
    }

    AdvanceResult run() {
        openStates();
        if (m_options.shard) return runShard();
        endIfStrict(false);
        AdvanceResult result = integrate();
        if (result.outcome == Outcome::Cancelled) throw Cancelled();
        if (result.outcome == Outcome::Done && m_atTime) m_deformer.restore(*m_atTime);
        if (wantsVelocity() && !solveVelocity() && result.outcome == Outcome::Done)
            result = m_deformer.failure();
        if (result.outcome == Outcome::Cancelled) throw Cancelled();
        m_faults = faultsOf<Dim>(m_shape, m_deformer.state().points);
        if (const Message snaps = snapMessage(m_deformer.statistics().snaps, Dim); !snaps.isEmpty())
            m_watch.notice(snaps);
        if (result.outcome == Outcome::Done || m_options.partial) {
            endIfStrict(false);
            warnOfFaults();
            const bool isFaulty = m_options.strict && !m_notices.empty();
            if (!isFaulty) writeAll();
            endIfStrict(isFaulty);
        } else {
            m_films.discard();
            m_files.discard();
        }
        writeReports();
        m_files.commit();
        if (m_watch.summary && result.outcome == Outcome::Done)
            m_watch.summary(summaryText(m_deformer.statistics(), integrationOf(m_project)));
        tellOfCanvas();
        tellOfFaults();
        return result;
    }

  private:
    /// The same, and notices are kept for the report. Threads that paint may call it.
    RunWatch listening(RunWatch watch) {
        watch.notice = [this, tell = std::move(watch.notice)](const Message& text) {
            const std::scoped_lock lock(m_noticing);
            m_notices.push_back(text);
            if (tell) tell(text);
        };
        return watch;
    }

    double end() const { return m_options.at.value_or(endOf(m_project)); }
    /// Returns the end of the integration: that of other states, whose last step is cut there.
    double flowEnd() const { return m_known ? m_known->header().end : end(); }
    double frameTime(int k) const {
        const RunOutputs& outputs = m_options.outputs;
        const auto [from, to] = frameSpan(m_project, end(), outputs);
        const int intervals = outputs.loop ? outputs.count : outputs.count - 1;
        return k < intervals ? from + (to - from) * k / intervals : to;
    }

    void tell(const std::string& work, double fraction) const {
        if (m_watch.stop.stop_requested()) throw Cancelled();
        if (m_watch.progress) m_watch.progress(work, fraction);
    }

    void openStates() {
        const std::string& from = m_options.from;
        const FileNames& files = m_options.outputs.states;
        if (from.empty() && files.empty()) return;
        const StatesHeader header = statesHeader<Dim>(m_project, m_shape, end());
        if (!from.empty()) {
            m_known.emplace(from, header);
            if (end() > m_known->header().end)
                throw InputError(from, "holds the states of a run to time " +
                                           shortNumber(m_known->header().end) + " only (see --at)");
        }
        for (const std::string& to : files)
            if (m_known)
                m_states.emplace_back(to, *m_known);
            else
                m_states.emplace_back(to, header);
    }

    /// Returns a watch for the frames with these numbers, and for the shape at the end if the integration
    /// continues beyond it.
    typename Deformer<Dim>::Watch watchFor(int firstFrame, int endFrame) {
        typename Deformer<Dim>::Watch watch;
        watch.stop = m_watch.stop;
        if (m_watch.progress) {
            const auto part = [this](double time) { return end() > 0 ? std::min(time / end(), 1.0) : 1; };
            watch.progress = [this, part](double time) { m_watch.progress("deforming", part(time)); };
            watch.within = [this, part](const Within& now) {
                const int percent = static_cast<int>(100 * part(now.time));
                m_watch.progress("deforming " + std::to_string(percent) + " %, " + nameOf(now.work),
                                 now.part);
            };
        }
        if (m_known) watch.known = &*m_known;
        m_frame = firstFrame;
        for (int k = firstFrame; k < endFrame; ++k) watch.frames.push_back(frameTime(k));
        const bool goesBeyond = end() < flowEnd();
        if (goesBeyond) watch.frames.push_back(end());
        watch.onFrame = [this, endFrame, goesBeyond](const State<Dim>& state) {
            if (m_frame < endFrame) return takeFrame(state);
            if (goesBeyond) m_atTime = state;
        };
        return watch;
    }

    AdvanceResult integrate() {
        auto watch = watchFor(0, m_options.outputs.hasFrames() ? m_options.outputs.count : 0);
        if (!m_states.empty())
            watch.onStep = [this](const StepRecord<Dim>& step) {
                for (StatesWriter<Dim>& states : m_states) states.add(step);
                if (m_states.front().isDue()) keepState();
            };
        watch.enough = end();
        const AdvanceResult result = m_deformer.advance(flowEnd(), watch);
        const double time = m_deformer.state().time;
        if (!m_states.empty() && time > 0 && m_states.front().reached() != time) keepState();
        return result;
    }

    void keepState() {
        for (StatesWriter<Dim>& states : m_states)
            states.checkpoint(m_deformer.state(), m_deformer.statistics());
        if (m_watch.kept) m_watch.kept(*m_states.front().reached());
    }

    /// All from states that are there. A canvas that fits needs all frames.
    AdvanceResult runShard() {
        const int count = m_options.outputs.count, begin = m_options.shard->begin(count),
                  end = m_options.shard->end(count);
        const bool fits = m_options.canvas.kind == Canvas::Fit;
        const int first = fits ? 0 : begin, last = fits ? count : end;
        const double until = last > first ? frameTime(last - 1) : 0;
        if (until > m_known->reached())
            throw InputError(m_options.from, "holds the states up to time " +
                                                 shortNumber(m_known->reached()) +
                                                 " only: go on with them first (--from and --states)");
        m_painted = {begin, end};
        AdvanceResult result = m_deformer.advance(until, watchFor(first, last));
        if (result.outcome == Outcome::Cancelled) throw Cancelled();
        if constexpr (Dim == 2) writeWaitingFrames();
        if (begin == 0) writeCollections();
        m_files.commit();
        return result;
    }

    /// Ends the run at the first notice with --strict. The report stays if the deformed shape is the reason.
    void endIfStrict(bool ofShape) {
        if (!m_options.strict || m_notices.empty()) return;
        m_films.discard();
        m_files.discard();
        if (ofShape) writeReports();
        m_files.commit();
        throw NoticeError(m_notices, ofShape);
    }

    void writeAll() {
        warnOfColours();
        writeShapes();
    }

    void writeShapes() {
        const RunOutputs& outputs = m_options.outputs;
        const Points<Dim> pose = m_deformer.state().points;
        for (const std::string& path : outputs.velocity) writeVelocity(path, pose);
        for (const std::string& path : outputs.mesh) writeMesh(path, pose);
        writePoints(pose);
        if constexpr (Dim == 2) {
            writePictures(pose);
            writeMaterial();
            writeWaitingFrames();
            writeFilms();
        }
        writeAnimations();
        writeCollections();
    }

    bool wantsVelocity() const {
        return !m_options.outputs.velocity.empty() || (m_options.fields && !m_options.outputs.mesh.empty());
    }

    bool solveVelocity() {
        m_velocity = m_deformer.velocity(m_watch.stop);
        return m_velocity.cols() > 0;
    }

    /// No cell folds over, but one may be next to nothing, and a body may pass through another.
    void warnOfFaults() const {
        const double minimum = distortion<Dim>(*m_shape.rest, m_deformer.state().points).minDet;
        if (minimum < kCrushed)
            m_watch.notice("a cell has shrunk to " + shortNumber(minimum) + " of its size");
        if (Dim == 3 && !m_faults.crossings.empty()) m_watch.notice(crossingText(m_faults));
        if (const std::string turned = turnedOver<Dim>(m_shape, m_deformer.state().points); !turned.empty())
            m_watch.notice(turned);
    }

    void tellOfCanvas() const {
        if (m_watch.summary && m_canvas && m_options.canvas.kind != Canvas::Picture)
            m_watch.summary(canvasText(*m_canvas));
    }

    /// No format drops a colour profile without a word.
    void warnOfColours() const {
        if (!m_shape.picture) return;
        for (const FileNames* names : {&m_options.outputs.image, &m_options.outputs.frames})
            for (const std::string& path : *names)
                if (canWriteImage(path) && losesProfile(path, *m_shape.picture)) warnOfColoursIn(path);
        for (const std::string& path : m_options.outputs.films)
            if (!m_shape.picture->iccProfile().empty() && filmFormatOf(path)->id != FilmFormat::Webp)
                warnOfColoursIn(path);
    }

    void warnOfColoursIn(const std::string& path) const {
        m_watch.notice(path +
                       ": the format holds no colour profile: the colours' numbers are kept as they are");
    }

    /// Reports faults of poses. Parts of a picture may overlap each other in the order of their depth.
    void tellOfFaults() const {
        if (!m_watch.summary) return;
        if (Dim == 2 && !m_faults.crossings.empty()) m_watch.summary(crossingText(m_faults));
        if (!m_faults.blown.empty()) m_watch.summary(blownText(m_faults));
    }

    /// The numbers that are written are those that were checked, but for the one format that rounds them.
    void warnOfRounding(const std::string& path, const Points<Dim>& pose) const {
        const bool rounds =
            lowerExtension(path) == ".stl" && m_options.meshes.encoding != MeshWriteOptions::Encoding::Text;
        if (!rounds) return;
        Points<3> points = Points<3>::Zero(3, pose.cols());
        points.topRows<Dim>() = pose;
        if (const std::string text = roundingText(points); !text.empty()) m_watch.notice(path + ": " + text);
        if (Dim == 3) return;
        const Points<Dim> rounded = pose.template cast<float>().template cast<double>();
        if (const int flips = distortion<Dim>(*m_shape.rest, rounded).flips; flips > 0)
            m_watch.notice(
                path + ": " + std::to_string(flips) +
                " triangles are turned over by the single precision of binary STL; --encoding text "
                "keeps all digits");
    }

    void tellOfLosses(const std::string& path) const {
        const std::string lost = lostInShape<Dim>(path, m_shape, m_options.meshes);
        if (!lost.empty()) m_watch.notice(path + ": " + lost);
    }

    void writeMesh(const std::string& path, const Points<Dim>& pose) {
        warnOfRounding(path, pose);
        tellOfLosses(path);
        std::vector<MeshField> fields;
        if (m_options.fields) fields = fieldsFor(path, m_shape, pose, m_velocity);
        m_files.add(path, ".vtu", [&](const std::string& file) {
            writeShape(file, m_shape, pose, fields, m_options.meshes);
        });
    }

    void writeVelocity(const std::string& path, const Points<Dim>& pose) {
        if (m_velocity.cols() == 0) return;
        const bool table = path == "-" || lowerExtension(path) == ".csv";
        m_files.add(path, ".csv", [&](const std::string& file) {
            if (table)
                return writeTextFile(
                    file, velocityTable<Dim>(writtenPart(m_shape, pose), writtenPart(m_shape, m_velocity)));
            const auto fields = shapeFields(m_shape, pose, m_velocity);
            writeShape(file, m_shape, pose, {fields.back()}, m_options.meshes);
        });
    }

    // --- Points ---

    /// Reads them, and finds their places at rest unless the map is the inverse one.
    void readPoints() {
        for (const PointsOutput& one : m_options.outputs.points) {
            const PointFile& file = m_pointFiles.emplace_back(one.in, pointDimension());
            file.requireHeldBy(one.out);
            if (const std::string lost = file.lostIn(one.out, m_options.meshes); !lost.empty())
                m_watch.notice(one.out + ": " + lost);
            if (!m_options.inverse) m_pointMaps.push_back(pointMap(file, *carrier(), 0));
        }
    }

    /// Points of a flat mesh in another plane than that of x and y have three coordinates.
    int pointDimension() const {
        if constexpr (Dim == 2) return m_shape.plane.isXy() ? 2 : 3;
        return Dim;
    }

    /// Returns the mesh that carries points, with the attached parts of a picture.
    std::shared_ptr<const SimplicialMesh<Dim>> carrier() const {
        if constexpr (Dim == 2) return drawnRest(m_shape);
        return m_shape.rest;
    }
    Points<Dim> carrierIn(const Points<Dim>& pose) const {
        if constexpr (Dim == 2)
            if (m_shape.texture) return m_shape.texture->withRiders(pose);
        return pose;
    }

    PointMap<Dim> pointMap(const PointFile& file, const SimplicialMesh<Dim>& from, double time) {
        std::vector<float> order;
        if constexpr (Dim == 2) order = depths(time);
        PointMap<Dim> map(from, order, ownCoordinates(m_shape, file.points()));
        const auto tellOf = [&](int count, const std::string& where) {
            if (count > 0)
                m_watch.notice(file.path() + ": " + std::to_string(count) + " of " +
                               std::to_string(file.points().cols()) + " points " +
                               (count == 1 ? "lies " : "lie ") + where);
        };
        tellOf(
            map.outside(),
            "outside the shape: such points follow the nearest place of its border, as the shape turns and "
            "stretches there");
        tellOf(map.covered(), std::string("where the shape covers itself: ") +
                                  (Dim == 2 ? "the front counts" : "the last cell there counts"));
        return map;
    }

    void writePoints(const Points<Dim>& pose) {
        const auto rest = carrier();
        const Points<Dim> bent = carrierIn(pose);
        for (std::size_t k = 0; k < m_pointFiles.size(); ++k) {
            const PointFile& file = m_pointFiles[k];
            Points<Dim> own;
            if (m_options.inverse) {
                SimplicialMesh<Dim> from = *rest;
                from.points = bent;
                own = pointMap(file, from, m_deformer.state().time).mapped(rest->points);
            } else {
                own = m_pointMaps[k].mapped(bent);
            }
            const Points<3> points = inSpace(m_shape, file.points(), own);
            m_files.add(m_options.outputs.points[k].out, ".csv",
                        [&](const std::string& to) { file.write(to, points, m_options.meshes); });
        }
    }

    const std::vector<float>& depths(double time) {
        const auto mesh = drawnRest(m_shape);
        return *m_depths.of(depthOf(m_project), mesh, partLevels(domainOf(m_project).parts, *mesh, time));
    }

    WarpOptions warpOptions(double time, const std::function<void(double)>& progress) {
        if (!m_painters) m_painters = cellPainters(m_options.backEnd, {}, m_watch.notice, m_device);
        WarpOptions options = warpOptionsOf(m_project, m_options);
        options.depth = depths(time);
        if constexpr (Dim == 2)
            if (m_shape.texture) options.blends = m_shape.texture->blends();
        const auto [width, height] = canvasSize(m_shape);
        options.frameWidth = width, options.frameHeight = height;
        options.makePainter = m_painters;
        options.stop = m_watch.stop;
        options.progress = progress;
        return options;
    }

    /// Returns the picture at a time in the pixels of `view`.
    WarpedPicture warped(double time, const Points<2>& pixels, const View& view,
                         const std::function<void(double)>& progress) {
        WarpOptions options = warpOptions(time, progress);
        if (view.scale != 1) options.restMargin = 0;  // in pixels of the picture in its own size
        return {*m_shape.picture, restInPixels(m_shape), pixels, view, options};
    }

    void writeLayers(const std::string& file, double time, const Points<2>& pixels, const View& view) {
        const WarpOptions options = warpOptions(time, {});
        const auto levels = partLevels(domainOf(m_project).parts, *drawnRest(m_shape), time);
        const auto layers = warpedLayers(m_shape, pixels, levels, view, options);
        const Image merged = warpImage(*m_shape.picture, restInPixels(m_shape), pixels, view, options);
        if (isLayeredFile(file))
            writeOpenRaster(file, layers, merged);
        else
            writeLayeredExr(file, merged, layers, m_options.depth);
    }

    void writeSvg(const std::string& file, double time, const Points<2>& pixels, const View& view) {
        if (!m_svg) m_svg.emplace(m_project, folderOf(m_path), m_watch.notice);
        const auto levels = partLevels(domainOf(m_project).parts, *drawnRest(m_shape), time);
        writeTextFile(file, m_svg->text(m_shape, pixels, levels, view, warpOptions(time, {})));
    }

    /// Throws Cancelled.
    void writePicture(const std::string& file, const WarpedPicture& picture) const {
        writeWarped(file, picture, m_options.depth, m_options.lossy);
    }

    /// Tells what is between the fractions `from` and `to` of the warping.
    std::function<void(double)> warping(double from, double to) const {
        if (!m_watch.progress) return {};
        return [this, from, to](double done) { m_watch.progress("warping", from + (to - from) * done); };
    }

    Extent<2> extent(const Points<2>& pixels) const {
        return extentOf<2>(pixels, restInPixels(m_shape).cells);
    }

    void writePictures(const Points<2>& pose) {
        const RunOutputs& outputs = m_options.outputs;
        if (outputs.image.empty() && outputs.stMap.empty()) return;
        const Points<2> pixels = inPixels(m_shape, pose);
        const auto size = canvasSize(m_shape);
        const View view = canvasView(size, extent(pixels), m_options.canvas);
        const double time = m_deformer.state().time;
        m_canvas = view;
        const double count = static_cast<double>(outputs.image.size());
        for (std::size_t k = 0; k < outputs.image.size(); ++k) {
            const double done = static_cast<double>(k);
            m_files.add(outputs.image[k], ".png", [&](const std::string& file) {
                if (isSvgFile(file)) return writeSvg(file, time, pixels, view);
                if (isLayeredFile(file) || getsPartChannels(file, m_shape))
                    return writeLayers(file, time, pixels, view);
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

    void writeMaterial() {
        const bool isPicture = domainOf(m_project).kind == DomainKind::Image;
        const auto size = isPicture ? canvasSize(m_shape) : std::array{0, 0};
        for (const MaterialPart part : kMaterialParts)
            for (const std::string& path : m_options.outputs.material[static_cast<std::size_t>(part)])
                m_files.add(path, ".png", [&](const std::string& file) {
                    const PictureFrame frame = pictureFrame(size[0], size[1], *m_shape.rest);
                    writeImage(file, materialPicture(part, frame, *m_shape.rest, *m_shape.material));
                });
    }

    bool isPainted(int frame) const {
        return !m_painted || (frame >= m_painted->first && frame < m_painted->second);
    }

    void takeFrame(const State<Dim>& state) {
        const int number = m_frame++;
        bool hasPictures = !m_options.outputs.films.empty(), hasAnimations = false;
        for (const std::string& pattern : m_options.outputs.frames) {
            if (Dim == 2 && (canWriteImage(pattern) || isSvgFile(pattern)))
                hasPictures = true;
            else if (isAnimation(pattern))
                hasAnimations = true;
            else
                takeMeshFrame(pattern, number, state);
        }
        if constexpr (Dim == 2)
            if (hasPictures) takePictureFrame(number, inPixels(m_shape, state.points));
        if (hasAnimations) m_animation.push_back(state.points);
    }

    void takeMeshFrame(const std::string& pattern, int number, const State<Dim>& state) {
        std::vector<MeshField> fields;
        const std::string name = frameName(pattern, number);
        if (m_options.fields) fields = fieldsFor(name, m_shape, state.points);
        warnOfRounding(name, state.points);
        if (number == 0) tellOfLosses(name);
        m_files.add(name, "", [&](const std::string& file) {
            writeShape(file, m_shape, state.points, fields, m_options.meshes);
        });
    }

    void writeCollections() {
        for (const std::string& pattern : m_options.outputs.numberedFrames())
            if (!collectionName(pattern).empty()) writeCollection(pattern);
    }

    void writeCollection(const std::string& pattern) {
        std::vector<std::string> names;
        std::vector<double> times;
        for (int k = 0; k < m_options.outputs.count && (m_options.shard || k < m_frame); ++k) {
            const std::string name = frameName(pattern, k);
            names.push_back(std::filesystem::path(name).filename().string());
            times.push_back(frameTime(k));
        }
        m_files.add(collectionName(pattern), "",
                    [&](const std::string& file) { writeTextFile(file, collectionText(names, times)); });
    }

    /// One file holds all its poses.
    void writeAnimations() {
        for (const std::string& path : m_options.outputs.frames) {
            if (!isRigFile(path)) continue;
            if constexpr (Dim == 2)
                writeRigOf(path);
            else
                m_files.add(path, ".glb", [&](const std::string& file) {
                    writeAnimation(file, m_shape, m_animation, m_options.outputs.framesPerSecond);
                });
        }
    }

    void writeRigOf(const std::string& path) {
        std::vector<std::vector<int>> levels;
        const auto mesh = drawnRest(m_shape);
        for (std::size_t k = 0; k < m_animation.size(); ++k)
            levels.push_back(partLevels(domainOf(m_project).parts, *mesh, frameTime(static_cast<int>(k))));
        const Rig rig = makeRig(m_shape, m_animation, depths(0), levels, m_options.outputs.framesPerSecond);
        if (const std::string lost = lostInRig(path, rig); !lost.empty()) m_watch.notice(path + ": " + lost);
        writeRig(path, rig, m_files);
    }

    /// A canvas that fits is known only when all frames are.
    void takePictureFrame(int number, const Points<2>& pixels) {
        const Extent<2> shape = extent(pixels);
        if (m_options.canvas.kind != Canvas::Fit)
            return writePictureFrames(
                number, pixels, canvasView(canvasSize(m_shape), shape, m_options.canvas.forFrames()), {});
        if (!m_waiting) {
            const FileNames films = m_options.outputs.filmFiles();
            m_waiting.emplace(films.empty() ? m_options.outputs.numberedFrames().front() : films.front());
            m_allFrames = shape;
        }
        m_allFrames.low = m_allFrames.low.cwiseMin(shape.low);
        m_allFrames.high = m_allFrames.high.cwiseMax(shape.high);
        m_waiting->add(pixels);
    }

    void writeWaitingFrames() {
        if (!m_waiting) return;
        const View view = canvasView(canvasSize(m_shape), m_allFrames, m_options.canvas.forFrames());
        const double count = m_waiting->count();
        for (int k = 0; k < m_waiting->count(); ++k) {
            if (!isPainted(k)) continue;
            tell("warping", k / count);
            writePictureFrames(k, m_waiting->read(k), view, warping(k / count, (k + 1) / count));
        }
    }

    void writePictureFrames(int number, const Points<2>& pixels, const View& view,
                            const std::function<void(double)>& progress) {
        m_canvas = view;
        const FileNames numbered = m_options.outputs.numberedFrames();
        for (const std::string& pattern : numbered)
            if (isSvgFile(pattern))
                m_files.add(frameName(pattern, number), "", [&](const std::string& file) {
                    writeSvg(file, frameTime(number), pixels, view);
                });
        if (m_options.outputs.filmFiles().empty() && std::ranges::none_of(numbered, canWriteImage)) return;
        const WarpedPicture picture = warped(frameTime(number), pixels, view, progress);
        for (const std::string& pattern : numbered)
            if (canWriteImage(pattern))
                m_files.add(frameName(pattern, number), "",
                            [&](const std::string& file) { writePicture(file, picture); });
        m_films.add(m_options.outputs.filmFiles(), picture);
    }

    void writeFilms() {
        if (m_films.any()) tell("encoding", 0);
        m_films.finish();
    }

    FilmOptions filmOptions() const {
        const RunOutputs& outputs = m_options.outputs;
        FilmOptions film{outputs.framesPerSecond, m_options.lossy, outputs.count, {}, m_watch.stop};
        if (m_project.audio.empty()) return film;
        film.sound.file = pathIn(folderOf(m_path), m_project.audio);
        film.sound.from = frameSpan(m_project, end(), outputs).from;
        return film;
    }

    void writeReports() {
        if (m_options.outputs.report.empty()) return;
        const Points<Dim>& pose = m_deformer.state().points;
        const std::chrono::duration<double> total = Clock::now() - m_start;
        const RunFigures figures{
            static_cast<int>(writtenPart(m_shape, pose).cols()),
            m_shape.rest->cellCount(),
            Dim,
            m_deformer.state().time,
            total.count(),
            m_deformer.backEndName(),
            m_deformer.deviceName(),
            nameOf(m_deformer.solver()),
            distortionOf<Dim>(m_options.backEnd, *m_shape.rest, {}, m_watch.notice, m_device)(pose),
            m_deformer.statistics(),
            m_deformer.restEnergy(),
            m_deformer.restForce(),
            faultsJson(m_faults),
            qualityJson<Dim>(*m_shape.rest, pose),
            m_shape.verdict,
            m_shape.cage,
            m_canvas,
            reachedAt(designOf(m_project), m_deformer.state().time),
            m_notices};
        const std::string text = reportJson(figures);
        for (const std::string& path : m_options.outputs.report)
            m_files.add(path, ".json", [&](const std::string& file) { writeTextFile(file, text); });
    }

    const Project& m_project;
    const std::string m_path;  // of the project
    const Shape<Dim> m_shape;
    const RunOptions& m_options;
    std::mutex m_noticing;
    std::vector<std::string> m_notices;  // for the report
    const RunWatch m_watch;
    Clock::time_point m_start;
    SharedDevice m_device;
    Deformer<Dim> m_deformer;
    CellDepths m_depths;                // of pictures
    std::optional<View> m_canvas;       // of the last picture
    MakeCellPainter m_painters;         // made with the first picture
    int m_frame = 0;                    // number of the next
    std::optional<PoseFile> m_waiting;  // frames, in pixels of the picture
    Extent<2> m_allFrames;              // around those that wait
    std::vector<Points<Dim>> m_animation;
    std::deque<PointFile> m_pointFiles;
    std::vector<PointMap<Dim>> m_pointMaps;  // from the rest
    std::optional<StatesReader<Dim>> m_known;
    std::deque<StatesWriter<Dim>> m_states;        // with the same states
    std::optional<State<Dim>> m_atTime;            // the shape that is wanted, within the states
    std::optional<std::pair<int, int>> m_painted;  // of the frames; none: all
    Points<Dim> m_velocity;
    PoseFaults<Dim> m_faults;  // of the pose at the end
    OutputSet m_files;
    FilmOutputs m_films{m_files, filmOptions()};
    std::optional<SvgExport> m_svg;  // made with the first SVG file
};

/// A shape that ends before its cycle has none of its frames.
void requireSpan(const Project& project, const RunOptions& options) {
    if (!options.outputs.hasFrames()) return;
    const FrameSpan span = frameSpan(project, options.at.value_or(endOf(project)), options.outputs);
    if (span.from >= span.to && options.outputs.loop)
        throw InputError("time.cycle: begins at " + shortNumber(span.from) + ", where the motion is over");
}

bool writesPictures(const RunOutputs& outputs) {
    return !outputs.image.empty() || !outputs.stMap.empty() || !outputs.films.empty() ||
           std::ranges::any_of(outputs.frames, canWriteImage);
}

}  // namespace

AdvanceResult runProject(const Project& project, const std::string& path, const RunOptions& options,
                         const RunWatch& watch) try {
    const Clock::time_point start = Clock::now();
    requirePossible(project, options.outputs);
    requireSpan(project, options);
    for (const FileNames* pictures : {&options.outputs.image, &options.outputs.frames})
        for (const std::string& file : *pictures) {
            requireDepth(file, options);
            requireDrawing(file, project, folderOf(path), options);
        }
    if (watch.progress) watch.progress("reading", 0);
    const std::jthread loading = writesPictures(options.outputs) ? loadPictureLibrary() : std::jthread();
    requireNothingOutside(project, options);
    AnyShape shape = loadShape(project, folderOf(path), watch.stop);
    std::vector<Message> notices = std::visit([](const auto& one) { return one.notices; }, shape);
    if (const std::string note = fallsShort(project); !note.empty() && !options.at) notices.push_back(note);
    for (const Message& notice : notices)
        if (watch.notice) watch.notice(notice);
    RunOptions heard = options;
    heard.notices.insert(heard.notices.end(), notices.begin(), notices.end());
    if (options.strict && !heard.notices.empty()) throw NoticeError(heard.notices, false);
    return std::visit(
        [&]<int Dim>(Shape<Dim>& one) {
            return Run<Dim>(project, path, std::move(one), heard, watch, start).run();
        },
        shape);
} catch (const InputError& error) {
    if (!error.file().empty()) throw;
    throw error.named(path);
} catch (const NotEnoughMemory& error) {
    throw OutOfMemory(path, std::string(error.what()) + ": " + adviceOnMemory(project));
}

}  // namespace wend
