// Whole tasks by mouse and keys, with a picture and a solid in one test body: from a sample to a film, undone
// completely, redone completely, saved and reopened in another window.
#include <QComboBox>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <QTreeWidget>
#include <nlohmann/json.hpp>

#include "app/panels/fields/energy_slider.h"
#include "app/panels/fields/number_boxes.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/material_panel.h"
#include "app/panels/pin_list.h"
#include "app/project/edits/curve_edits.h"
#include "app/project/file/project_writer.h"
#include "app/project/project.h"
#include "app/session/opening.h"
#include "app/window/actions/pin_actions.h"
#include "app/window/film/time_strip.h"
#include "app/window/film/track_view.h"
#include "tests/support/bar.h"
#include "tests/support/dialogs.h"

using namespace wend;
using namespace wend::test;

namespace {

/// Positions on a long sample: how far along it, and how far up.
template <int Dim>
struct Sample;

template <>
struct Sample<2> {
    static constexpr const char* kName = "strip";
    static Vec2 place(double u, double v) { return {90 + 1820 * u, 1390 - 280 * v}; }
};

template <>
struct Sample<3> {
    static constexpr const char* kName = "bar";
    static Vec3 place(double u, double v) { return {9 * u, 0, v}; }
};

}  // namespace

class TestWholeTask : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void everyStepLeadsBackAndForth_data() { dimensions(); }
    void everyStepLeadsBackAndForth();

  private:
    ShapeSession& session() { return m_f->session(); }
    QUndoStack& stack() { return *session().document().undoStack(); }
    template <int Dim>
    QPoint at(double u, double v) {
        return Bar<Dim>::canvas(*m_f).toWidget(Sample<Dim>::place(u, v)).toPoint();
    }
    template <int Dim>
    QPoint pin(int handle);
    void key(int key, Qt::KeyboardModifiers modifiers = {});
    void draw(const std::vector<QPoint>& way, Qt::KeyboardModifiers modifiers = {});
    void choose(const char* tool) { m_f->tool(tool)->trigger(); }
    void goTo(Mode mode) { key(Qt::Key_1 + static_cast<int>(mode), Qt::ControlModifier); }
    PinList& list() { return m_f->window().properties().pins(); }
    void select(int handle);
    void clickSign(int handle, PinList::Column column);
    template <class Widget>
    Widget* shown(const QString& name);
    void press(const QString& button);
    void type(QAbstractSpinBox& box, const QString& text);
    void rename(int handle, const QString& name);
    bool done(const char* what);
    template <int Dim>
    void task();
    template <int Dim>
    void setPins();
    template <int Dim>
    void bendAndPaint();
    void arrangePins();
    void makeFilm();
    template <int Dim>
    void thereAndBack();
    template <int Dim>
    QImage seen(SolidFixture& in, double time);

    std::unique_ptr<SolidFixture> m_f;
    std::vector<std::string> m_after;  // the document after each step, the opened one first
    int m_pictures = 0;                // that were saved, for looking at
};

void TestWholeTask::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_after.clear();
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

template <int Dim>
QPoint TestWholeTask::pin(int handle) {
    for (const auto& view : session().gestures().pins(true))
        if (view.handle == handle) return Bar<Dim>::canvas(*m_f).onScreen(view.centre).toPoint();
    return {};
}

/// Drags from the first place to the last one, in small moves.
void TestWholeTask::draw(const std::vector<QPoint>& way, Qt::KeyboardModifiers modifiers) {
    QWidget& view = m_f->view();
    QTest::mouseMove(&view, way.front());
    QTest::mousePress(&view, Qt::LeftButton, modifiers, way.front());
    for (std::size_t k = 1; k < way.size(); ++k)
        for (int i = 1; i <= 6; ++i) QTest::mouseMove(&view, way[k - 1] + (way[k] - way[k - 1]) * i / 6);
    QTest::mouseRelease(&view, Qt::LeftButton, modifiers, way.back());
}

