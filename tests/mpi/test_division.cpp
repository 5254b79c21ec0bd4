// Systems divided into the parts that processes hold: all parts together equal the whole.
#include <QTest>
#include <numeric>

#include "core/assembly/cpu_back_end.h"
#include "mpi/division.h"
#include "tests/core/test_energy_samples.h"

using namespace wend;
using namespace wend::test;

class TestDivision : public QObject {
    Q_OBJECT
  private slots:
    void productsArePartsOfTheWhole_data();
    void productsArePartsOfTheWhole();
    void copiesAreSentByTheirOwners();
    void partsWithoutUnknownsAreEmpty();
    void groupsAreJoinedByCells();
};

namespace {

/// A system with points in cells that depend on each other and vertices that slide.
template <int Dim>
struct Sample {
    SimplicialMesh<Dim> mesh;
    Material<Dim> material;
    std::shared_ptr<const AssemblyPlan<Dim>> plan;
    ReducedSystem<Dim> system;

    explicit Sample(bool smoothing) {
        std::mt19937 random(4);
        mesh = unitGrid<Dim>(Dim == 2 ? 14 : 6, 0.15, random);
        material = randomMaterial<Dim>(random, mesh.cellCount(), {});
        if (!smoothing) material.smoothing.kind = SmoothingKind::None;
        plan = std::make_shared<const AssemblyPlan<Dim>>(
            makeAssemblyPlan<Dim>(mesh, smoothing, Contributions::Left));
        std::vector<ConstraintRow> rows;
        Sliders sliders;
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            if (mesh.points(0, v) < 0.02) rows.push_back({{{v, 1.0}}});
            if (mesh.points(1, v) < 0.02) sliders.push_back({v, 2U});
            if (mesh.points(1, v) > 0.9 / std::sqrt(Dim)) sliders.push_back({v, 0, {0.6, 0.8, 0}});
        }
        const int cells = mesh.cellCount();
        for (int c : {cells / 2, cells / 2 + 1, cells / 2 + 2}) {
            ConstraintRow row;
            for (int k = 0; k <= Dim; ++k) row.terms.emplace_back(mesh.cells[c][k], 0.1 + 0.2 * k);
            rows.push_back(row);
        }
        system = ReducedSystem<Dim>(*plan, eliminate(simplified(rows), sliders), sliders);
    }

    std::unique_ptr<BackEnd<Dim>> backEnd(std::shared_ptr<const AssemblyPlan<Dim>> ofPlan,
                                          const SimplicialMesh<Dim>& ofMesh,
                                          const Material<Dim>& ofMaterial) const {
        auto result = makeCpuBackEnd<Dim>(std::move(ofPlan), ofMesh, ofMaterial, 1);
        result->setMassRegularization(std::vector<double>(ofMesh.cells.size(), 0.3));
        result->setShape(ofMesh.points);
        return result;
    }

    /// Slabs with a ragged border.
    std::vector<int> owners(int parts) const {
        std::vector<int> ownerOf(mesh.vertexCount(), -1);
        for (int v : system.unknowns())
            ownerOf[v] = std::min(parts - 1, static_cast<int>(1.6 * parts * mesh.points(0, v) + v % 3 / 3));
        return ownerOf;
    }
};

template <int Dim>
Points<Dim> product(BackEnd<Dim>& backEnd, const ReducedSystem<Dim>& system, const Points<Dim>& y,
                    int vertices) {
    Points<Dim> v = Points<Dim>::Zero(Dim, vertices), Av, result;
    system.expand(y, v);
    backEnd.apply(v, Av);
    system.restrict(Av, result);
    return result;
}

template <int Dim>
std::vector<int> unknownOf(const ReducedSystem<Dim>& system, int vertices) {
    std::vector<int> result(vertices, -1);
    for (std::size_t i = 0; i < system.unknowns().size(); ++i)
        result[system.unknowns()[i]] = static_cast<int>(i);
    return result;
}

