#include <QFile>
#include <QLineF>
#include <QPainter>
#include <QTextStream>
#include <algorithm>

#include "app/panels/distortion_panel.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/surface_panel.h"
#include "app/tools/pins/pin_picking.h"
#include "app/views/volume/solid_overlay.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/look_choices.h"
#include "app/window/actions/toolbox.h"
#include "app/window/main_window.h"
#include "app/window/solid_workshop.h"
#include "tests/support/contrast.h"
#include "tests/support/surfaces.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// The look of a solid in the window: cuts, detail surfaces, marks, and the view of the next document.
class TestSolidLooks : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void cutIsTakenBack();
    void cutEndsWithItsDocument();
    void sectionBesideDetailIsFilled();
    void firstCutTakesTheNearHalf_data();
    void firstCutTakesTheNearHalf();
    void wrongTrianglesAreRedFromBehind();
    void wrongTrianglesShineThrough();
    void marksAreWhereVerticesAreSeen();
    void fitShowsPathsToo();
    void fitShowsDetailToo();
    void worstPlaceIsMarkedWhereItIsSeen();
    void anotherDocumentIsSeenAsItIs();
    void movedSolidsAreClosed();
    void solidAfterAMovedOneIsSeenWhole();
    void arrowsAreSeenBeforeEveryGround();
    void mapsHaveARimOnDarkGround();
    void pinsThatAreCutAwayAreFaint();
    void pointedValueFollowsTheMap();

  private:
    QString file(const char* name, const QByteArray& text);
    QString project(const QByteArray& detail);
    void open(const QString& path);
    SolidWorkshop& solids() { return m_window->solids(); }
    SolidCanvas& canvas() { return *solids().canvas(); }
    ShapeSession& session() { return m_window->session(); }
    QColor colourAt(const Vec3& p);

    std::unique_ptr<TestFolder> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

namespace {

QByteArray boxText(const Vec3& half, int pieces) {
    const Surface bar = box(-half, half, pieces);
    QByteArray text;
    QTextStream out(&text);
    for (Eigen::Index i = 0; i < bar.points.cols(); ++i)
        out << "v " << bar.points(0, i) << ' ' << bar.points(1, i) << ' ' << bar.points(2, i) << '\n';
    for (const auto& t : bar.triangles) out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
    out.flush();
    return text;
}

bool isRed(const QColor& c) {
    return c.red() > 80 && c.red() > 2.2 * c.green() && c.red() > 1.8 * c.blue();
}

}  // namespace

void TestSolidLooks::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_folder = std::make_unique<TestFolder>();
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1200, 800);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), 20000));
}

void TestSolidLooks::cleanup() {
    if (m_window && !session().document().isEmpty()) session().document().undoStack()->setClean();
    m_window.reset();
}

QString TestSolidLooks::file(const char* name, const QByteArray& text) {
    QFile file(m_folder->filePath(QString::fromLatin1(name)));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) return {};
    return file.fileName();
}

/// Returns a project of a bar of 4 × 1 × 1, held as a whole and carried upwards by 6, with or without a red
/// box inside as its detail.
QString TestSolidLooks::project(const QByteArray& detail) {
    file("bar.obj", boxText({2, 0.5, 0.5}, 6));
    file("red.mtl", "newmtl red\nKd 1 0 0\n");
    file("inside.obj", "mtllib red.mtl\nusemtl red\n" + boxText({1.9, 0.4, 0.4}, 6));
    return file(detail.isEmpty() ? "plain.wend" : "detailed.wend",
                R"({"format": "wend", "version": 1, "domain": {"surface": "bar.obj", "vertices": 400)" +
                    (detail.isEmpty() ? QByteArray() : R"(, "detail": ")" + detail + "\"") +
                    R"(}, "handles": [{"name": "all", "at": {"region": {"box": {"min": [-3, -1, -1],
                    "max": [3, 1, 1]}}}, "motion": [{"kind": "translate", "by": [0, 0, 6],
                    "time": [0, 1]}]}], "time": {"end": 1}})");
}

