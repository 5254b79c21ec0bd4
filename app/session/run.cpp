#include "app/session/run.h"

#include <chrono>
#include <filesystem>

#include "app/document/options.h"
#include "app/document/text_file.h"
#include "app/session/output_set.h"
#include "app/session/shape_file.h"
#include "core/mesh/error.h"
#include "kernels/back_end_choice.h"

namespace wend {
namespace {

using Clock = std::chrono::steady_clock;

/// "dir/f_####.png" and 7 → "dir/f_0007.png": the last run of # is the number.
std::string frameName(const std::string& pattern, int number) {
    const auto last = pattern.find_last_of('#');
    auto first = last;
    while (first > 0 && pattern[first - 1] == '#') --first;
    std::string digits = std::to_string(number);
    if (const std::size_t width = last - first + 1; digits.size() < width)
        digits.insert(0, width - digits.size(), '0');
    return pattern.substr(0, first) + digits + pattern.substr(last + 1);
}

constexpr double kCrushed = 1e-3;  // of a cell's measure at rest: the picture is ruined there

/// One run: the scene, its deformer, the frames that were passed, and the files that are being made.
template <int Dim>
class Run {
  public:
    Run(const Project& project, Scene<Dim> scene, const RunOptions& options, const RunWatch& watch,
        Clock::time_point start)
        : m_project(project),
          m_scene(std::move(scene)),
          m_options(options),
          m_watch(watch),
          m_start(start),
          m_deformer(m_scene.rest, m_scene.material, m_scene.handles, integrationOf(project),
                     backEndFactory<Dim>(options.backEnd, {}, watch.notice)) {}

    AdvanceResult run() {
        AdvanceResult result = integrate();
        if (result.outcome == Outcome::Cancelled) throw Cancelled();
        if (wantsVelocity() && !solveVelocity() && result.outcome == Outcome::Done)
            result = {Outcome::SolverFailed, result.time, -1, "the velocity field cannot be solved for"};
        if (result.outcome == Outcome::Done || m_options.partial) warnOfCrushedCells();
        if (result.outcome == Outcome::Done || m_options.partial) writeShapes();
        writeReport();
        m_files.commit();
        return result;
    }

  private:
    struct Frame {
        double time;
        Points<Dim> points;
    };

    double end() const { return m_options.at.value_or(m_project.end); }

    void tell(const std::string& work, double fraction) const {
        if (m_watch.stop.stop_requested()) throw Cancelled();
        if (m_watch.progress) m_watch.progress(work, fraction);
    }

    AdvanceResult integrate() {
        typename Deformer<Dim>::Watch watch;
        watch.stop = m_watch.stop;
        watch.progress = [this](double time) {
            if (m_watch.progress) m_watch.progress("deforming", end() > 0 ? time / end() : 1);
        };
        if (!m_options.outputs.frames.empty()) {
            const int count = m_options.outputs.count;
            for (int k = 0; k < count; ++k)
                watch.frames.push_back(k + 1 < count ? end() * k / (count - 1) : end());
            watch.onFrame = [this](const State<Dim>& state) {
                m_frames.push_back({state.time, state.points});
            };
        }
        return m_deformer.advance(end(), watch);
    }

    void writeShapes() {
        const RunOutputs& outputs = m_options.outputs;
        const Points<Dim> pose = m_deformer.state().points;
        if (!outputs.velocity.empty()) writeVelocity(pose);
        if (!outputs.mesh.empty()) writeMesh(pose);
        if constexpr (Dim == 2) writePictures(pose);
        writeFrames();
    }

    bool wantsVelocity() const {
        return !m_options.outputs.velocity.empty() || (m_options.fields && !m_options.outputs.mesh.empty());
    }

    bool solveVelocity() {
        m_velocity = m_deformer.velocity();
        return m_velocity.cols() > 0;
    }

    /// No cell folds over, but one may be next to nothing.
    void warnOfCrushedCells() const {
        const double least = distortion<Dim>(*m_scene.rest, m_deformer.state().points).minDet;
        if (least < kCrushed && m_watch.notice)
            m_watch.notice("a cell has shrunk to " + shortNumber(least) + " of its size");
    }

    void writeMesh(const Points<Dim>& pose) {
        std::vector<MeshField> fields;
        if (m_options.fields) fields = shapeFields(m_scene, pose, m_velocity);
        m_files.add(m_options.outputs.mesh, ".vtu", [&](const std::string& file) {
            writeShape(file, m_scene, pose, fields, m_options.meshes);
        });
    }

    void writeVelocity(const Points<Dim>& pose) {
        if (m_velocity.cols() == 0) return;
        const std::string& path = m_options.outputs.velocity;
        const bool table = path == "-" || lowerExtension(path) == ".csv";
        m_files.add(path, ".csv", [&](const std::string& file) {
            if (table) return writeTextFile(file, velocityTable<Dim>(pose, m_velocity));
            const auto fields = shapeFields(m_scene, pose, m_velocity);
            writeMeshFile(file, poseFile(m_scene, pose, {fields.back()}), m_options.meshes);
        });
    }

