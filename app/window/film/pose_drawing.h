#pragma once

#include <QImage>
#include <QObject>
#include <functional>

#include "app/engine/motion/frame.h"
#include "app/views/volume/solid_look.h"

namespace wend {

class ShapeCanvas;
class SolidCanvas;

/// Draws frames small, as the canvas shows them but without marks, maps and edges.
class PoseDrawing : public QObject {
    Q_OBJECT

  public:
    /// `solid` returns the view of solids, null before the first one.
    PoseDrawing(const ShapeCanvas& picture, std::function<SolidCanvas*()> solid, QObject* parent);

    /// Passes the picture of a frame of the shown shape on, which is null where it cannot be drawn: of a
    /// solid at once, otherwise later, drawn in another thread. `size`: in pixels.
    void draw(const FramePtr& frame, const QSize& size, std::function<void(const QImage&)> take);

  private:
    const ShapeCanvas& m_picture;
    std::function<SolidCanvas*()> m_solid;
    PlainView m_view;
};

}  // namespace wend
