#pragma once

#include <functional>
#include <memory>

namespace wend {

struct Image;
struct WarpJob;

/// Paints the cells of a warp in the place of the processor's cores, strip by strip.
class CellPainter {
  public:
    virtual ~CellPainter() = default;
    /// Paints the pixels whose centres are covered by cells; others stay zero. `strip` begins at row `top` of
    /// the output. Returns false on failure: the CPU then does this and all later strips.
    virtual bool paint(const WarpJob& job, int top, Image& strip) = 0;
};

/// Makes a painter for a warp with known cells; null if it cannot.
using MakeCellPainter = std::function<std::unique_ptr<CellPainter>(const WarpJob&)>;

}  // namespace wend
