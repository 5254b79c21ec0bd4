#include "app/window/notices/notes.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QResizeEvent>
#include <QStatusBar>
#include <QUndoStack>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/base/connect_each.h"
#include "app/engine/shape/shape_builder.h"
#include "app/project/domain.h"
#include "app/session/shape_motion.h"
#include "warp/inpaint.h"

namespace wend {

namespace {

constexpr int kWorkDelay = 400;   // milliseconds before the note is shown
constexpr int kFirstDelay = 200;  // as long as there is nothing else to look at
constexpr int kBar = 4;           // pixels high
constexpr int kBelow = 18;        // pixels left free under it

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

WorkNote::WorkNote(ShapeMotion& motion, QWidget& over)
    : QFrame(&over),
      m_motion(motion),
      m_document(motion.document()),
      m_text(new QLabel(this)),
      m_bar(new QProgressBar(this)),
      m_cancel(new QPushButton(tr("Cancel (Esc)"), this)) {
    setObjectName(QStringLiteral("workNote"));
    m_text->setTextFormat(Qt::PlainText);
    m_cancel->setFocusPolicy(Qt::NoFocus);  // the view keeps its keys
    m_cancel->setStatusTip(tr("Stops what is being computed and goes back to the last complete state"));
    m_cancel->setToolTip(m_cancel->statusTip());
    m_bar->setTextVisible(false);
    m_bar->setFixedHeight(kBar);
    m_bar->setAccessibleName(tr("Progress"));
    auto* row = new QHBoxLayout;
    row->setSpacing(16);
    row->addWidget(m_text);
    row->addWidget(m_cancel);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 8, 8, 8);
    column->setSpacing(4);
    column->addLayout(row);
    column->addWidget(m_bar);
    hide();
    over.installEventFilter(this);
    m_delay.setSingleShot(true);
    m_delay.callOnTimeout(this, [this] {
        show();  // first: words are as wide as the font is that they are shown in
        showText();
        raise();
        qApp->installEventFilter(this);
    });
    connect(m_cancel, &QPushButton::clicked, &motion, &ShapeMotion::cancelWork);
    connectEach(this, &WorkNote::takeState, &motion, &ShapeMotion::busyChanged, &motion,
                &ShapeMotion::frameChanged);
    const auto advance = [this](double time, double end) {
        m_part = end > 0 ? time / end : 0;
        takeState();
    };
    connectEach(this, advance, &motion, &ShapeMotion::progress, &motion, &ShapeMotion::within);
    connect(&m_document, &Document::projectChanged, this, [this] {
        m_part = 0;
        follow();
    });
}

ShapeInputs WorkNote::inputs() const {
    return {m_document.generation(), 0, m_document.project(), m_document.picture(),
            m_document.folder().toStdString()};
}

/// Returns whether a new mesh is being made. A shape is computed after every change, but may reuse its mesh.
bool WorkNote::makesMesh() const {
    return m_motion.isMeshing() && !(m_meshed.project && sameMesh(m_meshed, inputs()));
}

/// Returns the first part behind which the ground is to be filled; null if that has been done for all, which
/// takes much longer than their meshes.
const PicturePart* WorkNote::filledPart() const {
    static const std::vector<PicturePart> none;
    const auto& before = m_meshed.project ? domainOf(*m_meshed.project).parts : none;
    const auto isFilled = [&](const PicturePart& part) {
        return std::ranges::any_of(before, [&](const PicturePart& one) {
            return one.fill && one.cut == part.cut && one.feather == part.feather;
        });
    };
    if (!canInpaint()) return nullptr;
    for (const PicturePart& part : m_document.domain().parts)
        if (part.fill && !isFilled(part)) return &part;
    return nullptr;
}

/// Remembers the inputs of the newest mesh, and shows or hides the note.
void WorkNote::takeState() {
    if (m_document.isEmpty())
        m_meshed = {};
    else if (m_motion.frame() && !m_motion.isMeshing())
        m_meshed = inputs();
    follow();
}

/// Drags need no note; the work that they leave starts the delay again.
void WorkNote::follow() {
    const bool works = m_motion.isBusy() && !m_motion.isDragging();
    if (!works) {
        m_delay.stop();
        hide();
        qApp->removeEventFilter(this);
    } else if (isHidden()) {
        if (!m_delay.isActive()) m_delay.start(m_motion.frame() ? kWorkDelay : kFirstDelay);
    } else {
        showText();
    }
}

QString WorkNote::text() const {
    return isHidden() ? QString() : m_text->text();
}

QString WorkNote::words(double part) const {
    if (m_document.isEmpty()) return {};
    if (!makesMesh())
        return tr("Computing the motion: %1 %").arg(QLocale().toString(static_cast<int>(100 * part)));
    const Domain& domain = m_document.domain();
    if (const PicturePart* filled = filledPart())
        return tr("Filling the ground behind “%1” …").arg(QString::fromStdString(filled->name));
    if (domain.kind == DomainKind::Mesh || domain.maxVolume > 0 || domain.edge > 0)
        return tr("Meshing %1 …").arg(m_document.displayName());
    return tr("Meshing %1 with about %Ln vertices …", nullptr, domain.vertices).arg(m_document.displayName());
}

void WorkNote::showText() {
    m_text->setText(words(m_part));
    m_text->setMinimumWidth(m_text->fontMetrics().horizontalAdvance(words(1)) + 2);
    m_bar->setVisible(!makesMesh());  // meshing has no progress
    m_bar->setValue(static_cast<int>(100 * m_part));
    setAccessibleName(m_text->text());
    place();
}

void WorkNote::place() {
    layout()->activate();  // the row within it knows the new words, too
    resize(sizeHint().boundedTo(parentWidget()->size()));
    move((parentWidget()->width() - width()) / 2, parentWidget()->height() - height() - kBelow);
}

/// Returns false during a gesture and in a menu or dialog, where Escape has its own meaning.
bool WorkNote::isCancelKey(QObject* watched, QEvent* event) const {
    if (event->type() != QEvent::KeyPress || isHidden() || !watched->isWidgetType()) return false;
    return static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape &&
           QGuiApplication::mouseButtons() == Qt::NoButton && !QApplication::activeModalWidget() &&
           !QApplication::activePopupWidget();
}

bool WorkNote::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize) place();
    if (!isCancelKey(watched, event)) return QFrame::eventFilter(watched, event);
    m_motion.cancelWork();
    return true;
}

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

