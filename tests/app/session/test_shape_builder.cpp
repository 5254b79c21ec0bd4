// The window's shape, updated step by step, equals the command line's, made from scratch, after a change of
// each setting in turn.

#include <QtTest>

#include "app/engine/shape/flat_shape.h"
#include "app/engine/shape/shape_builder.h"
#include "app/project/domain.h"
#include "app/project/file/project_reader.h"
#include "app/project/options/settings.h"
#include "core/base/error.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/mesh_files.h"
#include "tests/support/surfaces.h"

using namespace wend;

namespace {

/// Returns other valid values of the setting for this project.
std::vector<double> othersOf(const Option& setting, const Project& project) {
    const double now = settingOf(project, setting.key);
    std::vector<double> tried{0, 1, 2, now + 1, 1.7 * now, 0.6 * now};
    if (setting.kind == OptionKind::Choice) {
        tried.clear();
        for (std::size_t k = 0; k < choicesOf(setting).size(); ++k) tried.push_back(static_cast<double>(k));
    } else if (setting.kind == OptionKind::Flag)
        tried = {0, 1};
    const Range range = rangeOf(setting, dimensionOf(project));
    std::erase_if(tried, [&](double value) {
        if (setting.kind == OptionKind::Integer && value != std::floor(value)) return true;
        return value == now || !(range.contains(value));
    });
    return tried;
}

template <int Dim>
bool sameShape(const Shape<Dim>& window, const Shape<Dim>& line) {
    return window.rest->points == line.rest->points && window.rest->cells == line.rest->cells;
}

template <int Dim>
bool sameMaterial(const Material<Dim>& a, const Material<Dim>& b) {
    return a.phi == b.phi && a.anisotropy == b.anisotropy && a.memory == b.memory &&
           a.smoothing.kind == b.smoothing.kind && a.smoothing.length == b.smoothing.length &&
           a.smoothing.lambda == b.smoothing.lambda;
}

}  // namespace

class TestShapeBuilder : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void everySettingIsFollowed_data();
    void everySettingIsFollowed();

  private:
    template <int Dim>
    void follow(const Project& project, const Option& setting);

    QTemporaryDir m_folder;
    std::string m_base = m_folder.path().toStdString();
};

void TestShapeBuilder::initTestCase() {
    QVERIFY(m_folder.isValid());
    writeImage(m_base + "/disc.png", discPicture(120, 40));
    writeMesh<2>(m_base + "/grid.obj", stripMesh(4, 4));
    test::writeSurface(m_base + "/bar.obj", test::box({0, 0, 0}, {3, 1, 1}, 3));
}

void TestShapeBuilder::everySettingIsFollowed_data() {
    QTest::addColumn<QString>("domain");
    QTest::newRow("frame of a picture") << "'image': 'disc.png', 'vertices': 150";
    QTest::newRow("cut-out")
        << "'image': 'disc.png', 'outline': {'from': 'alpha', 'margin': 3}, 'vertices': 150";
    QTest::newRow("flat mesh") << "'mesh': 'grid.obj'";
    QTest::newRow("surface") << "'surface': 'bar.obj', 'vertices': 150";
    QTest::newRow("cage") << "'surface': 'bar.obj', 'vertices': 150, 'cage': true";
}

/// One builder changes the setting and restores it: any data that it keeps must be right for the next
/// project.
template <int Dim>
void TestShapeBuilder::follow(const Project& project, const Option& setting) {
    ShapeBuilder<Dim> builder;
    const auto build = [&](const Project& of) {
        ShapeInputs inputs;
        inputs.project = copyOf(of);
        inputs.folder = m_base;
        if (domainOf(of).kind == DomainKind::Image) inputs.picture = loadPicture(domainOf(of), m_base);
        return builder.build(inputs, {});
    };
    const Shape<Dim> first = build(project);
    for (const double value : othersOf(setting, project)) {
        const auto changed = copyOf(project);
        setting.field.at.set(*changed, value);
        const QByteArray place =
            QByteArray(setting.key.data(), setting.key.size()) + " = " + QByteArray::number(value);
        Shape<Dim> line;
        try {
            line = std::get<Shape<Dim>>(loadShape(*changed, m_base));
        } catch (const InputError& error) {
            continue;  // no shape on either path
        }
        const Shape<Dim> window = build(*changed);
        QVERIFY2(sameShape(window, line), place + ": another mesh");
        QVERIFY2(sameMaterial(*window.material, *line.material), place + ": another material");
        if (setting.field.makes == Makes::Material || setting.field.makes == Makes::Motion)
            QVERIFY2(window.rest == first.rest, place + ": the mesh was made anew for nothing");
        const Shape<Dim> again = build(project);
        QVERIFY2(again.rest == first.rest, place + ": what was there before was made anew");
        QVERIFY2(sameMaterial(*again.material, *first.material), place + ": the material stays behind");
    }
}

void TestShapeBuilder::everySettingIsFollowed() {
    QFETCH(QString, domain);
    const auto project = parseProject(json("{'format': 'wend', 'version': 1, 'domain': {" +
                                           domain.toStdString() + "}, 'material': {'phi': 'metr'}}"),
                                      m_base + "/p.wend")
                             .project;
    int count = 0;
    for (const Option& setting : options()) {
        if (!setting.field.at.set || !isFor(setting, *project)) continue;
        ++count;
        dimensionOf(*project) == 2 ? follow<2>(*project, setting) : follow<3>(*project, setting);
        if (QTest::currentTestFailed()) return;
    }
    QVERIFY(count > 5);
}

QTEST_GUILESS_MAIN(TestShapeBuilder)
#include "test_shape_builder.moc"
