#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QLabel;
class QPainter;
class QSlider;
class QToolButton;

namespace wend {

class ExactBox;
class JumpSlider;

/// The time below the canvas: play, loop, the time and length of the film, a slider from 0 to the end, and
/// how far the motion has been computed.
class TimeStrip : public QWidget {
    Q_OBJECT

  public:
    explicit TimeStrip(ShapeSession& session, QWidget* parent = nullptr);
    QToolButton* playButton() const { return m_play; }
    QToolButton* loopButton() const { return m_loop; }
    QSlider* slider() const;
    ExactBox* length() const { return m_length; }
    /// Returns the range of the slider in the strip's coordinates.
    QRect way() const;
    void setIcons(const QIcon& play, const QIcon& pause, const QIcon& loop);

  signals:
    void wayChanged();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void makeLength();
    void showEnd(double end);
    void showLength();
    void changeLength();
    void showTime();
    void paintSettling(QPainter& painter, double end);
    void showPlaying(bool playing);

    ShapeSession& m_session;
    QToolButton* m_play;
    QToolButton* m_loop;
    JumpSlider* m_slider;
    QLabel* m_label;
    ExactBox* m_length;
    QIcon m_playIcon, m_pauseIcon;
    double m_computed = 0;
};

}  // namespace wend
