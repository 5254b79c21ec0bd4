// Large shapes are embedded in a coarser body while they are dragged: the preview stays near their own flow,
// and some properties are exact.

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <QtTest>
#include <algorithm>
#include <numeric>

#include "app/engine/motion/live_drag.h"
#include "core/base/error.h"
#include "core/meshing/coarse_mesh.h"
#include "kernels/back_end_choice.h"

using namespace wend;

class TestCoarseBody : public QObject {
    Q_OBJECT

  private slots:
    void bothDimensions_data();
    void begunWhereTheShapeIs_data() { bothDimensions_data(); }
    void begunWhereTheShapeIs();
    void affineMapsAreFollowed_data() { bothDimensions_data(); }
    void affineMapsAreFollowed();
    void nearTheShapesOwnFlow_data();
    void nearTheShapesOwnFlow();
    void continuesFromABentShape_data() { bothDimensions_data(); }
    void continuesFromABentShape();
    void pinsAreUnderTheHand_data() { bothDimensions_data(); }
    void pinsAreUnderTheHand();
    void pinsSideBySideDoWithoutIt_data() { bothDimensions_data(); }
    void pinsSideBySideDoWithoutIt();
    void partsSideBySideAreExact_data() { bothDimensions_data(); }
    void partsSideBySideAreExact();
    void bodyHasTheMaterialOfTheShape_data() { bothDimensions_data(); }
    void bodyHasTheMaterialOfTheShape();
    void bordersSlide();
    void holesStayOpen();
    void jawsStayApart();
    void onlyLargeShapesNeedOne();
};

namespace {

constexpr double kLength = 4;  // of a bar of width 1
constexpr double kDent = 0.16;

/// Cuts every box of a grid into Dim! simplices (Kuhn), one for each order of the axes along which its far
/// corner is reached from its lowest one.
template <int Dim>
SimplicialMesh<Dim> gridBar(int across) {
    std::array<int, Dim> counts;
    counts.fill(across);
    counts[0] = static_cast<int>(kLength) * across;
    const auto number = [&](const std::array<int, Dim>& at) {
        int n = 0;
        for (int k = Dim - 1; k >= 0; --k) n = n * (counts[k] + 1) + at[k];
        return n;
    };
    int vertices = 1, boxes = 1;
    for (const int count : counts) vertices *= count + 1, boxes *= count;
    SimplicialMesh<Dim> mesh;
    mesh.points.resize(Dim, vertices);
    for (int v = 0, rest = 0; v < vertices; ++v) {
        rest = v;
        for (int k = 0; k < Dim; ++k) {
            mesh.points(k, v) = static_cast<double>(rest % (counts[k] + 1)) / across;
            rest /= counts[k] + 1;
        }
    }
    for (int b = 0; b < boxes; ++b) {
        std::array<int, Dim> corner;
        for (int k = 0, rest = b; k < Dim; rest /= counts[k], ++k) corner[k] = rest % counts[k];
        std::array<int, Dim> axes;
        std::iota(axes.begin(), axes.end(), 0);
        do {
            Cell<Dim> cell;
            std::array<int, Dim> at = corner;
            cell[0] = number(at);
            for (int k = 0; k < Dim; ++k) {
                ++at[axes[k]];
                cell[k + 1] = number(at);
            }
            if (cellMeasure<Dim>(mesh.points, cell) < 0) std::swap(cell[0], cell[1]);
            mesh.cells.push_back(cell);
        } while (std::next_permutation(axes.begin(), axes.end()));
    }
    return mesh;
}

template <int Dim>
Shape<Dim> bar(double phi = phi::kMetr) {
    Shape<Dim> shape;
    shape.rest = std::make_shared<const SimplicialMesh<Dim>>(gridBar<Dim>(Dim == 2 ? 24 : 10));
    shape.material =
        std::make_shared<const Material<Dim>>(Material<Dim>::uniform(shape.rest->cellCount(), phi, {}));
    return shape;
}

template <int Dim>
std::shared_ptr<const CoarseBody<Dim>> bodyOf(const Shape<Dim>& shape) {
    return std::make_shared<const CoarseBody<Dim>>(
        shape, coarseMesh<Dim>(*shape.rest, shape.rest->vertexCount() / 6));
}

template <int Dim>
Handle<Dim> endHandle(int side) {
    HalfSpace<Dim> half{Vec<Dim>::Zero(), Vec<Dim>::Zero()};
    half.point.x() = side ? kLength - 0.25 : 0.25;
    half.normal.x() = side ? 1 : -1;
    Handle<Dim> handle;
    handle.name = side ? "right" : "left";
    handle.at = Region<Dim>(half);
    return handle;
}

template <int Dim>
std::vector<Handle<Dim>> ends() {
    return {endHandle<Dim>(0), endHandle<Dim>(1)};
}

template <int Dim>
Handle<Dim> pin(double x, double y) {
    Vec<Dim> at = Vec<Dim>::Constant(0.5);
    at.x() = x, at.y() = y;
    Handle<Dim> handle;
    handle.at = std::vector<Vec<Dim>>{at};
    return handle;
}

/// Returns the amount by which the pointer moves the right end at sample i.
Amount handAt(int i) {
    return {-0.02 * i, 0.12 * i, 0};
}
constexpr int kSamples = 8;

/// Drags through all samples; returns false if it did not arrive.
template <int Dim>
bool lead(LiveDrag<Dim>& drag, int handle, const Points<Dim>& from, int samples = kSamples) {
    drag.begin({handle}, {}, from);
    for (int i = 1; i <= samples; ++i)
        if (drag.follow(handAt(i)).stopped) return false;
    return true;
}

template <int Dim>
double farthest(const Points<Dim>& a, const Points<Dim>& b) {
    return (a - b).colwise().norm().maxCoeff();
}

/// Returns a bent pose with shears that no cell of the body shares.
template <int Dim>
Points<Dim> bent(const Points<Dim>& rest) {
    constexpr double curvature = 0.4;
    Points<Dim> pose = rest;
    for (Eigen::Index v = 0; v < rest.cols(); ++v) {
        const double x = rest(0, v), angle = curvature * x;
        const double arm = 1 / curvature - rest(1, v) + 0.004 * std::sin(40 * x);
        pose(0, v) = arm * std::sin(angle);
        pose(1, v) = 1 / curvature - arm * std::cos(angle);
    }
    return pose;
}

}  // namespace

