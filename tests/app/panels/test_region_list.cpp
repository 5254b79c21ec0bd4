#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QToolButton>
#include <QUndoStack>

#include "app/panels/region_list.h"
#include "app/project/edits/depth_edits.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/region_edits.h"
#include "app/project/project.h"
#include "tests/support/bar.h"

using namespace wend;
using namespace wend::test;

/// Regions of a picture in lists and numbers: where its mesh is finer, what lies in front, and how large the
/// circle of a pin is.
class TestRegionList : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void groupsOfOneName();
    void strokesAreListed_data() { kinds(); }
    void strokesAreListed();
    void chosenOnesAreOutlined_data() { kinds(); }
    void chosenOnesAreOutlined();
    void whatAFileHasIsListed();
    void circlesHaveARadius();

  private:
    static void kinds();
    bool open(RegionsOf of);
    bool brush(double fromU, double toU);
    RegionList& panel(RegionsOf of) {
        Properties& side = m_f->window().properties();
        return of == RegionsOf::Detail ? side.detailRegions() : side.depthRegions();
    }
    std::vector<NamedRegions> groups(RegionsOf of) {
        const Project& project = m_f->project();
        return of == RegionsOf::Detail ? namedRegions(project.domain.sizes) : namedRegions(project.depth);
    }
    QUndoStack& undo() { return *m_f->session().document().undoStack(); }

    std::unique_ptr<SolidFixture> m_f;
};

void TestRegionList::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

void TestRegionList::kinds() {
    QTest::addColumn<int>("kind");
    QTest::newRow("detail") << static_cast<int>(RegionsOf::Detail);
    QTest::newRow("depth") << static_cast<int>(RegionsOf::Depth);
}

/// With the tool that brushes them.
bool TestRegionList::open(RegionsOf of) {
    if (!m_f->openPicture()) return false;
    m_f->tool(of == RegionsOf::Detail ? "sizes" : "depth")->trigger();
    BrushSettings tip = m_f->window().properties().brush().now();
    tip.radius = 20;
    m_f->window().properties().brush().set(tip);
    return panel(of).isVisible();
}

bool TestRegionList::brush(double fromU, double toU) {
    ShapeCanvas& canvas = m_f->window().canvas();
    const QPoint a = canvas.toWidget(Bar<2>::place(fromU, 0)).toPoint();
    const QPoint b = canvas.toWidget(Bar<2>::place(toU, 0)).toPoint();
    QTest::mouseMove(&canvas, a);
    QTest::mousePress(&canvas, Qt::LeftButton, {}, a);
    for (int i = 1; i <= 8; ++i) QTest::mouseMove(&canvas, a + (b - a) * i / 8);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, b);
    return settle(m_f->session());
}

/// Those without a name stand alone; a name that is taken gets a number.
void TestRegionList::groupsOfOneName() {
    DepthRegions depth;
    const auto add = [&](const char* name, double order) {
        depth.push_back({name, Ball<3>{{order, 0, 0}, 1}, order});
    };
    add("a", 1), add("", 2), add("b", 3), add("a", 4), add("", 5);
    const auto all = namedRegions(depth);
    QCOMPARE(all.size(), std::size_t(4));
    QVERIFY(all[0].name == "a" && all[0].regions.size() == 2 && all[0].value == 1);
    QVERIFY(all[1].name.empty() && all[1].regions.size() == 1 && all[3].value == 5);
    const DepthRegions renamed = withRegionsName(depth, 2, "a");
    QVERIFY(renamed[2].name == "a 2" && renamed[0].name == "a");
    QVERIFY(withRegionsName(depth, 1, "c")[1].name == "c");
    // A pin that gives an order has its regions' name, and none takes that of another.
    Project project;
    project.depth = depth;
    auto& handles = project.design.handles;
    handles.push_back({"b", std::vector<Vec3>{{3, 0, 0}}, {}});
    handles.push_back({"d", std::vector<Vec3>{{4, 0, 0}}, {}});
    const Project both = withDepthName(project, 2, "e");
    QVERIFY(both.depth[2].name == "e" && depthOfHandle(both.depth, "e") == 3);
    QVERIFY(both.design.handles[0].name == "e");
    QVERIFY(withDepthName(project, 2, "d").depth[2].name == "d 2");
    const DepthRegions without = withoutRegions(depth, 0);
    QVERIFY(without.size() == 3 && without[0].order == 2 && without[1].name == "b");
    const DepthRegions changed = withRegionsValue(depth, 0, -1);
    QVERIFY(changed[0].order == -1 && changed[3].order == -1 && changed[1].order == 2);
    QVERIFY(withoutRegions(depth, 7) == depth);
    QVERIFY(namedRegions(std::vector<SizeRegion>()).empty());
}

