#pragma once

#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/engine/shape/depth.h"
#include "app/engine/shape/shape.h"
#include "app/output/run.h"
#include "app/output/svg_export.h"
#include "core/base/safe_file.h"
#include "core/base/types.h"
#include "kernels/back_end_choice.h"
#include "warp/film.h"
#include "warp/sampling.h"

namespace wend {

class OutputSet;
struct WarpOptions;
class WarpedPicture;

/// The films of a run. Each is encoded while frames come, and is whole with the other outputs or not there.
class FilmOutputs {
  public:
    /// `files` must outlive this object.
    FilmOutputs(OutputSet& files, FilmOptions options) : m_files(files), m_options(std::move(options)) {}

    /// Adds the picture to the films with these names. Throws InputError and Cancelled.
    void add(const std::vector<std::string>& paths, const WarpedPicture& picture);
    /// Completes all films. Throws InputError and Cancelled.
    void finish();
    /// Ends the work on all films; their files are the output set's to discard.
    void discard() { m_films.clear(); }
    bool any() const { return !m_films.empty(); }

  private:
    Film& filmAt(const std::string& path);

    OutputSet& m_files;
    FilmOptions m_options;
    std::map<std::string, Film> m_films;
};

/// Keeps poses that have to wait, such as until the size of a canvas for all of them is known. They are on
/// the disk, since a long sequence would fill the memory, and are deleted with this object.
class PoseFile {
  public:
    /// Makes the file in the folder of `path`, which errors name.
    explicit PoseFile(const std::string& path);

    /// Appends a pose; all have one size. Throws InputError when the disk is full.
    void add(const Points2& pose);
    int count() const { return m_count; }
    /// Returns the k-th pose, bit for bit.
    Points2 read(int k);

  private:
    std::string m_path;
    TemporaryFolder m_folder;
    std::fstream m_stream;
    Eigen::Index m_columns = 0;
    int m_count = 0;
};

/// Writes the pictures of a run: those of its end, frames, films, ST maps and the material.
class PictureOutput {
  public:
    /// `path` is that of the project. All arguments but `film` must outlive this object.
    PictureOutput(const Project& project, const std::string& path, const Shape<2>& shape,
                  const RunOptions& options, const RunWatch& watch, const SharedDevice& device,
                  OutputSet& files, FilmOptions film);

    /// Writes the pictures and ST maps of a pose (2 × n) at a time. Throws InputError and Cancelled.
    void write(double time, const Points2& pose);
    void writeMaterial();
    /// Writes a frame, or keeps its pose until all frames are known, for a canvas that fits them. Throws
    /// InputError and Cancelled.
    void takeFrame(int number, double time, const Points2& pose);
    /// Limits the frames that takeFrame() keeps and writes later to those from `begin` to before `end`.
    void setShare(int begin, int end) { m_share = {begin, end}; }
    /// Writes the frames that takeFrame() has kept. Throws InputError and Cancelled.
    void writeWaitingFrames();
    void writeFilms();
    void discardFilms() { m_films.discard(); }

    /// Returns the canvas of the last picture.
    const std::optional<View>& canvas() const { return m_canvas; }
    /// Returns the order of the cells at a time.
    const std::vector<float>& depths(double time);

  private:
    WarpOptions warpOptions(double time, const std::function<void(double)>& progress);
    WarpedPicture warped(double time, const Points2& pixels, const View& view,
                         const std::function<void(double)>& progress);
    std::function<void(double)> warping(double from, double to) const;
    Extent<2> extent(const Points2& pixels) const;
    void writeParts(const std::string& file, double time, const Points2& pixels, const View& view);
    void writeSvg(const std::string& file, double time, const Points2& pixels, const View& view);
    void writePicture(const std::string& file, const WarpedPicture& picture) const;
    void writeFrame(int number, double time, const Points2& pixels, const View& view,
                    const std::function<void(double)>& progress);
    void tell(const std::string& work, double fraction) const;

    const Project& m_project;
    const std::string& m_path;
    const Shape<2>& m_shape;
    const RunOptions& m_options;
    const RunWatch& m_watch;
    const SharedDevice& m_device;
    OutputSet& m_files;
    FilmOutputs m_films;
    CellDepths m_depths;
    std::optional<View> m_canvas;
    MakeCellPainter m_painters;         // made with the first picture
    std::optional<PoseFile> m_waiting;  // frames, in pixels of the picture
    std::vector<double> m_times;        // of these
    Extent<2> m_allFrames;              // around these
    std::optional<std::pair<int, int>> m_share;
    std::optional<SvgExport> m_svg;  // made with the first SVG file
};

}  // namespace wend