template <int Dim>
void compareProducts(bool smoothing, int parts) {
    const Sample<Dim> sample(smoothing);
    const int vertices = sample.mesh.vertexCount();
    std::mt19937 random(5);
    Points<Dim> y = randomField<Dim>(random, static_cast<int>(sample.system.unknowns().size()));
    const auto backEnd = sample.backEnd(sample.plan, sample.mesh, sample.material);
    const Points<Dim> whole = product<Dim>(*backEnd, sample.system, y, vertices);
    const double size = whole.cwiseAbs().maxCoeff();
    const Points<Dim> field = randomField<Dim>(random, vertices);
    double square = 0;  // vᵀ A v
    const std::vector<int> indexOf = unknownOf(sample.system, vertices);
    std::vector<int> seen(y.cols(), 0);
    for (const Part<Dim>& part :
         allParts<Dim>(Division<Dim>(*sample.plan, sample.system, sample.owners(parts), parts))) {
        const SimplicialMesh<Dim> mesh{gathered<Dim>(sample.mesh.points, part.vertices), part.corners};
        Material<Dim> material{{}, {}, sample.material.smoothing};
        for (int c : part.cells) {
            material.phi.push_back(sample.material.phi[c]);
            material.anisotropy.push_back(sample.material.anisotropy[c]);
        }
        const auto plan = std::make_shared<const AssemblyPlan<Dim>>(
            makeAssemblyPlan<Dim>(mesh, smoothing, Contributions::Left));
        const ReducedSystem<Dim> system(*plan, part.elimination, part.sliders);
        QCOMPARE(static_cast<int>(system.unknowns().size()), part.own + part.copies);
        Points<Dim> local(Dim, part.own + part.copies);
        for (int i = 0; i < part.own + part.copies; ++i) {
            QCOMPARE(system.unknowns()[i], i);
            local.col(i) = y.col(indexOf[part.vertices[i]]);
        }
        const auto own = sample.backEnd(plan, mesh, material);
        const Points<Dim> result = product<Dim>(*own, system, local, mesh.vertexCount());
        for (int i = 0; i < part.own; ++i) {
            const int unknown = indexOf[part.vertices[i]];
            ++seen[unknown];
            // Sums are taken in another order.
            QVERIFY((result.col(i) - whole.col(unknown)).cwiseAbs().maxCoeff() < 1e-13 * size);
        }
        const Points<Dim> v = gathered<Dim>(field, part.vertices);
        Points<Dim> Av;
        own->apply(v, Av);
        square += v.leftCols(part.own).cwiseProduct(Av.leftCols(part.own)).sum();
        for (int vertex : part.followers) square += v.col(vertex).dot(Av.col(vertex));
    }
    Points<Dim> product;
    backEnd->apply(field, product);
    const double expected = field.cwiseProduct(product).sum();
    QVERIFY(std::abs(square - expected) < 1e-13 * expected);
    QVERIFY(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
}

}  // namespace

void TestDivision::productsArePartsOfTheWhole_data() {
    QTest::addColumn<bool>("smoothing");
    QTest::addColumn<int>("parts");
    for (int parts : {1, 2, 5}) {
        QTest::addRow("%d", parts) << true << parts;
        QTest::addRow("%d without smoothing", parts) << false << parts;
    }
}

/// The system has B and φ of its own in every cell, mass, sliders, and points in cells of two parts.
void TestDivision::productsArePartsOfTheWhole() {
    QFETCH(bool, smoothing);
    QFETCH(int, parts);
    compareProducts<2>(smoothing, parts);
    compareProducts<3>(smoothing, parts);
}

void TestDivision::copiesAreSentByTheirOwners() {
    const Sample<3> sample(true);
    const auto parts = allParts<3>(Division<3>(*sample.plan, sample.system, sample.owners(4), 4));
    int copies = 0;
    for (int number = 0; number < 4; ++number)
        for (const auto& neighbour : parts[number].neighbours) {
            const auto& list = parts[neighbour.part].neighbours;
            const auto back =
                std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.part == number; });
            QVERIFY(back != list.end());
            QCOMPARE(static_cast<int>(back->sent.size()), neighbour.copies);
            for (int k = 0; k < neighbour.copies; ++k, ++copies) {
                QVERIFY(back->sent[k] < parts[neighbour.part].own);
                QCOMPARE(parts[neighbour.part].vertices[back->sent[k]],
                         parts[number].vertices[neighbour.firstCopy + k]);
            }
        }
    QCOMPARE(copies, std::accumulate(parts.begin(), parts.end(), 0,
                                     [](int sum, const auto& part) { return sum + part.copies; }));
    QVERIFY(copies > 0);
}

void TestDivision::partsWithoutUnknownsAreEmpty() {
    const Sample<2> sample(true);
    const auto part = Division<2>(*sample.plan, sample.system, sample.owners(2), 3).part(2);
    QCOMPARE(part.own, 0);
    QVERIFY(part.cells.empty() && part.vertices.empty());
}

/// A row of four squares, each cut in two: a group for every column of vertices.
void TestDivision::groupsAreJoinedByCells() {
    SimplicialMesh<2> mesh;
    mesh.points.resize(2, 10);
    std::vector<int> groupOf;
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 2; ++j) {
            mesh.points.col(2 * i + j) = Vec2(i, j);
            groupOf.push_back(i < 4 ? i : -1);
        }
    for (int i = 0; i < 4; ++i) {
        mesh.cells.push_back({2 * i, 2 * i + 2, 2 * i + 3});
        mesh.cells.push_back({2 * i, 2 * i + 3, 2 * i + 1});
    }
    const auto graph = groupGraph<2>(makeAssemblyPlan<2>(mesh, true, Contributions::Left), groupOf, 4);
    QCOMPARE(graph.nodeWeight, (std::vector<int>{2, 2, 2, 2}));
    QCOMPARE(graph.start, (std::vector<int>{0, 1, 3, 5, 6}));
    QCOMPARE(graph.neighbour, (std::vector<int>{1, 0, 2, 1, 3, 2}));
    for (int group = 0; group < 4; ++group)  // as heavy there as back
        for (int i = graph.start[group]; i < graph.start[group + 1]; ++i) {
            const int other = graph.neighbour[i];
            for (int k = graph.start[other]; k < graph.start[other + 1]; ++k)
                if (graph.neighbour[k] == group) QCOMPARE(graph.edgeWeight[k], graph.edgeWeight[i]);
        }
}

QTEST_APPLESS_MAIN(TestDivision)
#include "test_division.moc"