/// Sends the key to a window that has the keyboard: without a window manager nothing restores it after a
/// dialog.
void TestWholeTask::key(int key, Qt::KeyboardModifiers modifiers) {
    m_f->window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
    m_f->view().setFocus();
    QTest::keyClick(&m_f->view(), static_cast<Qt::Key>(key), modifiers);
}

/// Selects the handle by its row in the list.
void TestWholeTask::select(int handle) {
    QTreeWidget& tree = *list().list();
    tree.scrollToItem(list().rowOf(handle));
    const QRect row = tree.visualItemRect(list().rowOf(handle));
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, QPoint(row.left() + 30, row.center().y()));
}

void TestWholeTask::clickSign(int handle, PinList::Column column) {
    QTreeWidget& tree = *list().list();
    tree.scrollToItem(list().rowOf(handle));
    const QRect row = tree.visualItemRect(list().rowOf(handle));
    QTest::mouseClick(
        tree.viewport(), Qt::LeftButton, {},
        QPoint(tree.columnViewportPosition(column) + tree.columnWidth(column) / 2, row.center().y()));
}

/// Returns the visible widget with that name.
template <class Widget>
Widget* TestWholeTask::shown(const QString& name) {
    for (Widget* one : m_f->window().findChildren<Widget*>())
        if (one->isVisible() && (one->accessibleName() == name || one->objectName() == name)) return one;
    return nullptr;
}

void TestWholeTask::press(const QString& button) {
    for (auto* one : m_f->window().findChildren<QAbstractButton*>())
        if (one->isVisible() && QString(one->text()).remove('&') == button)
            return QTest::mouseClick(one, Qt::LeftButton);
    QFAIL(qPrintable(button));
}

void TestWholeTask::type(QAbstractSpinBox& box, const QString& text) {
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Return);
}

void TestWholeTask::rename(int handle, const QString& name) {
    select(handle);
    QTreeWidget& tree = *list().list();
    tree.setFocus();
    tree.setCurrentItem(list().rowOf(handle));
    QTest::keyClick(&tree, Qt::Key_F2);
    auto* editor = tree.findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->setText(name);
    QTest::keyClick(editor, Qt::Key_Return);
    const auto named = [&] {
        const std::string& now = m_f->project().design.handles.at(handle).name;
        return now == name.toStdString() && list().rowOf(handle)->text(PinList::Name) == name;
    };
    QVERIFY(QTest::qWaitFor(named, 20000));
    QVERIFY(tree.hasFocus());  // Enter ended the name alone
}

/// Checks that the last change is one step, and that its shape has arrived.
bool TestWholeTask::done(const char* what) {
    const bool isStep = stack().index() == static_cast<int>(m_after.size());
    const std::string now = toJson(m_f->project());
    if (!isStep || now == m_after.back())
        qWarning("%s: %d steps after %zu deeds", what, stack().index(), m_after.size());
    const bool isOther = now != m_after.back();
    m_after.push_back(now);
    return isStep && isOther && settle(session());
}

void TestWholeTask::everyStepLeadsBackAndForth() {
    BOTH(task);
}

/// The sample's own pins are 0 and 1, at its ends.
template <int Dim>
void TestWholeTask::task() {
    QAction* sample = nullptr;
    for (QAction* one : m_f->window().actions().samples->actions())
        if (one->text() == QLatin1String(Sample<Dim>::kName)) sample = one;
    QVERIFY(sample);
    sample->trigger();
    QVERIFY(m_f->takeOpened([&] { return session().document().dimension() == Dim; }));
    m_after = {toJson(m_f->project())};
    const QImage opened = seen<Dim>(*m_f, 0);
    setPins<Dim>();
    if (!QTest::currentTestFailed()) bendAndPaint<Dim>();
    if (!QTest::currentTestFailed()) arrangePins();
    if (!QTest::currentTestFailed()) makeFilm();
    if (QTest::currentTestFailed()) return;
    const std::size_t last = m_after.size() - 1;
    for (std::size_t i = last; i-- > 0;) {
        key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(stack().index(), static_cast<int>(i));
        QCOMPARE(toJson(m_f->project()), m_after[i]);
    }
    QVERIFY(!stack().canUndo() && settle(session()));
    QCOMPARE(seen<Dim>(*m_f, 0), opened);
    thereAndBack<Dim>();
}

