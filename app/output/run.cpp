#include "app/output/run.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <filesystem>
#include <mutex>

#include "app/engine/shape/held_border.h"
#include "app/engine/shape/pose_faults.h"
#include "app/engine/shape/shape_builder.h"
#include "app/output/layer_export.h"
#include "app/output/output_set.h"
#include "app/output/picture_output.h"
#include "app/output/point_file.h"
#include "app/output/report.h"
#include "app/output/rig.h"
#include "app/output/rig_files.h"
#include "app/output/run_options.h"
#include "app/output/run_states.h"
#include "app/output/shape_file.h"
#include "app/output/svg_export.h"
#include "app/project/domain.h"
#include "app/project/file/named_files.h"
#include "app/project/file/text_file.h"
#include "app/project/options/options.h"
#include "app/project/project.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/base/input_file.h"
#include "core/base/memory.h"
#include "core/energy/distortion.h"
#include "core/integration/deformer.h"
#include "core/integration/stop_message.h"
#include "core/mesh/mesh_of_file.h"
#include "kernels/back_end_choice.h"
#include "warp/film_format.h"
#include "warp/image_formats.h"
#include "warp/layered_exr.h"
#include "warp/picture_library.h"

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
        if constexpr (Dim == 2)
            m_pictures.emplace(m_project, m_path, m_shape, m_options, m_watch, m_device, m_files,
                               filmOptions());
        m_points.emplace(
            m_shape, m_options, m_watch.notice,
            [this](double time) -> const std::vector<float>& { return m_pictures->depths(time); });
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
            discard();
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
    /// Returns the watch extended to keep notices for the report. Threads that paint may call its notice().
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

    /// Paints the frames of a shard from the known states. A canvas that fits the motion needs all frames.
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
        if (m_pictures) m_pictures->setShare(begin, end);
        AdvanceResult result = m_deformer.advance(until, watchFor(first, last));
        if (result.outcome == Outcome::Cancelled) throw Cancelled();
        if (m_pictures) m_pictures->writeWaitingFrames();
        if (begin == 0) writeCollections();
        m_files.commit();
        return result;
    }

    void discard() {
        if (m_pictures) m_pictures->discardFilms();
        m_files.discard();
    }

    /// Ends the run at the first notice with --strict. The report stays if the deformed shape is the reason.
    void endIfStrict(bool ofShape) {
        if (!m_options.strict || m_notices.empty()) return;
        discard();
        if (ofShape) writeReports();
        m_files.commit();
        throw NoticeError(m_notices, ofShape);
    }

    void writeAll() {
        warnOfColours();
        warnOfNumbers();
        warnOfNames();
        writeShapes();
    }

    void writeShapes() {
        const RunOutputs& outputs = m_options.outputs;
        const Points<Dim> pose = m_deformer.state().points;
        for (const std::string& path : outputs.velocity) writeVelocity(path, pose);
        for (const std::string& path : outputs.mesh) writeMesh(path, pose);
        const double time = m_deformer.state().time;
        m_points->write(time, pose, m_files);
        if constexpr (Dim == 2) {
            m_pictures->write(time, pose);
            m_pictures->writeMaterial();
            m_pictures->writeWaitingFrames();
            m_pictures->writeFilms();
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

    /// Reports cells that are nearly flat, and bodies that pass through one another; no cell is inverted.
    void warnOfFaults() const {
        const double minimum = distortion<Dim>(*m_shape.rest, m_deformer.state().points).minDet;
        if (minimum < kCrushed)
            m_watch.notice("a cell has shrunk to " + shortNumber(minimum) + " of its size");
        if (Dim == 3 && !m_faults.crossings.empty()) m_watch.notice(crossingText(m_faults));
        if (const std::string turned = turnedOver<Dim>(m_shape, m_deformer.state().points); !turned.empty())
            m_watch.notice(turned);
    }

    std::optional<View> canvas() const { return m_pictures ? m_pictures->canvas() : std::nullopt; }

    void tellOfCanvas() const {
        if (m_watch.summary && canvas() && m_options.canvas.kind != Canvas::Picture)
            m_watch.summary(canvasText(*canvas()));
    }

    /// Reports every output whose format drops the colour profile.
    void warnOfColours() const {
        if (!m_shape.picture) return;
        for (const FileNames* names : {&m_options.outputs.image, &m_options.outputs.frames})
            for (const std::string& path : *names)
                if (canWriteImage(path) && losesProfile(path, *m_shape.picture)) warnOfColoursIn(path);
        for (const std::string& path : m_options.outputs.films)
            if (!m_shape.picture->iccProfile().empty() && filmFormatOf(path)->id != FilmFormat::Webp)
                warnOfColoursIn(path);
    }

    /// Reports every output whose format does not hold the picture's numbers, unless --depth chooses others.
    void warnOfNumbers() const {
        if (!m_shape.picture) return;
        for (const FileNames* names : {&m_options.outputs.image, &m_options.outputs.frames})
            for (const std::string& path : *names) {
                if (!m_options.depth && roundsNumbers(path, m_shape.picture->type))
                    m_watch.notice(path +
                                   ": the format does not hold numbers of this depth: they are rounded");
                if (losesNegativeLight(path, *m_shape.picture))
                    m_watch.notice(path + ": the format holds no negative light: it becomes 0");
            }
    }

    /// Reports parts whose names are too long for channels of OpenEXR.
    void warnOfNames() const {
        if constexpr (Dim == 2)
            for (const FileNames* names : {&m_options.outputs.image, &m_options.outputs.stMap})
                for (const std::string& path : *names)
                    for (const PicturePart& part : domainOf(m_project).parts)
                        if (getsPartChannels(path, m_shape) && part.name.size() > kLongestChannelName)
                            m_watch.notice(path + ": the name of the part \"" + part.name.substr(0, 20) +
                                           "…\" is too long for channels: it is shortened");
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

    /// Repeats the checks on rounded numbers for binary STL, the only format that rounds them.
    void warnOfRounding(const std::string& path, const Points<Dim>& pose) const {
        const bool rounds =
            lowerExtension(path) == ".stl" && m_options.meshes.encoding != MeshWriteOptions::Encoding::Text;
        if (!rounds) return;
        Points3 points = Points3::Zero(3, pose.cols());
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
            if (hasPictures) m_pictures->takeFrame(number, frameTime(number), state.points);
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

    /// Writes the outputs that hold all poses in one file.
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
        const Rig rig =
            makeRig(m_shape, m_animation, m_pictures->depths(0), levels, m_options.outputs.framesPerSecond);
        if (const std::string lost = lostInRig(path, rig); !lost.empty()) m_watch.notice(path + ": " + lost);
        writeRig(path, rig, m_files);
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
            canvas(),
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
    int m_frame = 0;  // number of the next
    std::vector<Points<Dim>> m_animation;
    std::optional<StatesReader<Dim>> m_known;
    std::deque<StatesWriter<Dim>> m_states;  // with the same states
    std::optional<State<Dim>> m_atTime;      // the shape that is wanted, within the states
    Points<Dim> m_velocity;
    PoseFaults<Dim> m_faults;  // of the pose at the end
    OutputSet m_files;
    std::optional<PictureOutput> m_pictures;  // of a picture
    std::optional<MappedPoints<Dim>> m_points;
};

/// Throws InputError if the motion ends before its cycle begins, which would leave no frames.
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

/// Throws InputError for what cannot be made of the project, before anything is read.
void requireOutputs(const Project& project, const std::string& path, const RunOptions& options) {
    requirePossible(project, options.outputs);
    requireSpan(project, options);
    for (const FileNames* pictures : {&options.outputs.image, &options.outputs.frames})
        for (const std::string& file : *pictures) {
            requireDepth(file, options);
            requireDrawing(file, project, folderOf(path), options);
        }
    requireNothingOutside(project, options);
}

template <int Dim>
AdvanceResult runOf(const Project& project, const std::string& path, const Shape<Dim>& shape,
                    const RunOptions& options, const RunWatch& watch, Clock::time_point start) {
    std::vector<Message> notices = shape.notices;
    if (const std::string note = fallsShort(project); !note.empty() && !options.at) notices.push_back(note);
    for (const Message& notice : notices)
        if (watch.notice) watch.notice(notice);
    RunOptions heard = options;
    heard.notices.insert(heard.notices.end(), notices.begin(), notices.end());
    if (options.strict && !heard.notices.empty()) throw NoticeError(heard.notices, false);
    return Run<Dim>(project, path, shape, heard, watch, start).run();
}

/// Names the project's file in errors that name none, and advises where memory does not suffice.
template <class Work>
AdvanceResult withNamedErrors(const Project& project, const std::string& path, const Work& work) try {
    return work();
} catch (const InputError& error) {
    if (!error.file().empty()) throw;
    throw error.named(path);
} catch (const NotEnoughMemory& error) {
    throw OutOfMemory(path, std::string(error.what()) + ": " + adviceOnMemory(project));
}

}  // namespace

AdvanceResult runProject(const Project& project, const std::string& path, const RunOptions& options,
                         const RunWatch& watch) {
    const Clock::time_point start = Clock::now();
    return withNamedErrors(project, path, [&] {
        requireOutputs(project, path, options);
        if (watch.progress) watch.progress("reading", 0);
        const std::jthread loading = writesPictures(options.outputs) ? loadPictureLibrary() : std::jthread();
        const AnyShape shape = loadShape(project, folderOf(path), watch.stop);
        return std::visit([&](const auto& one) { return runOf(project, path, one, options, watch, start); },
                          shape);
    });
}

template <int Dim>
AdvanceResult runShape(const Project& project, const std::string& path, const Shape<Dim>& shape,
                       const RunOptions& options, const RunWatch& watch) {
    const Clock::time_point start = Clock::now();
    return withNamedErrors(project, path, [&] {
        requireOutputs(project, path, options);
        const std::jthread loading = writesPictures(options.outputs) ? loadPictureLibrary() : std::jthread();
        return runOf(project, path, shape, options, watch, start);
    });
}

template AdvanceResult runShape<2>(const Project&, const std::string&, const Shape<2>&, const RunOptions&,
                                   const RunWatch&);
template AdvanceResult runShape<3>(const Project&, const std::string&, const Shape<3>&, const RunOptions&,
                                   const RunWatch&);

}  // namespace wend
