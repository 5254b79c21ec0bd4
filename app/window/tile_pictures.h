#pragma once

#include <QTimer>
#include <functional>
#include <memory>

#include "app/session/shape_session.h"
#include "app/views/volume/plain_view.h"

namespace wend {

class EnergySlider;
class ShapeCanvas;
class SolidCanvas;

/// Computes the effect of each energy on the user's shape for the tiles: on a coarse mesh, of a solid in a
/// coarse cage, one after the other, once nothing has changed for a while. Before anything moves, and for
/// shapes without a coarse mesh, the tiles show a sample.
class TilePictures : public QObject {
    Q_OBJECT

  public:
    /// `solid` returns the view of solids, null before the first one.
    TilePictures(ShapeSession& session, const ShapeCanvas& picture, std::function<SolidCanvas*()> solid,
                 EnergySlider& tiles);
    /// Returns whether the pictures match the shown shape.
    bool isDone() const { return m_done; }

  private:
    bool isPossible() const;
    void expire();
    void begin();
    void ask();
    void take();
    QPixmap drawn(const FramePtr& frame);
    QPixmap drawnFlat(const FramePtr& frame) const;
    QPixmap drawnSolid(const PosedFrame<3>& frame);

    ShapeSession& m_session;
    const ShapeCanvas& m_canvas;
    std::function<SolidCanvas*()> m_solid;
    EnergySlider& m_tiles;
    ShapeSession m_coarse;
    PlainView m_view;
    QTimer m_idle;
    std::shared_ptr<const Project> m_project;  // that they are made of,
    double m_time = 0;                         // and when
    std::vector<QPixmap> m_made;
    bool m_running = false, m_done = false;
};

}  // namespace wend
