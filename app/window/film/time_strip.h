#pragma once

#include <QObject>
#include <QRect>
#include <QWidget>
#include <vector>

#include "app/engine/motion/playback.h"
#include "app/project/edits/document.h"

class QLabel;
class QPainter;
class QSlider;
class QToolButton;

namespace wend {

class ExactBox;
class JumpSlider;
class ShapeMotion;
class TrackView;

/// The horizontal scale of the ruler and the tracks: time in pixels, counted in seconds or in frames. While
/// it counts frames, times snap to them.
class TimeScale : public QObject {
    Q_OBJECT

  public:
    explicit TimeScale(Document& document, Playback& playback, QObject* parent = nullptr);

    /// Returns the rectangle of the whole film, in pixels.
    const QRect& way() const { return m_way; }
    void setWay(const QRect& way);
    double end() const;
    double xOf(double time) const;
    double timeAt(double x) const;
    double pixelsOf(double duration) const { return xOf(duration) - xOf(0); }
    /// Returns the frames per unit of time.
    double rate() const;
    bool countsFrames() const { return m_countsFrames; }
    void setCountsFrames(bool counts);
    /// Returns the time of the nearest frame while it counts frames, else the same.
    double onFrame(double time) const;
    /// Returns the step of an arrow key.
    double step() const;
    /// Returns the nearest of the marks within reach, or else the time on its frame.
    double snapped(double time, const std::vector<double>& marks) const;
    QString text(double time) const;

  signals:
    void changed();

  private:
    Document& m_document;
    Playback& m_playback;
    QRect m_way{132, 0, 252, 0};
    bool m_countsFrames;
};

/// The time below the canvas: play, loop, the time and length of the film, a slider from 0 to the end, and
/// how far the motion has been computed.
class TimeStrip : public QWidget {
    Q_OBJECT

  public:
    TimeStrip(Document& document, Playback& playback, const ShapeMotion& motion, const TrackView& tracks,
              QWidget* parent = nullptr);
    QToolButton* playButton() const { return m_play; }
    QToolButton* loopButton() const { return m_loop; }
    QSlider* slider() const;
    ExactBox* length() const { return m_length; }
    /// Returns the range of the slider in the strip's coordinates.
    QRect way() const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void showEnd(double end);
    void showLength();
    void changeLength();
    void showTime();
    void paintSettling(QPainter& painter, double end);

    Document& m_document;
    Playback& m_playback;
    const ShapeMotion& m_motion;
    const TrackView& m_tracks;  // above the slider, at its scale
    QToolButton* m_play;
    QToolButton* m_loop;
    JumpSlider* m_slider;
    QLabel* m_label;
    ExactBox* m_length;
    double m_computed = 0;
};

}  // namespace wend
