#include "app/view/status_fields.h"

#include <QLabel>
#include <QLocale>
#include <QResizeEvent>
#include <QStatusBar>
#include <QUndoStack>
#include <algorithm>
#include <utility>

namespace wend {

namespace {

constexpr int kMessageMargin = 32;  // pixels that the bar leaves free beside words
constexpr int kBetween = 6;         // numbers
constexpr int kApart = 12;          // numbers and what is before them, however long they are
constexpr int kIndent = 8;          // of a hint, from the window's edge
constexpr int kTold = 10000;        // milliseconds

/// The longest beginning of the text that fits and ends where one of the marks stands; empty if there is
/// none.
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

/// Whole sentences, or the part before a colon or semicolon, or what there is room for and dots.
QString fittedTo(int room, const QString& hint, const QFontMetrics& metrics) {
    if (metrics.horizontalAdvance(hint) <= room) return hint;
    const QString sentences = beginningTo(hint, {QStringLiteral(". ")}, metrics, room);
    if (!sentences.isEmpty()) return sentences;
    const QString part = beginningTo(hint, {QStringLiteral(": "), QStringLiteral("; ")}, metrics, room);
    return part.isEmpty() ? metrics.elidedText(hint, Qt::ElideRight, room) : part;
}

}  // namespace

/// A hint as far as there is room; the tooltip has all of it.
class StatusFields::HintLabel : public QLabel {
  public:
    using QLabel::QLabel;

    void setHint(const QString& hint) {
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
    : QObject(&bar), m_bar(bar), m_session(session), m_delay(session), m_hint(new HintLabel(&bar)) {
    bar.setSizeGripEnabled(false);
    m_hint->setIndent(kIndent);
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // the window may be narrow
    bar.addWidget(m_hint, 1);
    bar.setContentsMargins(0, 0, 12, 0);
    m_time = add(
        tr("Time per frame"),
        tr("While you drag: how long the view lags behind your hand. At rest: how long computing it took"),
        tr("%1 ms").arg(QStringLiteral("0000")));
    m_pointer = add(tr("Position"), tr("Where the pointer is, in the picture's pixels"),
                    QStringLiteral("00000.0, 00000.0"));
    m_pinError = add(tr("Pin error"), tr("How far the worst pin is from where it should be"),
                     tr("pin error %1 px").arg(QStringLiteral("0.00")));
    m_worst = add(tr("Worst place"), tr("How far the worst place is from rest in what the map shows"),
                  tr("worst %1").arg(QStringLiteral("stretch 0.000")));
    m_worst->setObjectName(QStringLiteral("worstField"));
    m_area = add(tr("Area change"), tr("How much larger or smaller the shape is than at rest"),
                 tr("area %1 %").arg(QStringLiteral("+00.0")));
    bar.installEventFilter(this);
    connect(&bar, &QStatusBar::messageChanged, this, [this](const QString& message) {
        if (message.isEmpty()) makeRoom(m_hint->toolTip());
    });
    connect(&session.document(), &Document::opened, this, [this] {  // they are of another document
        setHint({});
        setPointer({});
    });
    connect(session.document().undoStack(), &QUndoStack::indexChanged, this,
            [this, last = 0](int steps) mutable {
                if (steps < std::exchange(last, steps)) tell({});  // it was of what is taken back
            });
    connect(&session, &ShapeSession::frameChanged, this, &StatusFields::showFrame);
    connect(&m_delay, &SeenDelay::seen, this, &StatusFields::showTime);
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
    m_numbers << label;
    return label;
}

/// Numbers give way to words, from the left: those first that matter least.
void StatusFields::makeRoom(const QString& words) {
    m_words = words;
    m_room = m_bar.width() - kMessageMargin;
    const int wanted = m_bar.fontMetrics().horizontalAdvance(words);
    bool fits = m_isShown;
    for (auto number = m_numbers.rbegin(); number != m_numbers.rend(); ++number) {
        const int taken = std::max((*number)->minimumWidth(), (*number)->sizeHint().width()) + kBetween;
        fits = fits && m_room - taken >= wanted;
        (*number)->setVisible(fits);
        if (fits) m_room -= taken;
    }
}

bool StatusFields::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) makeRoom(m_words);
    return QObject::eventFilter(watched, event);
}

/// The bar hides the hint under a message only as long as nobody else shows it.
void StatusFields::setVisible(bool visible) {
    m_bar.clearMessage();
    m_isShown = visible;
    m_hint->setVisible(visible);
    makeRoom(m_hint->toolTip());
}

void StatusFields::tell(const QString& text) {
    if (text.isEmpty()) {
        if (!m_toldUntil.hasExpired()) m_bar.clearMessage();
        return forgetTold();
    }
    m_told = text;
    m_toldUntil.setRemainingTime(kTold);
    makeRoom(text);
    m_bar.showMessage(text, kTold);
}

void StatusFields::showTip(const QString& tip) {
    const bool told = (tip.isEmpty() || tip == m_tip) && !m_toldUntil.hasExpired();
    if (!tip.isEmpty()) m_tip = tip;
    if (tip.isEmpty() && !told) return m_bar.clearMessage();
    makeRoom(told ? m_told : tip);
    m_bar.showMessage(told ? m_told : fittedTo(m_room, tip, m_bar.fontMetrics()),
                      told ? static_cast<int>(m_toldUntil.remainingTime()) : 0);
}

void StatusFields::setHint(const QString& hint) {
    m_hint->setHint(hint);
    if (m_bar.currentMessage().isEmpty()) makeRoom(hint);
}

void StatusFields::setMeasure(Measure measure) {
    if (measure == m_measure) return;
    m_measure = measure;
    showFrame();
}

void StatusFields::setPointer(const QString& text) {
    m_pointer->setText(text);
}

void StatusFields::showFrame() {
    const FramePtr& frame = m_session.frame();
    if (!frame) {
        for (QLabel* label : m_numbers) label->clear();
        return;
    }
    const QLocale locale;
    const bool picture = m_session.document().picture() != nullptr;
    const QString error = locale.toString(frame->pinError, 'f', 2);
    m_pinError->setText(picture ? tr("pin error %1 px").arg(error) : tr("pin error %1").arg(error));
    const QString place = worstText(*frame->distortion, m_measure, frame->dimension);
    m_worst->setText((m_measure == Measure::Area ? tr("worst %1", "a ratio") : tr("worst %1")).arg(place));
    const double change = 100 * (frame->growth - 1);
    const QString percent = (change >= 0.05 ? QStringLiteral("+") : QString()) +
                            locale.toString(std::abs(change) < 0.05 ? 0.0 : change, 'f', 1);
    m_area->setText(frame->dimension == 2 ? tr("area %1 %").arg(percent) : tr("volume %1 %").arg(percent));
    if (!m_session.isDragging()) showTime(frame->milliseconds);
}

/// Of what is seen.
void StatusFields::showTime(double milliseconds) {
    m_time->setText(milliseconds > 0 ? tr("%1 ms").arg(QLocale().toString(milliseconds, 'f', 0)) : QString());
}

}  // namespace wend
