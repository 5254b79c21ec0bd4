#include <QDoubleSpinBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QToolButton>
#include <QUndoStack>
#include <set>

#include "app/panels/region_list.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/material_edits.h"
#include "app/project/edits/value_edits.h"
#include "app/project/file/project_reader.h"
#include "app/project/file/project_writer.h"
#include "app/project/project.h"
#include "tests/support/bar.h"
#include "tests/support/layers.h"

using namespace wend;
using namespace wend::test;

/// Regions of a picture in lists and numbers: where its mesh is finer, which places are in front, and how
/// large the circle of a pin is.
class TestRegionList : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void layersOfAFile();
    void paintOfOneNameStaysApart();
    void strokesWithoutEffectAreNoSteps();
    void strokesAreListed_data() { kinds(); }
    void strokesAreListed();
    void chosenOnesAreOutlined_data() { kinds(); }
    void chosenOnesAreOutlined();
    void regionsOfAFileAreListed();
    void circlesHaveARadius();

  private:
    static void kinds();
    bool open(RegionsOf of);
    bool brush(double fromU, double toU);
    RegionList& panel(RegionsOf of) {
        Properties& side = m_f->window().properties();
        return of == RegionsOf::Detail ? side.detailRegions() : side.depthRegions();
    }
    ValueLayers layers(RegionsOf of) {
        const Project& project = m_f->project();
        return of == RegionsOf::Detail ? project.domain.sizes : project.depth;
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

/// Opens the step with the tool that paints these regions.
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

/// Consecutive regions of a file with one name and value are a layer; those without a name are layers of
/// their own. A name that is taken gets a number.
void TestRegionList::layersOfAFile() {
    QJsonArray list;
    const auto add = [&](const char* name, double order) {
        const QJsonObject circle{{"centre", QJsonArray{order, 0}}, {"radius", 1}};
        list << QJsonObject{{"name", name}, {"shape", QJsonObject{{"circle", circle}}}, {"order", order}};
    };
    add("a", 1), add("a", 1), add("a", 4), add("", 5), add("", 5), add("b", 3), add("a", 4);
    Project project;
    project.domain.path = "a.png";
    project.design.handles = {{"b", std::vector<Vec3>{{3, 0, 0}}, {}},
                              {"d", std::vector<Vec3>{{4, 0, 0}}, {}}};
    QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(toJson(project))).object();
    json["depth"] = list;
    project = *parseProject(QJsonDocument(json).toJson().toStdString(), "p.wend").project;
    const ValueLayers& depth = project.depth;
    QCOMPARE(depth.size(), std::size_t(6));
    QVERIFY(depth[0].regions.size() == 2 && depth[0].value == 1 && depth[1].value == 4);
    QVERIFY(depth[2].name.empty() && depth[3].name.empty() && depth[5].name == "a");
    const QJsonObject written = QJsonDocument::fromJson(QByteArray::fromStdString(toJson(project))).object();
    const auto valuesIn = [](const QJsonArray& regions) {
        std::vector<std::pair<QString, double>> all;
        for (const QJsonValue& one : regions)
            all.emplace_back(one["name"].toString(), one["order"].toDouble());
        return all;
    };
    QCOMPARE(valuesIn(written["depth"].toArray()), valuesIn(list));
    std::set<Id> ids;
    for (const ValueLayer& layer : depth) ids.insert(layer.id);
    QCOMPARE(ids.size(), depth.size());
    // Edits change the layer of an id and keep all ids.
    const ValueLayers renamed = withLayerName(depth, depth[4].id, "a");
    QVERIFY(renamed[4].name == "a 2" && renamed[4].id == depth[4].id && renamed[0].name == "a");
    const ValueLayers without = withoutLayer(depth, depth[0].id);
    QVERIFY(without.size() == 5 && without[0].value == 4 && without[0].id == depth[1].id);
    QVERIFY(withoutLayer(depth, Id::None) == depth && !layerOf(depth, Id::None));
    const ValueLayers moved = withLayerMoved(depth, depth[1].id, 2);
    QVERIFY(moved[3].id == depth[1].id && moved[1].id == depth[2].id && moved[0].id == depth[0].id);
    QVERIFY(withLayerMoved(depth, depth[1].id, -9)[0].id == depth[1].id);
    // A pin that gives an order has its layer's name, and none takes that of another.
    const Project both = withDepthName(project, depth[4].id, "e");
    QVERIFY(both.depth[4].name == "e" && depthOfHandle(both.depth, "e") == 3);
    QCOMPARE(both.design.handles[0].name, std::string("e"));
    QCOMPARE(withDepthName(project, depth[4].id, "d").depth[4].name, std::string("d 2"));
    Project several = project;
    several.depth[1].name = "b";
    several = withDepthName(several, depth[4].id, "e");
    QVERIFY(several.depth[1].name == "e" && several.depth[4].name == "e");
}

