#include "app/panels/flow_panel.h"

#include <QCoreApplication>
#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/panels/fields/controls.h"
#include "app/panels/fields/jump_slider.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/picture_tip.h"
#include "app/panels/fields/reasons.h"
#include "app/project/edits/setting_edits.h"
#include "app/project/options/options.h"
#include "app/project/options/settings.h"
#include "app/session/settle_step.h"
#include "app/style/theme.h"

namespace wend {

namespace {

constexpr int kMemorySteps = 100;
constexpr double kStrongest = 40;  // ρ near the slider's end: a strip returns to within 1/500 of its size
constexpr int kPicture = 44, kSliderHeight = 22, kGap = 2;

/// Evenly in effect: the residue of a closed path falls about evenly with the root of ρ. The end is elastic.
double memoryAt(int value) {
    if (value == kMemorySteps) return std::numeric_limits<double>::infinity();
    const double part = static_cast<double>(value) / kMemorySteps;
    return kStrongest * part * part;
}

int stepOfMemory(double memory) {
    if (std::isinf(memory)) return kMemorySteps;
    const double part = std::sqrt(std::clamp(memory / kStrongest, 0.0, 1.0));
    return std::min(static_cast<int>(std::lround(kMemorySteps * part)), kMemorySteps - 1);
}

/// Returns the measured residual bend after a closed path, relative to that without memory.
double leftAfter(double memory) {
    return 1 / (1 + memory / 3);
}

/// Returns a strip that is fixed on the left and raised by `up` on the right.
QPainterPath strip(const QRectF& box, double up) {
    QPainterPath path;
    path.moveTo(box.left(), box.center().y());
    path.cubicTo({box.center().x(), box.center().y()}, {box.center().x(), box.center().y()},
                 {box.right(), box.center().y() - up});
    return path;
}

}  // namespace

MemorySlider::MemorySlider(QWidget* parent) : QWidget(parent), m_slider(new JumpSlider(this)) {
    m_slider->setObjectName(QStringLiteral("memorySlider"));
    m_slider->setRange(0, kMemorySteps);
    m_slider->setSingleStep(5);
    m_slider->setPageStep(25);
    const Row& words = option("material.memory").row;
    describe(m_slider, QCoreApplication::translate("Options", words.label),
             QCoreApplication::translate("Options", words.help));
    setFocusProxy(m_slider);
    connect(m_slider, &JumpSlider::moved, this, &MemorySlider::choose);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void MemorySlider::setMemory(double memory) {
    m_memory = memory;
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(stepOfMemory(memory));
    update();
}

void MemorySlider::choose(int value, int gesture) {
    m_memory = memoryAt(value);
    update();
    emit memoryChosen(m_memory, gesture);
}

int MemorySlider::lineHeight() const {
    return fontMetrics().lineSpacing();
}

QSize MemorySlider::sizeHint() const {
    return {160, kPicture + kSliderHeight + kGap + lineHeight()};
}

void MemorySlider::resizeEvent(QResizeEvent*) {
    m_slider->setGeometry(0, kPicture, width(), kSliderHeight);
}

void MemorySlider::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) updateGeometry();
    QWidget::changeEvent(event);
}

void MemorySlider::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme theme = Theme::of(palette());
    QColor quiet = palette().color(QPalette::WindowText);
    quiet.setAlphaF(isEnabled() ? 0.35 : 0.15);
    const QRectF box(8, 4, width() - 40, kPicture - 10);
    const QPointF end(box.right(), box.center().y());
    painter.setPen(QPen(quiet, 6, Qt::SolidLine, Qt::FlatCap));
    painter.drawPath(strip(box, 0));
    painter.setPen(QPen(quiet, 1.2, Qt::DashLine));
    painter.drawEllipse(end + QPointF(11, 0), 11, 11);  // the path of the pin
    painter.setPen(QPen(isEnabled() ? theme.accent : quiet, 2.5));
    painter.drawPath(strip(box, 0.45 * box.height() * leftAfter(m_memory)));
    const QRect line(0, kPicture + kSliderHeight + kGap, width(), lineHeight());
    painter.setPen(isEnabled() ? theme.secondText : quiet);
    painter.drawText(line, Qt::AlignLeft, tr("not at all"));
    painter.drawText(line, Qt::AlignRight, tr("fully"));
}

FlowPanel::FlowPanel(Document& document, Playback& playback, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_playback(playback),
      m_memory(new MemorySlider(this)),
      m_settle(pushButton(
          this, "settle", tr("Relax"),
          tr("The pins stay where they are, and what lies between them releases its tension. This takes "
             "one second at the end of the film."),
          [this] { settleAtEnd(m_document, m_playback); })) {
    showInTip(m_settle, relaxPictures);
    showInTip(m_memory->slider(), memoryPictures);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->setSpacing(8);
    layout->addLayout(sideBySide({panelTitle(tr("Springs back"), this), nullptr, m_settle}));
    layout->addWidget(m_memory);
    connect(m_memory, &MemorySlider::memoryChosen, this, [this](double memory, int gesture) {
        changeSetting(m_document, "material.memory", memory, gesture);
    });
    connect(&m_document, &Document::projectChanged, this, &FlowPanel::showProject);
    showProject();
}

void FlowPanel::showProject() {
    setEnabled(!m_document.isEmpty());
    if (m_document.isEmpty()) return;
    const double memory = settingOf(*m_document.project(), "material.memory");
    const bool isElastic = std::isinf(memory);
    allow(
        m_settle, canSettle(m_document),
        isElastic ? tr("A shape that springs back fully is always relaxed.") : tr("Nothing has moved yet."));
    m_memory->setMemory(memory);
}

}  // namespace wend
