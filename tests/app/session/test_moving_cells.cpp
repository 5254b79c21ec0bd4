// The coarser cells with which a large picture is drawn while it moves: nothing is drawn far from its place,
// the outline is the shape's own, the order is kept, and the window uses them for drags only.

#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <set>

#include "app/views/canvas/render_thread.h"

using namespace wend;

class TestMovingCells : public QObject {
    Q_OBJECT
  private slots:
    void nothingIsFarFromItsPlace();
    void outlineIsTheShapesOwn();
    void moreAreTakenWhereItBends();
    void unusedVerticesDoNotMatter();
    void usualMeshesAreDrawnSo();
    void shapesWithoutGainAreDrawnWhole();
    void pictureIsTheSame_data();
    void pictureIsTheSame();
    void dragsAloneAreDrawnSo();
    void partsAreDrawnSo();
};

namespace {

using MeshPtr = std::shared_ptr<const SimplicialMesh<2>>;

constexpr int kSide = 160;  // squares of the grid
constexpr double kUnit = 4;
constexpr int kHole = 40;  // its first square and its size

/// A square of triangles with a square hole.
MeshPtr gridOf(int side) {
    auto mesh = std::make_shared<SimplicialMesh<2>>();
    mesh->points.resize(2, (side + 1) * (side + 1));
    const auto at = [side](int i, int j) { return j * (side + 1) + i; };
    for (int j = 0; j <= side; ++j)
        for (int i = 0; i <= side; ++i) mesh->points.col(at(i, j)) = kUnit * Vec2(i, j);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            if (std::min(i, j) >= kHole && std::max(i, j) < 2 * kHole) continue;
            mesh->cells.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh->cells.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

/// Applies a wave that no coarse mesh follows everywhere, and moves one vertex as a pin does.
Points2 bent(const SimplicialMesh<2>& mesh, double pull = 9) {
    Points2 pose = mesh.points;
    const double size = kSide * kUnit;
    for (Eigen::Index v = 0; v < pose.cols(); ++v) {
        const Vec2 p = mesh.points.col(v) / size;
        pose.col(v) += 20 * Vec2(std::sin(5 * p.y()), p.x() * p.x() + std::cos(4 * p.x() * p.y()));
    }
    pose.col(100 * (kSide + 1) + 120) += Vec2(pull, 0);
    return pose;
}

/// Returns the farthest distance of a vertex of the shape from its place in the cells, over all cells.
double farthest(const SimplicialMesh<2>& mesh, const std::vector<Cell<2>>& cells, const Points2& pose) {
    std::vector<double> least(static_cast<std::size_t>(mesh.vertexCount()), -1);
    for (const Cell<2>& cell : cells) {
        const Vec2 a = mesh.points.col(cell[0]);
        Mat2 edges, moved;
        edges << mesh.points.col(cell[1]) - a, mesh.points.col(cell[2]) - a;
        moved << pose.col(cell[1]) - pose.col(cell[0]), pose.col(cell[2]) - pose.col(cell[0]);
        const Mat2 toWeights = edges.inverse();
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            const Vec2 w = toWeights * (mesh.points.col(v) - a);
            if (w.minCoeff() < -1e-9 || w.sum() > 1 + 1e-9) continue;
            const double off = (pose.col(cell[0]) + moved * w - pose.col(v)).norm();
            least[v] = std::max(least[v], off);
        }
    }
    std::set<int> used;
    for (const Cell<2>& cell : mesh.cells) used.insert(cell.begin(), cell.end());
    double most = 0;
    for (const int v : used) most = std::max(most, least[v] < 0 ? HUGE_VAL : least[v]);
    return most;
}

std::set<std::pair<int, int>> borderOf(const SimplicialMesh<2>& mesh) {
    std::set<std::pair<int, int>> border;
    for (const auto& facet : facetsOf(mesh))
        if (!facet.interior()) border.insert(std::minmax(facet.vertices[0], facet.vertices[1]));
    return border;
}

/// Green on red, in steps that a displaced cell would show.
std::shared_ptr<const Image> picture() {
    Image image{static_cast<int>(kSide * kUnit),
                static_cast<int>(kSide * kUnit),
                4,
                PixelType::UInt8,
                true,
                true,
                {},
                {}};
    image.makePixels();
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double wave = std::sin(0.05 * x) * std::sin(0.04 * y);
            const std::uint8_t pixel[] = {static_cast<std::uint8_t>(x < image.width / 2 ? 200 : 40),
                                          static_cast<std::uint8_t>(127 + 100 * wave), 60, 255};
            std::copy_n(reinterpret_cast<const std::byte*>(pixel), 4, image.row(y) + 4 * x);
        }
    return std::make_shared<const Image>(std::move(image));
}

