#include "app/window/film/time_scale.h"

#include <QLocale>
#include <cmath>

#include "app/base/preferences.h"
#include "app/project/edits/film_edits.h"

namespace wend {

namespace {

constexpr double kSnapReach = 6;     // pixels, of what snaps
constexpr double kArrowStep = 0.04;  // seconds, of an arrow key

}  // namespace

TimeScale::TimeScale(Document& document, Playback& playback, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_playback(playback),
      m_countsFrames(preferences::rulerInFrames.value()) {}

void TimeScale::setWay(const QRect& way) {
    m_way = way;
    emit changed();
}

double TimeScale::end() const {
    return m_playback.end();
}

double TimeScale::xOf(double time) const {
    return m_way.x() + (end() > 0 ? time / end() * m_way.width() : 0);
}

double TimeScale::timeAt(double x) const {
    return (x - m_way.x()) / m_way.width() * end();
}

double TimeScale::rate() const {
    return filmMarksOf(m_document).frameRate;
}

void TimeScale::setCountsFrames(bool counts) {
    m_countsFrames = counts;
    preferences::rulerInFrames.set(counts);
    emit changed();
}

double TimeScale::onFrame(double time) const {
    return m_countsFrames ? std::round(time * rate()) / rate() : time;
}

double TimeScale::step() const {
    return m_countsFrames ? 1 / rate() : kArrowStep;
}

double TimeScale::snapped(double time, const std::vector<double>& marks) const {
    double best = onFrame(time), reach = kSnapReach;
    for (const double mark : marks)
        if (const double d = std::abs(xOf(mark) - xOf(time)); d < reach) reach = d, best = mark;
    return best;
}

QString TimeScale::text(double time) const {
    const QLocale locale;
    return m_countsFrames ? tr("frame %1").arg(locale.toString(time * rate(), 'g', 5))
                          : tr("%1 s").arg(locale.toString(time, 'f', 2));
}

}  // namespace wend