#define IN_BOTH(body)         \
    QFETCH(int, dimension);   \
    if (dimension == 2)       \
        body.operator()<2>(); \
    else                      \
        body.operator()<3>()

void TestCoarseBody::bothDimensions_data() {
    QTest::addColumn<int>("dimension");
    QTest::newRow("plane") << 2;
    QTest::newRow("space") << 3;
}

void TestCoarseBody::begunWhereTheShapeIs() {
    const auto check = []<int Dim>() {
        const Shape<Dim> shape = bar<Dim>();
        const auto body = bodyOf(shape);
        QVERIFY(body->rest()->vertexCount() < shape.rest->vertexCount() / 3);
        // Where the last vertex is pushed in, the body folds over, since it reaches beyond the shape.
        Points<Dim> dented = shape.rest->points;
        for (Eigen::Index v = 0; v < dented.cols(); ++v)
            if (dented(1, v) == 1 && std::abs(dented(0, v) - 2) < 0.15) dented(1, v) -= kDent;
        for (const Points<Dim>& pose :
             {Points<Dim>(shape.rest->points), bent<Dim>(shape.rest->points), dented}) {
            const auto ride = body->begin(pose);
            QVERIFY(ride.has_value());
            // Of coordinates up to 4: rounding.
            QVERIFY(farthest<Dim>(body->carried(*ride, ride->body), pose) < 1e-13 * kLength);
        }
        // An inverted shape has no body to be embedded in.
        Points<Dim> mirrored = shape.rest->points;
        mirrored.row(0) *= -1;
        QVERIFY(!body->begin(mirrored).has_value());
    };
    IN_BOTH(check);
}

/// Both the shape and the body follow an affine map, whatever the initial pose, by the definition of the
/// embedding.
void TestCoarseBody::affineMapsAreFollowed() {
    const auto check = []<int Dim>() {
        const Shape<Dim> shape = bar<Dim>();
        const auto body = bodyOf(shape);
        const Points<Dim> pose = bent<Dim>(shape.rest->points);
        const auto ride = body->begin(pose);
        QVERIFY(ride.has_value());
        Mat<Dim> A = Mat<Dim>::Identity();
        A(0, 1) = 0.7, A(1, 0) = -0.9, A(0, 0) = 1.3;
        const Vec<Dim> b = Vec<Dim>::Constant(2);
        const Points<Dim> there = (A * ride->body).colwise() + b, expected = (A * pose).colwise() + b;
        QVERIFY(farthest<Dim>(body->carried(*ride, there), expected) < 1e-12 * kLength);
    };
    IN_BOTH(check);
}

void TestCoarseBody::nearTheShapesOwnFlow_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<double>("phi");
    for (const int dim : {2, 3})
        for (const auto& [name, phi] :
             {std::pair{"EQUIA", phi::kEquia}, {"METR", phi::kMetr}, {"AKVF", phi::kAkvf}})
            QTest::addRow("%d %s", dim, name) << dim << phi;
}

