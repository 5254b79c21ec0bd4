#pragma once

#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "app/session/shape_session.h"
#include "app/views/volume/solid_look.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace wend {

class EnergySlider;
class ShapeCanvas;
class SolidCanvas;

/// A second session of the same document with another energy, or without paint. It follows every change, drag
/// and time of the first and computes in its own thread.
class Comparison : public QObject {
    Q_OBJECT

  public:
    explicit Comparison(ShapeSession& session, QObject* parent = nullptr);

    ShapeSession& other() { return m_other; }
    bool isOn() const { return m_on; }
    std::optional<double> phi() const { return m_phi; }
    /// Starts the comparison with that energy, or without paint if none is given.
    void begin(std::optional<double> phi);
    /// Pauses the comparison but keeps its results.
    void end();
    /// Returns the frame for the project and time of the first session; null until it is computed.
    FramePtr frame() const;

  signals:
    void changed();

  private:
    void take();
    void takeSelection();
    std::shared_ptr<const Project> wanted() const;

    ShapeSession& m_session;
    ShapeSession m_other;
    int m_generation = -1;  // of the document that it has
    std::optional<double> m_phi;
    bool m_on = false;
};

/// The page of the shape, and beside it during a comparison the same view with another energy or without
/// paint. Both halves state the energy and the resulting change. Pins can be dragged in either.
class CompareView : public QWidget {
    Q_OBJECT

  public:
    struct Parts {
        ShapeSession& session;
        QWidget& page;                        // with the views
        ShapeCanvas& picture;                 // of pictures,
        std::function<SolidCanvas*()> solid;  // and of solids; null before the first one
    };
    explicit CompareView(const Parts& parts, QWidget* parent = nullptr);

    Comparison& comparison() { return m_comparison; }
    bool isSplit() const { return m_split; }
    /// Returns the other half for pictures.
    ShapeCanvas& picture() { return *m_picture; }
    /// Returns the other half for solids; null before the first comparison of one.
    SolidCanvas* solid() { return m_solid; }

  public slots:
    /// Starts a comparison with that energy, or without paint if none is given.
    void split(std::optional<double> phi);
    void join();
    /// Previews an energy while the pointer rests on it. NaN ends the preview.
    void preview(double phi);

  signals:
    void splitChanged(bool split);
    /// Emitted when the other half for solids has been made.
    void solidMade(wend::SolidCanvas* solid);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool isOnPin(const QPointF& at) const;
    QWidget* ownHead();
    QWidget* otherHead();
    void showHeads();
    void showEnergies();
    void showHalf();
    void changeEvent(QEvent* event) override;
    void focusOwn();
    void makeSolid();
    void connectViews();
    void takeFrame();
    void showOtherHalf();

    Parts m_parts;
    Comparison m_comparison;
    QLabel *m_ownName, *m_ownTotals, *m_otherTotals;
    QComboBox* m_energy;
    QToolButton* m_close = nullptr;
    QWidget *m_ownHead, *m_otherHead, *m_other;
    ShapeCanvas* m_picture;
    SolidCanvas* m_solid = nullptr;
    bool m_split = false, m_previews = false;
    bool m_passes = false;  // a drag that was begun in the other half
};

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
