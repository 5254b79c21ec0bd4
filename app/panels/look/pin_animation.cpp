#include "app/panels/look/pin_animation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/document/design.h"
#include "app/panels/look/liveliness.h"

namespace wend {
namespace {

constexpr int kDrop = 120, kTremble = 200, kNameAfter = 300;  // milliseconds
constexpr double kHeight = 14, kWay = 3;  // pixels that it falls, and trembles to either side
constexpr double kSquash = 0.3;

std::size_t pinCount(const Document& document) {
    if (document.isEmpty()) return 0;
    return std::visit([](const auto& design) { return design.handles.size(); }, document.design());
}

}  // namespace

PinAnimation::PinAnimation(ShapeSession& session) : m_session(session) {
    for (auto [animation, duration] : {std::pair{&m_drop, kDrop}, {&m_tremble, kTremble}}) {
        animation->setDuration(duration);
        animation->setStartValue(0.0);
        animation->setEndValue(1.0);
        connect(animation, &QVariantAnimation::valueChanged, this, &PinAnimation::changed);
    }
    m_nameDue.setSingleShot(true);
    m_nameDue.setInterval(kNameAfter);
    connect(&m_nameDue, &QTimer::timeout, this, [this] {
        m_named = m_hovered;
        emit changed();
    });
    const Document& document = session.document();
    connect(&document, &Document::opened, this, [this, &document] {
        m_drop.stop(), m_tremble.stop();
        m_count = pinCount(document);
    });
    connect(&document, &Document::projectChanged, this, &PinAnimation::takeProject);
    connect(&session, &ShapeSession::frameChanged, this, &PinAnimation::takeFrame);
}

void PinAnimation::begin(QVariantAnimation& animation, std::vector<int> pins) {
    if (!isLively()) return;
    m_drop.stop(), m_tremble.stop();
    m_pins = std::move(pins);
    animation.start();
}

void PinAnimation::hover(int handle) {
    if (std::exchange(m_hovered, handle) == handle) return;
    m_named = -1;
    handle < 0 ? m_nameDue.stop() : m_nameDue.start();
}

void PinAnimation::takeProject() {
    const std::size_t count = pinCount(m_session.document());
    if (count == m_count + 1) begin(m_drop, {static_cast<int>(count) - 1});
    m_count = count;
}

/// Why it stopped is said in the status bar.
void PinAnimation::takeFrame() {
    const FramePtr& frame = m_session.frame();
    const bool stopped = frame && frame->live && frame->stopped;
    if (stopped && !m_stopped && m_session.gesture()) begin(m_tremble, m_session.gesture()->handles());
    m_stopped = stopped;
}

PinAnimation::Look PinAnimation::of(int handle) const {
    const bool drops = m_drop.state() == QAbstractAnimation::Running,
               trembles = m_tremble.state() == QAbstractAnimation::Running;
    if ((!drops && !trembles) || std::ranges::find(m_pins, handle) == m_pins.end()) return {};
    if (trembles) {
        const double t = m_tremble.currentValue().toDouble();
        return {QPointF(kWay * (1 - t) * std::sin(4 * std::numbers::pi * t), 0), 0};
    }
    // It falls in two thirds of the time, and is flat where it lands.
    const double t = m_drop.currentValue().toDouble(), fall = std::min(1.0, 1.5 * t);
    return {QPointF(0, -kHeight * (1 - fall * fall)),
            t <= 2.0 / 3 ? 0 : kSquash * std::sin(3 * std::numbers::pi * (1 - t))};
}

}  // namespace wend
