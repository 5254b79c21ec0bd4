#pragma once

#include <QFile>
#include <QTextStream>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/file/project_writer.h"
#include "app/views/canvas/canvas.h"
#include "app/views/volume/solid_canvas.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/toolbox.h"
#include "app/window/main_window.h"
#include "app/window/properties.h"
#include "app/window/solid_workshop.h"
#include "tests/support/projects.h"
#include "tests/support/surfaces.h"
#include "tests/support/window_fixture.h"

namespace wend::test {

/// The window with a bar along x from −2 to 2, one thick, seen from the front: x runs to the right and z up.
class SolidFixture {
  public:
    SolidFixture() {
        m_window.resize(1200, 800);
        m_window.show();
        m_window.activateWindow();
    }
    ~SolidFixture() { session().document().undoStack()->setClean(); }

    bool open(int vertices = 300) {
        m_window.openPath(writeBar());
        if (!QTest::qWaitFor([&] { return !session().document().isEmpty(); }, 20000)) return false;
        setVertices(session().document(), vertices);
        const bool settled = settle(session());
        m_window.activateWindow();
        const bool active = QTest::qWaitForWindowActive(&m_window);
        actions().front->trigger();
        canvas().setFocus();
        return settled && active;
    }
    /// Opens a picture instead, as in the window's other tests.
    bool openPicture() {
        m_window.openPath(writeCutOut(m_folder));
        if (!QTest::qWaitFor([&] { return !session().document().isEmpty(); }, 20000)) return false;
        setVertices(session().document(), 400);
        const bool settled = settle(session());
        m_window.activateWindow();
        const bool active = QTest::qWaitForWindowActive(&m_window);
        m_window.canvas().setFocus();
        return settled && active;
    }
    /// Opens the bar, or the picture, as a project whose mesh is coarse from the first, so that only later
    /// changes can be undone.
    bool openProject(int dimension, int vertices) {
        const auto project =
            dimension == 2 ? barProject(writeCutOut(m_folder), vertices) : solidProject(writeBar(), vertices);
        const QString path = m_folder.filePath(QStringLiteral("bar.wend"));
        writeProject(path.toStdString(), *project);
        return openFile(path);
    }
    bool openFile(const QString& path) {
        m_window.openPath(path);
        return takeOpened([&] { return session().document().source() == path; });
    }
    /// Waits for the opened file: the window is active, the view has the keyboard, a solid is seen from the
    /// front.
    template <class IsOpen>
    bool takeOpened(const IsOpen& isOpen) {
        if (!QTest::qWaitFor(isOpen, 60000)) return false;
        const bool settled = settle(session());
        m_window.activateWindow();
        const bool active = QTest::qWaitForWindowActive(&m_window, 20000);
        if (session().document().dimension() == 3) actions().front->trigger();
        view().setFocus();
        return settled && active;
    }
    /// Returns the view of the picture or of the solid.
    QWidget& view() {
        if (session().document().dimension() == 3) return canvas();
        return m_window.canvas();
    }
    /// Makes both ends handles 0 and 1, the second selected.
    bool holdEnds() {
        const auto frame = session().motion().frame<3>();
        for (const double x : {-2.0, 2.0}) {
            std::vector<int> end;
            for (int v = 0; v < frame->vertices; ++v)
                if (std::abs(frame->rest->points(0, v) - x) < 1e-9) end.push_back(v);
            session().addHandle(session().pins().placementOf(end), "End");
        }
        session().selection().set({1});
        m_window.actions().selectTool->trigger();
        return settle(session());
    }

    MainWindow& window() { return m_window; }
    const QTemporaryDir& folder() const { return m_folder; }
    SolidCanvas& canvas() { return *m_window.solids().canvas(); }
    SolidActions& actions() { return m_window.solids().actions(); }
    QAction* tool(const char* id) { return m_window.tools().action(QLatin1String(id)); }
    ShapeSession& session() { return m_window.session(); }
    const Project& project() { return *session().document().project(); }
    const Domain& domain() { return session().document().domain(); }
    const std::vector<Pin>& handles() { return session().document().design().handles; }
    Vec3 pin(int handle) {
        for (const auto& view : session().gestures().pins())
            if (view.handle == handle) return view.centre;
        return Vec3::Zero();
    }
    QPoint at(const Vec3& p) { return canvas().toWidget(p).toPoint(); }

    void press(const QPoint& from, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseMove(&canvas(), from);
        QTest::mousePress(&canvas(), Qt::LeftButton, modifiers, from);
    }
    void moveTo(const QPoint& from, const QPoint& to) {
        for (int i = 1; i <= 8; ++i) QTest::mouseMove(&canvas(), from + (to - from) * i / 8);
    }
    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {}) {
        press(from, modifiers);
        moveTo(from, to);
        QTest::mouseRelease(&canvas(), Qt::LeftButton, modifiers, to);
    }
    void click(const QPoint& where, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseMove(&canvas(), where);
        QTest::mouseClick(&canvas(), Qt::LeftButton, modifiers, where);
    }
    /// Writes the bar as an OBJ file.
    QString writeBar() {
        const Surface bar = box({-2, -0.5, -0.5}, {2, 0.5, 0.5}, 6);
        const QString path = m_folder.filePath(QStringLiteral("bar.obj"));
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly)) return {};
        QTextStream out(&file);
        for (Eigen::Index i = 0; i < bar.points.cols(); ++i)
            out << "v " << bar.points(0, i) << ' ' << bar.points(1, i) << ' ' << bar.points(2, i) << '\n';
        for (const auto& t : bar.triangles)
            out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
        return path;
    }
    /// Saves a screenshot for inspection, in the folder that the variable names.
    void picture(const QString& name) {
        if (!qEnvironmentVariableIsSet("WEND_TEST_PICTURES")) return;
        const auto isDrawn = [this] {
            if (session().document().isEmpty()) return true;
            return session().document().dimension() == 3 ? canvas().isSettled()
                                                         : m_window.canvas().isSettled();
        };
        if (!QTest::qWaitFor(isDrawn)) qWarning("not settled: %s", qPrintable(name));
        m_window.grab().save(qEnvironmentVariable("WEND_TEST_PICTURES") + '/' + name + ".png");
    }

  private:
    TestFolder m_folder;
    MainWindow m_window;
};

}  // namespace wend::test
