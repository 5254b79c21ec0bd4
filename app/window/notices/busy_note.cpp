#include "app/window/notices/busy_note.h"

#include <QEvent>

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

}  // namespace wend