/// Two layers of paint of one name are still two in the file when the one between them is gone.
void TestRegionList::paintOfOneNameStaysApart() {
    const auto layer = [](const char* name, double x) {
        return layerWith(name, MaterialRegion{{Ball<3>{{x, 0, 0}, 1}}, 1.0});
    };
    Project project;
    project.domain.path = "a.png";
    project.design.material.layers = {layer("a", 0), layer("b", 1), layer("a", 2)};
    auto& layers = project.design.material.layers;
    const std::vector<MaterialLayer> before = layers;
    layers = withoutLayer(before, before[1].id);
    const auto read = [&] { return parseProject(toJson(project), "p.wend").project->design.material.layers; };
    QVERIFY(layers.size() == 2 && read().size() == 2 && read()[0].name == "a");
    layers = withLayerMoved(before, before[1].id, 1);
    QVERIFY(layers.size() == 3 && read().size() == 3 && layers[1].id == before[2].id);
    layers = *withLayerMergedDown(before, before[1].id);
    QVERIFY(layers.size() == 2 && read().size() == 2);
}

/// A stroke that evens out an even value changes nothing and adds no undo step.
void TestRegionList::strokesWithoutEffectAreNoSteps() {
    QVERIFY(open(RegionsOf::Depth));
    Document& document = m_f->session().document();
    const Ball<3> ball{Vec3::Zero(), 1};
    const int steps = document.undoStack()->count();
    document.changeDepth("nothing", withDepthStroke(document.depth(), {SoftRegion{ball}}, 0));
    document.changeSizes("nothing", withSizeStroke(document.domain().sizes, {SoftRegion{ball}}, 1));
    QCOMPARE(document.undoStack()->count(), steps);
}

/// The last stroke is on top, with its number, which can be changed; it can be renamed by typing and removed.
/// Each change is a step.
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
    QCOMPARE(list.item(0)->text(), QString::fromStdString(layers(of)[1].name));
    QCOMPARE(list.item(1)->text(), QString::fromStdString(layers(of)[0].name));
    auto* value = qobject_cast<QDoubleSpinBox*>(part("Value"));
    const double before = layers(of)[0].value, other = layers(of)[1].value;
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
    QCOMPARE(layers(of)[0].value, of == RegionsOf::Detail ? 0.3 : 3);
    QCOMPARE(layers(of)[1].value, other);
    undo().undo();
    QCOMPARE(layers(of)[0].value, before);
    QCOMPARE(list.currentRow(), 1);
    // The layer is renamed.
    list.setFocus();
    list.editItem(list.item(1));
    auto* editor = list.findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("Knee"));
    QTest::keyClick(editor, Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return layers(of)[0].name == "Knee"; }, 20000));
    QCOMPARE(list.currentItem()->text(), QStringLiteral("Knee"));
    // The layer is removed and restored.
    const int count = undo().count();
    QTest::mouseClick(part("Remove"), Qt::LeftButton);
    QCOMPARE(layers(of).size(), std::size_t(1));
    QCOMPARE(undo().count(), count + 1);
    QCOMPARE(list.count(), 1);
    undo().undo();
    QVERIFY(layers(of).size() == 2 && layers(of)[0].name == "Knee" && list.count() == 2);
    QCOMPARE(list.currentRow(), 1);  // what came back, not the topmost
    QVERIFY(settle(m_f->session()));
    m_f->picture(QStringLiteral("regions-%1").arg(kind));
}

/// The outline is shown on the shape as long as the list is visible.
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
    const auto ball = std::get<Ball<3>>(layers(of)[0].regions[0].shape);
    const QPoint edge = canvas.toWidget(inPlane(ball.centre) - Vec2(0, ball.radius)).toPoint();
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

/// Regions without a name, of any shape, are listed too.
void TestRegionList::regionsOfAFileAreListed() {
    QVERIFY(open(RegionsOf::Depth));
    Project next = m_f->project();
    next.depth = {layerWith("", 1, Box<3>{{40, 60, 0}, {80, 100, 0}}),
                  layerWith("", -2, Polygon{{{100, 60}, {140, 60}, {120, 100}}}),
                  layerWith("", 3, HalfSpace<3>{{180, 80, 0}, {1, 0, 0}})};
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

/// The radius of a pin that holds a part is a number; changing it is one step, and a radius that holds
/// nothing is refused.
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
