// The panel of the film: frame rate, cycle and sound of the project, and how playback follows the cycle.

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QUndoStack>

#include "app/engine/motion/playback.h"
#include "app/panels/fields/number_boxes.h"
#include "app/panels/fields/option_field.h"
#include "app/panels/film_panel.h"
#include "app/project/project.h"
#include "app/window/actions/actions.h"
#include "app/window/main_window.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

class TestFilmPanel : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void rateIsTheProjects();
    void cycleIsTheProjects();
    void soundIsTheProjects();
    void playingStaysInTheCycle();

  private:
    const Project& project() { return *m_window->session().document().project(); }
    QUndoStack& undo() { return *m_window->session().document().undoStack(); }
    FilmPanel& panel() { return *m_window->findChild<FilmPanel*>(); }
    QCheckBox& cycles() { return *panel().findChild<QCheckBox*>(); }
    QList<ExactBox*> ends() { return m_cycle->findChildren<ExactBox*>(); }

    std::unique_ptr<TestFolder> m_folder;
    std::unique_ptr<MainWindow> m_window;
    QWidget* m_cycle = nullptr;
};

void TestFilmPanel::init() {
    m_folder = std::make_unique<TestFolder>();
    m_window = std::make_unique<MainWindow>();
    m_window->show();
    m_window->openPath(writeCutOut(*m_folder));
    ShapeSession& session = m_window->session();
    QVERIFY(QTest::qWaitFor([&] { return !session.document().isEmpty(); }, 20000));
    QVERIFY(settle(session));
    session.addPin({40, 80, 0});
    session.addPin({200, 80, 0});
    QVERIFY(settle(session));
    session.gestures().begin();
    session.gestures().moveBy({-10, 25, 0});
    session.gestures().end(0.5);
    QVERIFY(settle(session));
    for (QWidget* one : panel().findChildren<QWidget*>())
        if (one->findChildren<ExactBox*>(Qt::FindDirectChildrenOnly).size() == 2) m_cycle = one;
    QVERIFY(m_cycle);
}

void TestFilmPanel::cleanup() {
    undo().setClean();
    m_window.reset();
}

void TestFilmPanel::rateIsTheProjects() {
    auto* rate = panel().findChild<OptionField*>();
    QCOMPARE(rate->number(), 24.0);
    rate->setNumber(12.5);
    emit rate->changed();
    QCOMPARE(project().frameRate, 12.5);
    undo().undo();
    QCOMPARE(project().frameRate, 24.0);
    QCOMPARE(rate->number(), 24.0);
}

/// The cycle can grow from nothing to the whole film; successive edits of one field are one step.
void TestFilmPanel::cycleIsTheProjects() {
    QVERIFY(m_cycle->isHidden());
    cycles().click();
    QVERIFY(!m_cycle->isHidden());
    QVERIFY((*project().cycle == std::array{0.0, project().end}));
    const int steps = undo().index();
    ends()[0]->setValue(0.1);
    ends()[0]->setValue(0.2);
    ends()[1]->setValue(0.6);
    QVERIFY((*project().cycle == std::array{0.2, 0.6}));
    QCOMPARE(undo().index(), steps + 1);
    ends()[0]->setValue(5);  // stays before the end
    QVERIFY(project().cycle->at(0) < project().cycle->at(1));
    while (undo().index() >= steps) undo().undo();
    QVERIFY(!project().cycle && !cycles().isChecked() && m_cycle->isHidden());
}

void TestFilmPanel::soundIsTheProjects() {
    const auto buttons = panel().findChildren<QPushButton*>();
    auto* name = panel().findChild<QLabel*>(QStringLiteral("soundFile"));
    QVERIFY(name->isHidden() && buttons[1]->isHidden());
    panel().setSound(QStringLiteral("/music/a song.ogg"));
    QCOMPARE(project().audio, std::string("/music/a song.ogg"));
    QCOMPARE(name->text(), QStringLiteral("a song.ogg"));
    buttons[1]->click();
    QVERIFY(project().audio.empty() && name->isHidden());
    undo().undo();
    QCOMPARE(project().audio, std::string("/music/a song.ogg"));
}

void TestFilmPanel::playingStaysInTheCycle() {
    Project next = project();
    next.cycle = {0.25 * next.end, 0.5 * next.end};
    m_window->session().document().change(QStringLiteral("cycle"), std::move(next));
    QVERIFY(settle(m_window->session()));
    const auto [from, to] = *project().cycle;
    Playback& playback = m_window->session().playback();
    m_window->actions().loop->setChecked(true);
    playback.setTime(0);
    QList<double> times;
    connect(&playback, &Playback::timeChanged, this, [&](double time) { times << time; });
    playback.setPlaying(true);
    const auto jumps = [&] {
        int count = 0;
        for (int k = 1; k < times.size(); ++k)
            if (times[k] < times[k - 1]) count += times[k - 1] == to && times[k] == from ? 1 : 1000;
        return count;
    };
    QVERIFY(QTest::qWaitFor([&] { return jumps() >= 2; }, 30000));
    playback.setPlaying(false);
    QVERIFY(jumps() < 1000);
    disconnect(&playback, nullptr, this, nullptr);
}

QTEST_MAIN(TestFilmPanel)
#include "test_film_panel.moc"
