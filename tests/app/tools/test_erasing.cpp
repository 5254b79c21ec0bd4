#include <QFile>
#include <QSignalSpy>

#include "app/project/edits/material_edits.h"
#include "app/tools/paint/layer_lines.h"
#include "tests/support/paint_test.h"

using namespace wend;
using namespace wend::test;

/// The eraser removes parts of strokes and fills.
class TestErasing : public PaintTest {
    Q_OBJECT
  private slots:
    void init() { begin(); }
    void cleanup() { m_f.reset(); }
    void erasedPlacesFollowTheShape_data() { dimensions(); }
    void erasedPlacesFollowTheShape();
    void eraserChangesAllVisibleLayers_data() { dimensions(); }
    void eraserChangesAllVisibleLayers();
    void halfAnEraserLeavesHalf_data() { dimensions(); }
    void layersErasedPieceByPieceGo();
    void layersHiddenInPartAreErased();
    void halfAnEraserLeavesHalf();
    void fillsAreTakenBack_data() { dimensions(); }
    void fillsAreTakenBack();
    void linesExcludeErasedParts();

  private:
    template <int Dim>
    void followTheShape();
    template <int Dim>
    void takeFromAll();
    template <int Dim>
    void leaveHalf();
    template <int Dim>
    void takeBackFills();
};

namespace {

/// Computes the effect of the file's regions over another value, cell by cell, by an independent sum.
template <int Dim>
std::vector<double> expected(const PosedFrame<Dim>& frame, const std::vector<MaterialRegion>& regions,
                             double everywhere, double painted) {
    std::vector<double> values;
    for (const auto& cell : frame.rest->cells) {
        Vec<Dim> centre = Vec<Dim>::Zero();
        for (const int v : cell) centre += frame.rest->points.col(v) / (Dim + 1);
        double cover = 0;
        for (const auto& region : regions) {
            const auto ball = std::get<Ball<Dim>>(regionIn<Dim>(region.shape));
            const double t =
                std::clamp(0.5 - ((centre - ball.centre).norm() - ball.radius) / region.feather, 0.0, 1.0);
            const double m = t * t * (3 - 2 * t);
            cover = region.erases() ? (1 - m) * cover : cover + m * (1 - cover);
        }
        values.push_back(everywhere + cover * (painted - everywhere));
    }
    return values;
}

double farthest(const std::vector<double>& a, const std::vector<double>& b) {
    double far = a.size() == b.size() ? 0 : INFINITY;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) far = std::max(far, std::abs(a[i] - b[i]));
    return far;
}

}  // namespace

void TestErasing::erasedPlacesFollowTheShape() {
    BOTH(followTheShape);
}

/// An erased place has the value of its surroundings, even if that changes later; with a soft edge, in the
/// painted layer.
template <int Dim>
void TestErasing::followTheShape() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    auto& canvas = Bar<Dim>::canvas(*m_f);
    const double angle = phi::conformal(Dim);
    m_f->tool("paint")->trigger();
    set([&](BrushSettings& b) { b.phi = angle, b.radius = 60, b.hardness = 0.8; });
    stroke<Dim>({-1.5, 0}, {1.5, 0});
    QVERIFY(settle(session));
    const auto painted = phis<Dim>();
    const auto names = layers();
    const int before = steps();
    eraseWith<Dim>(40);
    stroke<Dim>({0, 0}, {0.1, 0}, {}, false);
    const auto shown = posed<Dim>(canvas.shownFrame())->material->phi;
    QVERIFY(shown != painted);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, canvas.toWidget(Bar<Dim>::place(0.1, 0)).toPoint());
    QVERIFY(settle(session));
    QVERIFY(phis<Dim>() == shown);
    QCOMPARE(steps(), before + 1);
    QVERIFY(layers() == names && names.size() == 1);
    for (const double everywhere : {phi::kMetr, phi::kAkvf, 1.1}) {
        QVERIFY(setEverywhere<Dim>(everywhere));
        const auto wanted = expected<Dim>(*session.motion().frame<Dim>(), regions<Dim>(), everywhere, angle);
        QVERIFY2(farthest(phis<Dim>(), wanted) < 1e-12,
                 qPrintable(QString::number(farthest(phis<Dim>(), wanted))));
        QCOMPARE(phis<Dim>()[cellAt<Dim>(0)], everywhere);
        QCOMPARE(phis<Dim>()[cellAt<Dim>(-1.3)], angle);
    }
    const auto last = phis<Dim>();
    for (int i = 0; i < 4; ++i) QVERIFY(undo());
    QVERIFY(phis<Dim>() == painted);
    for (int i = 0; i < 4; ++i) m_f->window().actions().redo->trigger();
    QVERIFY(settle(session));
    QVERIFY(phis<Dim>() == last);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("erased.wend"));
    session.document().save(path);
    m_f->window().openPath(path);
    QVERIFY(QTest::qWaitFor([&] { return session.document().source() == path; }, 20000) && settle(session));
    QVERIFY(phis<Dim>() == last);
    QFile file(path);  // for those who know of no erasers
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    QVERIFY(text.contains("\"leaves\": 0") && text.count("\"phi\": 1.1") > 1);
}