StatusFields::StatusFields(QStatusBar& bar, Document& document, const ShapeMotion& motion)
    : QObject(&bar), m_bar(bar), m_motion(motion), m_hint(new HintLabel(&bar)) {
    bar.setSizeGripEnabled(false);
    m_hint->setIndent(kIndent);
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // the window may be narrow
    bar.addWidget(m_hint, 1);
    bar.setContentsMargins(0, 0, 12, 0);
    m_pointer = add(tr("Position"), tr("Where the pointer is, in the picture's pixels"),
                    QStringLiteral("00000.0, 00000.0"));
    m_growth = add(tr("Area change"), tr("How much larger or smaller the shape is than at rest"),
                   tr("area %1 %").arg(QStringLiteral("+00.0")));
    connect(&document, &Document::opened, this, [this] {
        setHint({});
        setPointer({});
    });
    connect(document.undoStack(), &QUndoStack::indexChanged, this, [this, last = 0](int steps) mutable {
        if (steps < std::exchange(last, steps)) showMessage({});  // it described the undone step
    });
    connect(&document, &Document::notice, this, &StatusFields::showMessage);
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

/// Waits until the end of a drag, because each change of the text lays out the window anew.
void StatusFields::setPointer(const QString& text) {
    m_pointed = text;
    if (!m_motion.isDragging()) showPointer();
}

void StatusFields::showPointer() {
    if (m_pointed != m_pointer->text()) m_pointer->setText(m_pointed);
}

void StatusFields::refresh() {
    showPointer();
    const FramePtr& frame = m_motion.frame();
    if (!frame) return m_growth->clear();
    const QLocale locale;
    const double change = 100 * (frame->growth - 1);
    const QString percent = (change >= 0.05 ? QStringLiteral("+") : QString()) +
                            locale.toString(std::abs(change) < 0.05 ? 0.0 : change, 'f', 1);
    m_growth->setText(frame->dimension == 2 ? tr("area %1 %").arg(percent) : tr("volume %1 %").arg(percent));
}

}  // namespace wend