/// Makes a coarser mesh, three pins along the shape, and two held parts.
template <int Dim>
void TestWholeTask::setPins() {
    m_f->window().findChild<FoldingSection*>(QStringLiteral("advanced"))->setOpen(true);
    goTo(Mode::Mesh);
    auto* vertices = shown<QAbstractSpinBox>(QStringLiteral("Vertices"));
    QVERIFY(vertices);
    type(*vertices, QStringLiteral("400"));
    QVERIFY(done("a coarser mesh"));
    goTo(Mode::Pins);
    key(Qt::Key_Home);
    key(Qt::Key_P);
    for (const double u : {0.3, 0.5, 0.66}) {
        QTest::mouseClick(&m_f->view(), Qt::LeftButton, {}, at<Dim>(u, 0.5));
        QVERIFY(done("a pin"));
    }
    choose("lasso");
    draw({at<Dim>(0.15, -0.2), at<Dim>(0.25, -0.2), at<Dim>(0.25, 1.2), at<Dim>(0.15, 1.2),
          at<Dim>(0.15, -0.1)});
    QVERIFY(done("a part held by a lasso"));
    choose("rectangle");
    draw({at<Dim>(0.75, -0.3), at<Dim>(0.85, 1.3)});
    QVERIFY(done("a part held by a box"));
    QCOMPARE(session().pins().count(), 7);
}

/// Moves the pin in the middle up, makes its path a curve with another point, and paints strokes of each
/// kind.
template <int Dim>
void TestWholeTask::bendAndPaint() {
    choose("select");
    const QPoint from = pin<Dim>(3);
    draw({from, from + QPoint(10, -60)});
    QVERIFY(done("a drag"));
    const auto curve = [this] { return lastCurve(m_f->session().document().design(), 3)->points; };
    m_f->window().curves().make->trigger();
    QVERIFY(done("a path"));
    m_f->window().curves().insert->trigger();
    QVERIFY(done("a point of the path"));
    const QPoint point = Bar<Dim>::canvas(*m_f).onScreen(curve()[2]).toPoint();
    draw({point, point + QPoint(-30, 10)});
    QVERIFY(done("a point that is dragged"));
    key(Qt::Key_Home);
    QVERIFY(settle(session()));
    goTo(Mode::Paint);
    choose("paint");
    key(Qt::Key_3, Qt::ShiftModifier);
    draw({at<Dim>(0.4, 0.5), at<Dim>(0.48, 0.6)});
    QVERIFY(done("what is kept, painted"));
    press(QStringLiteral("Stiffness"));
    draw({at<Dim>(0.55, 0.4), at<Dim>(0.62, 0.5)});
    QVERIFY(done("stiffness, painted"));
    choose("comb");
    draw({at<Dim>(0.66, 0.3), at<Dim>(0.74, 0.5)});
    QVERIFY(done("a direction, combed"));
}

void TestWholeTask::arrangePins() {
    goTo(Mode::Pins);
    auto& pins = *m_f->window().findChild<PinActions*>();
    rename(2, QStringLiteral("shoulder"));
    QVERIFY(done("another name"));
    clickSign(5, PinList::Lock);
    QVERIFY(done("a lock"));
    clickSign(6, PinList::Seen);
    QVERIFY(done("a pin hidden"));
    m_f->window().actions().selectAll->trigger();
    withNext<QInputDialog>(this, [](QInputDialog& dialog) {
        dialog.setTextValue(QStringLiteral("All"));
        dialog.accept();
    });
    pins.group->trigger();
    QVERIFY(done("a group"));
    select(2);
    pins.mirror->trigger();
    QVERIFY(done("a mirror image"));
    EnergySlider* keep = m_f->window().materialPanel().energySlider();
    QTest::mouseClick(keep->findChildren<QToolButton*>().first(), Qt::LeftButton);
    QVERIFY(done("another energy"));
}

