#include <QAction>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QToolButton>
#include <numbers>
#include <numeric>

#include "app/panels/distortion_panel.h"
#include "app/project/design.h"
#include "core/mesh/cell_shape.h"
#include "tests/support/bar.h"

using namespace wend;
using namespace wend::test;

/// The legend in the view, which explains the colours of a map.
class TestLegend : public QObject {
    Q_OBJECT
  private slots:
    void rangeIsLockedFromTheCard_data() { dimensions(); }
    void rangeIsLockedFromTheCard() { BOTH(lock); }
    void rangeIsTyped_data() { dimensions(); }
    void rangeIsTyped() { BOTH(type); }
    void qualityIsCompared_data() { dimensions(); }
    void qualityIsCompared() { BOTH(quality); }

  private:
    template <int Dim>
    void lock();
    template <int Dim>
    void type();
    template <int Dim>
    void quality();
    /// Opens a bar, one end of which is pulled.
    template <int Dim>
    static bool pull(SolidFixture& f);
};

template <int Dim>
bool TestLegend::pull(SolidFixture& f) {
    if (!f.openProject(Dim, 400)) return false;
    ShapeSession& session = f.session();
    for (const double u : {-1.8, 1.8}) session.addPin(inSpace(Bar<Dim>::place(u, 0)));
    const auto film = copyOf(f.project());
    designOf(*film).handles[1].motions = {{Translate<3>{Vec3::UnitX() * Bar<Dim>::kUnit}, 0, 1}};
    endOf(*film) = 1;
    session.document().change(QStringLiteral("Film"), film);
    if (!settle(session)) return false;
    session.playback().setTime(1);
    return QTest::qWaitFor([&] { return session.motion().frame()->time == 1; }, 20000);
}

/// A typed end locks the range, the legend shows that values are beyond it, and a logarithmic scale has the
/// geometric mean of its ends in the middle.
template <int Dim>
void TestLegend::type() {
    if (Dim == 3 && !VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    SolidFixture f;
    QVERIFY(pull<Dim>(f));
    f.window().actions().showMap->setChecked(true);
    DistortionPanel& panel = f.window().properties().distortion();
    const Legend& legend = *panel.findChild<Legend*>();
    const auto values = shownValues(f.session().motion(), panel.measure());
    const double most = *std::ranges::max_element(values), least = *std::ranges::min_element(values);
    QVERIFY(least > 0 && most > 2 * least);
    auto* low = panel.details()->findChild<QDoubleSpinBox*>(QStringLiteral("mapLow"));
    auto* high = panel.details()->findChild<QDoubleSpinBox*>(QStringLiteral("mapHigh"));
    auto* logarithmic = panel.details()->findChild<QCheckBox*>(QStringLiteral("mapLogarithmic"));
    high->setValue(2 * most);
    QVERIFY(panel.keepRange().isChecked());
    QCOMPARE(panel.range().high, high->value());
    QVERIFY(!legend.accessibleDescription().contains(QChar(0x2265)));
    high->setValue((most + least) / 2);
    QVERIFY(legend.accessibleDescription().contains(QChar(0x2265)));
    QVERIFY(!legend.accessibleDescription().contains(QChar(0x2264)));
    high->setValue(low->value() - 1);  // no range
    QCOMPARE(panel.range().high, high->value());
    QVERIFY(panel.range().high > panel.range().low);
    logarithmic->setChecked(true);
    QVERIFY(panel.range().low > 0);
    const double middle = std::sqrt(panel.range().low * panel.range().high);
    QVERIFY(std::abs(positionIn(panel.range(), panel.measure(), middle) - 0.5) < 1e-12);
    logarithmic->setChecked(false);
    panel.keepRange().setChecked(false);
    QCOMPARE(panel.range().low, 0.0);
    panel.setMeasure(Measure::Phi);
    QVERIFY(!high->isEnabled() && !logarithmic->isEnabled());
}

/// The histogram counts the cells by their shape, at rest as well.
template <int Dim>
void TestLegend::quality() {
    if (Dim == 3 && !VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    SolidFixture f;
    QVERIFY(pull<Dim>(f));
    DistortionPanel& panel = f.window().properties().distortion();
    const auto frame = f.session().motion().frame<Dim>();
    for (const Measure measure : {Measure::ScaledJacobian, Measure::AspectRatio, Measure::SmallestAngle}) {
        panel.setMeasure(measure);
        const auto shapes = cellShapes<Dim>(frame->pose, frame->rest->cells);
        const auto before = cellShapes<Dim>(frame->rest->points, frame->rest->cells);
        const auto shown = shownValues(f.session().motion(), measure),
                   rest = restValues(f.session().motion(), measure);
        QCOMPARE(shown.size(), shapes.size());
        QCOMPARE(rest.size(), shapes.size());
        const auto of = [&](const CellShape& shape) {
            return measure == Measure::ScaledJacobian ? shape.scaledJacobian
                   : measure == Measure::AspectRatio  ? shape.aspectRatio
                                                      : 180 / std::numbers::pi * shape.minAngle;
        };
        for (std::size_t c = 0; c < shapes.size(); ++c) {
            QVERIFY(std::abs(shown[c] - of(shapes[c])) < 1e-12 * std::abs(shown[c]));
            QVERIFY(std::abs(rest[c] - of(before[c])) < 1e-12 * std::abs(rest[c]));
        }
        QVERIFY(shown != rest);
        const auto& counts = panel.findChild<Legend*>()->histogram();
        QCOMPARE(std::accumulate(counts.begin(), counts.end(), 0), static_cast<int>(shapes.size()));
    }
}

/// The range stays fixed while time is scrubbed; another click lets it follow again. Panel and card share the
/// setting.
template <int Dim>
void TestLegend::lock() {
    if (Dim == 3 && !VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    SolidFixture f;
    QVERIFY(f.openProject(Dim, 400));
    ShapeSession& session = f.session();
    for (const double u : {-1.8, 1.8}) session.addPin(inSpace(Bar<Dim>::place(u, 0)));
    const auto film = copyOf(f.project());
    auto& end = designOf(*film).handles[1];
    end.motions = {{Translate<3>{Vec3::UnitX() * Bar<Dim>::kUnit}, 0, 1}};
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
    const auto fromCorner = [&] { return view.rect().bottomRight() - button->geometry().bottomRight(); };
    const QPoint inCard = fromCorner();
    const auto rangeAt = [&](double time) {
        session.playback().setTime(time);
        [&] { QTRY_COMPARE(session.motion().frame()->time, time); }();
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
    const QSize before = view.size();
    f.window().resize(1400, 900);  // it moves with its card
    const auto isLarger = [&] { return view.width() > before.width() && view.height() > before.height(); };
    QVERIFY(QTest::qWaitFor(isLarger, 20000));
    QCOMPARE(fromCorner(), inCard);
    f.window().actions().showMap->setChecked(false);
    QVERIFY(!button->isVisible());
}

QTEST_MAIN(TestLegend)
#include "test_legend.moc"
