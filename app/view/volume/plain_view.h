#pragma once

#include <QImage>
#include <QPointer>

#include "app/session/motion/frame.h"

namespace wend {

class SolidCanvas;
class VolumeView;

/// Draws the whole of a solid as a canvas shows it, from where it looks, but without what is only of the
/// view: no map, no cut, no edges and marks. The widget that does so is never seen.
class PlainView {
  public:
    /// `size`: in pixels. Null where OpenGL gives none.
    QImage draw(const SolidCanvas& like, const PosedFrame<3>& frame, const QSize& size);

  private:
    QPointer<VolumeView> m_view;
};

}  // namespace wend
