#pragma once

#include "app/engine/motion/frame.h"
#include "app/output/run.h"
#include "app/project/edits/document.h"
#include "warp/blend_mode.h"

namespace wend {

struct WarpOptions;

enum class ExportKind { Picture, Film, Frames, StMap, Mesh };

/// Returns whether it is all of the motion that is exported.
constexpr bool isMotion(ExportKind kind) {
    return kind == ExportKind::Film || kind == ExportKind::Frames;
}

/// How far a shape reaches beyond the sides of its picture, in whole pixels; zeros where it does not.
struct Overhang {
    int left = 0, top = 0, right = 0, bottom = 0;

    bool any() const { return left + top + right + bottom > 0; }
};

/// A frame of the window with everything that is needed to write it: immutable values, for any thread. The
/// files are the same as those that `wend run` writes of the same shape.
class FrameExport {
  public:
    /// `motion` has all frames, and `seconds` is their duration.
    FrameExport(const Document& document, FramePtr frame, std::vector<FramePtr> motion, double seconds);

    int dimension() const { return m_frame->dimension; }
    const FramePtr& frame() const { return m_frame; }
    double seconds() const { return m_seconds; }
    double frameRate() const;
    /// Returns the frames of a sequence or film.
    FrameSpan span(bool loop) const;
    bool hasParts() const { return !m_levels.empty(); }
    /// Returns whether the picture, or a part of it, is an SVG drawing whose paths can be written.
    bool hasDrawing() const;
    /// Returns the number of vertices in a mesh file with this extension.
    int vertexCount(const std::string& extension) const;

    /// Returns the picture that the shape carries, or null; rest and pose are in its pixels.
    const std::shared_ptr<const Image>& picture() const { return m_picture; }
    const SimplicialMesh<2>& restInPixels() const { return *m_rest; }
    const Points2& poseInPixels() const { return m_pose; }
    /// Returns the source position of every pixel of the picture.
    Image stMapOf(const View& view) const;
    const std::vector<float>& depths() const { return m_depths; }
    /// Returns the view that the canvas shows; for a sequence or film, of all of its frames: see span().
    /// Throws InputError.
    View view(ExportKind kind, const CanvasChoice& canvas, bool loop = false) const;
    /// Returns what a canvas of the picture's size cuts off.
    Overhang overhang(ExportKind kind, bool loop = false) const;
    WarpOptions warpOptions(const RunOptions& options) const;

    /// Writes the file, all of a sequence, whose name contains ####, or a film. `remark` receives what the
    /// user should know about the files. Throws InputError and Cancelled.
    void write(ExportKind kind, const std::string& path, const RunOptions& options, const RunWatch& watch,
               std::string& remark) const;

  private:
    void writePicture(const std::string& path, const View& view, const RunOptions& options,
                      const RunWatch& watch) const;
    void writeStMap(const std::string& path, const View& view) const;
    template <int Dim>
    void writeMesh(const std::string& path, const RunOptions& options, const RunWatch& watch,
                   std::string& remark) const;
    void writeMesh(const std::string& path, const RunOptions& options, const RunWatch& watch,
                   std::string& remark) const;
    void writeFrames(ExportKind kind, const std::string& path, const RunOptions& options,
                     const RunWatch& watch) const;
    Extent<2> extent(ExportKind kind, bool loop) const;

    std::shared_ptr<const Project> m_project;
    std::string m_name;  // of the project, for messages and paths
    FramePtr m_frame;
    std::vector<FramePtr> m_motion;
    double m_seconds = 0;
    std::shared_ptr<const Image> m_picture;
    std::shared_ptr<const SimplicialMesh<2>> m_rest, m_source;  // the second: see sourceRest()
    std::array<int, 2> m_size{};                                // of the plane that is rendered
    Points2 m_pose;
    std::vector<BlendMode> m_blends;
    std::vector<int> m_levels;    // of parts: see partLevels()
    std::vector<float> m_depths;  // per cell: see WarpOptions
};

}  // namespace wend