/// The end is moved by a quarter of the length. Held vertices stay and the moved end is exact; in between, a
/// body with a sixth of the vertices, whose cells are a fifth of the bar's width, differs by at most 2 % of
/// the length, which is hardly visible.
void TestCoarseBody::nearTheShapesOwnFlow() {
    QFETCH(double, phi);
    const auto check = [&]<int Dim>() {
        const Shape<Dim> shape = bar<Dim>(phi);
        const Points<Dim>& rest = shape.rest->points;
        LiveDrag<Dim> riding(shape, ends<Dim>(), bodyOf(shape)), own(shape, ends<Dim>());
        QVERIFY(riding.rides() && !own.rides());
        QVERIFY(lead<Dim>(riding, 1, rest) && lead<Dim>(own, 1, rest));
        const double off = farthest<Dim>(riding.pose(), own.pose());
        qInfo("off by %g", off);
        QVERIFY2(off > 1e-6 && off < 0.02 * kLength, qPrintable(QString::number(off)));
        for (int v = 0; v < shape.rest->vertexCount(); ++v) {
            const bool left = rest(0, v) <= 0.25, right = rest(0, v) >= kLength - 0.25;
            if (!left && !right) continue;
            Vec<Dim> there = rest.col(v);
            if (right) there += handAt(kSamples).template head<Dim>();
            QVERIFY((riding.pose().col(v) - there).norm() < 1e-10);
        }
    };
    IN_BOTH(check);
}

/// A drag that starts from the end of the shape's own flow has no jump, and it returns to where the own flow
/// arrives.
void TestCoarseBody::continuesFromABentShape() {
    const auto check = []<int Dim>() {
        const Shape<Dim> shape = bar<Dim>();
        LiveDrag<Dim> own(shape, ends<Dim>()), riding(shape, ends<Dim>(), bodyOf(shape));
        QVERIFY(lead<Dim>(own, 1, shape.rest->points));
        const Points<Dim> start = own.pose();
        riding.begin({1}, {}, start);
        own.begin({1}, {}, start);
        QVERIFY(riding.rides());
        QCOMPARE(farthest<Dim>(riding.pose(), start), 0.0);
        for (int i = 1; i <= kSamples; ++i) {
            QVERIFY(!riding.follow(Amount(-handAt(i))).stopped);
            QVERIFY(!own.follow(Amount(-handAt(i))).stopped);
        }
        const double off = farthest<Dim>(riding.pose(), own.pose());
        QVERIFY2(off < 0.02 * kLength, qPrintable(QString::number(off)));
    };
    IN_BOTH(check);
}

void TestCoarseBody::pinsAreUnderTheHand() {
    const auto check = []<int Dim>() {
        const Shape<Dim> shape = bar<Dim>();
        const std::vector<Handle<Dim>> handles{endHandle<Dim>(0), pin<Dim>(3.03, 0.52), pin<Dim>(2, 0.25)};
        LiveDrag<Dim> riding(shape, handles, bodyOf(shape));
        QVERIFY(riding.rides());
        QVERIFY(lead<Dim>(riding, 1, shape.rest->points));
        const Embedding<Dim> pins(*shape.rest, [&] {
            Points<Dim> points(Dim, 2);
            for (const int i : {0, 1}) points.col(i) = std::get<std::vector<Vec<Dim>>>(handles[i + 1].at)[0];
            return points;
        }());
        const Points<Dim> at = pins.carry(*shape.rest, shape.rest->points),
                          now = pins.carry(*shape.rest, riding.pose());
        QVERIFY((now.col(0) - at.col(0) - handAt(kSamples).template head<Dim>()).norm() < 1e-9);
        QVERIFY((now.col(1) - at.col(1)).norm() < 1e-9);
        // The vertices around a pin are not torn out: without pins they are near to where they are with them.
        for (int v = 0; v < shape.rest->vertexCount(); ++v)
            if ((shape.rest->points.col(v) - at.col(0)).norm() < 0.12)
                QVERIFY(
                    (riding.pose().col(v) - shape.rest->points.col(v) - handAt(kSamples).template head<Dim>())
                        .norm() < 0.2);
    };
    IN_BOTH(check);
}

