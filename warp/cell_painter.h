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
    /// Paints what the cells cover, by the pixels' centres; the rest stays zero. `strip` begins at row `top`
    /// of the output. False if it cannot: the processor then does this strip and all later ones.
    virtual bool paint(const WarpJob& job, int top, Image& strip) = 0;
};

/// Makes one for a warp whose cells are known; nothing if it cannot.
using MakeCellPainter = std::function<std::unique_ptr<CellPainter>(const WarpJob&)>;

}  // namespace wend