/// The last one on top, with its number, which can be changed; renamed by typing, and removed. Each is a
/// step.
void TestRegionList::strokesAreListed() {
    QFETCH(int, kind);
    const auto of = static_cast<RegionsOf>(kind);
    QVERIFY(open(of));
    QListWidget& list = *panel(of).list();
    const auto part = [&](const char* name) {
        const QString id = of == RegionsOf::Detail ? QStringLiteral("detail") : QStringLiteral("depth");
        return panel(of).findChild<QWidget*>(id + QLatin1String(name));
    };
    QVERIFY(list.isHidden() && part("Remove")->isHidden());
    QVERIFY(brush(-1.2, -0.9) && brush(0.8, 1.2));
    QCOMPARE(list.count(), 2);
    QCOMPARE(list.item(0)->text(), QString::fromStdString(groups(of)[1].name));
    QCOMPARE(list.item(1)->text(), QString::fromStdString(groups(of)[0].name));
    auto* value = qobject_cast<QDoubleSpinBox*>(part("Value"));
    const double before = groups(of)[0].value, other = groups(of)[1].value;
    QCOMPARE(list.currentRow(), 0);  // what was brushed just now can be changed at once
    QVERIFY(part("Remove")->isEnabled() && value->isEnabled());
    QCOMPARE(value->value(), (of == RegionsOf::Detail ? 100 : 1) * other);
    list.setFocus();
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(list.item(1)).center());
    QCOMPARE(value->value(), (of == RegionsOf::Detail ? 100 : 1) * before);
    value->setFocus();
    value->selectAll();
    QTest::keyClicks(value, of == RegionsOf::Detail ? QStringLiteral("30") : QStringLiteral("3"));
    QTest::keyClick(value, Qt::Key_Return);
    QCOMPARE(groups(of)[0].value, of == RegionsOf::Detail ? 0.3 : 3);
    QCOMPARE(groups(of)[1].value, other);
    undo().undo();
    QCOMPARE(groups(of)[0].value, before);
    QCOMPARE(list.currentRow(), 1);
    // Another name.
    list.setFocus();
    list.editItem(list.item(1));
    auto* editor = list.findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("Knee"));
    QTest::keyClick(editor, Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return groups(of)[0].name == "Knee"; }, 20000));
    QCOMPARE(list.currentItem()->text(), QStringLiteral("Knee"));
    // Away, and back.
    const int count = undo().count();
    QTest::mouseClick(part("Remove"), Qt::LeftButton);
    QCOMPARE(groups(of).size(), std::size_t(1));
    QCOMPARE(undo().count(), count + 1);
    QCOMPARE(list.count(), 1);
    undo().undo();
    QVERIFY(groups(of).size() == 2 && groups(of)[0].name == "Knee" && list.count() == 2);
    QCOMPARE(list.currentRow(), 1);  // what came back, not the topmost
    QVERIFY(settle(m_f->session()));
    m_f->picture(QStringLiteral("regions-%1").arg(kind));
}

