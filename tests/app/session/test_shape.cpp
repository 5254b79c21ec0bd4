// The deformer's input made from a project: meshes with the handles' points, materials per cell, textures.

#include <QtTest>

#include "app/engine/shape/flat_shape.h"
#include "app/engine/shape/held_border.h"
#include "app/engine/shape/material_raster.h"
#include "app/engine/shape/shape_builder.h"
#include "app/output/run.h"
#include "app/project/file/project_reader.h"
#include "core/base/error.h"
#include "core/integration/deformer.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/layers.h"

using namespace wend;

namespace {

SimplicialMesh<2> grid(int n) {
    return stripMesh(n, n);
}

std::shared_ptr<Project> parsed(const std::string& rest, const std::string& folder) {
    return parseProject(json("{'format': 'wend', 'version': 1, " + rest + "}"), folder + "/p.wend").project;
}

Vec2 centroid(const SimplicialMesh<2>& mesh, int cell) {
    Vec2 sum = Vec2::Zero();
    for (int v : mesh.cells[cell]) sum += mesh.points.col(v);
    return sum / 3;
}

}  // namespace

class TestShape : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        m_base = m_folder.path().toStdString();
        writeImage(m_base + "/disc.png", discPicture(200, 80));
        writeMesh<2>(m_base + "/grid.obj", grid(4));
    }

    void frame() {
        const auto project = parsed("'domain': {'image': 'disc.png', 'vertices': 500}", m_base);
        const auto shape = std::get<Shape<2>>(loadShape(*project, m_base));
        QVERIFY(std::abs(shape.rest->vertexCount() - 500) <= 50);
        QCOMPARE(shape.picture->width, 200);
        double area = 0;
        for (const auto& cell : shape.rest->cells) area += cellMeasure<2>(shape.rest->points, cell);
        QVERIFY(std::abs(area - 200 * 200) < 1e-6);
    }

    /// Points of handles that act from the start are the first vertices, each place once; later ones are not.
    void handlePointsAreVertices() {
        const auto project = parsed(
            "'domain': {'image': 'disc.png', 'outline': {'from': 'alpha'}, 'vertices': 400}, 'handles': ["
            "{'at': {'points': [[100.25, 90.5], [60, 100]]}}, {'at': {'points': [[60, 100], [120, 130]]}},"
            "{'at': {'points': [[111, 111]]}, 'active': [0.5, 1]}, {'at': {'points': [[1, 1]]}}]",
            m_base);
        const auto shape = std::get<Shape<2>>(loadShape(*project, m_base));
        QCOMPARE(shape.rest->points.col(0), Vec2(100.25, 90.5));
        QCOMPARE(shape.rest->points.col(1), Vec2(60, 100));
        QCOMPARE(shape.rest->points.col(2), Vec2(120, 130));
        for (int i = 0; i < shape.rest->vertexCount(); ++i)
            QVERIFY((shape.rest->points.col(i) - Vec2(111, 111)).norm() > 1e-6);
        QCOMPARE(heldHandles(*project, shape).size(), std::size_t(4));
    }

    void edgeLength() {
        const auto project = parsed("'domain': {'image': 'disc.png', 'edge': 20}", m_base);
        const auto shape = std::get<Shape<2>>(loadShape(*project, m_base));
        double sum = 0;
        for (const auto& cell : shape.rest->cells)
            for (int k = 0; k < 3; ++k)
                sum += (shape.rest->points.col(cell[k]) - shape.rest->points.col(cell[(k + 1) % 3])).norm();
        const double mean = sum / (3 * shape.rest->cellCount());
        QVERIFY2(std::abs(mean - 20) < 4, qPrintable(QString::number(mean)));
    }

    void meshDomainKeepsOrder() {
        const auto project = parsed("'domain': {'mesh': 'grid.obj'}", m_base);
        const auto shape = std::get<Shape<2>>(loadShape(*project, m_base));
        QCOMPARE(shape.rest->points, grid(4).points);
        QVERIFY(shape.rest->cells == grid(4).cells);
        QVERIFY(!shape.picture);
    }

    /// φ changes linearly with the membership, starting from the result of the regions before.
    void regionsBlendPhi() {
        MaterialSpec spec;
        spec.phi = 1;
        spec.layers.push_back(test::layerWith("", {{Blend<3>{{0, 0, 0}, {4, 0, 0}}, 0}, 2.0, {}}));
        spec.layers.push_back(test::layerWith("", {{Box<3>{{-1, 3, 0}, {9, 9, 0}}, 0}, 0.5, {}}));
        const SimplicialMesh<2> mesh = grid(4);
        const auto material = rasterizeMaterial<2>(spec, mesh);
        for (int c = 0; c < mesh.cellCount(); ++c) {
            const Vec2 p = centroid(mesh, c);
            const double expected = p.y() > 3 ? 0.5 : 1 + p.x() / 4;
            QVERIFY(std::abs(material->phi[c] - expected) < 1e-14);
        }
        QVERIFY(material->anisotropy.empty());
    }

    /// A half-space is the side that its normal points to.
    void featherIsSmooth() {
        MaterialSpec spec;
        spec.phi = 1;
        spec.layers.push_back(test::layerWith("", {{HalfSpace<3>{{20, 0, 0}, {1, 0, 0}}, 10}, 2.0, {}}));
        const SimplicialMesh<2> mesh = grid(40);
        const auto material = rasterizeMaterial<2>(spec, mesh);
        int between = 0;
        for (int c = 0; c < mesh.cellCount(); ++c) {
            const double x = centroid(mesh, c).x();
            if (x < 15) QCOMPARE(material->phi[c], 1.0);
            if (x > 25) QCOMPARE(material->phi[c], 2.0);
            between += material->phi[c] > 1.01 && material->phi[c] < 1.99;
        }
        QVERIFY(between > 100);
    }

    /// B = (1 − m) B_prev + m (I + (s − 1) a aᵀ): in the middle of a blend the mean of both.
    void stiffnessBlends() {
        MaterialSpec spec;
        spec.layers.push_back(
            test::layerWith("", {{Blend<3>{{0, 0, 0}, {4, 0, 0}}, 0}, {}, Stiffness{{0, 3, 0}, 9}}));
        const SimplicialMesh<2> mesh = grid(4);
        const auto material = rasterizeMaterial<2>(spec, mesh);
        for (int c = 0; c < mesh.cellCount(); ++c) {
            const Mat2 expected = Vec2(1, 1 + 8 * centroid(mesh, c).x() / 4).asDiagonal();
            QVERIFY((material->anisotropy[c] - expected).norm() < 1e-14);
        }
        requireValid(*material, mesh.cellCount());
    }

    void cellValues() {
        MaterialSpec spec;
        const SimplicialMesh<2> mesh = grid(1);
        spec.cellPhi = {0.5, 0.7};
        spec.layers.push_back(
            test::layerWith("", {{Box<3>{{-1, -1, 0}, {3, 3, 0}}, 0}, {}, Stiffness{{1, 0, 0}, 2}}));
        QCOMPARE(rasterizeMaterial<2>(spec, mesh)->phi[1], 0.7);
        spec.cellPhi.push_back(1);
        QVERIFY_THROWS_EXCEPTION(InputError, rasterizeMaterial<2>(spec, mesh));
        spec.cellPhi.clear();
        spec.cellB = {Mat3::Identity()};
        QVERIFY_THROWS_EXCEPTION(InputError, rasterizeMaterial<2>(spec, mesh));
    }

    /// uv gives the mesh's place in the picture, and a pose follows it by the best affine map.
    void textureCoordinates() {
        auto picture = std::make_shared<Image>(discPicture(200, 50));
        auto rest = std::make_shared<SimplicialMesh<2>>(grid(4));
        Eigen::Matrix2Xd uv = rest->points / 4;  // y up, as v
        const Texture texture = textureOf(*picture, rest, uv);
        for (int i = 0; i < rest->vertexCount(); ++i) {
            const Vec2 expected(50 * rest->points(0, i), 200 - 50 * rest->points(1, i));
            QVERIFY((texture.rest->points.col(i) - expected).norm() < 1e-11);
        }
        QVERIFY((texture.toPixels(rest->points) - texture.rest->points).norm() < 1e-9);
        SimplicialMesh<2> spare = *rest;  // a vertex that no cell has, with a texture point of no meaning
        spare.points.conservativeResize(2, rest->vertexCount() + 1);
        spare.points.col(rest->vertexCount()) << 1000, -500;
        Eigen::Matrix2Xd more = uv;
        more.conservativeResize(2, uv.cols() + 1);
        more.col(uv.cols()) << 0.5, 0.5;
        const Texture same = textureOf(*picture, std::make_shared<const SimplicialMesh<2>>(spare), more);
        QVERIFY((same.toPixels(rest->points) - texture.rest->points).norm() < 1e-9);
        const Texture plain = textureOf(*picture, rest, {});
        QVERIFY(plain.toPixels(rest->points) ==
                rest->points);  // to the last bit: an identity warp must be one
    }

    void canvas() {
        const std::array<int, 2> picture{200, 200};
        Points2 pose(2, 3);
        pose << -10.5, 220.25, 5, 3, 4, 90;
        const auto extent = extentOf<2>(pose, {{0, 1, 2}});
        QCOMPARE(canvasView(picture, extent, Canvas::Picture).width, 200);
        const View fit = canvasView(picture, extent, Canvas::Fit);
        QCOMPARE(fit.origin, Vec2(-11, 3));
        QCOMPARE(fit.width, 232);
        QCOMPARE(fit.height, 87);
        CanvasChoice part(Canvas::Part);
        part.part = {-5, 7, 30, 20};
        const View kept = canvasView(picture, extent, part);
        QVERIFY(kept.origin == Vec2(-5, 7) && kept.width == 30 && kept.height == 20 && kept.scale == 1);
        part.part = {0, 0, 400'000, 400'000};
        QVERIFY_THROWS_EXCEPTION(InputError, canvasView(picture, extent, part));
        for (const double far : {2.1e4, 2e6, 1e200}) {  // more than 400 million pixels
            pose(0, 1) = pose(1, 2) = far;
            QVERIFY_THROWS_EXCEPTION(InputError,
                                     canvasView(picture, extentOf<2>(pose, {{0, 1, 2}}), Canvas::Fit));
        }
    }

    /// The frames of a sequence are written to disk while the shape still moves, and not kept in memory.
    void framesDoNotWait_data() {
        QTest::addColumn<int>("canvas");
        QTest::newRow("picture") << int(Canvas::Picture);
        QTest::newRow("fit") << int(Canvas::Fit);
    }
    void framesDoNotWait() {
        QFETCH(int, canvas);
        const QTemporaryDir folder;
        const std::string base = folder.path().toStdString();
        writeImage(base + "/disc.png", discPicture(60, 25));
        const auto project = parsed(
            "'domain': {'image': 'disc.png', 'vertices': 100}, 'handles': [{'at': {'points': [[30, 30]]}, "
            "'motion': [{'kind': 'translate', 'by': [9, 5], 'time': [0, 1]}]}]",
            base);
        RunOptions options;
        options.canvas = static_cast<Canvas>(canvas);
        options.outputs.frames = {base + "/f_#.png"};
        options.outputs.count = 9;
        RunWatch watch;
        qsizetype atOnce = 0;
        // Unfinished files are in a hidden folder.
        watch.progress = [&](const std::string& work, double) {
            QDirIterator all(folder.path(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
            qsizetype hidden = 0;
            while (all.hasNext()) hidden += all.next().contains(QStringLiteral("/."));
            if (work == "deforming") atOnce = std::max(atOnce, hidden);
        };
        QCOMPARE(runProject(*project, base + "/p.wend", options, watch).outcome, Outcome::Done);
        QVERIFY(atOnce > (options.canvas.kind == Canvas::Fit ? 0 : 5));
        QCOMPARE(QDir(folder.path()).entryList({"f_?.png"}).size(), 9);
        QVERIFY(QDir(folder.path())
                    .entryList({".*"}, QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot)
                    .isEmpty());
    }

    void missingFiles_data() {
        QTest::addColumn<QString>("domain");
        QTest::addColumn<QString>("file");
        QTest::newRow("picture") << "{'image': 'no.png'}"
                                 << "/no.png: ";
        QTest::newRow("mesh") << "{'mesh': 'no.obj'}"
                              << "/no.obj: ";
        QTest::newRow("texture") << "{'mesh': 'grid.obj', 'image': 'no.png'}"
                                 << "/no.png: ";
        QTest::newRow("surface") << "{'surface': 'no.stl'}"
                                 << "/no.stl: ";
        QTest::newRow("open surface") << "{'surface': 'grid.obj'}"
                                      << "/grid.obj: ";
    }
    void missingFiles() {
        QFETCH(QString, domain);
        QFETCH(QString, file);
        const auto project = parsed("'domain': " + domain.toStdString(), m_base);
        try {
            loadShape(*project, m_base);
            QFAIL("nothing was thrown");
        } catch (const InputError& error) {
            QVERIFY2(QString(error.what()).contains(file), error.what());
        }
    }

    void stops() {
        std::stop_source source;
        source.request_stop();
        const auto project = parsed("'domain': {'image': 'disc.png', 'vertices': 20000}", m_base);
        QVERIFY_THROWS_EXCEPTION(Cancelled, loadShape(*project, m_base, source.get_token()));
    }

  private:
    QTemporaryDir m_folder;
    std::string m_base;
};

QTEST_APPLESS_MAIN(TestShape)
#include "test_shape.moc"
