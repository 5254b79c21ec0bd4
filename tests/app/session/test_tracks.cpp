#include <QDataStream>
#include <QFile>
#include <QFileInfo>
#include <QMenu>
#include <QPointer>
#include <QScopeGuard>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QUndoStack>
#include <cmath>
#include <cstring>
#include <numbers>

#include "app/panels/film_panel.h"
#include "app/project/design.h"
#include "app/project/edits/film_edits.h"
#include "app/project/edits/key_edits.h"
#include "app/project/file/project_writer.h"
#include "app/session/opening.h"
#include "app/session/pins/mirroring.h"
#include "app/window/film/sound_track.h"
#include "app/window/film/time_ruler.h"
#include "app/window/film/time_strip.h"
#include "app/window/film/track_view.h"
#include "tests/support/child_processes.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// Key poses on the tracks and the ruler above them, on the real window: mouse, keys and menus.
class TestTracks : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void keysAreDragged();
    void severalKeysGoTogether();
    void framesChooseKeys();
    void keysByKeyboard();
    void keysAreCopiedToTheTimeShown();
    void keysAreCopiedToAnotherPin();
    void keysAreMirrored();
    void mirrorImagesOfPins();
    void choiceStaysWithItsPins();
    void menuOfAKey();
    void lockedKeysStay();
    void menuOfABarSimplifies();
    void dragAtTheEndIsCorrected();
    void filmIsMadeOfPoses();
    void cycleIsMarked();
    void markersNameTimes();
    void framesAreCounted();
    void soundIsDrawnAndHeard();
    void soundIsThatOfItsTime();

  private:
    ShapeSession& session() { return m_window->session(); }
    const Project& project() { return *session().document().project(); }
    FilmMarks marks() { return filmMarksOf(session().document()); }
    QUndoStack& undo() { return *session().document().undoStack(); }
    TrackView& tracks() { return *m_window->window().findChild<TrackView*>(); }
    TimeRuler& ruler() { return tracks().ruler(); }
    const std::vector<PinMotion>& motions(int handle) { return designOf(project()).handles[handle].motions; }
    std::vector<double> keys(int handle) { return keyTimes(designOf(project()), handle); }
    double pixel() { return 1 / tracks().scale().pixelsOf(1); }
    QPoint spot(int handle, double time) { return tracks().keySpot({handle, time}).toPoint(); }
    void click(int handle, double time, Qt::KeyboardModifiers modifiers = {});
    void drag(QWidget& widget, const QPoint& from, const QPoint& by, Qt::KeyboardModifiers modifiers = {});
    QAction* menuEntry(QWidget& at, const QPoint& place, const QString& text);
    void show(double time);
    void openFilm();
    Vec2 placeAt(int handle, double time);

    std::unique_ptr<SolidFixture> m_window;
};

/// Opens a bar with pins left, right and in the middle; the first two move from 0 to 1 and on to 2, and from
/// 1 to 2.
void TestTracks::init() {
    QSettings().remove(QStringLiteral("ruler"));
    m_window = std::make_unique<SolidFixture>();
    openFilm();
}

void TestTracks::openFilm() {
    QVERIFY(m_window->openPicture());
    for (const double x : {40.0, 200.0, 120.0}) session().addPin({x, 80, 0});
    QVERIFY(settle(session()));
    m_window->window().findChild<Toolbox*>()->setMode(Mode::Animate);
    const auto next = copyOf(project());
    endOf(*next) = 4;
    auto& handles = designOf(*next).handles;
    handles[0].motions = {{Translate<3>{{0, 10, 0}}, 0, 1}, {Translate<3>{{5, 0, 0}}, 1, 2}};
    handles[1].motions = {{Translate<3>{{0, -6, 0}}, 1, 2}};
    session().document().change(QStringLiteral("Film"), next);
    QVERIFY(settle(session()));
    settleLayout(m_window->window().canvas());
    tracks().setFocus();
    show(3);
}

void TestTracks::cleanup() {
    m_window.reset();
    QSettings().remove(QStringLiteral("ruler"));
}

void TestTracks::show(double time) {
    session().playback().setTime(time);
    QVERIFY(settle(session()));
}

void TestTracks::click(int handle, double time, Qt::KeyboardModifiers modifiers) {
    QTest::mouseClick(tracks().viewport(), Qt::LeftButton, modifiers, spot(handle, time));
}

