#pragma once

#include <QObject>
#include <QRect>
#include <vector>

#include "app/engine/motion/playback.h"
#include "app/project/edits/document.h"

namespace wend {

/// The horizontal scale of the ruler and the tracks: time in pixels, counted in seconds or in frames. While
/// it counts frames, times snap to them.
class TimeScale : public QObject {
    Q_OBJECT

  public:
    explicit TimeScale(Document& document, Playback& playback, QObject* parent = nullptr);

    /// The pixels of the whole film.
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

}  // namespace wend
