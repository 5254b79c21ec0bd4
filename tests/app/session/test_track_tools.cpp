#include <QFile>
#include <QLabel>
#include <QMenuBar>
#include <QPointer>
#include <QProcess>
#include <QScopeGuard>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolButton>
#include <QUndoStack>

#include "app/panels/fields/number_boxes.h"
#include "app/panels/film_panel.h"
#include "app/project/design.h"
#include "app/project/edits/film_edits.h"
#include "app/project/edits/progress.h"
#include "app/project/file/project_writer.h"
#include "app/session/opening.h"
#include "app/window/film/ease_editor.h"
#include "app/window/film/key_pose_strip.h"
#include "app/window/film/sound_track.h"
#include "app/window/film/time_ruler.h"
#include "app/window/film/time_strip.h"
#include "app/window/film/track_view.h"
#include "app/window/help/shortcuts.h"
#include "tests/support/child_processes.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// Tools of the tracks on the real window: the easing curve, the pictures of key poses, and the sound while
/// time is scrubbed.
class TestTrackTools : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void curveIsDragged();
    void curveFollowsTheChoice();
    void curveByKeysAndNumbers();
    void presetsAndHold();
    void rotationsHaveNoHandles();
    void posesAreDrawn();
    void posesOfASolid();
    void posesMakeRoomForRows();
    void soundWhileScrubbing();
    void cheatSheetHasTheKeys();

  private:
    ShapeSession& session() { return m_window->session(); }
    const Project& project() { return *session().document().project(); }
    QUndoStack& undo() { return *session().document().undoStack(); }
    TrackView& tracks() { return *m_window->window().findChild<TrackView*>(); }
    KeyPoseStrip& poses() { return tracks().poses(); }
    EaseEditor& editor() { return *m_window->window().findChild<EaseEditor*>(); }
    EasePlot& plot() { return editor().plot(); }
    const std::vector<PinMotion>& motions(int handle) {
        return designOf(project()).handles[static_cast<std::size_t>(handle)].motions;
    }
    Progress progress(int handle, int motion) {
        return shownProgress(designOf(project()), {handle, motion}).curve;
    }
    void choose(int handle, double time, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseClick(tracks().viewport(), Qt::LeftButton, modifiers,
                          tracks().keySpot({handle, time}).toPoint());
    }
    void dragHandle(int handle, double way);

    std::unique_ptr<SolidFixture> m_window;
};

/// A bar with pins left and right; the first moves from 0 to 1 and on to 2 s, the other one from 1 to 2 s.
void TestTrackTools::init() {
    QSettings().remove(QStringLiteral("ruler"));
    m_window = std::make_unique<SolidFixture>();
    QVERIFY(m_window->openPicture());
    for (const double x : {40.0, 200.0}) session().addPin({x, 80, 0});
    QVERIFY(settle(session()));
    m_window->window().findChild<Toolbox*>()->setMode(Mode::Animate);
    const auto next = copyOf(project());
    endOf(*next) = 4;
    auto& handles = designOf(*next).handles;
    handles[0].motions = {{Translate<3>{{0, 30, 0}}, 0, 1}, {Translate<3>{{5, 0, 0}}, 1, 2}};
    handles[1].motions = {{Translate<3>{{0, -20, 0}}, 1, 2}};
    session().document().change(QStringLiteral("Film"), next);
    QVERIFY(settle(session()));
    settleLayout(m_window->window().canvas());
    tracks().setFocus();
}

void TestTrackTools::cleanup() {
    m_window.reset();
    QSettings().remove(QStringLiteral("ruler"));
}