    /// The picture in the pixels of `view`, with progress between the fractions `from` and `to` of the
    /// writing.
    Image picture(const Points<2>& pixels, const View& view, double from, double to) const {
        WarpOptions options;
        options.filter = m_options.filter;
        options.threads = m_project.integration.threads;
        options.stop = m_watch.stop;
        if (m_watch.progress)
            options.progress = [this, from, to](double done) {
                m_watch.progress("warping", from + (to - from) * done);
            };
        return warpImage(*m_scene.picture, *m_scene.texture.rest, pixels, view, options);
    }

    void writePictures(const Points<2>& pose) {
        const RunOutputs& outputs = m_options.outputs;
        if (outputs.image.empty() && outputs.stMap.empty()) return;
        const Points<2> pixels = m_scene.texture.toPixels(pose);
        const View view = canvasView(*m_scene.picture, {pixels}, m_options.canvas);
        if (!outputs.image.empty())
            m_files.add(outputs.image, ".png",
                        [&](const std::string& file) { writeImage(file, picture(pixels, view, 0, 1)); });
        if (!outputs.stMap.empty())
            m_files.add(outputs.stMap, ".exr", [&](const std::string& file) {
                writeImage(file, stMap(*m_scene.texture.rest, pixels, view, m_scene.picture->width,
                                       m_scene.picture->height));
            });
    }

    void writeFrames() {
        const std::string& pattern = m_options.outputs.frames;
        if (pattern.empty()) return;
        if constexpr (Dim == 2)
            if (canWriteImage(pattern)) return writePictureFrames(pattern);
        if constexpr (Dim == 3)
            if (isAnimation(pattern)) return writeAnimatedFrames(pattern);
        writeMeshFrames(pattern);
    }

    void writeMeshFrames(const std::string& pattern) {
        std::vector<std::string> names;
        std::vector<double> times;
        for (std::size_t k = 0; k < m_frames.size(); ++k) {
            tell("writing frames", static_cast<double>(k) / m_frames.size());
            std::vector<MeshField> fields;
            if (m_options.fields) fields = shapeFields(m_scene, m_frames[k].points);
            const std::string name = frameName(pattern, static_cast<int>(k));
            m_files.add(name, "", [&](const std::string& file) {
                writeShape(file, m_scene, m_frames[k].points, fields, m_options.meshes);
            });
            names.push_back(std::filesystem::path(name).filename().string());
            times.push_back(m_frames[k].time);
        }
        if (const std::string collection = collectionName(pattern); !collection.empty())
            m_files.add(collection, "",
                        [&](const std::string& file) { writeTextFile(file, collectionText(names, times)); });
    }

    void writeAnimatedFrames(const std::string& path) {
        std::vector<Points<Dim>> poses;
        for (const Frame& frame : m_frames) poses.push_back(frame.points);
        m_files.add(path, ".glb", [&](const std::string& file) {
            writeAnimation(file, m_scene, poses, m_options.outputs.framesPerSecond);
        });
    }

    void writePictureFrames(const std::string& pattern) {
        std::vector<Points<2>> poses;
        for (const Frame& frame : m_frames) poses.push_back(m_scene.texture.toPixels(frame.points));
        const View view = canvasView(*m_scene.picture, poses, m_options.canvas);
        for (std::size_t k = 0; k < poses.size(); ++k) {
            const double from = static_cast<double>(k) / poses.size(),
                         to = static_cast<double>(k + 1) / poses.size();
            tell("warping", from);
            m_files.add(frameName(pattern, static_cast<int>(k)), "", [&](const std::string& file) {
                writeImage(file, picture(poses[k], view, from, to));
            });
        }
    }

    void writeReport() {
        const std::string& path = m_options.outputs.report;
        if (path.empty()) return;
        const Points<Dim>& pose = m_deformer.state().points;
        const std::chrono::duration<double> total = Clock::now() - m_start;
        const RunFigures figures{m_scene.rest->vertexCount(),
                                 m_scene.rest->cellCount(),
                                 Dim,
                                 m_deformer.state().time,
                                 total.count(),
                                 m_deformer.backEndName(),
                                 m_deformer.deviceName(),
                                 distortion(*m_scene.rest, pose),
                                 m_deformer.statistics()};
        m_files.add(path, ".json",
                    [&](const std::string& file) { writeTextFile(file, reportJson(figures)); });
    }

    const Project& m_project;
    const Scene<Dim> m_scene;
    const RunOptions& m_options;
    const RunWatch& m_watch;
    Clock::time_point m_start;
    Deformer<Dim> m_deformer;
    std::vector<Frame> m_frames;
    Points<Dim> m_velocity;
    OutputSet m_files;
};

}  // namespace

AdvanceResult runProject(const Project& project, const std::string& path, const RunOptions& options,
                         const RunWatch& watch) try {
    const Clock::time_point start = Clock::now();
    requirePossible(project, options.outputs);
    if (watch.progress) watch.progress("reading", 0);
    AnyScene scene = loadScene(project, folderOf(path), watch.stop);
    return std::visit(
        [&]<int Dim>(Scene<Dim>& one) {
            for (const std::string& notice : one.notices)
                if (watch.notice) watch.notice(notice);
            return Run<Dim>(project, std::move(one), options, watch, start).run();
        },
        scene);
} catch (const InputError& error) {
    throw error.named(path);
}

}  // namespace wend