void TestTracks::drag(QWidget& widget, const QPoint& from, const QPoint& by,
                      Qt::KeyboardModifiers modifiers) {
    QTest::mousePress(&widget, Qt::LeftButton, modifiers, from);
    for (int i = 1; i <= 4; ++i) QTest::mouseMove(&widget, from + by * i / 4);
    QTest::mouseRelease(&widget, Qt::LeftButton, modifiers, from + by);
    QVERIFY(settle(session()));
}

/// Opens the menu there and returns the entry whose text begins so, with submenus.
QAction* TestTracks::menuEntry(QWidget& at, const QPoint& place, const QString& text) {
    const auto menus = m_window->window().findChildren<QMenu*>();
    for (const QPointer<QMenu>& old : QList<QPointer<QMenu>>(menus.begin(), menus.end()))
        if (old && old->testAttribute(Qt::WA_DeleteOnClose)) delete old;  // and its submenus
    QContextMenuEvent event(QContextMenuEvent::Mouse, place, at.mapToGlobal(place));
    QCoreApplication::sendEvent(&at, &event);
    for (QMenu* menu : m_window->window().findChildren<QMenu*>()) {
        const QMenu* top = menu;
        while (qobject_cast<QMenu*>(top->parent())) top = qobject_cast<QMenu*>(top->parent());
        if (!top->testAttribute(Qt::WA_DeleteOnClose)) continue;
        for (QAction* action : menu->actions())
            if (action->text().remove('&').startsWith(text)) return action;
    }
    return nullptr;
}

/// Computes the place as the sum of straight motions.
Vec2 TestTracks::placeAt(int handle, double time) {
    Vec2 place = Vec2::Zero();
    for (const PinMotion& motion : motions(handle))
        place += std::clamp((time - motion.start) / (motion.end - motion.start), 0.0, 1.0) *
                 inPlane(std::get<Translate<3>>(motion.kind).by);
    return place;
}

void TestTracks::keysAreDragged() {
    const int steps = undo().count();
    const double second = tracks().scale().pixelsOf(1);
    drag(*tracks().viewport(), spot(0, 1), {int(0.4 * second), 0});
    QCOMPARE(keys(0).size(), 3U);
    QVERIFY(std::abs(keys(0)[1] - 1.4) <= 2 * pixel());
    QCOMPARE(motions(0)[0].end, motions(0)[1].start);
    QCOMPARE(undo().count(), steps + 1);
    QCOMPARE(keys(1), (std::vector<double>{1, 2}));
    QCOMPARE(session().selection().handles(), std::vector<int>{0});
    drag(*tracks().viewport(), spot(1, 2), {int(9 * second), 0});  // beyond the end
    QVERIFY(endOf(project()) > 4 && keys(1)[1] == endOf(project()));
    undo().setIndex(steps);
    QCOMPARE(keys(0), (std::vector<double>{0, 1, 2}));
    QVERIFY(settle(session()));
    drag(*tracks().viewport(), spot(1, 2), {int(1 * second) + 3, 0});  // it snaps to the time shown
    QCOMPARE(keys(1)[1], 3.0);
    // Escape gives a drag up.
    QTest::mousePress(tracks().viewport(), Qt::LeftButton, {}, spot(0, 1));
    QTest::mouseMove(tracks().viewport(), spot(0, 1) + QPoint(20, 0));
    QTest::keyClick(&tracks(), Qt::Key_Escape);
    QTest::mouseRelease(tracks().viewport(), Qt::LeftButton, {}, spot(0, 1));
    QCOMPARE(keys(0), (std::vector<double>{0, 1, 2}));
}

void TestTracks::severalKeysGoTogether() {
    click(0, 1);
    click(1, 2, Qt::ShiftModifier);
    QCOMPARE(session().selection().handles(), (std::vector<int>{0, 1}));
    const double second = tracks().scale().pixelsOf(1);
    drag(*tracks().viewport(), spot(1, 2), {int(0.5 * second), 0});
    QVERIFY(std::abs(keys(0)[1] - 1.5) <= 2 * pixel() && std::abs(keys(1)[1] - 2.5) <= 2 * pixel());
    click(1, keys(1)[1], Qt::ControlModifier);  // taken away again
    QCOMPARE(session().selection().handles(), std::vector<int>{0});
    QTest::keyClick(&tracks(), Qt::Key_Delete);
    QCOMPARE(keys(0), (std::vector<double>{0, 2}));
    QCOMPARE(keys(1).size(), 2U);
    QVERIFY((placeAt(0, 2) - Vec2(5, 10)).norm() < 1e-12);
}

