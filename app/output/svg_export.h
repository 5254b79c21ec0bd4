#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/engine/shape/shape.h"
#include "app/project/project_fwd.h"
#include "core/base/message.h"
#include "warp/vector_drawing.h"
#include "warp/warped_drawing.h"

namespace wend {

struct Domain;
struct PicturePart;
struct RunOptions;
struct View;
struct WarpOptions;

/// Returns whether the name is that of an SVG file, which gets paths.
bool isSvgFile(const std::string& path);

/// Returns whether a project's picture, or a part of it, is an SVG drawing.
bool hasDrawing(const Domain& domain, const std::string& folder);

/// Throws InputError if a file in SVG cannot be made: the project has no drawing, or `options` ask for what
/// paths cannot be.
void requireDrawing(const std::string& path, const Project& project, const std::string& folder,
                    const RunOptions& options);

/// Makes SVG files of poses. Drawings are read once.
class SvgExport {
  public:
    /// `notice` receives one line for everything that is not as it was.
    SvgExport(const Project& project, std::string folder, std::function<void(const Message&)> notice);

    /// Returns the file of a pose; `pixels` is inPixels(), `levels` are those of the parts (partLevels()).
    /// Throws InputError and Cancelled.
    std::string text(const Shape<2>& shape, const Points2& pixels, const std::vector<int>& levels,
                     const View& view, const WarpOptions& options);

  private:
    const VectorDrawing& drawingOf(const std::string& file, const std::string& layer);
    const VectorDrawing* drawingOf(const PicturePart& part);
    const VectorDrawing& mainDrawing();
    Vec2 shiftOf(const PicturePart& part);
    SvgPage pageOf(const Shape<2>& shape, const View& view, const WarpOptions& options);
    void tell(const Message& text);

    const Domain& m_domain;
    std::string m_folder;
    std::function<void(const Message&)> m_notice;
    std::vector<std::string> m_warned;
    std::map<std::pair<std::string, std::string>, VectorDrawing> m_drawings;  // by file and layer
};

}  // namespace wend