void TestErasing::eraserChangesAllVisibleLayers() {
    BOTH(takeFromAll);
}

/// The eraser removes any value; hidden layers stay, and a layer with nothing left is removed.
template <int Dim>
void TestErasing::takeFromAll() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    const auto isStiff = [&](double u) {
        const auto& B = session.motion().frame<Dim>()->material->anisotropy;
        return !B.empty() && !B[cellAt<Dim>(u)].isIdentity(1e-9);
    };
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.phi = phi::kAkvf, b.radius = 30, b.hardness = 1; });
    if (Dim == 3) set([](BrushSettings& b) { b.radius = 66; });
    stroke<Dim>({-1, 0}, {1, 0});
    set([](BrushSettings& b) { b.target = BrushTarget::Stiffness, b.ratio = 8; });
    stroke<Dim>({-1, 0}, {1, 0});
    QVERIFY(settle(session));
    QCOMPARE(layers().size(), std::size_t(2));
    QVERIFY(isStiff(0) && phis<Dim>()[cellAt<Dim>(0)] == phi::kAkvf);
    eraseWith<Dim>(40);
    set([](BrushSettings& b) { b.target = BrushTarget::Direction; });
    QVERIFY(m_f->tool("eraser")->isChecked());
    QVERIFY(Bar<Dim>::canvas(*m_f).viewport().tool()->hint().contains(QStringLiteral("all visible layers")));
    stroke<Dim>({0, 0}, {0.1, 0});
    QVERIFY(settle(session));
    QCOMPARE(layers().size(), std::size_t(2));
    QVERIFY(!isStiff(0) && phis<Dim>()[cellAt<Dim>(0)] == phi::kMetr);
    QVERIFY(isStiff(-0.9) && phis<Dim>()[cellAt<Dim>(-0.9)] == phi::kAkvf);
    const auto names = layers();
    list()->item(0)->setCheckState(Qt::Unchecked);  // the topmost is hidden
    QVERIFY(settle(session) && !isStiff(-0.9));
    eraseWith<Dim>(110);
    stroke<Dim>({-1.3, 0}, {1.3, 0});
    QVERIFY(settle(session));
    QVERIFY(layers() == std::vector{names[1]});
    QCOMPARE(list()->count(), 1);
    list()->item(0)->setCheckState(Qt::Checked);
    QVERIFY(settle(session) && isStiff(-0.9) && !isStiff(0));
    stroke<Dim>({-1.3, 0}, {1.3, 0});
    QVERIFY(settle(session) && layers().empty() && !isStiff(-0.9));
    const int before = steps();
    QSignalSpy told(&session.document(), &Document::notice);
    stroke<Dim>({-1.3, 0}, {1.3, 0});
    QVERIFY(steps() == before && told.count() == 1);
    QVERIFY(undo() && isStiff(-0.9));
}

/// A file may hide a few regions of a layer: the others are erased as usual.
void TestErasing::layersHiddenInPartAreErased() {
    QVERIFY(Bar<2>::open(*m_f));
    Document& document = m_f->session().document();
    Design design = document.design();
    MaterialRegion seen{{Ball<3>{inSpace(Bar<2>::place(-0.9, 0)), 20}}, phi::kAkvf}, hidden = seen;
    hidden.shape = Ball<3>{inSpace(Bar<2>::place(0.9, 0)), 20};
    hidden.hidden = true;
    design.material.layers = {{"half", {seen, hidden}}};
    document.changeDesign("Layer", design);
    QVERIFY(settle(m_f->session()) && phis<2>()[cellAt<2>(-0.9)] == phi::kAkvf);
    eraseWith<2>(110);
    stroke<2>({-1.3, 0}, {1.3, 0});
    QVERIFY(settle(m_f->session()) && phis<2>()[cellAt<2>(-0.9)] == phi::kMetr);
}

