#include <QAction>
#include <QToolButton>

#include "app/document/design.h"
#include "app/panels/distortion_panel.h"
#include "tests/support/bar.h"

using namespace wend;
using namespace wend::test;

/// The card in the view that says what the colours of a map mean.
class TestLegend : public QObject {
    Q_OBJECT
  private slots:
    void rangeIsLockedFromTheCard_data() { dimensions(); }
    void rangeIsLockedFromTheCard() { BOTH(lock); }

  private:
    template <int Dim>
    void lock();
};

/// While one scrubs, the range stays; another click lets it follow again. Panel and card are one.
template <int Dim>
void TestLegend::lock() {
    if (Dim == 3 && !VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    SolidFixture f;
    QVERIFY(f.openProject(Dim, 400));
    ShapeSession& session = f.session();
    for (const double u : {-1.8, 1.8}) session.addPin(Bar<Dim>::place(u, 0));
    const auto film = copyOf(f.project());
    auto& end = designOf<Dim>(*film).handles[1];
    end.motions = {{Translate<Dim>{Vec<Dim>::UnitX() * Bar<Dim>::kUnit}, 0, 1}};
    endOf(*film) = 1;
    session.document().change(QStringLiteral("Film"), film);
    QVERIFY(settle(session));
    auto& view = Bar<Dim>::canvas(f);
    DistortionPanel& panel = f.window().properties().distortion();
    auto* button = view.template findChild<QToolButton*>(QStringLiteral("legendLock"));
    QVERIFY(button && !button->isVisible());
    f.window().actions().showMap->setChecked(true);
    QVERIFY(button->isVisible());
    QVERIFY(view.rect().adjusted(view.width() / 2, view.height() / 2, 0, 0).contains(button->geometry()));
    const auto rangeAt = [&](double time) {
        session.playback().setTime(time);
        [&] { QTRY_COMPARE(session.frame()->time, time); }();
        return panel.range().high;
    };
    const double still = rangeAt(0), moved = rangeAt(1);
    QVERIFY2(std::abs(still - moved) > 1e-3, qPrintable(QStringLiteral("%1 %2").arg(still).arg(moved)));
    QTest::mouseClick(button, Qt::LeftButton);
    f.picture(QStringLiteral("legend-%1").arg(Dim));
    QVERIFY(panel.keepRange().isChecked());
    QCOMPARE(rangeAt(0), moved);
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(panel.range().high, still);
    panel.keepRange().setChecked(true);
    QVERIFY(button->isChecked());
    f.window().resize(1000, 700);  // it goes along with its card
    settleLayout(view);
    QVERIFY(view.rect().adjusted(view.width() / 2, view.height() / 2, 0, 0).contains(button->geometry()));
    f.window().actions().showMap->setChecked(false);
    QVERIFY(!button->isVisible());
}

QTEST_MAIN(TestLegend)
#include "test_legend.moc"