/// Sets the easing, the times and the length of the film; then adds one more motion at its end.
void TestWholeTask::makeFilm() {
    goTo(Mode::Animate);
    settleLayout(m_f->view());
    session().selection().set({3});
    auto* ease = shown<QComboBox>(QStringLiteral("ease"));
    QVERIFY(ease);
    ease->setFocus();
    QTest::keyClick(ease, Qt::Key_Down);
    QVERIFY(done("an ease"));
    type(*m_f->window().findChild<TimeStrip*>()->length(), QStringLiteral("3"));
    QVERIFY(done("a longer film"));
    auto& tracks = *m_f->window().findChild<TrackView*>();
    const QRectF bar = tracks.barOf(3, 0);
    QVERIFY(!bar.isEmpty());
    const QPoint from(static_cast<int>(bar.right()) - 1, static_cast<int>(bar.center().y()));
    QTest::mousePress(tracks.viewport(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 5; ++i)
        QTest::mouseMove(tracks.viewport(), from - QPoint(static_cast<int>(bar.width() / 15) * i, 0));
    QTest::mouseRelease(tracks.viewport(), Qt::LeftButton, {},
                        from - QPoint(static_cast<int>(bar.width() / 15) * 5, 0));
    QVERIFY(done("an earlier end"));
    goTo(Mode::Pins);
    key(Qt::Key_End);
    session().selection().set({2});
    key(Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(done("one more motion"));
}

/// Redoes by the key, saves to a file, and reopens that in another window.
template <int Dim>
void TestWholeTask::thereAndBack() {
    for (std::size_t i = 1; i < m_after.size(); ++i) {
        key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(stack().index(), static_cast<int>(i));
        QCOMPARE(toJson(m_f->project()), m_after[i]);
    }
    QVERIFY(!stack().canRedo() && settle(session()));
    const double end = session().playback().end();
    std::vector<QImage> film;
    for (const double part : {0.0, 0.4, 1.0}) film.push_back(seen<Dim>(*m_f, part * end));
    QVERIFY(film[0] != film[1] && film[1] != film[2]);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("task.wend"));
    nameNextFile(&m_f->window(), path);
    m_f->window().actions().saveAs->trigger();
    QVERIFY(QFile::exists(path) && stack().isClean());
    SolidFixture other;
    QVERIFY(other.openFile(path));
    // The values are the same except for the file names, which are relative to another folder.
    const auto valuesOf = [](const Project& project) {
        auto values = nlohmann::json::parse(toJson(project));
        values["domain"].erase(Dim == 2 ? "image" : "surface");
        return values;
    };
    Project saved = m_f->project();
    saved.view.camera =
        session().document().camera();  // which changes no document, and is kept with the file
    QVERIFY(valuesOf(other.project()) == valuesOf(saved));
    QCOMPARE(other.session().playback().end(), end);
    for (const auto& [part, picture] : {std::pair{0.0, film[0]}, {0.4, film[1]}, {1.0, film[2]}})
        QCOMPARE(seen<Dim>(other, part * end), picture);
}

/// Returns the canvas at that time, with all of the shape in it, nothing selected and no pointer over it.
template <int Dim>
QImage TestWholeTask::seen(SolidFixture& in, double time) {
    in.window().tools().setMode(Mode::Pins);
    in.tool("select")->trigger();
    in.window().actions().showMap->setChecked(false);
    in.session().selection().clear();
    in.session().playback().setTime(time);
    in.view().setFocus();
    settleLayout(in.view());
    if (Dim == 3) in.actions().front->trigger();
    in.window().actions().fit->trigger();
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&in.view(), &leave);
    auto& canvas = Bar<Dim>::canvas(in);
    if (!settle(in.session()) || !QTest::qWaitFor([&] { return canvas.isSettled(); }, 60000))
        qWarning("the canvas does not settle");
    QImage image = canvas.grab().toImage();
    if (qEnvironmentVariableIsSet("WEND_TEST_PICTURES"))
        image.save(QStringLiteral("%1/task-%2-%3.png")
                       .arg(qEnvironmentVariable("WEND_TEST_PICTURES"))
                       .arg(Dim)
                       .arg(m_pictures++));
    return image;
}

QTEST_MAIN(TestWholeTask)
#include "test_whole_task.moc"
