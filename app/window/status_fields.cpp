#include "app/window/status_fields.h"

#include <QLabel>
#include <QLocale>
#include <QResizeEvent>
#include <QStatusBar>
#include <QUndoStack>
#include <algorithm>
#include <utility>

#include "app/session/calm_follower.h"
#include "app/session/shape_session.h"

namespace wend {

namespace {

constexpr int kMessageMargin = 32;   // pixels that Qt leaves free beside a message
constexpr int kApart = 12;           // pixels before a number
constexpr int kIndent = 8;           // pixels before a hint
constexpr int kMessageTime = 10000;  // milliseconds

/// Returns the longest beginning of the text that fits and ends at one of the marks, or an empty string.
QString beginningTo(const QString& text, const QStringList& marks, const QFontMetrics& metrics, int room) {
    QString longest;
    for (const QString& mark : marks)
        for (qsizetype at = text.indexOf(mark); at >= 0; at = text.indexOf(mark, at + 1)) {
            const QString beginning = text.left(at) + QLatin1Char('.');
            if (beginning.size() > longest.size() && metrics.horizontalAdvance(beginning) <= room)
                longest = beginning;
        }
    return longest;
}

/// Returns as many whole sentences as fit, else the part before a colon or semicolon, else an elided text.
QString fittedTo(int room, const QString& hint, const QFontMetrics& metrics) {
    if (metrics.horizontalAdvance(hint) <= room) return hint;
    const QString sentences = beginningTo(hint, {QStringLiteral(". ")}, metrics, room);
    if (!sentences.isEmpty()) return sentences;
    const QString part = beginningTo(hint, {QStringLiteral(": "), QStringLiteral("; ")}, metrics, room);
    return part.isEmpty() ? metrics.elidedText(hint, Qt::ElideRight, room) : part;
}

}  // namespace

/// A hint, shortened to the space that it has; the tooltip shows all of it.
class StatusFields::HintLabel : public QLabel {
  public:
    using QLabel::QLabel;

    void setHint(const QString& hint) {
        if (hint == m_hint) return;
        m_hint = hint;
        setToolTip(hint);
        fit();
    }

  protected:
    void resizeEvent(QResizeEvent* event) override {
        QLabel::resizeEvent(event);
        fit();
    }

  private:
    void fit() { setText(fittedTo(contentsRect().width() - indent(), m_hint, fontMetrics())); }

    QString m_hint;
};

StatusFields::StatusFields(QStatusBar& bar, ShapeSession& session)
    : QObject(&bar), m_bar(bar), m_session(session), m_hint(new HintLabel(&bar)) {
    bar.setSizeGripEnabled(false);
    m_hint->setIndent(kIndent);
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // the window may be narrow
    bar.addWidget(m_hint, 1);
    bar.setContentsMargins(0, 0, 12, 0);
    m_pointer = add(tr("Position"), tr("Where the pointer is, in the picture's pixels"),
                    QStringLiteral("00000.0, 00000.0"));
    m_growth = add(tr("Area change"), tr("How much larger or smaller the shape is than at rest"),
                   tr("area %1 %").arg(QStringLiteral("+00.0")));
    connect(&session.document(), &Document::opened, this, [this] {
        setHint({});
        setPointer({});
    });
    connect(session.document().undoStack(), &QUndoStack::indexChanged, this,
            [this, last = 0](int steps) mutable {
                if (steps < std::exchange(last, steps)) showMessage({});  // it described the undone step
            });
    new CalmFollower(
        session.motion(), this,
        [this] {
            showFrame();
            showPointer();
        },
        &session.gestures(), &ShapeGesture::pinsChanged, &session.motion(), &ShapeMotion::frameChanged);
}

QLabel* StatusFields::add(const QString& name, const QString& help, const QString& widest) {
    auto* label = new QLabel(&m_bar);
    label->setAccessibleName(name);
    label->setToolTip(help);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setContentsMargins(kApart, 0, 0, 0);
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widest) + kApart);
    label->setProperty("role", "second");
    m_bar.addPermanentWidget(label);
    return label;
}

/// Returns the part of a message that fits beside the numbers.
QString StatusFields::fitted(const QString& text) const {
    int room = m_bar.width() - kMessageMargin;
    for (const QLabel* number : {m_pointer, m_growth})
        if (number->isVisible()) room -= std::max(number->minimumWidth(), number->sizeHint().width());
    return fittedTo(room, text, m_bar.fontMetrics());
}

/// Clears the message first: Qt hides the hint only while a message is shown.
void StatusFields::setVisible(bool visible) {
    m_bar.clearMessage();
    for (QWidget* one : std::initializer_list<QWidget*>{m_hint, m_pointer, m_growth})
        one->setVisible(visible);
}

void StatusFields::showMessage(const QString& text) {
    if (text.isEmpty()) {
        if (!m_messageUntil.hasExpired()) m_bar.clearMessage();
        return forgetMessage();
    }
    m_message = text;
    m_messageUntil.setRemainingTime(kMessageTime);
    m_bar.setToolTip(text);
    m_bar.showMessage(fitted(text), kMessageTime);
}

void StatusFields::showTip(const QString& tip) {
    const bool restores = (tip.isEmpty() || tip == m_tip) && !m_messageUntil.hasExpired();
    if (!tip.isEmpty()) m_tip = tip;
    if (tip.isEmpty() && !restores) return m_bar.clearMessage();
    m_bar.showMessage(fitted(restores ? m_message : tip),
                      restores ? static_cast<int>(m_messageUntil.remainingTime()) : 0);
}

void StatusFields::setHint(const QString& hint) {
    m_hint->setHint(hint);
}

/// Each change of the text lays the window out anew: during a drag it waits for a calm moment.
void StatusFields::setPointer(const QString& text) {
    m_pointed = text;
    if (!m_session.motion().isDragging()) showPointer();
}

void StatusFields::showPointer() {
    if (m_pointed != m_pointer->text()) m_pointer->setText(m_pointed);
}

void StatusFields::showFrame() {
    const FramePtr& frame = m_session.motion().frame();
    if (!frame) return m_growth->clear();
    const QLocale locale;
    const double change = 100 * (frame->growth - 1);
    const QString percent = (change >= 0.05 ? QStringLiteral("+") : QString()) +
                            locale.toString(std::abs(change) < 0.05 ? 0.0 : change, 'f', 1);
    m_growth->setText(frame->dimension == 2 ? tr("area %1 %").arg(percent) : tr("volume %1 %").arg(percent));
}

}  // namespace wend