/// The body could not move one pin without the other; the shape can, and does.
void TestCoarseBody::pinsSideBySideDoWithoutIt() {
    const auto check = []<int Dim>() {
        const Shape<Dim> shape = bar<Dim>();
        std::vector<Handle<Dim>> handles = ends<Dim>();
        handles.push_back(pin<Dim>(0.27, 0.5));
        LiveDrag<Dim> drag(shape, handles, bodyOf(shape));
        QVERIFY(!drag.rides());
        drag.begin({2}, {}, shape.rest->points);
        QVERIFY(!drag.follow({0.005, 0, 0}).stopped);
    };
    IN_BOTH(check);
}

/// The parts are a tenth of the width apart, less than a cell of the body: held ones stay, and a rotated one
/// rotates rigidly.
void TestCoarseBody::partsSideBySideAreExact() {
    const auto check = []<int Dim>() {
        const Shape<Dim> shape = bar<Dim>();
        const Points<Dim>& rest = shape.rest->points;
        std::vector<Handle<Dim>> handles = ends<Dim>();
        Box<Dim> box{Vec<Dim>::Constant(-1), Vec<Dim>::Constant(2)};
        box.min.x() = 0.35, box.max.x() = 0.75;
        Handle<Dim>& beside = handles.emplace_back();
        beside.at = Region<Dim>(box);
        LiveDrag<Dim> drag(shape, handles, bodyOf(shape));
        QVERIFY(drag.rides());
        Grip turn;
        turn.kind = Grip::Kind::Turn;
        turn.centre = Vec3(0.55, 0.5, Dim == 2 ? 0 : 0.5);
        turn.axis = Vec3::UnitZ();
        drag.begin({2}, turn, rest);
        QVERIFY(!drag.follow({0.05, 0, 0}).stopped);
        const Eigen::Rotation2Dd by(0.05);
        for (int v = 0; v < shape.rest->vertexCount(); ++v) {
            Vec<Dim> there = rest.col(v);
            const bool turned = rest(0, v) >= 0.35 && rest(0, v) <= 0.75;
            if (turned)
                there.template head<2>() =
                    turn.centre.head<2>() + by * (there.template head<2>() - turn.centre.head<2>());
            if (turned || rest(0, v) <= 0.25) QVERIFY((drag.pose().col(v) - there).norm() < 1e-9);
        }
    };
    IN_BOTH(check);
}

/// A cell of the body has φ and direction of the half that contains it, or the mean if it is in both.
void TestCoarseBody::bodyHasTheMaterialOfTheShape() {
    const auto check = []<int Dim>() {
        Shape<Dim> shape = bar<Dim>();
        Material<Dim> halves = *shape.material;
        halves.memory = 0.5;
        Mat<Dim> stiff = Mat<Dim>::Identity();
        stiff(0, 0) = 9;
        for (const Cell<Dim>& cell : shape.rest->cells) {
            double x = 0;
            for (const int v : cell) x += shape.rest->points(0, v) / (Dim + 1);
            halves.phi[halves.anisotropy.size()] = x < kLength / 2 ? phi::kEquia : phi::kAkvf;
            halves.anisotropy.push_back(x < kLength / 2 ? stiff : Mat<Dim>(Mat<Dim>::Identity()));
        }
        shape.material = std::make_shared<const Material<Dim>>(halves);
        const auto body = bodyOf(shape);
        QCOMPARE(body->material()->memory, 0.5);
        // The same where the body was first made of another material.
        const auto other = bodyOf(bar<Dim>())->with(halves);
        QCOMPARE(other->material()->phi, body->material()->phi);
        QVERIFY(other->material()->anisotropy == body->material()->anisotropy);
        QCOMPARE(body->material()->phi.size(), body->rest()->cells.size());
        int left = 0, right = 0;
        for (int c = 0; c < body->rest()->cellCount(); ++c) {
            double low = kLength, high = 0;
            for (const int v : body->rest()->cells[c]) {
                low = std::min(low, body->rest()->points(0, v));
                high = std::max(high, body->rest()->points(0, v));
            }
            const double phi = body->material()->phi[c], along = body->material()->anisotropy[c](0, 0);
            QVERIFY(phi > phi::kEquia * (1 - 1e-12) && phi < phi::kAkvf * (1 + 1e-12));
            if (high < kLength / 2) {
                ++left;
                QVERIFY(std::abs(phi - phi::kEquia) < 1e-12 && std::abs(along - 9) < 1e-12);
            } else if (low > kLength / 2) {
                ++right;
                QVERIFY(std::abs(phi - phi::kAkvf) < 1e-12 && std::abs(along - 1) < 1e-12);
            }
        }
        QVERIFY(left > 50 && right > 50);
    };
    IN_BOTH(check);
}