RenderRequest requestOf(const MeshPtr& mesh, const Points2& pose) {
    auto frame = std::make_shared<PosedFrame<2>>();
    frame->rest = mesh;
    frame->pose = pose;
    frame->live = true;
    RenderRequest request;
    request.frame = std::move(frame);
    request.picture = std::make_shared<const ScreenPicture>(picture());
    request.view.pan({30, 30});
    request.size = QSize(760, 740);
    return request;
}

int worst(QRgb a, QRgb b) {
    return std::max(
        {std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
}

}  // namespace

void TestMovingCells::nothingIsFarFromItsPlace() {
    const MeshPtr mesh = gridOf(kSide);
    const Points2 pose = bent(*mesh);
    MovingCells moving;
    for (const double tolerance : {1.0, 0.5, 0.2}) {
        const auto drawn = moving.of(mesh, nullptr, pose, tolerance);
        QVERIFY2(drawn, qPrintable(QString::number(tolerance)));
        QVERIFY(3 * drawn->cells.size() < 2 * mesh->cells.size());
        QVERIFY(farthest(*mesh, drawn->cells, pose) <= tolerance * (1 + 1e-9));
    }
}

void TestMovingCells::outlineIsTheShapesOwn() {
    const MeshPtr mesh = gridOf(kSide);
    const auto drawn = MovingCells().of(mesh, nullptr, bent(*mesh), 0.5);
    QVERIFY(drawn);
    QVERIFY(borderOf({mesh->points, drawn->cells}) == borderOf(*mesh));
    QCOMPARE(drawn->plan->outline.size(), borderOf(*mesh).size());
}

void TestMovingCells::moreAreTakenWhereItBends() {
    const MeshPtr mesh = gridOf(kSide);
    MovingCells moving;
    const auto first = moving.of(mesh, nullptr, mesh->points, 0.5),
               same = moving.of(mesh, nullptr, mesh->points, 0.5);
    QVERIFY(first);
    QVERIFY(first == same);
    const auto later = moving.of(mesh, nullptr, bent(*mesh), 0.5);
    QVERIFY(later);
    QVERIFY(later->cells.size() > first->cells.size());
}

/// A vertex without a cell may be anywhere.
void TestMovingCells::unusedVerticesDoNotMatter() {
    const MeshPtr mesh = gridOf(kSide);
    Points2 pose = bent(*mesh);
    const int inHole = (kHole + 10) * (kSide + 1) + kHole + 10;
    pose.col(inHole) = Vec2(1e6, -1e6);
    const auto drawn = MovingCells().of(mesh, nullptr, pose, 0.5);
    QVERIFY(drawn);
    for (const Cell<2>& cell : drawn->cells) QVERIFY(std::ranges::find(cell, inHole) == cell.end());
}

/// A picture with the default number of vertices is drawn with such cells.
void TestMovingCells::usualMeshesAreDrawnSo() {
    const MeshPtr mesh = gridOf(74);
    QVERIFY(mesh->vertexCount() < 5700);
    Points2 pose = mesh->points;
    for (Eigen::Index v = 0; v < pose.cols(); ++v) pose(0, v) += 15 * std::sin(0.01 * pose(1, v));
    const auto drawn = MovingCells().of(mesh, nullptr, pose, 0.5);
    QVERIFY(drawn && 2 * drawn->cells.size() < mesh->cells.size());
    QVERIFY(farthest(*mesh, drawn->cells, pose) <= 0.5 + 1e-9);
}

void TestMovingCells::shapesWithoutGainAreDrawnWhole() {
    const MeshPtr small = gridOf(55), mesh = gridOf(kSide);
    QVERIFY(!MovingCells().of(small, nullptr, small->points, 1));
    // No coarser mesh follows noise; where twice the deviation is allowed, it is tried again.
    Points2 noisy = mesh->points;
    for (Eigen::Index v = 0; v < noisy.cols(); ++v)
        noisy.col(v) += Vec2(std::sin(7.0 * v), std::cos(3.0 * v));
    MovingCells moving;
    for (int i = 0; i < 20; ++i) QVERIFY(!moving.of(mesh, nullptr, noisy, 0.01));
    QVERIFY(moving.of(mesh, nullptr, noisy, 5));
    // The mesh covers itself at rest.
    auto twice = std::make_shared<SimplicialMesh<2>>(*mesh);
    const int count = mesh->vertexCount();
    twice->points.conservativeResize(2, 2 * count);
    twice->points.rightCols(count) = mesh->points.colwise() + Vec2(11.3, 7.1);
    for (const Cell<2>& cell : mesh->cells)
        twice->cells.push_back({cell[0] + count, cell[1] + count, cell[2] + count});
    QVERIFY(!MovingCells().of(twice, nullptr, twice->points, 1));
    // All vertices of a ribbon are on its outline, which is kept whole.
    constexpr int kSteps = 5000;
    auto ribbon = std::make_shared<SimplicialMesh<2>>();
    ribbon->points.resize(2, 2 * (kSteps + 1));
    for (int i = 0; i <= kSteps; ++i) {
        ribbon->points.col(2 * i) = kUnit * Vec2(i, 0);
        ribbon->points.col(2 * i + 1) = kUnit * Vec2(i, 1);
        if (i == kSteps) break;
        ribbon->cells.push_back({2 * i, 2 * i + 2, 2 * i + 3});
        ribbon->cells.push_back({2 * i, 2 * i + 3, 2 * i + 1});
    }
    QVERIFY(!MovingCells().of(ribbon, nullptr, ribbon->points, 1));
}

void TestMovingCells::pictureIsTheSame_data() {
    QTest::addColumn<bool>("folded");
    QTest::newRow("bent") << false;
    QTest::newRow("folded, in two depths") << true;
}

/// The outline is equal to the bit, and colours within the change over half a pixel, except for the step
/// where the halves meet. When folded, the right half is over the left one, and the other way round.
void TestMovingCells::pictureIsTheSame() {
    QFETCH(bool, folded);
    const MeshPtr mesh = gridOf(kSide);
    for (const bool leftAbove : {false, true}) {
        Points2 pose = bent(*mesh, 0);
        std::vector<float> depth;
        if (folded) {
            const double middle = kSide * kUnit / 2;
            for (Eigen::Index v = 0; v < pose.cols(); ++v)
                if (pose(0, v) > middle) pose(0, v) = middle - 0.8 * (pose(0, v) - middle);
            for (const Cell<2>& cell : mesh->cells) {
                const double x =
                    (mesh->points(0, cell[0]) + mesh->points(0, cell[1]) + mesh->points(0, cell[2])) / 3;
                depth.push_back((x < middle) == leftAbove ? 1 : 0);
            }
        }
        RenderRequest request = requestOf(mesh, pose);
        if (folded) request.plan = std::make_shared<const PaintingPlan>(*mesh, depth);
        const QImage whole = RenderThread::render(request);
        request.cells = MovingCells().of(mesh, request.plan, pose, 0.5);
        QVERIFY(request.cells);
        const QImage coarse = RenderThread::render(request);
        int differing = 0, seen = 0;
        for (int y = 0; y < whole.height(); ++y)
            for (int x = 0; x < whole.width(); ++x) {
                const QRgb a = whole.pixel(x, y), b = coarse.pixel(x, y);
                seen += qAlpha(a) > 0;
                if (qAlpha(a) == qAlpha(b) && worst(a, b) <= 8) continue;
                ++differing;
            }
        QVERIFY(seen > 100000);
        const int step = folded ? 4 * whole.height() : 2 * whole.height();
        QVERIFY2(differing < step, qPrintable(QString("%1 of %2").arg(differing).arg(seen)));
    }
}

void TestMovingCells::dragsAloneAreDrawnSo() {
    const MeshPtr mesh = gridOf(kSide);
    RenderThread thread;
    std::shared_ptr<const RenderResult> result;
    connect(&thread, &RenderThread::rendered, this, [&](const auto& drawn) { result = drawn; });
    const auto drawn = [&](bool live, Filter filter) {
        RenderRequest request = requestOf(mesh, bent(*mesh));
        auto frame = std::make_shared<PosedFrame<2>>(*request.frame);
        frame->live = live;
        request.frame = std::move(frame);
        request.filter = filter;
        result.reset();
        thread.post(std::move(request));
        return QTest::qWaitFor([&] { return result != nullptr; }, 60000) && result->request.cells != nullptr;
    };
    QVERIFY(drawn(true, Filter::Bilinear));
    QVERIFY(!drawn(true, Filter::Ewa));
    QVERIFY(!drawn(false, Filter::Bilinear));
}

/// Two sheets overlap at rest and are side by side in their picture: the second one is in front. Blended ones
/// have their own cells.
void TestMovingCells::partsAreDrawnSo() {
    constexpr int kSquares = 74;
    const MeshPtr sheet = gridOf(kSquares);
    const int vertices = sheet->vertexCount(), cells = sheet->cellCount();
    const auto twice = [&](const Vec2& shift) {
        SimplicialMesh<2> both = *sheet;
        both.points.conservativeResize(2, 2 * vertices);
        both.points.rightCols(vertices) = sheet->points.colwise() + shift;
        for (const Cell<2>& cell : sheet->cells)
            both.cells.push_back({cell[0] + vertices, cell[1] + vertices, cell[2] + vertices});
        both.parts = {{"back", 0, vertices, 0, cells}, {"front", vertices, 2 * vertices, cells, 2 * cells}};
        return std::make_shared<const SimplicialMesh<2>>(std::move(both));
    };
    const MeshPtr drawn = twice({90, 50});
    Texture texture{twice({kSquares * kUnit + 32, 10}), {}, drawn, std::vector<Sheet>(2), {}, 640, 640};
    Points2 pose = drawn->points;
    for (Eigen::Index v = 0; v < pose.cols(); ++v) pose(0, v) += 15 * std::sin(0.01 * pose(1, v));
    RenderThread thread;
    std::shared_ptr<const RenderResult> result;
    connect(&thread, &RenderThread::rendered, this, [&](const auto& one) { result = one; });
    const auto render = [&](RenderRequest request) {
        result.reset();
        thread.post(std::move(request));
        return QTest::qWaitFor([&] { return result != nullptr; }, 60000);
    };
    RenderRequest request = requestOf(drawn, pose);
    request.filter = Filter::Bilinear;
    request.texture = std::make_shared<const Texture>(texture);
    request.plan = std::make_shared<const PaintingPlan>(*drawn, std::vector<float>());
    const QImage whole = RenderThread::render(request);
    QVERIFY(render(request));
    QVERIFY(result->request.cells && 2 * result->request.cells->cells.size() < drawn->cells.size());
    int differing = 0, seen = 0;
    for (int y = 0; y < whole.height(); ++y)
        for (int x = 0; x < whole.width(); ++x) {
            const QRgb a = whole.pixel(x, y), b = result->image.pixel(x, y);
            QCOMPARE(qAlpha(b), qAlpha(a));
            seen += qAlpha(a) > 0;
            differing += worst(a, b) > 8;
        }
    QVERIFY(seen > 80000);
    QVERIFY2(differing < whole.height(), qPrintable(QString("%1 of %2").arg(differing).arg(seen)));
    texture.sheets[1].blend = BlendMode::Multiply;
    request.texture = std::make_shared<const Texture>(texture);
    QVERIFY(render(request));
    QVERIFY(!result->request.cells);
}

QTEST_MAIN(TestMovingCells)
#include "test_moving_cells.moc"