/// Opens the project at rest, from the front: x to the right, z up.
void TestSolidLooks::open(const QString& path) {
    QVERIFY(!path.isEmpty());
    const int before = session().document().generation();
    m_window->openPath(path);
    QVERIFY(QTest::qWaitFor([&] { return session().document().generation() > before; }, 20000));
    QVERIFY(settle(session()));
    session().playback().setTime(0);
    QVERIFY(QTest::qWaitFor([&] { return session().motion().frame()->time == 0; }, 20000));
    solids().actions().front->trigger();
    canvas().fit();
}

QColor TestSolidLooks::colourAt(const Vec3& p) {
    const QImage image = canvas().grabFramebuffer();
    return image.pixelColor((canvas().toWidget(p) * image.devicePixelRatio()).toPoint());
}

void TestSolidLooks::cutIsTakenBack() {
    open(project("inside.obj"));
    solids().actions().oblique->trigger();
    const QImage whole = canvas().grabFramebuffer();
    solids().actions().cut->trigger();
    QVERIFY(canvas().grabFramebuffer() != whole);
    solids().actions().cut->trigger();
    QCOMPARE(canvas().solid().cut(), CutKind::None);
    QVERIFY(canvas().grabFramebuffer() == whole);
}

void TestSolidLooks::cutEndsWithItsDocument() {
    open(project({}));
    const QImage whole = canvas().grabFramebuffer();
    open(project("inside.obj"));
    solids().actions().cut->trigger();
    canvas().setCutPlane({Vec3::Zero(), Vec3::UnitX()});
    canvas().grabFramebuffer();
    open(project({}));
    QCOMPARE(canvas().solid().cut(), CutKind::None);
    QVERIFY(!solids().actions().cut->isChecked());
    QVERIFY(canvas().grabFramebuffer() == whole);
}

/// The section of the tetrahedra has no gaps, from both sides and under a map: one colour, neither that of
/// the detail's inner side nor its red.
void TestSolidLooks::sectionBesideDetailIsFilled() {
    open(project("inside.obj"));
    for (const bool map : {false, true})
        for (const double side : {1.0, -1.0}) {
            m_window->actions().showMap->setChecked(map);
            if (canvas().solid().cut() == CutKind::None) solids().actions().cut->trigger();
            canvas().setCutPlane({Vec3(0.0123, 0, 0), Vec3(side, 0.02, 0.01).normalized()});
            canvas().look(side > 0 ? Camera::Axis::Right : Camera::Axis::Left);
            canvas().camera().fit(Vec3(-0.7, -0.7, -0.7), Vec3(0.7, 0.7, 0.7));
            const QColor middle = colourAt({0.0123, 0, 0});
            QVERIFY(middle.red() < 1.5 * middle.green());
            const QImage image = canvas().grabFramebuffer();
            int other = 0;
            for (int i = -11; i <= 11; ++i)
                for (int k = -11; k <= 11; ++k) {
                    const QColor c =
                        image.pixelColor(canvas().toWidget({0.0123, i / 25., k / 25.}).toPoint());
                    other += qAbs(c.red() - middle.red()) > 12 || qAbs(c.green() - middle.green()) > 12;
                }
            QVERIFY2(other <= 2, qPrintable(QString::number(other)));  // of 529: single pixels of slivers
        }
}

void TestSolidLooks::firstCutTakesTheNearHalf_data() {
    QTest::addColumn<int>("axis");
    for (const auto& [name, axis] : {std::pair{"front", Camera::Axis::Front},
                                     {"back", Camera::Axis::Back},
                                     {"left", Camera::Axis::Left},
                                     {"right", Camera::Axis::Right},
                                     {"top", Camera::Axis::Top},
                                     {"oblique", Camera::Axis::Isometric}})
        QTest::newRow(name) << static_cast<int>(axis);
}

void TestSolidLooks::firstCutTakesTheNearHalf() {
    QFETCH(int, axis);
    open(project("inside.obj"));
    canvas().look(static_cast<Camera::Axis>(axis));
    solids().actions().cut->trigger();
    QVERIFY(canvas().solid().plane().normal.dot(canvas().viewDirection()) < -0.5);
    const SolidHit hit = canvas().pick(canvas().toWidget(Vec3::Zero()));
    QVERIFY(hit.cell >= 0 && std::abs(canvas().solid().plane().height(hit.point)) < 1e-9);
}

