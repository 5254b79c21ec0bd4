#pragma once

#include <memory>
#include <optional>

#include "warp/warp.h"

namespace wend {

struct WarpJob;

/// A picture carried by the map rest → pose (see warpImage) whose rows are painted when they are wanted, so
/// that it need not be in memory as a whole. What it is made of must outlive it.
class WarpedPicture {
  public:
    /// Makes those levels of the picture's pyramid that the warp needs. Throws InputError for a shape that is
    /// not finite.
    WarpedPicture(const Image& source, const SimplicialMesh<2>& rest, const Points<2>& pose, const View& view,
                  const WarpOptions& options);
    WarpedPicture(const Pyramid& source, const SimplicialMesh<2>& rest, const Points<2>& pose,
                  const View& view, const WarpOptions& options);
    ~WarpedPicture();

    /// Size, layout and metadata; no pixels. A picture without alpha gets one only if some pixel is not
    /// covered.
    const Image& header() const;

    /// Rows from `top`, a multiple of kRows, as many as `strip` has. False if the options' token stopped it.
    bool paint(int top, Image& strip) const;

    static constexpr int kRows = 256;  // of a strip that is worth the threads, a multiple of a band's

  private:
    std::optional<Pyramid> m_pyramid;
    std::unique_ptr<WarpJob> m_job;
};

/// Warps and writes strip by strip: beside the source, a few strips are in memory (formats without scan
/// lines: the whole picture). Throws InputError, and Cancelled when stopped; nothing is written then.
void writeWarped(const std::string& path, const WarpedPicture& picture);

}  // namespace wend
