#include "app/window/notices/work_note.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/engine/shape/shape_builder.h"
#include "app/project/domain.h"
#include "warp/inpaint.h"

namespace wend {

namespace {

constexpr int kWorkDelay = 400;   // milliseconds before the note is shown
constexpr int kFirstDelay = 200;  // as long as there is nothing else to look at
constexpr int kBar = 4;           // pixels high
constexpr int kBelow = 18;        // pixels left free under it

}  // namespace

WorkNote::WorkNote(ShapeSession& session, QWidget& over)
    : QFrame(&over),
      m_session(session),
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
    connect(&m_delay, &QTimer::timeout, this, [this] {
        show();  // first: words are as wide as the font is that they are shown in
        showText();
        raise();
        qApp->installEventFilter(this);
    });
    connect(m_cancel, &QPushButton::clicked, &session.motion(), &ShapeMotion::cancelWork);
    connect(&session.motion(), &ShapeMotion::busyChanged, this, &WorkNote::takeState);
    connect(&session.motion(), &ShapeMotion::frameChanged, this, &WorkNote::takeState);
    for (const auto told : {&ShapeMotion::progress, &ShapeMotion::within})
        connect(&session.motion(), told, this, [this](double time, double end) {
            m_part = end > 0 ? time / end : 0;
            takeState();
        });
    connect(&session.document(), &Document::projectChanged, this, [this] {
        m_part = 0;
        follow();
    });
}

ShapeInputs WorkNote::inputs() const {
    const Document& document = m_session.document();
    return {document.generation(), 0, document.project(), document.picture(),
            document.folder().toStdString()};
}

/// A shape is on its way after every change. Its mesh is made only if none of before serves.
bool WorkNote::makesMesh() const {
    return m_session.motion().isMeshing() && !(m_meshed.project && sameMesh(m_meshed, inputs()));
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
    for (const PicturePart& part : m_session.document().domain().parts)
        if (part.fill && !isFilled(part)) return &part;
    return nullptr;
}

/// Takes what the session says after it was told of a change, which the note may hear of earlier.
void WorkNote::takeState() {
    if (m_session.document().isEmpty())
        m_meshed = {};
    else if (m_session.motion().frame() && !m_session.motion().isMeshing())
        m_meshed = inputs();
    follow();
}

/// Drags need no note; the work that they leave starts the delay again.
void WorkNote::follow() {
    const bool works = m_session.motion().isBusy() && !m_session.motion().isDragging();
    if (!works) {
        m_delay.stop();
        hide();
        qApp->removeEventFilter(this);
    } else if (isHidden()) {
        if (!m_delay.isActive()) m_delay.start(m_session.motion().frame() ? kWorkDelay : kFirstDelay);
    } else {
        showText();
    }
}

QString WorkNote::text() const {
    return isHidden() ? QString() : m_text->text();
}

QString WorkNote::words(double part) const {
    const Document& document = m_session.document();
    if (document.isEmpty()) return {};
    if (!makesMesh())
        return tr("Computing the motion: %1 %").arg(QLocale().toString(static_cast<int>(100 * part)));
    const Domain& domain = document.domain();
    if (const PicturePart* filled = filledPart())
        return tr("Filling the ground behind “%1” …").arg(QString::fromStdString(filled->name));
    if (domain.kind == DomainKind::Mesh || domain.maxVolume > 0 || domain.edge > 0)
        return tr("Meshing %1 …").arg(document.displayName());
    return tr("Meshing %1 with about %Ln vertices …", nullptr, domain.vertices).arg(document.displayName());
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

/// Not during a gesture or in a menu or dialog, where Escape has its own meaning.
bool WorkNote::isCancelKey(QObject* watched, QEvent* event) const {
    if (event->type() != QEvent::KeyPress || isHidden() || !watched->isWidgetType()) return false;
    return static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape &&
           QGuiApplication::mouseButtons() == Qt::NoButton && !QApplication::activeModalWidget() &&
           !QApplication::activePopupWidget();
}

bool WorkNote::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize) place();
    if (!isCancelKey(watched, event)) return QFrame::eventFilter(watched, event);
    m_session.motion().cancelWork();
    return true;
}

}  // namespace wend
