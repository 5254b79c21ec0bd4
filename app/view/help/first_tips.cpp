#include "app/view/help/first_tips.h"

#include <QAction>
#include <QPainter>
#include <QPainterPath>
#include <QSettings>

#include "app/document/design.h"
#include "app/panels/fields/energy_slider.h"
#include "app/panels/look/theme.h"
#include "app/session/mark_size.h"
#include "app/view/actions/toolbox.h"
#include "app/view/canvas/canvas.h"
#include "app/view/volume/solid_canvas.h"

namespace wend {

namespace {

constexpr int kAll = (1 << FirstTips::kTips) - 1;
constexpr int kTick = 50;                // milliseconds
constexpr double kPoint = 7, kGap = 12;  // pixels: how far the bubble points, and keeps from the thing
constexpr double kRadius = 6;            // of its corners

/// What the tips ask to change: pins, their motions, what is kept.
std::array<double, FirstTips::kTips> counted(const Document& document) {
    std::array<double, FirstTips::kTips> count{};
    const auto take = [&count](const auto& design) {
        count[FirstTips::Pin] = static_cast<double>(design.handles.size());
        for (const auto& handle : design.handles) count[FirstTips::Drag] += !handle.motions.empty();
        count[FirstTips::Keep] = design.material.phi;
    };
    if (!document.isEmpty()) std::visit(take, document.design());
    return count;
}

/// The vertex nearest to the middle of the shape, which may have a hole there.
template <int Dim>
Vec<Dim> middleOf(const Points<Dim>& pose) {
    const Vec<Dim> mean = pose.rowwise().mean();
    Eigen::Index nearest = 0;
    (pose.colwise() - mean).colwise().squaredNorm().minCoeff(&nearest);
    return pose.col(nearest);
}

}  // namespace

FirstTips::FirstTips(const Parts& parts, QWidget& over) : QLabel(&over), m_parts(parts) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setTextFormat(Qt::PlainText);
    hide();
    m_done = QSettings().value(QStringLiteral("tipsDone"), 0).toInt() & kAll;
    m_parts.wanted.setChecked(m_done != kAll);
    m_timer.setInterval(kTick);
    connect(&m_timer, &QTimer::timeout, this, &FirstTips::follow);
    connect(&m_parts.wanted, &QAction::triggered, this, [this](bool on) { setDone(on ? 0 : kAll); });
    const Document& document = m_parts.session.document();
    connect(&document, &Document::opened, this, &FirstTips::begin);
    connect(&document, &Document::projectChanged, this, &FirstTips::takeProject);
    // Also of a pin that has moved before.
    connect(&m_parts.session, &ShapeSession::dragEnded, this, [this] {
        if (!isDone(Drag)) setDone(m_done | 1 << Drag);
    });
    begin();
}

void FirstTips::setDone(int tips) {
    m_done = tips;
    QSettings().setValue(QStringLiteral("tipsDone"), tips);
    m_parts.wanted.setChecked(tips != kAll);
    begin();
}

void FirstTips::begin() {
    m_before = counted(m_parts.session.document());
    const bool runs = m_done != kAll && !m_parts.session.document().isEmpty();
    runs ? m_timer.start() : m_timer.stop();
    follow();
}

void FirstTips::takeProject() {
    const auto now = counted(m_parts.session.document());
    int done = m_done;
    for (int tip = 0; tip < kTips; ++tip)
        if (tip == Keep ? now[tip] != m_before[tip] : now[tip] > m_before[tip]) done |= 1 << tip;
    m_before = now;
    if (done != m_done) setDone(done);
}

/// Only beside a shape that lies still and can be worked on, with its pins.
bool FirstTips::mayShow() const {
    const ShapeSession& session = m_parts.session;
    return session.frame() && !m_parts.picture.viewport().looks().hidden && !session.isDragging() &&
           !session.playback().isPlaying() && !m_parts.tutorial.isVisible() &&
           (m_parts.tools.mode() == Mode::Pins || m_parts.tools.mode() == Mode::Animate);
}