/// No single place of the eraser covers a place of the brush; together they leave nothing.
void TestErasing::layersErasedPieceByPieceGo() {
    QVERIFY(Bar<2>::open(*m_f));
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.phi = phi::kAkvf, b.radius = 40, b.hardness = 1; });
    stroke<2>({0, 0}, {0.1, 0});
    QVERIFY(settle(m_f->session()));
    QCOMPARE(layers().size(), std::size_t(1));
    eraseWith<2>(25);
    stroke<2>({-0.8, 0}, {0.9, 0});
    QVERIFY(settle(m_f->session()));
    QCOMPARE(layers().size(), std::size_t(1));  // beside that way something is left
    for (const double v : {-0.5, -0.25, 0.25, 0.5}) stroke<2>({-0.8, v}, {0.9, v});
    QVERIFY(settle(m_f->session()));
    QVERIFY(layers().empty() && undo() && layers().size() == 1);
}

void TestErasing::halfAnEraserLeavesHalf() {
    BOTH(leaveHalf);
}

/// The amount does not depend on the number of balls in a stroke; a second stroke leaves half of the rest.
template <int Dim>
void TestErasing::leaveHalf() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.phi = phi::kAkvf, b.radius = Dim == 3 ? 150 : 60, b.hardness = 1; });
    stroke<Dim>({-1, 0}, {1, 0});
    eraseWith<Dim>(40);
    set([](BrushSettings& b) { b.amount = 0.5; });
    for (const double left : {0.5, 0.25}) {
        stroke<Dim>({-0.1, 0}, {0.1, 0});
        QVERIFY(settle(session));
        const double wanted = phi::kMetr + left * (phi::kAkvf - phi::kMetr);
        QVERIFY(std::abs(phis<Dim>()[cellAt<Dim>(0)] - wanted) < 1e-9);
    }
    QCOMPARE(phis<Dim>()[cellAt<Dim>(-0.9)], phi::kAkvf);
}

void TestErasing::fillsAreTakenBack() {
    BOTH(takeBackFills);
}

/// A fill is erased in part, and wholly by Ctrl; painting there again restores it.
template <int Dim>
void TestErasing::takeBackFills() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    m_f->tool("paint")->trigger();
    m_f->tool("fill")->trigger();
    set([](BrushSettings& b) { b.phi = phi::kAkvf, b.hardness = 1; });
    stroke<Dim>({0, 0}, {0, 0});
    eraseWith<Dim>(40);
    stroke<Dim>({0, 0}, {0.1, 0});
    QVERIFY(settle(session) && setEverywhere<Dim>(1.1));
    QVERIFY(phis<Dim>()[cellAt<Dim>(0)] == 1.1 && phis<Dim>()[cellAt<Dim>(-1.5)] == phi::kAkvf);
    m_f->tool("paint")->trigger();
    stroke<Dim>({0, 0}, {0, 0});
    QVERIFY(settle(session) && layers().size() == 1);
    QCOMPARE(phis<Dim>()[cellAt<Dim>(0)], phi::kAkvf);
    m_f->tool("fill")->trigger();
    stroke<Dim>({0, 0}, {0, 0}, Qt::ControlModifier);
    QVERIFY(settle(session) && layers().empty() && regions<Dim>().empty());
    QVERIFY(std::ranges::all_of(phis<Dim>(), [](double one) { return one == 1.1; }));
}

/// Each point of the lines is on a circle of the paint outside the erased parts, or on one of an eraser
/// within the paint.
void TestErasing::linesExcludeErasedParts() {
    SimplicialMesh<2> rest;
    rest.points.resize(2, 3);
    rest.points << 0, 100, 0, 0, 0, 100;
    rest.cells = {{0, 1, 2}};
    std::vector<MaterialRegion> layer{
        {{Ball<3>{{50, 50, 0}, 30}}, 1.0}, {{Ball<3>{{80, 50, 0}, 10}}}, {{Ball<3>{{70, 50, 0}, 4}}, 1.0}};
    layer[1].leaves = 0;
    int paint = 0, erased = 0, again = 0;
    for (const auto& line : linesOf(layer, rest).border)
        for (const Vec2& p : line) {
            const double a = (p - Vec2(50, 50)).norm() - 30, b = (p - Vec2(80, 50)).norm() - 10,
                         c = (p - Vec2(70, 50)).norm() - 4;
            const bool onPaint = std::abs(a) < 1e-6 && b > -1e-6, onEraser = std::abs(b) < 1e-6 && a < 1e-6;
            QVERIFY((onPaint || onEraser || std::abs(c) < 1e-6) && c > -1e-6);
            paint += onPaint, erased += onEraser;
            if (std::abs(c) < 1e-6 && b < -1e-6) ++again;
            QVERIFY(std::abs(c) > 1e-6 || b < 1e-6);  // where it is painted anyway it is no border
        }
    QVERIFY(paint > 20 && erased > 5 && again > 3);
}

QTEST_MAIN(TestErasing)
#include "test_erasing.moc"
