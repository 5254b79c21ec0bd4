#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "app/engine/motion/playback.h"
#include "app/project/edits/document.h"
#include "app/project/edits/film_edits.h"

class QMenu;

namespace wend {

class SoundTrack;
class TimeScale;

/// The ruler above the tracks: time in seconds or frames, the cycle as a band, markers, and the loudness of
/// the film's sound. It scrubs; Shift drags a new cycle, and its ends and the markers can be dragged.
class TimeRuler : public QWidget {
    Q_OBJECT

  public:
    TimeRuler(Document& document, Playback& playback, TimeScale& scale, SoundTrack& sound, QWidget* parent);

    /// Returns the height that it needs: rows without content are left out.
    int rows() const;
    /// Return where a marker's sign, or an end of the cycle (0 or 1), is drawn.
    QPointF markerSpot(int marker) const;
    QPointF cycleSpot(int end) const;
    /// Lets the cycle begin or end at the shown time.
    void markCycle(int end);
    void addMarker();

  signals:
    void rowsChanged();

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

  private:
    enum class Drag { None, Time, NewCycle, CycleStart, CycleEnd, Marker };
    struct Hit {
        Drag drag = Drag::Time;
        int marker = -1;
    };
    const Project& project() const;
    std::optional<std::array<double, 2>> cycle() const;
    double markerTime(int marker) const;
    Hit hitAt(const QPointF& at) const;
    double snapped(double x) const;
    void change(const QString& what, const std::shared_ptr<const Project>& next);
    void rename(int marker);
    void fillRates(QMenu& menu);
    void addCycleActions(QMenu& menu, double here);
    void markCycle(int end, double time);
    void addMarker(double time);
    void paintTicks(QPainter& painter) const;
    void paintCycle(QPainter& painter) const;
    void paintMarkers(QPainter& painter) const;
    void paintSound(QPainter& painter) const;
    int soundTop() const;

    Document& m_document;
    Playback& m_playback;
    TimeScale& m_scale;
    SoundTrack& m_sound;
    FilmMarks m_marks;
    Drag m_drag = Drag::None;
    int m_marker = -1;                // that is dragged
    double m_pressed = 0, m_now = 0;  // times of the drag
    int m_rows = 0;
};

}  // namespace wend