void TestTracks::framesChooseKeys() {
    const QPoint from = spot(1, 2) + QPoint(20, 8);
    drag(*tracks().viewport(), from, spot(0, 1) - QPoint(8, 10) - from);
    QCOMPARE(session().selection().handles(), (std::vector<int>{0, 1}));
    m_window->picture(QStringLiteral("track-keys"));
    QTest::keyClick(&tracks(), Qt::Key_Right, Qt::AltModifier);
    QVERIFY(std::abs(keys(0)[1] - 1.04) < 1e-9 && std::abs(keys(0)[2] - 2.04) < 1e-9);
    QVERIFY(std::abs(keys(1)[0] - 1.04) < 1e-9 && std::abs(keys(1)[1] - 2.04) < 1e-9);
    QCOMPARE(keys(0)[0], 0.0);
}

void TestTracks::keysByKeyboard() {
    click(0, 2);
    const int steps = undo().count();
    for (int i = 0; i < 5; ++i) QTest::keyClick(&tracks(), Qt::Key_Left, Qt::AltModifier);
    QVERIFY(std::abs(keys(0)[2] - 1.8) < 1e-9);
    QCOMPARE(undo().count(), steps + 1);
    QTest::keyClick(&tracks(), Qt::Key_Delete);
    QCOMPARE(keys(0), (std::vector<double>{0, 1}));
    QCOMPARE(session().document().design().handles.size(), 3U);  // the pin stays
}

