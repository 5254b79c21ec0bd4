#pragma once

#include <memory>
#include <optional>

#include "warp/warp.h"

namespace wend {

struct WarpJob;

/// A picture carried by the map rest → pose (see warpImage) whose rows are painted on demand, so that the
/// whole need not be in memory. The objects that it is made from must outlive it.
class WarpedPicture {
  public:
    /// Makes those levels of the picture's pyramid that the warp needs. Throws InputError for a shape that is
    /// not finite.
    WarpedPicture(const Image& source, const SimplicialMesh<2>& rest, const Points2& pose, const View& view,
                  const WarpOptions& options);
    WarpedPicture(const Pyramid& source, const SimplicialMesh<2>& rest, const Points2& pose, const View& view,
                  const WarpOptions& options);
    ~WarpedPicture();

    /// Returns size, layout and metadata without pixels. A picture without alpha gets one only if some pixel
    /// is not covered.
    const Image& header() const;

    /// Paints rows from `top`, a multiple of kRows, as many as `strip` has, which comes with zeros. Returns
    /// false if the options' token stopped it. Not for several threads at a time.
    bool paint(int top, Image& strip) const;

    /// Returns whether WarpOptions::makePainter's painter paints the cells: it blends none.
    bool hasPainter() const { return m_painter != nullptr; }

    static constexpr int kRows = 256;  // of a strip that is worth the threads, a multiple of a band's

  private:
    bool paintCells(int top, Image& strip) const;

    std::optional<Pyramid> m_pyramid;
    std::unique_ptr<WarpJob> m_job;
    mutable std::unique_ptr<CellPainter> m_painter;  // none any more once it failed
};

/// Warps and writes strip by strip: beside the source, a few strips are in memory (formats without scan
/// lines: the whole picture). `type`: instead of the source's, as far as the format holds it; values stay
/// what they are. `lossy`: of WebP. Throws InputError, and Cancelled when stopped; nothing is written then.
void writeWarped(const std::string& path, const WarpedPicture& picture,
                 std::optional<PixelType> type = std::nullopt, bool lossy = false);

}  // namespace wend