/// Vertices on the lower side stay on it and slide along it.
void TestCoarseBody::bordersSlide() {
    const Shape<2> shape = bar<2>();
    std::vector<Handle<2>> handles{endHandle<2>(0), pin<2>(3, 0.5)};
    Handle<2>& side = handles.emplace_back();
    side.at = Region<2>(HalfSpace<2>{{0, 1e-9}, {0, -1}});
    side.slides = 1;
    LiveDrag<2> riding(shape, handles, bodyOf(shape));
    QVERIFY(riding.rides());
    riding.begin({1}, {}, shape.rest->points);
    QVERIFY(!riding.follow({0.2, 0.05, 0}).stopped);
    double along = 0;
    for (int v = 0; v < shape.rest->vertexCount(); ++v) {
        if (shape.rest->points(1, v) != 0) continue;
        QVERIFY(std::abs(riding.pose()(1, v)) < 1e-12);
        along = std::max(along, std::abs(riding.pose()(0, v) - shape.rest->points(0, v)));
    }
    QVERIFY2(along > 0.02, qPrintable(QString::number(along)));
}

/// In the plane the body has the shape's own outline, so separate parts stay separate.
void TestCoarseBody::holesStayOpen() {
    SimplicialMesh<2> mesh = gridBar<2>(24);
    std::erase_if(mesh.cells, [&](const Cell<2>& cell) {
        return std::ranges::all_of(cell, [&](int v) {
            const Vec2 p = mesh.points.col(v);
            return p.x() >= 1 && p.x() <= 3 && p.y() >= 0.45 && p.y() <= 0.55;
        });
    });
    const SimplicialMesh<2> body = coarseMesh<2>(mesh, 400);
    double area = 0, expected = 0;
    for (const auto& cell : body.cells) area += cellMeasure<2>(body.points, cell);
    for (const auto& cell : mesh.cells) expected += cellMeasure<2>(mesh.points, cell);
    QVERIFY(expected < kLength - 0.1);
    QVERIFY(std::abs(area - expected) < 1e-9);
    for (const auto& cell : body.cells) {
        const Vec2 p = (body.points.col(cell[0]) + body.points.col(cell[1]) + body.points.col(cell[2])) / 3;
        QVERIFY(p.x() < 1 || p.x() > 3 || std::abs(p.y() - 0.5) > 0.04);
    }
}

/// Cubes wider than the gap between two jaws would join them; a bar has no jaws, nor has a shape with a
/// sufficiently wide gap.
void TestCoarseBody::jawsStayApart() {
    const auto tongs = [](double gap) {
        SimplicialMesh<3> mesh = gridBar<3>(10);
        std::erase_if(mesh.cells, [&](const Cell<3>& cell) {
            return std::ranges::all_of(cell, [&](int v) {
                const Vec3 p = mesh.points.col(v);
                return p.x() >= 1 && std::abs(p.y() - 0.5) <= gap / 2 + 1e-9;
            });
        });
        return mesh;
    };
    for (const int vertices : {300, 800, 1500})
        QVERIFY(coarseMesh<3>(gridBar<3>(10), vertices).vertexCount() > 200);
    QVERIFY_THROWS_EXCEPTION(InputError, coarseMesh<3>(tongs(0.2), 300));
    QVERIFY(coarseMesh<3>(tongs(0.6), 1500).vertexCount() > 200);
}

void TestCoarseBody::onlyLargeShapesNeedOne() {
    QVERIFY(!CoarseBody<2>::of(bar<2>()));
    QVERIFY(!CoarseBody<3>::of(bar<3>()));
    Shape<2> large = bar<2>();
    large.rest = std::make_shared<const SimplicialMesh<2>>(gridBar<2>(70));  // 20,000
    large.material =
        std::make_shared<const Material<2>>(Material<2>::uniform(large.rest->cellCount(), phi::kMetr, {}));
    const auto body = CoarseBody<2>::of(large);
    QVERIFY(body && body->rest()->vertexCount() < 6000);
    // Coincident triangles have no outline; such a shape is dragged without a body.
    auto doubled = std::make_shared<SimplicialMesh<2>>(*large.rest);
    const int count = doubled->vertexCount();
    doubled->points.conservativeResize(2, 2 * count);
    doubled->points.rightCols(count) = large.rest->points.colwise() + Vec2(0.3, 0.3);
    for (Cell<2> cell : large.rest->cells) {
        for (int& v : cell) v += count;
        doubled->cells.push_back(cell);
    }
    large.rest = doubled;
    large.material =
        std::make_shared<const Material<2>>(Material<2>::uniform(doubled->cellCount(), phi::kMetr, {}));
    QVERIFY(!CoarseBody<2>::of(large));
}

QTEST_GUILESS_MAIN(TestCoarseBody)
#include "test_coarse_body.moc"
