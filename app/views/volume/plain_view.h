#pragma once

#include <QImage>
#include <QPointer>

#include "app/engine/motion/frame.h"

namespace wend {

class SolidCanvas;
class VolumeView;

/// Draws a whole solid from a canvas's viewpoint without map, cut, edges and marks, in a hidden widget.
class PlainView {
  public:
    /// `size`: in pixels. Null where OpenGL gives none.
    QImage draw(const SolidCanvas& like, const PosedFrame<3>& frame, const QSize& size);

  private:
    QPointer<VolumeView> m_view;
};

}  // namespace wend