/// On the shape, as long as the list is seen.
void TestRegionList::chosenOnesAreOutlined() {
    QFETCH(int, kind);
    const auto of = static_cast<RegionsOf>(kind);
    QVERIFY(open(of) && brush(-0.5, 0.5));
    ShapeCanvas& canvas = m_f->window().canvas();
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&canvas, &leave);
    const auto seen = [&] {
        [[maybe_unused]] const bool settled = QTest::qWaitFor([&] { return canvas.isSettled(); }, 20000);
        return canvas.grab().toImage();
    };
    const auto ball = std::get<Ball<3>>(groups(of)[0].regions[0].shape);
    const QPoint edge = canvas.toWidget(inPlane(ball.centre) - Vec<2>(0, ball.radius)).toPoint();
    const auto differAtTheEdge = [&](const QImage& a, const QImage& b) {
        for (int y = -3; y <= 3; ++y)
            if (a.pixel(edge + QPoint(0, y)) != b.pixel(edge + QPoint(0, y))) return true;
        return false;
    };
    panel(of).list()->setCurrentRow(-1);
    const QImage bare = seen();
    panel(of).list()->setCurrentRow(0);
    QVERIFY(differAtTheEdge(bare, seen()));
    panel(of).list()->setCurrentRow(-1);
    QVERIFY(!differAtTheEdge(bare, seen()));
    panel(of).list()->setCurrentRow(0);
    m_f->tool("pin")->trigger();
    const QImage posing = seen();
    panel(of).list()->setCurrentRow(-1);
    QVERIFY(!differAtTheEdge(posing, seen()));
}

/// Also what has no name, of any shape.
void TestRegionList::whatAFileHasIsListed() {
    QVERIFY(open(RegionsOf::Depth));
    Project next = m_f->project();
    next.depth = {{"", Box<3>{{40, 60, 0}, {80, 100, 0}}, 1},
                  {"", Polygon{{{100, 60}, {140, 60}, {120, 100}}}, -2},
                  {"", HalfSpace<3>{{180, 80, 0}, {1, 0, 0}}, 3}};
    m_f->session().document().change(QStringLiteral("Depth"), next);
    QVERIFY(settle(m_f->session()));
    QListWidget& list = *panel(RegionsOf::Depth).list();
    QCOMPARE(list.count(), 3);
    QCOMPARE(list.item(0)->text(), QStringLiteral("One side"));
    QCOMPARE(list.item(2)->text(), QStringLiteral("Rectangle"));
    list.setCurrentRow(1);
    list.editItem(list.item(1));
    auto* editor = list.findChild<QLineEdit*>();
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("Ear"));
    QTest::keyClick(editor, Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return m_f->project().depth[1].name == "Ear"; }, 20000));
}

/// That of a pin which holds a part: a number that is one step, and that is not taken where it holds nothing.
void TestRegionList::circlesHaveARadius() {
    QVERIFY(m_f->openPicture());
    auto* field = m_f->window().findChild<QDoubleSpinBox*>(QStringLiteral("circleRadius"));
    ShapeSession& session = m_f->session();
    session.addPin({60, 80, 0});
    session.addHandle(Region<3>(Ball<3>{{170, 80, 0}, 15}), "Circle");
    QVERIFY(settle(session));
    session.selection().set({0});
    QVERIFY(field && field->isVisible());  // a point may be widened
    QCOMPARE(field->value(), 0.0);
    session.selection().set({1});
    QVERIFY(field->isVisible());
    QCOMPARE(field->value(), 15.0);
    const auto radius = [&] {
        const auto& at = session.document().design().handles[1].at;
        return std::get<Ball<3>>(std::get<Region<3>>(at)).radius;
    };
    const int steps = undo().count();
    const auto type = [&](const char* text) {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QLatin1String(text));
        QTest::keyClick(field, Qt::Key_Return);
    };
    type("22.5");
    QCOMPARE(radius(), 22.5);
    QCOMPARE(undo().count(), steps + 1);
    QVERIFY(settle(session));
    const auto* count = m_f->window().findChild<QLabel*>(QStringLiteral("regionCount"));
    QVERIFY(count->text().section(' ', -1).toInt() > 3);
    type("0.02");
    QCOMPARE(radius(), 22.5);
    QCOMPARE(field->value(), 22.5);
    undo().undo();
    QCOMPARE(radius(), 15.0);
    QCOMPARE(field->value(), 15.0);
    session.selection().set({0, 1});
    QVERIFY(!field->isVisible());
}

QTEST_MAIN(TestRegionList)
#include "test_region_list.moc"
