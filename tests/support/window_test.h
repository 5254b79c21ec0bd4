#pragma once

#include "app/project/design.h"
#include "app/views/canvas/canvas.h"
#include "app/window/main_window.h"
#include "tests/support/projects.h"
#include "tests/support/window_fixture.h"

namespace wend::test {

/// The base of tests of the window with a picture: the window, and mouse events in its view.
class WindowTest : public QObject {
  protected:
    void begin() {
        m_folder = std::make_unique<TestFolder>();
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1100, 760);
        QVERIFY(showActive(*m_window));
    }
    void end() {
        if (!m_window->session().document().isEmpty()) m_window->session().document().undoStack()->setClean();
        m_window.reset();
    }
    void open() {
        m_window->openPath(writeCutOut(*m_folder));
        QVERIFY(QTest::qWaitFor([&] { return !m_window->session().document().isEmpty(); }, 20000));
        setVertices(m_window->session().document(), 400);
        QVERIFY(settle(m_window->session()));
        m_window->canvas().setFocus();
    }
    QPoint at(double x, double y) const { return m_window->canvas().toWidget({x, y}).toPoint(); }
    void click(double x, double y, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseClick(&m_window->canvas(), Qt::LeftButton, modifiers, at(x, y));
    }
    void dragPin(double x, double y, double dx, double dy) {
        ShapeCanvas& canvas = m_window->canvas();
        QTest::mousePress(&canvas, Qt::LeftButton, {}, at(x, y));
        for (int i = 1; i <= 5; ++i) QTest::mouseMove(&canvas, at(x + dx * i / 5, y + dy * i / 5));
    }
    /// Pins both ends of the strip and drags the right one down.
    bool bend() {
        click(40, 80);
        click(200, 80);
        if (!settle(m_window->session())) return false;
        dragPin(200, 80, 0, 20);
        QTest::mouseRelease(&m_window->canvas(), Qt::LeftButton, {}, at(200, 100));
        return settle(m_window->session());
    }
    std::size_t pinCount() { return m_window->session().document().design().handles.size(); }

    std::unique_ptr<TestFolder> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

}  // namespace wend::test
