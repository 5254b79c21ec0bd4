#include <QComboBox>
#include <QListWidget>
#include <QMenu>
#include <QToolButton>

#include "app/engine/motion/fields.h"
#include "app/panels/distortion_panel.h"
#include "app/panels/fields/number_boxes.h"
#include "app/panels/fields/region_numbers.h"
#include "app/panels/mesh_panel.h"
#include "app/panels/region_list.h"
#include "app/project/domain.h"
#include "app/project/edits/value_edits.h"
#include "app/session/opening.h"
#include "tests/support/layers.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// Painting and regions make a solid's cells finer or coarser, in the window.
class TestCellSizes : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void strokesAreLayers();
    void sizeOfRegularCells();
    void strokesMakeCellsFiner();
    void shiftPaintsTheOtherWayRound();
    void regionsByNumbers();
    void regionOfTheSelectedHandle();
    void mapOfSizesWhilePainting();

  private:
    RegionList& panel() { return m_f->window().properties().detailRegions(); }
    QListWidget& list() { return *panel().list(); }
    ExactBox& box(const char* name) { return *panel().findChild<ExactBox*>(name); }
    const SoftRegion& region() { return m_f->domain().sizes.at(0).regions.at(0); }
    void type(QDoubleSpinBox& box, double value);
    QToolButton& button(const QString& text);
    QAction* entry(int place) { return button(RegionList::tr("Add")).menu()->actions().at(place); }
    void brushTheRightEnd(Qt::KeyboardModifiers modifiers = {});
    double meanSize(bool right);
    std::unique_ptr<SolidFixture> m_f;
};

void TestCellSizes::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
    QVERIFY(m_f->open(900));
    const auto refined = copyOf(m_f->project());
    domainOf(*refined).refineSurface = true;
    m_f->session().document().change(QStringLiteral("Refine"), refined);
    QVERIFY(settle(m_f->session()));
}

void TestCellSizes::type(QDoubleSpinBox& box, double value) {
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, box.locale().toString(value));
    QTest::keyClick(&box, Qt::Key_Return);
}

QToolButton& TestCellSizes::button(const QString& text) {
    for (auto* button : panel().findChildren<QToolButton*>())
        if (button->text() == text) return *button;
    qFatal("no such button");
}

void TestCellSizes::brushTheRightEnd(Qt::KeyboardModifiers modifiers) {
    m_f->drag(m_f->at({1.4, -0.5, -0.3}), m_f->at({1.8, -0.5, 0.3}), modifiers);
}

/// Returns the mean size of the cells in the right or the left quarter of the bar, near the front.
double TestCellSizes::meanSize(bool right) {
    const auto frame = m_f->session().motion().frame<3>();
    const auto sizes = cellValues(*frame, Measure::CellSize);
    double sum = 0;
    int count = 0;
    for (std::size_t c = 0; c < sizes.size(); ++c) {
        Vec3 middle = Vec3::Zero();
        for (const int v : frame->rest->cells[c]) middle += frame->rest->points.col(v) / 4;
        if ((right ? middle.x() : -middle.x()) < 1 || middle.y() > -0.2) continue;
        sum += sizes[c];
        ++count;
    }
    return sum / count;
}

/// Strokes and regions are layers on top, with names of their own, and replace the layers that they cover.
void TestCellSizes::strokesAreLayers() {
    ValueLayers sizes = {layerWith("", 2, Ball<3>{Vec3::Zero(), 1}),
                         layerWith("", 3, Ball<3>{Vec3::Ones(), 1})};
    const auto ball = [](const Vec3& centre, double radius) {
        return SoftRegion{Ball<3>{centre, radius}, 0.5 * radius};
    };
    sizes = withSizeStroke(sizes, {ball(Vec3::Zero(), 1), ball(Vec3::Ones(), 1)}, 0.5);
    sizes = withSizeRegion(sizes, Ball<3>{Vec3::Zero(), 2}, 0.25);
    QCOMPARE(sizes.size(), std::size_t(4));
    QVERIFY(sizes[2].name == "Stroke 1" && sizes[2].regions.size() == 2 && sizes[2].value == 0.5);
    QCOMPARE(sizes[3].name, std::string("Region 1"));
    // A larger ball, whose hard inside contains the balls around (1, 1, 1) but not that around the origin.
    sizes = withSizeStroke(sizes, {ball(Vec3::Constant(2), 4.5)}, 0.1);
    QCOMPARE(sizes.size(), std::size_t(4));
    QVERIFY(sizes[1].name == "Stroke 1" && sizes[1].regions.size() == 1 && sizes[3].name == "Stroke 2");
}

