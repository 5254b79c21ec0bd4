#pragma once

#include <QPixmap>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "app/engine/motion/frame.h"

namespace wend {

class Playback;
class PoseDrawing;
class ShapeMotion;
class TimeScale;

/// Shows the shape at the key poses of all pins above the ruler; a click sets the time to that of a pose. The
/// pictures are drawn one by one while the program is idle.
class KeyPoseStrip : public QWidget {
    Q_OBJECT

  public:
    KeyPoseStrip(const ShapeMotion& motion, Playback& playback, const TimeScale& scale, QWidget* parent);

    static constexpr int kHeight = 52;  // pixels
    void setDrawing(PoseDrawing* drawing);
    /// Returns the times of the key poses, increasing.
    std::vector<double> times() const;
    /// Returns the rectangle of the picture of a time; empty where those before take its room.
    QRectF placeOf(double time) const;
    /// Returns the picture of a time; null as long as there is none.
    QPixmap pictureOf(double time) const;
    /// Returns whether all pictures with room show the shape as it is.
    bool isDone() const;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool event(QEvent* event) override;

  private:
    struct Pose {
        double time = 0;
        FramePtr frame;  // that the picture shows
        QPixmap picture;
    };
    struct Placed {
        const Pose* pose;
        QRectF place;
    };
    void takeKeys();
    void expire();
    void drawNext();
    void take(double time, const FramePtr& frame, const QImage& image);
    std::vector<Placed> placed() const;
    bool isCurrent(const Pose& pose) const;

    const ShapeMotion& m_motion;
    Playback& m_playback;
    const TimeScale& m_scale;
    PoseDrawing* m_drawing = nullptr;
    QTimer m_idle;
    std::vector<Pose> m_poses;  // in the order of time
    int m_generation = -1;      // of the document that they are of
    bool m_draws = false;
};

}  // namespace wend