void TestSolidLooks::wrongTrianglesAreRedFromBehind() {
    file("open.obj", "v 0 0 0\nv 1 0 0.2\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    m_window->openPath(file("open.wend", R"({"format": "wend", "version": 1,
        "domain": {"surface": "open.obj", "vertices": 400, "cage": false}})"));
    QVERIFY(QTest::qWaitFor([&] { return solids().canvas() && isRed(colourAt({0.3, 0.6, 0})); }, 20000));
    for (const Camera::Axis axis : {Camera::Axis::Top, Camera::Axis::Bottom}) {
        canvas().look(axis);
        QVERIFY(isRed(colourAt({0.3, 0.6, 0})));
    }
}

/// A loose triangle in a closed box shines faintly through the side in front of it.
void TestSolidLooks::wrongTrianglesShineThrough() {
    file("loose.obj", boxText({2, 0.5, 0.5}, 1) + "v -1 0 -0.3\nv 1 0 -0.3\nv 0 0 0.4\nf 9 10 11\n");
    m_window->openPath(file("loose.wend", R"({"format": "wend", "version": 1,
        "domain": {"surface": "loose.obj", "vertices": 400, "cage": false}})"));
    const auto redness = [&](double x) {
        const QColor c = colourAt({x, -0.5, 0});
        return c.red() - c.green();
    };
    QVERIFY(QTest::qWaitFor([&] { return m_window->findChild<SurfacePanel*>()->isVisible(); }, 20000));
    canvas().look(Camera::Axis::Front);
    QVERIFY2(redness(0) > redness(1.5) + 25, qPrintable(QString::number(redness(0))));
    QVERIFY(!isRed(colourAt({0, -0.5, 0})));
}

/// The bar is seen from above, with half of it cut away.
void TestSolidLooks::marksAreWhereVerticesAreSeen() {
    open(project("inside.obj"));
    solids().actions().top->trigger();
    const std::vector<int> held = session().pins().verticesOf(0);
    const auto frame = session().motion().frame<3>();
    QCOMPARE(canvas().marksOf(held).size(), held.size());
    int seen = 0, hidden = 0;
    for (std::size_t i = 0; i < held.size(); ++i) {
        const VertexMark mark = canvas().marksOf({held[i]}).front();
        const Vec3 rest = frame->rest->points.col(held[i]);
        const bool inner = rest.cwiseAbs().cwiseQuotient(Vec3(2, 0.5, 0.5)).maxCoeff() < 1 - 1e-9;
        // The mark of a border vertex is on the box inside.
        const double depth = mark.at.cwiseAbs().cwiseQuotient(Vec3(1.9, 0.4, 0.4)).maxCoeff();
        QVERIFY(inner ? mark.at == rest : std::abs(depth - 1) < 1e-9);
        QVERIFY(rest.z() < 0.5 - 1e-9 || !mark.hidden);
        QVERIFY(rest.z() > 0.4 || rest.cwiseAbs().y() > 0.4 || std::abs(rest.x()) > 1.8 || mark.hidden);
        ++(mark.hidden ? hidden : seen);
    }
    QVERIFY(seen > 10 && hidden > 10);
    solids().actions().cut->trigger();
    canvas().setCutPlane({Vec3::Zero(), Vec3::UnitX()});
    const auto left = canvas().marksOf(held);
    QVERIFY(left.size() > 10 && left.size() < held.size());
    for (const VertexMark& mark : left) QVERIFY(mark.at.x() <= 1e-9);
}

void TestSolidLooks::fitShowsPathsToo() {
    open(project({}));
    canvas().camera().zoom(5, {0, 0}, canvas().size());
    QVERIFY(!canvas().rect().contains(canvas().toWidget({0, 0, 6}).toPoint()));
    m_window->actions().fit->trigger();
    for (const Vec3& p : {Vec3(0, 0, 6), Vec3(-2, 0, 0), Vec3(2, 0, 0)})
        QVERIFY(canvas().rect().contains(canvas().toWidget(p).toPoint()));
    QVERIFY(canvas().camera().pivot().norm() < 1e-9);  // turned around the solid all the same
}

/// The view fits embedded surfaces far outside the tetrahedra, but only while they are shown.
void TestSolidLooks::fitShowsDetailToo() {
    QVERIFY(!project({}).isEmpty());
    file("wide.obj", boxText({14, 0.4, 0.4}, 6));
    open(project("wide.obj"));
    QAction* fit = m_window->actions().fit;
    const auto showsTips = [&] {
        fit->trigger();
        const QRect view = canvas().rect();
        return view.contains(canvas().toWidget({14, -0.4, 0.4}).toPoint()) &&
               view.contains(canvas().toWidget({-14, -0.4, -0.4}).toPoint());
    };
    QVERIFY(showsTips());
    solids().actions().top->trigger();
    QVERIFY(showsTips());
    canvas().setCutKind(CutKind::Exact);
    QVERIFY(showsTips());
    canvas().setCutKind(CutKind::None);
    solids().actions().detail->setChecked(false);
    QVERIFY(!showsTips());
}

/// The worst cell of a pulled bar is inside: there is a faint ring only, without the cross hairs that would
/// point at a visible place. A cut through it shows it, from one side.
void TestSolidLooks::worstPlaceIsMarkedWhereItIsSeen() {
    file("bar.obj", boxText({2, 0.5, 0.5}, 2));
    const int before = session().document().generation();
    m_window->openPath(
        file("pulled.wend", R"({"format": "wend", "version": 1, "domain": {"surface": "bar.obj",
        "vertices": 26}, "handles": [{"name": "end", "at": {"region": {"box": {"min": [-3, -1, -1],
        "max": [-1.9, 1, 1]}}}}, {"name": "other end", "at": {"region": {"box": {"min": [1.9, -1, -1],
        "max": [3, 1, 1]}}}}, {"name": "pull", "at": {"points": [[0, -0.5, 0]]}, "motion": [{"kind":
        "translate", "by": [0, -0.2, 0], "time": [0, 1]}]}], "time": {"end": 1}})"));
    QVERIFY(QTest::qWaitFor([&] { return session().document().generation() > before; }, 20000));
    QVERIFY(settle(session()));
    m_window->actions().showMap->setChecked(true);
    const auto frame = session().motion().frame<3>();
    const int worst = worstOf(*frame->distortion, m_window->findChild<DistortionPanel*>()->measure()).cell;
    Vec3 centre = Vec3::Zero();
    for (const int v : frame->rest->cells[worst]) centre += frame->pose.col(v) / 4;
    // The pictures with and without the map differ by the mark of the worst place.
    const auto marks = [&](bool map) {
        m_window->actions().showMap->setChecked(map);
        QImage image(canvas().size(), QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        canvas().overlay().paintMarks(painter);
        return image;
    };
    const auto reach = [&](const QPointF& at) {
        const QImage with = marks(true), without = marks(false);
        double farthest = 0;
        for (int y = 0; y < with.height(); ++y)
            for (int x = 0; x < with.width(); ++x)
                if (with.pixel(x, y) != without.pixel(x, y))
                    farthest = std::max(farthest, QLineF(QPointF(x + 0.5, y + 0.5), at).length());
        return farthest;
    };
    const auto sizeOfMark = [&] {
        const auto place = canvas().placeOf(*session().motion().frame(), worst);
        return reach(canvas().toWidget(place ? *place : centre));
    };
    session().playback().setTime(0);
    QTRY_COMPARE(session().motion().frame()->time, 0.0);
    QCOMPARE(sizeOfMark(), 0.0);  // at rest no place is the worst
    session().playback().setTime(1);
    QTRY_COMPARE(session().motion().frame()->time, 1.0);
    const auto isCross = [](double size) { return size > 15 && size < 22; };
    const auto isRing = [](double size) { return size > 9 && size < 15; };
    solids().actions().front->trigger();
    canvas().fit();
    QVERIFY(!canvas().placeOf(*session().motion().frame(), worst));
    QVERIFY(isRing(sizeOfMark()));
    canvas().setCutKind(CutKind::Exact);
    canvas().setCutPlane({centre, -Vec3::UnitY()});
    const auto seen = canvas().placeOf(*session().motion().frame(), worst);
    QVERIFY(seen && std::abs(seen->y() - centre.y()) < 1e-9);  // on the section
    QVERIFY(isCross(sizeOfMark()));
    solids().actions().back->trigger();
    canvas().fit();
    QVERIFY(!canvas().placeOf(*session().motion().frame(), worst));
    QVERIFY(isRing(sizeOfMark()));
}

void TestSolidLooks::anotherDocumentIsSeenAsItIs() {
    open(project("inside.obj"));
    Actions& common = m_window->actions();
    SolidActions& a = solids().actions();
    common.showMap->setChecked(true);
    common.showMesh->setChecked(true);
    a.detail->setChecked(false);
    m_window->tools().action(QStringLiteral("lasso"))->setChecked(true);
    QVERIFY(!isRed(colourAt({0.3, -0.4, 0.1})));
    open(project("inside.obj"));
    QVERIFY(!common.showMap->isChecked() && !common.showMesh->isChecked());
    QVERIFY(a.detail->isChecked() && common.pinTool->isChecked());
    QVERIFY(isRed(colourAt({0.3, -0.4, 0.1})));
}

/// Every panel and the view are notified when a solid is closed at the end of its motion.
void TestSolidLooks::movedSolidsAreClosed() {
    open(project("inside.obj"));
    m_window->actions().showMap->setChecked(true);
    m_window->actions().showArrows->setChecked(true);
    session().selection().set({0});
    session().playback().setTime(session().playback().end());
    QVERIFY(settle(session()));
    m_window->actions().closeFile->trigger();
    QVERIFY(session().document().isEmpty() && !session().motion().frame());
    QVERIFY(!canvas().isVisible());
    open(project("inside.obj"));
    QVERIFY(canvas().isVisible());
}

/// The next solid is not confused with the one before, whose motion ends elsewhere.
void TestSolidLooks::solidAfterAMovedOneIsSeenWhole() {
    open(project({}));
    session().playback().setTime(1);
    QVERIFY(settle(session()));
    const QString large = file("large.obj", boxText({40, 10, 10}, 4));
    const int before = session().document().generation();
    m_window->openPath(large);
    QVERIFY(QTest::qWaitFor([&] { return session().document().generation() > before; }, 20000));
    QVERIFY(settle(session()));
    for (const double x : {-40.0, 40.0})
        QVERIFY(canvas().rect().contains(canvas().toWidget({x, 10, 10}).toPoint()));
    QVERIFY(canvas().toWidget({40, 0, 0}).x() - canvas().toWidget({-40, 0, 0}).x() > canvas().width() / 4);
}

/// Arrows contrast with black and white backdrops, and with those of both appearances.
void TestSolidLooks::arrowsAreSeenBeforeEveryGround() {
    open(project({}));
    Actions& common = m_window->actions();
    const auto least = [&] {  // contrast of half of what is blue in the view
        const QImage seen = canvas().grabFramebuffer();
        std::vector<double> all;
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 0; x < seen.width(); ++x)
                if (const QColor c = seen.pixelColor(x, y);
                    c.blue() > c.red() + 50 && c.blue() > c.green() + 40)
                    all.push_back(contrast(c, seen.pixelColor(2, seen.height() / 2)));
        if (all.size() < 200) return 0.0;
        std::ranges::nth_element(all, all.begin() + static_cast<long>(all.size() / 2));
        return all[all.size() / 2];
    };
    QCOMPARE(least(), 0.0);
    common.showArrows->setChecked(true);
    QVERIFY(QTest::qWaitFor([&] { return session().motion().velocity().cols() > 0; }, 20000));
    for (QAction* look : {common.darkLook, common.lightLook})
        for (const char* name : {"Black", "White", "Checks"}) {
            look->trigger();
            for (QAction* one : common.backdrop->menu()->actions())
                if (withoutKey(one->text()) == QLatin1String(name)) one->trigger();
            const double found = least();
            QVERIFY2(found >= 3, qPrintable(QString("%1: %2").arg(name).arg(found)));
        }
    common.systemLook->trigger();
}