/// The edge of a regular tetrahedron is its size.
void TestCellSizes::sizeOfRegularCells() {
    auto rest = std::make_shared<SimplicialMesh<3>>();
    rest->points = Points3(3, 4);
    rest->points << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1;
    rest->cells = {{0, 1, 2, 3}};
    PosedFrame<3> frame;
    frame.rest = rest;
    QVERIFY(std::abs(cellValue(frame, Measure::CellSize, 0) - 2 * std::sqrt(2.0)) < 1e-12);
}

void TestCellSizes::strokesMakeCellsFiner() {
    const int before = m_f->session().motion().frame()->vertices;
    const double even = meanSize(true) / meanSize(false);
    QVERIFY(std::abs(even - 1) < 0.15);
    QTest::mouseClick(m_f->window().findChild<MeshPanel*>()->findChild<QToolButton*>("paintSizes"),
                      Qt::LeftButton);
    QVERIFY(m_f->actions().sizes->isChecked() && panel().isVisible());
    QTest::keyClick(&m_f->canvas(), Qt::Key_BracketRight);
    brushTheRightEnd();
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->domain().sizes.size(), std::size_t(1));
    QVERIFY(m_f->domain().sizes[0].regions.size() > 1);
    QCOMPARE(m_f->domain().sizes[0].value, 0.5);
    QVERIFY2(meanSize(true) < 0.8 * meanSize(false), qPrintable(QString::number(meanSize(true))));
    // The total number of vertices still meets the aim.
    QVERIFY(std::abs(m_f->session().motion().frame()->vertices - 900) <= 135);
    m_f->actions().oblique->trigger();
    m_f->window().actions().showMesh->setChecked(true);
    m_f->picture(QStringLiteral("sizes-painted"));
    list().setCurrentRow(0);
    m_f->picture(QStringLiteral("sizes-stroke"));
    // The factor is changed in the panel, and the layer removed; each is one undo step.
    type(box("detailValue"), 25);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->domain().sizes.at(0).value, 0.25);
    const double fine = meanSize(true) / meanSize(false);
    QVERIFY(fine < 0.6);
    QTest::mouseClick(&button(RegionList::tr("Remove")), Qt::LeftButton);
    QVERIFY(m_f->domain().sizes.empty());
    for (int i = 0; i < 2; ++i) m_f->window().actions().undo->trigger();
    QCOMPARE(m_f->domain().sizes.at(0).value, 0.5);
    m_f->window().actions().undo->trigger();
    QVERIFY(settle(m_f->session()));
    QVERIFY(m_f->domain().sizes.empty());
    QCOMPARE(m_f->session().motion().frame()->vertices, before);
}

void TestCellSizes::shiftPaintsTheOtherWayRound() {
    QTest::keyClick(&m_f->canvas(), Qt::Key_A, Qt::ShiftModifier);
    QVERIFY(m_f->actions().sizes->isChecked());
    m_f->window().properties().brush().edges().set(0.4);
    const double before = meanSize(true) / meanSize(false);
    m_f->canvas().setFocus();
    for (int i = 0; i < 5; ++i) QTest::keyClick(&m_f->canvas(), Qt::Key_BracketRight);
    brushTheRightEnd(Qt::ShiftModifier);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->domain().sizes.at(0).value, 2.5);
    const double after = meanSize(true) / meanSize(false);
    QVERIFY2(after > 1.15 * before, qPrintable(QString::number(after / before)));
    // Esc cancels a stroke.
    const auto count = m_f->domain().sizes.size();
    m_f->press(m_f->at({0, -0.5, 0}));
    QTest::keyClick(&m_f->canvas(), Qt::Key_Escape);
    QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, {}, m_f->at({0.3, -0.5, 0}));
    QCOMPARE(m_f->domain().sizes.size(), count);
}

