#include "app/window/files/opening_note.h"

#include <QEvent>

#include "app/views/canvas/canvas.h"
#include "app/window/files/file_workflow.h"

namespace wend {

namespace {

constexpr int kBusyDelay = 150;  // milliseconds

}  // namespace

BusyNote::BusyNote(QWidget& over) : QLabel(&over) {
    setObjectName(QStringLiteral("busyNote"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAlignment(Qt::AlignCenter);
    setMargin(14);
    setTextFormat(Qt::PlainText);
    hide();
    over.installEventFilter(this);
    m_delay.setSingleShot(true);
    m_delay.setInterval(kBusyDelay);
    connect(&m_delay, &QTimer::timeout, this, [this] {
        place();
        show();
        raise();
    });
}

void BusyNote::showText(const QString& text) {
    setText(text);
    setAccessibleName(text);
    if (text.isEmpty()) {
        m_delay.stop();
        hide();
    } else if (isHidden() && !m_delay.isActive()) {
        m_delay.start();
    }
    place();
    raise();  // over a page that came
}

void BusyNote::place() {
    resize(sizeHint().boundedTo(parentWidget()->size()));
    move((parentWidget()->width() - width()) / 2, (parentWidget()->height() - height()) / 2);
}

bool BusyNote::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) place();
    return QLabel::eventFilter(watched, event);
}

/// The file is opened in the same turn of the event loop, so the note stays visible in between.
OpeningNote::OpeningNote(FileWorkflow& files, ShapeCanvas& canvas, QWidget& over)
    : BusyNote(over), m_canvas(canvas) {
    connect(&files, &FileWorkflow::openingChanged, this, [this](const QString& name) {
        m_reads = !name.isEmpty();
        if (m_reads) m_name = name;
    });
    connect(&files, &FileWorkflow::openingChanged, this, &OpeningNote::refresh, Qt::QueuedConnection);
    connect(&m_canvas, &ShapeCanvas::prepared, this, &OpeningNote::refresh);
}

void OpeningNote::refresh() {
    showText(m_reads || m_canvas.isPreparing() ? tr("Opening %1 …").arg(m_name) : QString());
}

}  // namespace wend