/// The next thing to do of what can be done; −1 if there is none.
int FirstTips::due() const {
    if (!mayShow()) return -1;
    if (m_before[Pin] == 0) return isDone(Pin) || !m_parts.tools.isChosen("pin") ? -1 : Pin;
    if (!isDone(Drag)) return m_parts.tools.isChosen("pin") || m_parts.tools.isChosen("select") ? Drag : -1;
    return isDone(Keep) || m_before[Drag] == 0 || !isBesideKeep() ? -1 : Keep;
}

/// Not while another half of a comparison lies between.
bool FirstTips::isBesideKeep() const {
    constexpr int kBetween = 24;
    const int right = parentWidget()->mapToGlobal(QPoint(parentWidget()->width(), 0)).x();
    return m_parts.energies.isVisible() && m_parts.energies.mapToGlobal(QPoint()).x() - right < kBetween;
}

template <int Dim, class Canvas>
QPointF FirstTips::anchorOn(const Canvas& canvas, Tip tip) const {
    const auto pins = m_parts.session.pins<Dim>();
    const Vec<Dim> at =
        tip == Drag && !pins.empty() ? pins.back().centre : middleOf<Dim>(m_parts.session.frame<Dim>()->pose);
    return canvas.mapTo(parentWidget(), canvas.toWidget(at));
}

QPointF FirstTips::anchor(Tip tip) const {
    if (tip == Keep) {
        const QPointF tiles = m_parts.energies.mapToGlobal(QPointF(0, m_parts.energies.height() / 3.0));
        return {static_cast<double>(parentWidget()->width()), parentWidget()->mapFromGlobal(tiles).y()};
    }
    if (m_parts.session.frame<2>()) return anchorOn<2>(m_parts.picture, tip);
    const SolidCanvas* solid = m_parts.solid();
    return solid ? anchorOn<3>(*solid, tip) : QPointF();
}

void FirstTips::follow() {
    const int tip = due();
    if (tip < 0) return hide();
    const std::array<QString, kTips> texts{tr("Click the shape to pin it"), tr("Drag the pin"),
                                           tr("Change what the shape keeps")};
    setText(texts[static_cast<std::size_t>(tip)]);
    setAccessibleName(text());
    const QPointF at = anchor(static_cast<Tip>(tip));
    const int point = static_cast<int>(kPoint);
    m_pointsLeft =
        tip != Keep && at.x() + marked(kGap) + sizeHint().width() + point < parentWidget()->width();
    setContentsMargins(m_pointsLeft ? 12 + point : 12, 8, m_pointsLeft ? 12 : 12 + point, 8);
    resize(sizeHint());
    const double gap = tip == Keep ? 2 : marked(kGap);
    const double left = m_pointsLeft ? at.x() + gap : at.x() - gap - width();
    move(std::clamp(qRound(left), 0, std::max(0, parentWidget()->width() - width())),
         std::clamp(qRound(at.y() - height() / 2.0), 0, std::max(0, parentWidget()->height() - height())));
    if (isVisible()) return;
    show();
    raise();
}

void FirstTips::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(m_pointsLeft ? kPoint : 0, 0, m_pointsLeft ? 0 : -kPoint, 0);
    const double tip = m_pointsLeft ? 0 : width(), base = m_pointsLeft ? box.left() : box.right(),
                 middle = box.center().y();
    QPainterPath bubble, point;
    bubble.addRoundedRect(box, kRadius, kRadius);
    point.addPolygon(QPolygonF({{base, middle - kPoint}, {tip, middle}, {base, middle + kPoint}}));
    painter.setPen(Qt::NoPen);
    painter.setBrush(Theme::of(palette()).accent);
    painter.drawPath(bubble.united(point));
    painter.setPen(Qt::white);
    painter.drawText(contentsRect(), Qt::AlignCenter, text());
}

}  // namespace wend
