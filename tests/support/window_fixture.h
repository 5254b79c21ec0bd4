#pragma once

#include <QColor>
#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "app/session/shape_session.h"

namespace wend::test {

/// A cut-out: a leaning bar with rounded ends on a transparent ground.
inline QString writeCutOut(const QTemporaryDir& folder, const QString& name = QStringLiteral("bar.png")) {
    QImage image(240, 160, QImage::Format_RGBA8888);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    QLinearGradient fill(20, 0, 220, 0);
    fill.setColorAt(0, QColor(220, 120, 40));
    fill.setColorAt(1, QColor(40, 110, 200));
    painter.setBrush(fill);
    painter.drawRoundedRect(QRectF(20, 60, 200, 40), 20, 20);
    painter.end();
    const QString path = folder.filePath(name);
    image.save(path);
    return path;
}

/// Waits until nothing is being computed and the frame matches the document; otherwise prints which condition
/// fails.
inline bool settle(ShapeSession& session) {
    QString problem;
    const auto listening = QObject::connect(&session.motion(), &ShapeMotion::problem,
                                            [&problem](const QString& text) { problem = text; });
    const bool settled = QTest::qWaitFor(
        [&] { return session.motion().frame() && !session.motion().isBusy() && !session.motion().isStale(); },
        60000);
    QObject::disconnect(listening);
    if (!settled)
        qWarning("not settled: %s, %s, %s; %s", session.motion().frame() ? "a frame" : "no frame",
                 session.motion().isBusy() ? "busy" : "idle",
                 session.motion().isStale() ? "stale" : "current", qPrintable(problem));
    return settled;
}

/// Delivers posted events until the widget keeps its size: layouts follow from one another.
template <class Widget>  // tests without widgets include this, too
void settleLayout(const Widget& widget) {
    QRect before;
    do {
        before = widget.geometry();
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
    } while (widget.geometry() != before);
}

/// Shows the window and makes it the active one, which gets the keys: without a window manager nothing else
/// does.
template <class Window>  // tests without widgets include this, too
bool showActive(Window& window) {
    window.show();
    window.activateWindow();
    return QTest::qWaitForWindowActive(&window, 20000);
}

/// A folder that also holds the settings. It must exist before the windows, which read and write them as soon
/// as they are made.
class TestFolder : public QTemporaryDir {
  public:
    TestFolder() {
        QCoreApplication::setOrganizationName(QStringLiteral("WendTest"));
        QCoreApplication::setApplicationName(QStringLiteral("WendTest"));
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, path());
    }
};

}  // namespace wend::test
