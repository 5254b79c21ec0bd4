#pragma once

#include <array>
#include <functional>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

#include "app/project/design.h"
#include "app/project/pixel_rect.h"
#include "app/project/project_fwd.h"
#include "core/assembly/back_end.h"
#include "core/base/message.h"
#include "core/mesh/mesh_write_options.h"
#include "core/mesh/used_vertices.h"
#include "core/solver/iterative_solver.h"
#include "warp/image.h"
#include "warp/sampling.h"

namespace wend {

struct AdvanceResult;
template <int Dim>
struct Shape;

using FileNames = std::vector<std::string>;

/// A file of points and where the mapped ones are written.
struct PointsOutput {
    std::string in, out;
};

/// The outputs of a run, each written to any number of files; "-" is standard output.
struct RunOutputs {
    FileNames image, mesh, velocity, stMap, report;
    std::array<FileNames, 3> material;  // by MaterialPart: at rest, of what there is in the plane
    FileNames frames;             // with #### for the number, counted from 0; or one file, see isAnimation()
    FileNames films;              // of pictures, by their extensions, see filmFormats()
    int count = 25;               // of frames and a film's pictures, at equal times
    bool loop = false;            // the end of the motion or the cycle, which is like its start, has no frame
    double framesPerSecond = 24;  // of a film
    FileNames states;             // see StatesWriter
    std::vector<PointsOutput> points;

    /// Returns the names of all that is one file or a collection beside numbered frames.
    FileNames singleFiles() const;
    /// Returns the names of sequences whose frames are files of their own.
    FileNames numberedFrames() const;
    /// Returns the names of the films of pictures.
    FileNames filmFiles() const;
    bool hasFrames() const { return !frames.empty() || !films.empty(); }
    bool any() const;
};

/// The I-th of N parts of the frames: consecutive ones, as many in each as possible.
struct Shard {
    int index = 1, count = 1;

    int begin(int frames) const { return part(index - 1, frames); }
    int end(int frames) const { return part(index, frames); }

  private:
    int part(int k, int frames) const { return static_cast<int>(static_cast<long>(k) * frames / count); }
};

/// Selects the part of the plane that a picture shows: as large as the source, as large as the shape needs,
/// or a part of the source.
enum class Canvas { Picture, Fit, Part };
struct CanvasChoice {
    CanvasChoice(Canvas as = Canvas::Picture) : kind(as) {}
    Canvas kind;
    PixelRect part;     // of Canvas::Part
    double scale = 1;   // of the pixels that are written
    int width = 0;      // of what is written, in pixels, in the place of `scale` if it is positive
    bool even = false;  // a canvas that fits or is scaled has an even width and height

    /// Returns the canvas for pictures that follow each other, whose sizes are even because encoders of films
    /// need that.
    CanvasChoice forFrames() const {
        CanvasChoice canvas = *this;
        canvas.even = true;
        return canvas;
    }
    bool isScaled() const { return scale != 1 || width > 0; }
};

/// Makers of the solvers by multigrid; if empty, this process solves.
struct RunSolvers {
    IterativeSolverFactory<2> plane;
    IterativeSolverFactory<3> space;

    template <int Dim>
    const IterativeSolverFactory<Dim>& of() const {
        if constexpr (Dim == 2)
            return plane;
        else
            return space;
    }
};

struct RunOptions {
    RunOutputs outputs;
    std::optional<double> at;    // instead of the project's end
    std::string from;            // a file of states to continue from
    std::optional<Shard> shard;  // of the frames: then nothing else is written, and all comes from the states
    BackEndKind backEnd = BackEndKind::Automatic;
    RunSolvers solvers;
    Filter filter = Filter::Ewa;
    CanvasChoice canvas;
    std::optional<PixelType> depth;  // of pictures; without: the source's
    Outside outside = Outside::Transparent;
    std::array<float, 4> colour = {0, 0, 0, 0};  // of Outside::Colour
    bool lossy = false;                          // of WebP
    bool fields = true;  // meshes have distortion, φ, B and velocity if the format supports them
    MeshWriteOptions meshes;
    bool inverse = false;  // points are mapped from the deformed shape to the rest
    bool partial = false;  // if the deformation stops early, write the last good shape anyway
    bool strict = false;   // a notice ends the run, see NoticeError
    std::vector<std::string> notices = {};  // that the report lists before those of the run
};

/// Thrown for a notice that ends a run with RunOptions::strict.
class NoticeError : public std::runtime_error {
  public:
    NoticeError(const std::vector<std::string>& notices, bool ofShape)
        : std::runtime_error(
              notices.front() +
              (notices.size() == 1 ? "" : " (and " + std::to_string(notices.size() - 1) + " more)")),
          m_ofShape(ofShape) {}
    /// Returns true if the deformed shape is the reason, false if the input or what was asked of it is.
    bool isOfShape() const { return m_ofShape; }

  private:
    bool m_ofShape;
};

struct RunWatch {
    /// Gets a description of the current work, and the fraction of it that is done, in [0, 1].
    std::function<void(const std::string& work, double fraction)> progress;
    /// Gets a sentence that the user should read, such as that a device failed and the processor continues.
    std::function<void(const Message& text)> notice;
    std::stop_token stop;
    /// Gets one line about the result when everything is written.
    std::function<void(const std::string& text)> summary = {};
    /// Gets the time up to which the file of states is complete, whenever that grows.
    std::function<void(double time)> kept = {};
};

/// Throws InputError for an output that cannot be made: an unknown extension, a missing folder, a picture
/// asked of a project that has none. Looks at nothing but names, so it can come first.
void requirePossible(const Project& project, const RunOutputs& outputs);

/// Integrates the project in file `path` and writes the outputs: all of them, whole, or none. If the
/// deformation stops early, only the report is written, with the last good time (see RunOptions::partial).
/// Throws InputError, Cancelled, and NoticeError: for a notice about the deformed shape the report is written
/// nevertheless, else nothing is.
AdvanceResult runProject(const Project& project, const std::string& path, const RunOptions& options,
                         const RunWatch& watch = {});
/// Does the same with the project's shape, which is neither read nor meshed again.
template <int Dim>
AdvanceResult runShape(const Project& project, const std::string& path, const Shape<Dim>& shape,
                       const RunOptions& options, const RunWatch& watch = {});

/// Returns whether the frames are written to one file: a .webp of pictures, a .glb of a solid, without a
/// place for the number.
bool isAnimation(const std::string& frames);
/// Returns the name of the collection that is written beside .vtu frames: "dir/f_####.vtu" → "dir/f.pvd";
/// empty for other formats.
std::string collectionName(const std::string& pattern);

/// The times that frames are spread over, the second of which has none in a loop.
struct FrameSpan {
    double from = 0, to = 1;
};
/// Returns the frames from the start to `end`; in a loop those of the project's cycle, if it has one.
FrameSpan frameSpan(const Project& project, double end, const RunOutputs& outputs);
/// Returns how many frames such a span has at that rate.
int frameCount(const FrameSpan& span, double framesPerSecond, bool loop);

/// Returns the part of the plane that a picture shows of a shape (or of all frames of one) within that box.
/// Throws InputError for more pixels than pictures may have. `size` is that of the plane that is rendered.
View canvasView(const std::array<int, 2>& size, const Extent<2>& shapeInPixels, const CanvasChoice& canvas);

/// Returns the nodal velocities as rows "x,y[,z],vx,vy[,vz]" with 17 significant digits.
template <int Dim>
std::string velocityTable(const Points<Dim>& pose, const Points<Dim>& velocity);

}  // namespace wend