void TestCellSizes::regionsByNumbers() {
    m_f->actions().sizes->trigger();
    entry(0)->trigger();
    QVERIFY(settle(m_f->session()));
    QCOMPARE(list().currentRow(), 0);
    const auto* ball = std::get_if<Ball<3>>(&region().shape);
    QVERIFY(ball && ball->centre.norm() < 1e-9);
    auto* numbers = panel().findChild<RegionNumbers*>();
    QVERIFY(numbers->isVisible());
    const auto boxes = numbers->findChildren<QDoubleSpinBox*>();
    for (QDoubleSpinBox* one : boxes)
        if (one->isVisible() && one->accessibleName() == RegionNumbers::tr("Radius")) type(*one, 0.8);
    QVERIFY(settle(m_f->session()));
    ball = std::get_if<Ball<3>>(&region().shape);
    QVERIFY(ball && ball->radius == 0.8);
    type(box("detailFeather"), 0.3);
    type(box("detailValue"), 30);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(region().feather, 0.3);
    QCOMPARE(m_f->domain().sizes.at(0).value, 0.3);
    m_f->actions().oblique->trigger();
    m_f->window().actions().showMesh->setChecked(true);
    m_f->picture(QStringLiteral("sizes-region"));
    // Another kind of region replaces it at the same place; after saving and reading it is the same.
    auto* kind = numbers->findChild<QComboBox*>();
    kind->setFocus();
    QTest::keyClick(kind, Qt::Key_Down);
    QVERIFY(settle(m_f->session()));
    QVERIFY(std::holds_alternative<Box<3>>(region().shape));
    QTemporaryDir folder;
    m_f->session().document().save(folder.filePath(QStringLiteral("sizes.wend")));
    QVERIFY(domainOf(*openFile(folder.filePath(QStringLiteral("sizes.wend"))).project).sizes ==
            m_f->domain().sizes);
}

void TestCellSizes::regionOfTheSelectedHandle() {
    m_f->actions().sizes->trigger();
    QVERIFY(!entry(3)->isEnabled());
    const Region<3> half = HalfSpace<3>{{1, 0, 0}, {1, 0, 0}};
    m_f->session().selection().set({m_f->session().addHandle(half, "Region")});
    QVERIFY(settle(m_f->session()));
    QVERIFY(entry(3)->isEnabled());
    entry(3)->trigger();
    QVERIFY(settle(m_f->session()));
    QVERIFY(region().shape == half);
    QVERIFY(meanSize(true) < 0.7 * meanSize(false));
}

void TestCellSizes::mapOfSizesWhilePainting() {
    QAction* map = m_f->window().actions().showMap;
    DistortionPanel& maps = m_f->window().distortionPanel();
    const Measure before = maps.measure();
    QVERIFY(!map->isChecked());
    m_f->actions().sizes->trigger();
    QVERIFY(map->isChecked() && maps.measure() == Measure::CellSize);
    m_f->tool("paint")->trigger();
    QVERIFY(map->isChecked() && maps.measure() == Measure::Phi && !panel().isVisible());
    m_f->window().actions().pinTool->trigger();
    QVERIFY(!map->isChecked() && maps.measure() == before);
    // Every value is within the range.
    const auto values = shownValues(m_f->session().motion(), Measure::CellSize);
    const MeasureRange range = rangeOf(values, Measure::CellSize);
    for (const double value : values) {
        const double at = positionIn(range, Measure::CellSize, value);
        QVERIFY(at >= 0 && at <= 1);
        QVERIFY(std::abs(valueAt(range, Measure::CellSize, at) - value) < 1e-9 * value);
    }
}

QTEST_MAIN(TestCellSizes)
#include "test_cell_sizes.moc"
