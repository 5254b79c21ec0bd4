#include "app/window/film/key_pose_strip.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <set>

#include "app/base/connect_each.h"
#include "app/engine/motion/playback.h"
#include "app/project/design.h"
#include "app/project/edits/key_edits.h"
#include "app/session/shape_motion.h"
#include "app/style/theme.h"
#include "app/window/film/pose_drawing.h"
#include "app/window/film/time_strip.h"

namespace wend {

namespace {

constexpr int kPoseIdle = 150;                      // milliseconds without a change
constexpr double kPoseWidth = 46, kPoseMargin = 2;  // pixels of a picture, above and below it
constexpr double kPoseGap = 3;                      // pixels between two of them
constexpr double kOnePose = 1e-9;                   // seconds

}  // namespace

KeyPoseStrip::KeyPoseStrip(const ShapeMotion& motion, Playback& playback, const TimeScale& scale,
                           QWidget* parent)
    : QWidget(parent), m_motion(motion), m_playback(playback), m_scale(scale) {
    setObjectName(QStringLiteral("keyPoses"));
    setAccessibleName(tr("Key poses"));
    setStatusTip(tr("The shape at the key poses of all pins: a click goes there"));
    m_idle.setSingleShot(true);
    m_idle.setInterval(kPoseIdle);
    m_idle.callOnTimeout(this, &KeyPoseStrip::drawNext);
    const Document* document = &motion.document();
    connectEach(this, &KeyPoseStrip::takeKeys, document, &Document::opened, document,
                &Document::projectChanged);
    connectEach(this, &KeyPoseStrip::expire, &motion, &ShapeMotion::busyChanged, &motion,
                &ShapeMotion::frameChanged, &scale, &TimeScale::changed);
    connect(&playback, &Playback::timeChanged, this, qOverload<>(&QWidget::update));
    takeKeys();
}

void KeyPoseStrip::setDrawing(PoseDrawing* drawing) {
    m_drawing = drawing;
    expire();
}

/// Keeps the pictures of times that stay: those that are outdated are shown until they are drawn again.
void KeyPoseStrip::takeKeys() {
    const Document& document = m_motion.document();
    std::set<double> times;
    const int count = document.isEmpty() ? 0 : static_cast<int>(document.design().handles.size());
    for (int h = 0; h < count; ++h)
        for (const double time : keyTimes(document.design(), h)) times.insert(time);
    const bool same = std::exchange(m_generation, document.generation()) == document.generation();
    const auto before = same ? std::exchange(m_poses, {}) : std::vector<Pose>();
    m_poses.clear();
    for (const double time : times) {
        if (!m_poses.empty() && time - m_poses.back().time < kOnePose) continue;
        const auto old = std::ranges::find(before, time, &Pose::time);
        m_poses.push_back(old == before.end() ? Pose{time, {}, {}} : *old);
    }
    expire();
}

std::vector<double> KeyPoseStrip::times() const {
    std::vector<double> times;
    for (const Pose& pose : m_poses) times.push_back(pose.time);
    return times;
}

/// Places the pictures from left to right within the strip: one that would cover the one before it is left
/// out.
std::vector<KeyPoseStrip::Placed> KeyPoseStrip::placed() const {
    std::vector<Placed> result;
    for (const Pose& pose : m_poses) {
        const double x = std::min(m_scale.xOf(pose.time) - kPoseWidth / 2, width() - kPoseWidth - 1);
        if (!result.empty() && x < result.back().place.right() + kPoseGap) continue;
        result.push_back({&pose, QRectF(x, kPoseMargin, kPoseWidth, kHeight - 2 * kPoseMargin)});
    }
    return result;
}

QRectF KeyPoseStrip::placeOf(double time) const {
    for (const auto& [pose, place] : placed())
        if (pose->time == time) return place;
    return {};
}

QPixmap KeyPoseStrip::pictureOf(double time) const {
    const auto pose = std::ranges::find(m_poses, time, &Pose::time);
    return pose == m_poses.end() ? QPixmap() : pose->picture;
}

bool KeyPoseStrip::isCurrent(const Pose& pose) const {
    return pose.frame && pose.frame == m_motion.track().at(pose.time);
}

bool KeyPoseStrip::isDone() const {
    return std::ranges::all_of(placed(), [this](const Placed& one) { return isCurrent(*one.pose); });
}

void KeyPoseStrip::expire() {
    update();
    if (!m_poses.empty() && isVisible()) m_idle.start();
}

void KeyPoseStrip::drawNext() {
    if (!m_drawing || m_draws || !isVisible()) return;
    if (m_motion.isBusy() || m_motion.isDragging() || m_playback.isPlaying()) return m_idle.start();
    for (const auto& [pose, place] : placed()) {
        const FramePtr frame = m_motion.track().at(pose->time);
        if (!frame || frame == pose->frame) continue;
        m_draws = true;
        const QSize pixels = (place.size() * devicePixelRatioF()).toSize();
        return m_drawing->draw(frame, pixels, [this, time = pose->time, frame](const QImage& image) {
            take(time, frame, image);
        });
    }
}

void KeyPoseStrip::take(double time, const FramePtr& frame, const QImage& image) {
    m_draws = false;
    const auto pose = std::ranges::find(m_poses, time, &Pose::time);
    if (pose != m_poses.end() && frame->generation == m_generation) {
        pose->frame = frame;
        pose->picture = QPixmap::fromImage(image);
        pose->picture.setDevicePixelRatio(devicePixelRatioF());
    }
    update();
    m_idle.start(0);
}

void KeyPoseStrip::showEvent(QShowEvent*) {
    expire();
}

void KeyPoseStrip::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    for (const auto& [pose, place] : placed())
        if (place.contains(event->position())) {
            m_playback.setPlaying(false);
            return m_playback.setTime(pose->time);
        }
}

bool KeyPoseStrip::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    for (const auto& [pose, place] : placed())
        if (place.contains(help->pos())) {
            QToolTip::showText(help->globalPos(), tr("Key pose at %1").arg(m_scale.text(pose->time)));
            return true;
        }
    QToolTip::hideText();
    return true;
}

void KeyPoseStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme theme = Theme::of(palette());
    painter.fillRect(rect(), palette().color(QPalette::Window));
    const double now = m_playback.time();
    for (const Pose& pose : m_poses) {  // also those without a picture
        painter.setPen(theme.secondText);
        const double x = m_scale.xOf(pose.time);
        painter.drawLine(QPointF(x, height() - 3), QPointF(x, height()));
    }
    for (const auto& [pose, place] : placed()) {
        const bool shown = std::abs(pose->time - now) < kOnePose;
        painter.setPen(QPen(shown ? theme.accentText : theme.line, shown ? 2 : 1));
        painter.setBrush(theme.workspace);
        painter.drawRoundedRect(place, 4, 4);
        if (pose->picture.isNull()) continue;
        const QSizeF size = pose->picture.deviceIndependentSize();
        painter.drawPixmap(place.center() - QPointF(size.width() / 2, size.height() / 2), pose->picture);
    }
}

}  // namespace wend