void TestTracks::keysAreCopiedToTheTimeShown() {
    click(0, 1);
    click(0, 2, Qt::ShiftModifier);
    QTest::keyClick(&tracks(), Qt::Key_C, Qt::ControlModifier);
    show(3.5);
    const int steps = undo().count();
    QTest::keyClick(&tracks(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(undo().count(), steps + 1);
    QCOMPARE(keys(0), (std::vector<double>{0, 1, 2, 3.5, 4.5}));
    QCOMPARE(endOf(project()), 4.5);
    QVERIFY((placeAt(0, 3.5) - Vec2(0, 10)).norm() < 1e-9);
    QVERIFY((placeAt(0, 4.5) - Vec2(5, 10)).norm() < 1e-9);
    QVERIFY(settle(session()));
    QVERIFY((session().gestures().pins()[0].centre - Vec3(40, 90, 0)).norm() <
            1e-6);  // the shape is there, too
    QCOMPARE(session().playback().time(), 3.5);
    undo().undo();
    QCOMPARE(keys(0), (std::vector<double>{0, 1, 2}));
}

void TestTracks::keysAreCopiedToAnotherPin() {
    click(0, 1);
    QTest::keyClick(&tracks(), Qt::Key_C, Qt::ControlModifier);
    QTest::mouseClick(tracks().viewport(), Qt::LeftButton, {}, QPoint(30, spot(2, 0).y()));  // another row
    QCOMPARE(session().selection().handles(), std::vector<int>{2});
    show(2.5);
    QTest::keyClick(&tracks(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(keys(2), (std::vector<double>{0, 2.5}));
    QVERIFY((placeAt(2, 2.5) - Vec2(0, 10)).norm() < 1e-9);
    QSignalSpy notices(&session().document(), &Document::notice);
    show(0);
    QTest::keyClick(&tracks(), Qt::Key_V, Qt::ControlModifier);  // at rest nothing can be posed
    QCOMPARE(notices.size(), 1);
}

void TestTracks::keysAreMirrored() {
    click(0, 2);  // at (5, 10) from its rest, left of the middle
    QAction* mirror = menuEntry(*tracks().viewport(), spot(0, 2), QStringLiteral("Mirror"));
    QVERIFY(mirror);
    mirror->trigger();
    QVERIFY((placeAt(1, 2) - Vec2(-5, 10)).norm() < 1e-9);  // the right pin has the image
    QVERIFY((placeAt(0, 2) - Vec2(5, 10)).norm() < 1e-9);
    undo().undo();
    click(0, 2);
    click(1, 2, Qt::ShiftModifier);  // both: they change roles
    menuEntry(*tracks().viewport(), spot(0, 2), QStringLiteral("Mirror"))->trigger();
    QVERIFY((placeAt(1, 2) - Vec2(-5, 10)).norm() < 1e-9);
    QVERIFY((placeAt(0, 2) - Vec2(0, -6)).norm() < 1e-9);
    QTest::keyClick(&tracks(), Qt::Key_C, Qt::ControlModifier);
    show(4);
    QTest::keyClick(&tracks(), Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY((placeAt(0, 4) - Vec2(5, 10)).norm() < 1e-9);  // mirrored twice
    QVERIFY((placeAt(1, 4) - Vec2(0, -6)).norm() < 1e-9);
}

/// The left and the right pin are each other's images, and the middle one is its own.
void TestTracks::mirrorImagesOfPins() {
    const std::vector<CopiedKey> copies = {
        {0, 0, Amount(1, 2, 0)}, {1, 0, Amount(3, 4, 0)}, {2, 0, Amount(5, 6, 0)}};
    const auto images =
        mirroredKeys(*session().motion().frame(), session().document().design().handles, copies);
    QCOMPARE(images[0].handle, 1);
    QCOMPARE(images[1].handle, 0);
    QCOMPARE(images[2].handle, 2);
    QVERIFY(images[2].offset == Amount(-5, 6, 0));
}

/// Chosen and copied keys stay with their pin when a pin before it is removed and restored.
void TestTracks::choiceStaysWithItsPins() {
    const auto removePin = [&](int handle) {
        show(0);  // later, it would only end to hold
        session().selection().set({handle});
        session().removeSelected();
        show(3);
    };
    const auto isNudged = [&](int handle, double start, double end) {
        QTest::keyClick(&tracks(), Qt::Key_Right, Qt::AltModifier);
        const MotionTime time = timeOf(designOf(project()), handle, 0);
        return std::abs(time.start - start) < 1e-9 && std::abs(time.end - end) < 1e-9;
    };
    const int steps = undo().count();
    click(1, 2);
    QTest::keyClick(&tracks(), Qt::Key_C, Qt::ControlModifier);
    removePin(0);
    QCOMPARE(designOf(project()).handles.size(), 2U);
    QVERIFY(isNudged(0, 1, 2.04));
    QTest::keyClick(&tracks(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(keys(0), (std::vector<double>{1, 2.04, 3}));
    QCOMPARE(motions(1).size(), 0U);
    undo().setIndex(steps);
    click(1, 1);
    removePin(0);
    undo().undo();
    QVERIFY(isNudged(1, 1.04, 2));
    undo().undo();
    QTest::mouseClick(tracks().viewport(), Qt::LeftButton, {}, tracks().barOf(1, 0).center().toPoint());
    removePin(0);
    QVERIFY(isNudged(0, 1.04, 2.04));
    undo().setIndex(steps);
    QVERIFY(isNudged(1, 1.04, 2.04));
    QCOMPARE(keys(0), (std::vector<double>{0, 1, 2}));
    // Copies of a removed pin are pasted to the selected one.
    removePin(1);
    session().selection().set({1});
    QTest::keyClick(&tracks(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(keys(1).size(), 2U);
    QCOMPARE(keys(1)[1], 3.0);
    // In another file, copies are pasted to the pins at the same positions.
    session().document().close();
    openFilm();
    session().selection().set({});
    QTest::keyClick(&tracks(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(keys(1), (std::vector<double>{1, 2, 3}));
}

void TestTracks::menuOfAKey() {
    const auto entry = [&](const char* text) {
        return menuEntry(*tracks().viewport(), spot(0, 1), QString::fromLatin1(text));
    };
    QVERIFY(entry("Linear")->isChecked());
    entry("Slow on Both Sides")->trigger();
    QVERIFY(motions(0)[0].ease == Ease::Out && motions(0)[1].ease == Ease::In);
    QVERIFY(entry("Slow on Both Sides")->isChecked());
    entry("Slow after It")->trigger();
    QVERIFY(motions(0)[0].ease == Ease::Linear && motions(0)[1].ease == Ease::In);
    QVERIFY(!entry("Paste at the Time Shown")->isEnabled());
    entry("Hold to the Next")->trigger();
    QCOMPARE(keys(0), (std::vector<double>{0, 1}));
    undo().undo();
    entry("Remove Key")->trigger();
    QCOMPARE(keys(0), (std::vector<double>{0, 2}));
    const int steps = undo().count();
    QSignalSpy notices(&session().document(), &Document::notice);
    menuEntry(*tracks().viewport(), spot(0, 0), QStringLiteral("Remove Key"))
        ->trigger();  // it is at rest there
    QVERIFY(notices.size() == 1 && undo().count() == steps);
}

void TestTracks::lockedKeysStay() {
    const auto next = copyOf(project());
    designOf(*next).handles[0].traits.locked = true;
    session().document().change(QStringLiteral("Lock"), next);
    QVERIFY(settle(session()));
    drag(*tracks().viewport(), spot(0, 1), {40, 0});
    click(0, 1);
    QTest::keyClick(&tracks(), Qt::Key_Delete);
    QCOMPARE(keys(0), (std::vector<double>{0, 1, 2}));
}

/// A recording of an arc becomes few keys, or one straight move.
void TestTracks::menuOfABarSimplifies() {
    Recorded<3> arc;
    for (int i = 0; i <= 90; ++i) {
        const double angle = i * std::numbers::pi / 180;
        arc.times.push_back(i);
        arc.points.push_back(30 * Vec3(1 - std::cos(angle), std::sin(angle), 0));
    }
    const auto next = copyOf(project());
    designOf(*next).handles[2].motions = {{arc, 0, 3}};
    session().document().change(QStringLiteral("Arc"), next);
    QVERIFY(settle(session()));
    const auto entry = [&](const char* text) {
        return menuEntry(*tracks().viewport(), tracks().barOf(2, 0).center().toPoint(),
                         QString::fromLatin1(text));
    };
    entry("Many")->trigger();
    const std::size_t many = motions(2).size();
    QVERIFY(many > 1 && many < 8);
    double worst = 0;
    for (int i = 0; i <= 90; ++i) {
        Vec3 place = Vec3::Zero();
        for (const PinMotion& motion : motions(2)) {
            const double s = std::clamp((i / 30.0 - motion.start) / (motion.end - motion.start), 0.0, 1.0);
            const double eased[] = {s, s * s, s * (2 - s), s * s * (3 - 2 * s)};
            place += eased[int(motion.ease)] * std::get<Translate<3>>(motion.kind).by;
        }
        worst = std::max(worst, (place - arc.points[i]).norm());
    }
    QVERIFY2(worst <= session().motion().pixel() * 1.000001, qPrintable(QString::number(worst)));
    undo().undo();
    QVERIFY(settle(session()));
    entry("Straighten")->trigger();
    QCOMPARE(motions(2).size(), 1U);
    QVERIFY((placeAt(2, 1.5) - Vec2(15, 15)).norm() < 1e-9);
}

/// A second drag of the same pin at the end corrects the move; with Keep the Path it continues the path.
void TestTracks::dragAtTheEndIsCorrected() {
    QVERIFY(m_window->window().actions().poseHere->isChecked());
    const auto dragPin = [&](const QPoint& by) {
        session().playback().setTime(endOf(project()));
        QVERIFY(settle(session()));
        QWidget& canvas = m_window->window().canvas();
        drag(canvas, m_window->window().canvas().onScreen(session().gestures().pins()[2].centre).toPoint(),
             by);
    };
    dragPin({0, 30});
    QCOMPARE(endOf(project()), 5.0);
    const int steps = undo().count();
    dragPin({20, 0});
    QCOMPARE(endOf(project()), 5.0);
    QCOMPARE(motions(2).size(), 1U);
    QCOMPARE(undo().count(), steps + 1);
    const Vec3 by = std::get<Translate<3>>(motions(2)[0].kind).by;
    QVERIFY(by.x() > 1 && by.y() > 1);
    m_window->window().actions().keepWay->trigger();
    dragPin({20, 0});
    QCOMPARE(endOf(project()), 6.0);
    QCOMPARE(motions(2).size(), 2U);
    m_window->window().actions().keepWay->trigger();
    session().document().change(QStringLiteral("Other"), copyOf(project()));  // in between
    dragPin({20, 0});
    QCOMPARE(endOf(project()), 7.0);
}

/// A film is made of poses at three times, one between, another time for it, copies on the other side, and a
/// cycle, then saved and reopened.
void TestTracks::filmIsMadeOfPoses() {
    const int steps = undo().count();
    const std::string first = toJson(project());
    const auto pose = [&](double time, const QPoint& by) {
        show(time);
        QWidget& canvas = m_window->window().canvas();
        drag(canvas, m_window->window().canvas().onScreen(session().gestures().pins()[2].centre).toPoint(),
             by);
    };
    pose(1, {0, 30});
    pose(3, {0, -40});
    pose(3.5, {0, 10});
    QCOMPARE(keys(2), (std::vector<double>{0, 1, 3, 3.5}));
    const Vec2 before = placeAt(2, 1), after = placeAt(2, 3);
    pose(2, {30, 0});
    QCOMPARE(keys(2), (std::vector<double>{0, 1, 2, 3, 3.5}));
    QVERIFY((placeAt(2, 1) - before).norm() < 1e-9 && (placeAt(2, 3) - after).norm() < 1e-9);
    const Vec2 between = placeAt(2, 2);
    drag(*tracks().viewport(), spot(2, 2), {int(0.4 * tracks().scale().pixelsOf(1)), 0});
    const double moved = keys(2)[2];
    QVERIFY(std::abs(moved - 2.4) <= 2 * pixel() && (placeAt(2, moved) - between).norm() < 1e-9);
    tracks().setFocus();
    click(2, moved);
    QTest::keyClick(&tracks(), Qt::Key_C, Qt::ControlModifier);
    show(4);
    QTest::keyClick(&tracks(), Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);  // it is in the middle
    QVERIFY((placeAt(2, 4) - Vec2(-between.x(), between.y())).norm() < 1e-9);
    QTest::keyClick(&tracks(), Qt::Key_O);
    QVERIFY(settle(session()) && marks().cycle);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("film.wend"));
    session().document().save(path);
    const std::string last = toJson(project());
    const auto again = wend::openFile(path).project;
    QCOMPARE(toJson(*again).substr(toJson(*again).find("\"handles\"")),
             last.substr(last.find("\"handles\"")));
    QCOMPARE(undo().count(), steps + 7);
    undo().setIndex(steps);
    QCOMPARE(toJson(project()), first);
    undo().setIndex(steps + 7);
    QCOMPARE(toJson(project()), last);
}

void TestTracks::cycleIsMarked() {
    const auto at = [&](double time) { return QPoint(int(std::lround(tracks().scale().xOf(time))), 12); };
    const int steps = undo().count();
    drag(ruler(), at(0.5), at(2.5) - at(0.5), Qt::ShiftModifier);
    QVERIFY(marks().cycle);
    QVERIFY(std::abs(marks().cycle->at(0) - 0.5) <= pixel() &&
            std::abs(marks().cycle->at(1) - 2.5) <= pixel());
    QCOMPARE(session().playback().time(), 3.0);
    drag(ruler(), ruler().cycleSpot(1).toPoint(), at(3.5) - at(2.5));
    QVERIFY(std::abs(marks().cycle->at(1) - 3.5) <= 2 * pixel());
    show(1);
    QTest::keyClick(&tracks(), Qt::Key_I);
    QCOMPARE(marks().cycle->at(0), 1.0);
    show(2);
    QTest::keyClick(&tracks(), Qt::Key_O);
    QVERIFY((*marks().cycle == std::array{1.0, 2.0}));
    m_window->picture(QStringLiteral("ruler-cycle"));
    show(3);
    QTest::keyClick(&tracks(), Qt::Key_I);  // behind its end, which gives way
    QVERIFY((*marks().cycle == std::array{3.0, 4.0}));
    menuEntry(ruler(), at(1), QStringLiteral("Cycle from Here"))->trigger();  // where it was right-clicked
    QVERIFY(std::abs(marks().cycle->at(0) - 1) <= pixel() && marks().cycle->at(1) == 4);
    menuEntry(ruler(), at(2), QStringLiteral("Cycle to Here"))->trigger();
    QVERIFY(std::abs(marks().cycle->at(1) - 2) <= pixel());
    QCOMPARE(session().playback().time(), 3.0);
    menuEntry(ruler(), at(1), QStringLiteral("No Cycle"))->trigger();
    QVERIFY(!marks().cycle);
    QCOMPARE(undo().count(), steps + 8);
    undo().setIndex(steps);
    QVERIFY(!marks().cycle);
}

void TestTracks::markersNameTimes() {
    const int rows = ruler().rows();
    show(1.5);
    QTest::keyClick(&tracks(), Qt::Key_M, Qt::ShiftModifier);
    QCOMPARE(marks().markers.size(), 1U);
    QCOMPARE(marks().markers[0].at, 1.5);
    QCOMPARE(marks().markers[0].name, std::string("Marker 1"));
    QVERIFY(ruler().rows() > rows && ruler().height() == ruler().rows());
    show(0.5);
    QTest::keyClick(&tracks(), Qt::Key_M, Qt::ShiftModifier);
    QCOMPARE(marks().markers[0].name, std::string("Marker 2"));  // in the order of time
    m_window->picture(QStringLiteral("ruler-markers"));
    const double second = tracks().scale().pixelsOf(1);
    drag(ruler(), ruler().markerSpot(1).toPoint(), {int(second), 0});
    QVERIFY(std::abs(marks().markers[1].at - 2.5) <= 2 * pixel());
    const double at = marks().markers[1].at;
    drag(*tracks().viewport(), spot(1, 2), {int((at - 2) * second) + 3, 0});  // a key snaps to it
    QCOMPARE(keys(1)[1], at);
    menuEntry(ruler(), ruler().markerSpot(0).toPoint(), QStringLiteral("Remove Marker"))->trigger();
    QCOMPARE(marks().markers.size(), 1U);
    QCOMPARE(marks().markers[0].name, std::string("Marker 1"));
    const QPoint there(int(tracks().scale().xOf(1)), 12);  // not the time shown
    menuEntry(ruler(), there, QStringLiteral("Add Marker"))->trigger();
    QVERIFY(std::abs(marks().markers[0].at - 1) <= 2 * pixel());
}

void TestTracks::framesAreCounted() {
    const QPoint at(int(tracks().scale().xOf(1)), 12);
    QAction* count = menuEntry(ruler(), at, QStringLiteral("Count Frames"));
    QVERIFY(!count->isChecked());
    count->trigger();
    QVERIFY(tracks().scale().countsFrames());
    m_window->picture(QStringLiteral("ruler-frames"));
    menuEntry(ruler(), at, QStringLiteral("12 fps"))->trigger();
    QCOMPARE(marks().frameRate, 12.0);
    const auto onFrame = [](double time) { return std::abs(12 * time - std::round(12 * time)) < 1e-9; };
    const double second = tracks().scale().pixelsOf(1);
    for (const double by : {0.13, 0.29, 0.34}) {
        drag(*tracks().viewport(), spot(0, keys(0)[1]), {int(by * second), 0});
        QVERIFY(onFrame(keys(0)[1]));
    }
    QTest::mouseClick(&ruler(), Qt::LeftButton, {}, at + QPoint(int(0.3 * second), 0));
    QVERIFY(onFrame(session().playback().time()));
    const double before = session().playback().time();
    QTest::keyClick(&tracks(), Qt::Key_Right);
    QVERIFY(std::abs(session().playback().time() - before - 1 / 12.0) < 1e-9);
}

/// Writes a sound of one channel.
bool writeWave(const QString& path, const std::vector<double>& sound, int rate) {
    QFile wave(path);
    if (!wave.open(QFile::WriteOnly)) return false;
    const auto bytes = static_cast<quint32>(2 * sound.size());
    QDataStream out(&wave);
    out.setByteOrder(QDataStream::LittleEndian);
    out.writeRawData("RIFF", 4);
    out << quint32(36 + bytes);
    out.writeRawData("WAVEfmt ", 8);
    out << quint32(16) << quint16(1) << quint16(1) << quint32(rate) << quint32(2 * rate) << quint16(2)
        << quint16(16);
    out.writeRawData("data", 4);
    out << bytes;
    for (const double sample : sound) out << static_cast<qint16>(32767 * sample);
    return out.status() == QDataStream::Ok;
}

/// A second of silence and a second of a tone: the drawn loudness is that which ffmpeg decodes, and the
/// player is asked for the sound at the right times.
void TestTracks::soundIsDrawnAndHeard() {
    if (QStandardPaths::findExecutable(QStringLiteral("ffmpeg")).isEmpty()) QFAIL("ffmpeg is not there");
    QTemporaryDir folder;
    constexpr int kRate = 8000;
    std::vector<double> samples(2 * kRate, 0);
    for (int i = kRate; i < 2 * kRate; ++i)
        samples[i] = 0.5 * std::sin(2 * std::numbers::pi * 440 * i / kRate);
    const QString wave = folder.filePath(QStringLiteral("tone.wav"));
    QVERIFY(writeWave(wave, samples, kRate));
    QFile player(folder.filePath(QStringLiteral("ffplay")));  // instead of the real one
    QVERIFY(player.open(QFile::WriteOnly));
    player.write("#!/bin/sh\necho \"$@\" >>\"$(dirname \"$0\")/played\"\nexec sleep 60\n");
    player.close();
    QVERIFY(player.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
    const QByteArray path = qgetenv("PATH");
    qputenv("PATH", folder.path().toUtf8() + ':' + path);
    const auto restore = qScopeGuard([&] { qputenv("PATH", path); });

    auto& sound = *tracks().findChild<SoundTrack*>();
    const int rows = ruler().rows();
    auto& panel = *m_window->window().findChild<FilmPanel*>();
    panel.setSound(wave);
    QTRY_COMPARE_WITH_TIMEOUT(sound.peaks().size(), std::size_t(2 / SoundTrack::kPeriod), 20000);
    for (std::size_t i = 0; i < sound.peaks().size(); ++i)
        QVERIFY(i < 99    ? sound.peaks()[i] < 0.01F
                : i > 101 ? std::abs(sound.peaks()[i] - 0.5F) < 0.03F
                          : true);
    QVERIFY(ruler().rows() > rows);
    QVERIFY(settle(session()));
    m_window->picture(QStringLiteral("ruler-sound"));
    const auto played = [&] {
        QFile file(folder.filePath(QStringLiteral("played")));
        return file.open(QFile::ReadOnly) ? QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts)
                                          : QStringList();
    };
    session().playback().setTime(1.5);
    session().playback().setPlaying(true);
    QTRY_COMPARE_WITH_TIMEOUT(played().size(), 1, 20000);
    QVERIFY(played()[0].contains(QStringLiteral("-ss 1.500")) &&
            played()[0].contains(QStringLiteral("tone.wav")));
    session().playback().setTime(0.25);  // as a loop does
    QTRY_VERIFY_WITH_TIMEOUT(played().size() >= 2, 20000);
    session().playback().setPlaying(false);
    sound.setHeard(false);
    const auto count = played().size();
    const QList<pid_t> processes = childrenOf(getpid());
    session().playback().setTime(0);
    session().playback().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(session().playback().time() > 0.05, 20000);
    QCOMPARE(childrenOf(getpid()), processes);  // no player
    session().playback().setPlaying(false);
    QCOMPARE(played().size(), count);
    undo().undo();
    QVERIFY(sound.peaks().empty() && ruler().rows() == rows);
    QSignalSpy notices(&session().document(), &Document::notice);
    panel.setSound(folder.filePath(QStringLiteral("none.wav")));
    QTRY_COMPARE_WITH_TIMEOUT(notices.size(), 1, 20000);
}

/// Every second has a tone of its own, 400, 800 … Hz. The player's output, here written to a file, starts at
/// the time from which the film plays: the tone changes where the next second begins.
void TestTracks::soundIsThatOfItsTime() {
    if (QStandardPaths::findExecutable(QStringLiteral("ffplay")).isEmpty()) QFAIL("ffplay is not there");
    constexpr int kRate = 44100, kWindow = 441;  // 10 ms
    std::vector<double> samples(4 * kRate);
    double phase = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i] = 0.5 * std::sin(phase);
        phase += 2 * std::numbers::pi * 400 * static_cast<double>(1 + i / kRate) / kRate;
    }
    QTemporaryDir folder;
    const QString wave = folder.filePath(QStringLiteral("tones.wav"));
    QVERIFY(writeWave(wave, samples, kRate));
    qputenv("SDL_AUDIODRIVER", "disk");
    const auto restore = qScopeGuard([] { qunsetenv("SDL_AUDIODRIVER"), qunsetenv("SDL_DISKAUDIOFILE"); });
    m_window->window().findChild<FilmPanel*>()->setSound(wave);
    QVERIFY(settle(session()));
    for (const double from : {0.7, 1.9}) {
        const QString device = folder.filePath(QStringLiteral("device-%1").arg(from));
        qputenv("SDL_DISKAUDIOFILE", device.toUtf8());
        session().playback().setTime(from);
        session().playback().setPlaying(true);
        QTRY_VERIFY_WITH_TIMEOUT(QFileInfo(device).size() > 2 * kRate / 2, 20000);  // half a second
        session().playback().setPlaying(false);
        QFile file(device);
        QVERIFY(file.open(QFile::ReadOnly));
        const QByteArray heard = file.readAll();
        const auto at = [&](qsizetype i) {
            qint16 sample = 0;
            std::memcpy(&sample, heard.constData() + 2 * i, 2);
            return int{sample};
        };
        qsizetype first = 0;  // before it the player has nothing yet
        while (2 * first + 2 < heard.size() && at(first) == 0) ++first;
        std::vector<int> tones;  // of every window, by its changes of sign
        for (qsizetype w = first; tones.size() < 40 && 2 * (w + kWindow) < heard.size(); w += kWindow) {
            int changes = 0;
            for (qsizetype i = w + 1; i < w + kWindow; ++i) changes += (at(i) < 0) != (at(i - 1) < 0);
            tones.push_back(int(std::lround(changes / 8.0)));
        }
        QVERIFY(tones.size() >= 35);
        const int second = int(from), until = int(std::lround(100 * (second + 1 - from)));
        for (int w = 0; w < int(tones.size()); ++w)
            if (std::abs(w - until) > 1) QCOMPARE(tones[w], second + (w < until ? 1 : 2));
    }
}

QTEST_MAIN(TestTracks)
#include "test_tracks.moc"
