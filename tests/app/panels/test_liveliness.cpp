#include <QLabel>
#include <QSlider>
#include <QToolButton>

#include "app/panels/fields/energy_slider.h"
#include "app/panels/look/liveliness.h"
#include "app/panels/look/pin_animation.h"
#include "app/panels/material_panel.h"
#include "app/view/actions/actions.h"
#include "app/view/canvas/canvas.h"
#include "app/view/files/file_card.h"
#include "app/view/film/time_strip.h"
#include "app/view/main_window.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// Small movements of the window: they are there, they end, and nobody sees them who does not want to.
class TestLiveliness : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void newPinDrops();
    void pinThatIsStoppedTrembles();
    void playheadBouncesWhenALoopTurns();
    void samplesBreatheUnderThePointer();
    void tilesLeanWhereTheShapeIsPulled();
    void lessMotionIsRemembered();

  private:
    void open();
    ShapeSession& session() { return m_window->session(); }

    std::unique_ptr<TestFolder> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

void TestLiveliness::init() {
    if (m_window) session().document().undoStack()->setClean();
    m_window.reset();
    m_folder = std::make_unique<TestFolder>();
    m_window = std::make_unique<MainWindow>();
    m_window->show();
    QVERIFY(!isLively());
    m_window->actions().lessMotion->setChecked(false);
    if (!isLively()) QSKIP("the desktop wants no motion");
}

void TestLiveliness::open() {
    m_window->openPath(writeCutOut(*m_folder));
    QTRY_VERIFY_WITH_TIMEOUT(!session().document().isEmpty(), 20000);
    QVERIFY(settle(session()));
}

void TestLiveliness::newPinDrops() {
    open();
    PinAnimation animation(session());
    std::vector<PinAnimation::Look> looks;
    connect(&animation, &PinAnimation::changed, this, [&] { looks.push_back(animation.of(1)); });
    const Points<2> pose = session().frame<2>()->pose;
    session().addPin<2>(Vec<2>(pose.col(0)));
    session().addPin<2>(Vec<2>(pose.col(pose.cols() / 2)));
    QCOMPARE(animation.of(0).shift, QPointF());
    QCOMPARE(animation.of(1).shift.x(), 0.0);
    QVERIFY(animation.of(1).shift.y() < -10);  // it begins above its place
    QTRY_COMPARE(animation.of(1).shift, QPointF());
    QTRY_COMPARE(animation.of(1).squash, 0.0);
    for (const auto& look : looks) QVERIFY(look.shift.y() <= 0 && look.squash >= 0 && look.squash < 0.5);
    looks.clear();
    m_window->actions().lessMotion->setChecked(true);
    session().addPin<2>(Vec<2>(pose.col(pose.cols() / 3)));
    QCOMPARE(animation.of(2).shift, QPointF());
    QVERIFY(looks.empty());
}

/// One pin is pushed through another.
void TestLiveliness::pinThatIsStoppedTrembles() {
    open();
    session().addPin<2>(Vec<2>(110, 80));
    session().addPin<2>(Vec<2>(130, 80));
    QVERIFY(settle(session()));
    PinAnimation animation(session());
    double left = 0, right = 0;
    connect(&animation, &PinAnimation::changed, this, [&] {
        left = std::min(left, animation.of(1).shift.x());
        right = std::max(right, animation.of(1).shift.x());
        QCOMPARE(animation.of(0).shift, QPointF());
    });
    session().selection().set({1});
    session().beginDrag();
    for (int i = 1; i <= 8; ++i) session().dragTo<2>({-8.0 * i, 0});
    QVERIFY(QTest::qWaitFor([&] { return session().frame()->stopped; }, 30000));
    QTRY_VERIFY(left < 0 && right > 0 && animation.of(1).shift.isNull());
    QVERIFY(left >= -3 && right <= 3);
    session().cancelDrag();
}

void TestLiveliness::playheadBouncesWhenALoopTurns() {
    auto& strip = *m_window->findChild<TimeStrip*>();
    open();
    QSlider& slider = *strip.slider();
    const int rest = slider.y();
    Playback& playback = session().playback();
    playback.setEnd(0.2);
    playback.setReady(0.2);
    playback.setTime(0);
    int highest = rest;
    connect(&playback, &Playback::timeChanged, this, [&] { highest = std::min(highest, slider.y()); });
    playback.setLoops(true);
    playback.setPlaying(true);
    QTRY_VERIFY(highest < rest);
    QVERIFY(highest >= rest - 4);
    playback.setPlaying(false);
    QTRY_COMPARE(slider.y(), rest);
}

void TestLiveliness::samplesBreatheUnderThePointer() {
    FileCard* sample = nullptr;
    for (FileCard* card : m_window->findChildren<FileCard*>())
        if (card->path().endsWith(QStringLiteral("frog.wend"))) sample = card;
    QVERIFY(sample);
    // The rows of the card that its animal covers.
    const auto tall = [sample] {
        const QImage image = sample->grab().toImage();
        int rows = 0;
        for (int y = 4; y < 118; ++y) {
            bool any = false;
            for (int x = 10; x < 122; ++x) any = any || image.pixelColor(x, y).saturation() > 90;
            rows += any;
        }
        return rows;
    };
    QTRY_VERIFY_WITH_TIMEOUT(tall() > 50, 20000);
    const int rest = tall();
    const QPointF middle = sample->rect().center();
    QEnterEvent enter(middle, middle, sample->mapToGlobal(middle));
    QApplication::sendEvent(sample, &enter);
    QTRY_VERIFY(tall() > rest + 1);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(sample, &leave);
    QCOMPARE(tall(), rest);
}

void TestLiveliness::tilesLeanWhereTheShapeIsPulled() {
    open();
    EnergySlider& tiles = *m_window->materialPanel().energySlider();
    QToolButton& tile = *tiles.findChildren<QToolButton*>().first();
    // How far the upper half of the picture's ink lies to the right of the lower.
    const auto lean = [&tile] {
        const QImage image = tile.icon().pixmap(tile.iconSize()).toImage();
        double sum[2] = {}, ink[2] = {};
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const int half = 2 * y < image.height() ? 0 : 1, alpha = qAlpha(image.pixel(x, y));
                sum[half] += x * alpha, ink[half] += alpha;
            }
        return sum[0] / ink[0] - sum[1] / ink[1];
    };
    const double upright = lean();
    tiles.setLean(1);
    QVERIFY(lean() > upright + 1);
    tiles.setLean(-1);
    QVERIFY(lean() < upright - 1);
    tiles.setLean(0);
    QCOMPARE(lean(), upright);
}

void TestLiveliness::lessMotionIsRemembered() {
    m_window->actions().lessMotion->setChecked(true);
    QVERIFY(!isLively());
    m_window = std::make_unique<MainWindow>();
    QVERIFY(m_window->actions().lessMotion->isChecked() && !isLively());
    m_window->actions().lessMotion->setChecked(false);
    m_window = std::make_unique<MainWindow>();
    QVERIFY(!m_window->actions().lessMotion->isChecked() && isLively());
}

QTEST_MAIN(TestLiveliness)
#include "test_liveliness.moc"