/// The rim has no colour of the material, as on pictures.
void TestSolidLooks::mapsHaveARimOnDarkGround() {
    open(project({}));
    Actions& common = m_window->actions();
    const auto besideTheBar = [&] {
        const QImage seen = canvas().grabFramebuffer();
        const int y = canvas().toWidget({0, 0.5, 0.5}).toPoint().y();  // the far edge of the top
        int lightest = 0;
        for (int dy = -4; dy < 0; ++dy)
            lightest = std::max(lightest, seen.pixelColor(canvas().width() / 2, y + dy).lightness());
        return lightest;
    };
    common.darkLook->trigger();
    const int ground = besideTheBar();
    common.showMap->setChecked(true);
    QVERIFY2(besideTheBar() > ground + 50, qPrintable(QString::number(besideTheBar())));
    common.showMap->setChecked(false);
    QCOMPARE(besideTheBar(), ground);
    common.systemLook->trigger();
}

/// One pin is on the cut-away half, one on the other; the view is from the front, with the near half hidden.
void TestSolidLooks::pinsThatAreCutAwayAreFaint() {
    open(project({}));
    const auto addAt = [&](const Vec3& p) {
        const auto touched = canvas().touch(canvas().toWidget(p));
        QVERIFY(touched);
        session().addPin(std::optional(touched->place));
        QVERIFY(settle(session()));
    };
    addAt({1, -0.5, 0.1});
    const int front = static_cast<int>(session().document().design().handles.size()) - 1;
    const auto view = [&](int handle) {
        const auto pins = session().gestures().pins();
        return *std::ranges::find(pins, handle, &PinView::handle);
    };
    QVERIFY(!isMarkCovered(canvas(), view(front)));
    QVERIFY(!isMarkCovered(canvas(), view(0)));  // an area of all
    canvas().setCutKind(CutKind::Exact);
    canvas().setCutPlane({Vec3(0, 0.1, 0), -Vec3::UnitY()});
    addAt({-1, 0.1, 0.1});  // on the face of the cut
    QVERIFY(isMarkCovered(canvas(), view(front)));
    QVERIFY(!isMarkCovered(canvas(), view(front + 1)));
    QVERIFY(!isMarkCovered(canvas(), view(0)));  // some of it is there
    const QPointF mark = canvas().onScreen(view(front).centre);
    QCOMPARE(markUnder(canvas(), mark, false), front);  // where nothing else is
    canvas().setCutPlane({Vec3(0, 2, 0), -Vec3::UnitY()});
    QVERIFY(isMarkCovered(canvas(), view(0)));
    // Some whole cells reach beyond the plane.
    canvas().setCutKind(CutKind::WholeCells);
    canvas().setCutPlane({Vec3(0, 0.1, 0), -Vec3::UnitY()});
    const auto touched = canvas().touch(canvas().toWidget({0.2, 0.1, 0.1}));
    QVERIFY(touched && !canvas().isHidden(touched->place, touched->point));
}

/// The value under a resting pointer is updated, too.
void TestSolidLooks::pointedValueFollowsTheMap() {
    open(project({}));
    QString told;
    const QObject listener;
    connect(&canvas().viewport(), &Viewport::pointed, &listener,
            [&told](const QString& text) { told = text; });
    QTest::mouseMove(&canvas(), canvas().toWidget({0.3, -0.5, 0.1}).toPoint());
    QTRY_VERIFY2(told.startsWith("Cell"), qPrintable(told));
    m_window->actions().showMap->setChecked(true);
    QVERIFY2(told.startsWith("Stretch") && told.contains("Cell"), qPrintable(told));
    m_window->actions().showMap->setChecked(false);
    QVERIFY2(told.startsWith("Cell"), qPrintable(told));
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&canvas(), &leave);
    m_window->actions().showMap->setChecked(true);
    QVERIFY2(told.isEmpty(), qPrintable(told));
}

QTEST_MAIN(TestSolidLooks)
#include "test_solid_looks.moc"