void TestTrackTools::dragHandle(int handle, double way) {
    const QPoint from = plot().handleSpot(handle).toPoint();
    const double height = plot().height() - 16;  // without its margins
    const QPoint by(30, qRound(-way / (EasePlot::kHigh - EasePlot::kLow) * height));
    QTest::mousePress(&plot(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 4; ++i) QTest::mouseMove(&plot(), from + by * i / 4);
    QTest::mouseRelease(&plot(), Qt::LeftButton, {}, from + by);
    QVERIFY(settle(session()));
}

void TestTrackTools::curveIsDragged() {
    choose(0, 1);
    QTest::keyClick(&tracks(), Qt::Key_E);
    QVERIFY(editor().isVisible());
    const int steps = undo().count();
    const std::string before = toJson(project());
    dragHandle(0, -0.25);
    QCOMPARE(undo().count(), steps + 1);
    const Progress now = progress(0, 1);  // the motion after the key
    QVERIFY(std::abs(now.first - (1.0 / 3 - 0.25)) < 0.02 && std::abs(now.second - 2.0 / 3) < 1e-12);
    QVERIFY(std::holds_alternative<CurveMotion<3>>(motions(0)[1].kind));
    QCOMPARE(progress(0, 0), Progress());
    dragHandle(1, 0.5);  // beyond its end
    QVERIFY(progress(0, 1).second > 1.1);
    m_window->picture(QStringLiteral("ease-editor"));
    // Esc puts a handle back, without a step and without closing.
    QTest::mousePress(&plot(), Qt::LeftButton, {}, plot().handleSpot(0).toPoint());
    QTest::mouseMove(&plot(), plot().handleSpot(0).toPoint() + QPoint(0, 40));
    QTest::keyClick(&plot(), Qt::Key_Escape);
    QTest::mouseRelease(&plot(), Qt::LeftButton, {}, plot().handleSpot(0).toPoint());
    QVERIFY(editor().isVisible());
    QCOMPARE(undo().count(), steps + 2);
    undo().undo();
    undo().undo();
    QCOMPARE(toJson(project()), before);
    QCOMPARE(plot().curve(), Progress());
}

void TestTrackTools::curveFollowsTheChoice() {
    choose(0, 1);
    QTest::keyClick(&tracks(), Qt::Key_E);
    choose(0, 0);
    dragHandle(0, -1.0 / 3);  // snaps to 0: an easing
    QVERIFY(motions(0)[0].ease == Ease::Linear || std::abs(progress(0, 0).first) < 1e-12);
    QCOMPARE(plot().curve(), progress(0, 0));
    choose(1, 2);
    QCOMPARE(plot().curve(), progress(1, 0));
    // An easing is set between two keys of a pin, and of several pins at once.
    choose(0, 1);
    choose(0, 2, Qt::ShiftModifier);
    choose(1, 1, Qt::ShiftModifier);
    choose(1, 2, Qt::ShiftModifier);
    QCOMPARE(tracks().choice().easedMotions(), (std::vector<MotionId>{{0, 1}, {1, 0}}));
    const int steps = undo().count();
    dragHandle(1, 0.2);
    QCOMPARE(undo().count(), steps + 1);
    QVERIFY(std::abs(progress(0, 1).second - progress(1, 0).second) < 1e-12);
    QVERIFY(std::abs(progress(1, 0).second - (2.0 / 3 + 0.2)) < 0.02);
    QTest::mouseClick(tracks().viewport(), Qt::LeftButton, {},
                      QPoint(tracks().viewport()->width() - 4, tracks().viewport()->height() - 3));
    QVERIFY(tracks().choice().easedMotions().empty());
    QVERIFY(!editor().findChild<QToolButton*>()->isEnabled());
    m_window->window().findChild<Toolbox*>()->setMode(Mode::Pins);  // it goes with the tracks
    QVERIFY(!editor().isVisible());
}

void TestTrackTools::curveByKeysAndNumbers() {
    choose(0, 1);
    QTest::keyClick(&tracks(), Qt::Key_E);
    const int steps = undo().count();
    QTest::keyClick(&plot(), Qt::Key_Right);
    for (int i = 0; i < 3; ++i) QTest::keyClick(&plot(), Qt::Key_Up);
    QTest::keyClick(&plot(), Qt::Key_Down, Qt::ShiftModifier);
    QVERIFY(std::abs(progress(0, 1).second - (2.0 / 3 + 0.06 - 0.1)) < 1e-12);
    QCOMPARE(undo().count(), steps + 1);  // they merge
    choose(1, 1);
    QTest::keyClick(&plot(), Qt::Key_Up);
    QCOMPARE(undo().count(), steps + 2);  // another motion
    choose(0, 1);
    const auto boxes = editor().findChildren<ExactBox*>();
    QCOMPARE(boxes.size(), 2);
    boxes[0]->setValue(250);
    boxes[1]->setValue(-30);
    const Progress typed = progress(0, 1);
    QVERIFY(std::abs(typed.startSpeed() - 2.5) < 1e-12 && std::abs(typed.endSpeed() + 0.3) < 1e-12);
    QCOMPARE(undo().count(), steps + 3);
}

void TestTrackTools::presetsAndHold() {
    choose(0, 1);
    choose(0, 2, Qt::ShiftModifier);
    QTest::keyClick(&tracks(), Qt::Key_E);
    const auto buttons = editor().findChildren<QToolButton*>();
    QCOMPARE(buttons.size(), 5);
    const Ease eases[] = {Ease::Linear, Ease::In, Ease::Out, Ease::InOut};
    for (int i : {3, 1, 2, 0}) {
        buttons[i]->click();
        QVERIFY(std::holds_alternative<Translate<3>>(motions(0)[1].kind) && motions(0)[1].ease == eases[i]);
        for (int k = 0; k < 4; ++k) QCOMPARE(buttons[k]->isChecked(), k == i);
    }
    choose(0, 0);
    const int steps = undo().count();
    editor().findChild<QToolButton*>(QStringLiteral("easeHold"))->click();
    QCOMPARE(undo().count(), steps + 1);
    QCOMPARE(motions(0).size(),
             std::size_t{1});  // it rests from 0 to 1 s, and comes at 2 s where it was then
    QVERIFY(motions(0)[0].start == 1);
    QVERIFY((std::get<Translate<3>>(motions(0)[0].kind).by - Vec3(5, 30, 0)).norm() < 1e-12);
}

void TestTrackTools::rotationsHaveNoHandles() {
    const auto next = copyOf(project());
    Rotate<3> turn;
    turn.centre = {40, 80, 0};
    turn.axis = Vec3::UnitZ();
    turn.angle = 0.3;
    designOf(*next).handles[0].motions[1].kind = turn;
    session().document().change(QStringLiteral("Turn"), next);
    QVERIFY(settle(session()));
    choose(0, 1);
    QTest::keyClick(&tracks(), Qt::Key_E);
    const int steps = undo().count();
    dragHandle(0, 0.2);
    QCOMPARE(undo().count(), steps);
    editor().findChildren<QToolButton*>()[1]->click();
    QCOMPARE(motions(0)[1].ease, Ease::In);
    QVERIFY(!editor().findChildren<ExactBox*>()[0]->isEnabled());
}

/// The picture of a key pose is that of the shown shape, and only those of changed poses are drawn again.
void TestTrackTools::posesAreDrawn() {
    QVERIFY(poses().isVisible());
    QCOMPARE(poses().times(), (std::vector<double>{0, 1, 2}));
    QTRY_VERIFY_WITH_TIMEOUT(poses().isDone(), 30000);
    m_window->picture(QStringLiteral("key-poses"));
    const auto image = [&](double time) { return poses().pictureOf(time).toImage(); };
    QVERIFY(!image(0).isNull() && image(0) != image(1) && image(1) != image(2));
    const QImage rest = image(0), first = image(1), last = image(2);
    QTest::mouseClick(&poses(), Qt::LeftButton, {}, poses().placeOf(1).center().toPoint());
    QCOMPARE(session().playback().time(), 1.0);
    const auto next = copyOf(project());
    std::get<Translate<3>>(designOf(*next).handles[1].motions[0].kind).by = {0, 25, 0};
    session().document().change(QStringLiteral("Other"), next);
    QVERIFY(settle(session()));
    QTRY_VERIFY_WITH_TIMEOUT(poses().isDone(), 30000);
    QVERIFY(image(0) == rest && image(1) == first && image(2) != last);
    undo().undo();
    QVERIFY(settle(session()));
    QTRY_VERIFY_WITH_TIMEOUT(poses().isDone(), 30000);
    QVERIFY(image(2) == last);
    m_window->window().findChild<Toolbox*>()->setMode(Mode::Pins);
    QVERIFY(!poses().isVisible());
}

void TestTrackTools::posesOfASolid() {
    m_window = std::make_unique<SolidFixture>();
    QVERIFY(m_window->open());
    m_window->window().findChild<Toolbox*>()->setMode(Mode::Animate);
    const auto next = copyOf(project());
    endOf(*next) = 1;
    for (const double x : {-1.5, 1.5}) {
        Pin handle;
        handle.name = x < 0 ? "left" : "right";
        handle.at = std::vector<Vec3>{{x, 0, 0}};
        if (x > 0) handle.motions = {{Translate<3>{{0, 0, 0.8}}, 0, 1}};
        designOf(*next).handles.push_back(handle);
    }
    session().document().change(QStringLiteral("Film"), next);
    QVERIFY(settle(session()));
    QTRY_VERIFY_WITH_TIMEOUT(poses().isVisible() && poses().isDone(), 30000);
    QVERIFY(!poses().pictureOf(0).isNull());
    QVERIFY(poses().pictureOf(0).toImage() != poses().pictureOf(1).toImage());
    m_window->picture(QStringLiteral("key-poses-solid"));
}

void TestTrackTools::posesMakeRoomForRows() {
    QVERIFY(poses().isVisible());
    tracks().setMaximumHeight(100);
    settleLayout(m_window->window().canvas());
    QTRY_VERIFY(!poses().isVisible());
    QCOMPARE(tracks().ruler().y(), 0);
    tracks().setMaximumHeight(240);
    tracks().setMinimumHeight(240);
    QTRY_VERIFY(poses().isVisible());
    QCOMPARE(tracks().ruler().y(), int(KeyPoseStrip::kHeight));
    const auto menus = m_window->window().findChildren<QMenu*>();
    for (const QPointer<QMenu>& old : QList<QPointer<QMenu>>(menus.begin(), menus.end()))
        if (old && old->testAttribute(Qt::WA_DeleteOnClose)) delete old;  // and its submenus
    QContextMenuEvent event(QContextMenuEvent::Mouse, {200, 5}, tracks().ruler().mapToGlobal(QPoint(200, 5)));
    QCoreApplication::sendEvent(&tracks().ruler(), &event);
    for (QAction* action : tracks().ruler().findChild<QMenu*>()->actions())
        if (action->text().remove('&') == QStringLiteral("Show Key Poses")) action->trigger();
    QTRY_VERIFY(!poses().isVisible());
    QCOMPARE(tracks().ruler().y(), 0);
}

/// Scrubbing plays short pieces at the shown times, one after the other, the last one where the pointer ends;
/// none while it is switched off, and no player process is left.
void TestTrackTools::soundWhileScrubbing() {
    QTemporaryDir folder;
    QFile player(folder.filePath(QStringLiteral("ffplay")));  // instead of the real one
    QVERIFY(player.open(QFile::WriteOnly));
    player.write(
        "#!/bin/sh\ncd \"$(dirname \"$0\")\"\necho \"$@\" >>played\necho $$ >>processes\n"
        "while [ -e slow ]; do sleep 0.05; done\n");
    player.close();
    QVERIFY(player.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
    const QByteArray path = qgetenv("PATH");
    qputenv("PATH", folder.path().toUtf8() + ':' + path);
    const auto restore = qScopeGuard([&] { qputenv("PATH", path); });
    const auto lines = [&](const char* name) {
        QFile file(folder.filePath(QString::fromLatin1(name)));
        return file.open(QFile::ReadOnly) ? QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts)
                                          : QStringList();
    };
    m_window->window().findChild<FilmPanel*>()->setSound(folder.filePath(QStringLiteral("song.wav")));
    QVERIFY(settle(session()));
    TimeRuler& ruler = tracks().ruler();
    const auto at = [&](double time) { return QPoint(qRound(tracks().scale().xOf(time)), 12); };
    QTest::mousePress(&ruler, Qt::LeftButton, {}, at(1));
    QTRY_COMPARE_WITH_TIMEOUT(lines("played").size(), 1, 20000);
    QVERIFY(lines("played")[0].contains(QStringLiteral("song.wav -t 0.12")));
    // Pieces whose times passed while another was playing are left out.
    QFile slow(folder.filePath(QStringLiteral("slow")));
    QVERIFY(slow.open(QFile::WriteOnly));
    QTest::mouseMove(&ruler, at(1.25));
    QTRY_COMPARE_WITH_TIMEOUT(lines("played").size(), 2, 20000);
    for (const double time : {1.5, 1.75, 2.0, 3.0}) QTest::mouseMove(&ruler, at(time));
    slow.remove();
    QTRY_COMPARE_WITH_TIMEOUT(lines("played").size(), 3, 20000);
    const double shown = session().playback().time();
    QVERIFY(std::abs(shown - 3) < 0.02);
    QVERIFY(lines("played")[2].contains(QStringLiteral("-ss %1 ").arg(shown, 0, 'f', 3)));
    QTest::mouseRelease(&ruler, Qt::LeftButton, {}, at(3));
    // The slider below does the same; other changes of the time are silent.
    session().playback().setTime(0.5);
    auto& slider = *m_window->window().findChild<TimeStrip*>()->slider();
    slider.setSliderDown(true);
    slider.setValue(slider.maximum() / 2);
    slider.setSliderDown(false);
    QTRY_COMPARE_WITH_TIMEOUT(lines("played").size(), 4, 20000);
    QVERIFY(lines("played")[3].contains(QStringLiteral("-ss 2.000")));
    tracks().sound().setHeard(false);
    const QList<pid_t> processes = childrenOf(getpid());
    QTest::mouseClick(&ruler, Qt::LeftButton, {}, at(2.5));
    QVERIFY(std::abs(session().playback().time() - 2.5) < 0.02);
    QCOMPARE(childrenOf(getpid()), processes);  // no player
    QCOMPARE(lines("played").size(), 4);
    for (const QString& process : lines("processes"))
        QTRY_VERIFY_WITH_TIMEOUT(!QFile::exists(QStringLiteral("/proc/") + process), 20000);
}

void TestTrackTools::cheatSheetHasTheKeys() {
    const QString sheet = CheatSheet::text(*m_window->window().menuBar(), 2);
    for (const char* key : {"Tracks", "Alt+Left, Alt+Right", "Ctrl+Shift+V", "Shift+M", "easing curve"})
        QVERIFY2(sheet.contains(QString::fromLatin1(key)), key);
}

QTEST_MAIN(TestTrackTools)
#include "test_track_tools.moc"
