// Project files: valid ones are read, invalid ones are refused with their messages, and writing loses
// nothing.

#include <QtTest>
#include <filesystem>
#include <numbers>

#include "app/project/file/named_files.h"
#include "app/project/file/nearest_word.h"
#include "app/project/file/project_reader.h"
#include "app/project/file/project_writer.h"
#include "app/project/file/text_file.h"
#include "app/project/options/options.h"
#include "app/project/options/settings.h"
#include "app/project/project.h"
#include "core/base/error.h"
#include "tests/support/layers.h"
#include "tests/support/quoted.h"

using namespace wend;
namespace fs = std::filesystem;

namespace {

const std::string kImage = "'domain': {'image': 'frog.png'}";

std::string projectText(const std::string& rest) {
    return json("{'format': 'wend', 'version': 1, " + rest + "}");
}

std::string withHandle(const std::string& handle) {
    return projectText(kImage + ", 'handles': [" + handle + "]");
}

std::string withMotion(const std::string& motion) {
    return withHandle("{'at': {'points': [[1, 2]]}, 'motion': [" + motion + "]}");
}

std::string withMaterial(const std::string& material) {
    return projectText(kImage + ", 'material': {" + material + "}");
}

/// Everything that a project in the plane may say.
const std::string kFull = projectText(
    "'domain': {'image': 'frog.png', 'outline': {'from': 'alpha', 'threshold': 0.25, 'margin': 3, "
    "'smallest': 10}, 'edge': 2.5}, "
    "'material': { "
    "'phi': 'akvf', 'smoothing': {'kind': 'paper', 'lambda': 0.3}, 'memory': 2.5, "
    "'regions': [ "
    "{'name': 'leg', 'shape': {'polygon': [[10, 20], [90, 20], [90, 80]]}, 'feather': 12, 'phi': 2.2}, "
    "{'name': 'bone', 'shape': {'circle': {'centre': [50, 50], 'radius': 20}}, 'stiffness': {'axis': [1, 0], "
    "'ratio': 20}}, "
    "{'shape': {'box': {'min': [0, 1], 'max': [2, 3]}}, 'phi': 'conf'}, "
    "{'shape': {'halfspace': {'point': [0, 1], 'normal': [0, 1]}}, 'phi': 'equia'}, "
    "{'shape': {'blend': {'from': [0, 1], 'to': [0, 2]}}, 'phi': 0.1}], "
    "'cells': {'phi': [0.1, 0.2], 'B': [[1, 0, 0, 1], [2, 0.5, 0.5, 2]]} "
    "}, "
    "'handles': [ "
    "{'name': 'foot', 'at': {'points': [[12, 90], [30, 92]]}}, "
    "{'at': {'vertices': [3, 4]}, 'active': [0.1, null]}, "
    "{'name': 'hand', 'at': {'region': {'circle': {'centre': [5, 5], 'radius': 2}}}, 'active': [0, 2], "
    "'motion': [ "
    "{'kind': 'translate', 'by': [1, 0.1], 'time': [0, 0.5], 'ease': 'inOut'}, "
    "{'kind': 'rotate', 'centre': [0, 0], 'angle': -1.5707963267948966, 'time': [0.5, 1]}, "
    "{'kind': 'curve', 'interpolation': 'bezier', 'points': [[80, 10], [95, 10], [110, 30], [110, 50]], "
    "'frame': 'minimal', 'scale': 1.5, 'time': [1, 1.5]}, "
    "{'kind': 'recorded', 'times': [0, 0.1, 0.4], 'points': [[0, 0], [1, 1], [2, 1.000000000000001]], "
    "'time': [1.5, 2]}]}], "
    "'settle': [{'time': [0.25, 0.5]}, {'time': [1.9, 2.7]}], "
    "'time': {'end': 2}, "
    "'integration': {'method': 'rk4', 'tolerance': 1e-5, 'steps': 12}");

const Design& planar(const Project& project) {
    return project.design;
}

QString reasonFor(const std::string& text) {
    try {
        parseProject(text, "p.wend");
    } catch (const InputError& error) {
        return QString::fromUtf8(error.what());
    }
    return {};
}

struct Misspelt {
    QJsonValue json;
    std::string wrong, right;
};

/// Returns copies of the project with one misspelt key each, for every key of three letters or more.
std::vector<Misspelt> misspellings(const QJsonValue& value) {
    std::vector<Misspelt> all;
    if (value.isArray()) {
        const QJsonArray list = value.toArray();
        for (qsizetype i = 0; i < list.size(); ++i)
            for (const Misspelt& inside : misspellings(list[i])) {
                QJsonArray changed = list;
                changed[i] = inside.json;
                all.push_back({changed, inside.wrong, inside.right});
            }
    }
    const QJsonObject object = value.toObject();
    for (const QString& key : object.keys()) {
        for (const Misspelt& inside : misspellings(object[key])) {
            QJsonObject changed = object;
            changed[key] = inside.json;
            all.push_back({changed, inside.wrong, inside.right});
        }
        // A motion without its time overlaps the others, which is the message then.
        if (key.size() < 3 || (key == "time" && object.contains("kind"))) continue;
        const QString wrong = key.chopped(2) + key.back() + key[key.size() - 2];
        QJsonObject changed = object;
        changed[wrong] = changed.take(key);
        if (wrong != key) all.push_back({changed, wrong.toStdString(), key.toStdString()});
    }
    return all;
}

/// The keys of `expected` whose values `found` does not have.
QStringList missingFrom(const QJsonValue& found, const QJsonValue& expected, const QString& key) {
    QStringList lost;
    if (expected.isObject()) {
        const QJsonObject keys = expected.toObject();
        for (auto it = keys.begin(); it != keys.end(); ++it)
            lost += missingFrom(found[it.key()], it.value(), key + '.' + it.key());
    } else if (expected.isArray() && found.toArray().size() == expected.toArray().size()) {
        for (int k = 0; k < expected.toArray().size(); ++k)
            lost += missingFrom(found[k], expected[k], key + '[' + QString::number(k) + ']');
    } else if (found != expected) {
        lost << key;
    }
    return lost;
}

}  // namespace

/// A project that has the setting.
static Project projectWith(const Option& setting) {
    Project project;
    project.domain.path = "p.png";
    for (const DomainKind kind : {DomainKind::Image, DomainKind::Surface})
        for (const OutlineKind outline : {OutlineKind::Frame, OutlineKind::Alpha})
            for (const SmoothingKind smoothing : {SmoothingKind::Invariant, SmoothingKind::Paper}) {
                if (isFor(setting, project)) continue;
                project.domain.kind = kind;
                project.domain.outline = outline;
                project.design.dimension = kind == DomainKind::Surface ? 3 : 2;
                project.design.material.smoothing.kind = smoothing;
            }
    if (project.domain.kind == DomainKind::Surface) {  // what these belong to
        project.domain.repair = setting.key.starts_with("domain.repair.");
        if (setting.key.starts_with("domain.cage.")) project.domain.fit = Fit::Cage;
    }
    return project;
}

/// Returns a value of the setting's range that is not its default.
static double anotherValue(const Option& setting, const Project& project) {
    const double now = setting.field.at.get(project);
    if (setting.kind == OptionKind::Flag || setting.kind == OptionKind::Choice) return now == 0 ? 1 : 0;
    if (setting.kind == OptionKind::Phi) return 1.25;
    const double next = setting.range.contains(now + 1) ? now + 1 : 0.75 * now;
    return setting.range.contains(next) ? next : 0.5 * (setting.range.min + setting.range.max);
}

class TestProject : public QObject {
    Q_OBJECT

  private slots:
    void defaults() {
        const LoadedProject loaded = parseProject(projectText(kImage), "p.wend");
        QVERIFY(loaded.warnings.empty());
        const Project& project = *loaded.project;
        QCOMPARE(project.dimension(), 2);
        QCOMPARE(project.domain.path, std::string("frog.png"));
        QCOMPARE(project.domain.outline, OutlineKind::Frame);
        QCOMPARE(project.domain.vertices, 5000);
        QCOMPARE(planar(project).material.phi, phi::kMetr);
        QCOMPARE(planar(project).material.smoothing.length, 1.0 / 75);
        QCOMPARE(planar(project).material.memory, 0.0);
        QVERIFY(project.settle.empty());
        QCOMPARE(project.end, 1.0);
        QCOMPARE(project.integration.tolerance, 1e-4);
    }

    /// Each setting of the table is written and read back unchanged, no other setting changes, and a setting
    /// that invalidates something is noticed.
    void everySettingIsKeptAndCompared() {
        int seen = 0;
        for (const Option& one : options()) {
            if (!one.field.at.get) continue;
            const QByteArray key(one.key.data(), static_cast<qsizetype>(one.key.size()));
            const Project before = projectWith(one);
            QVERIFY2(isFor(one, before), key);
            Project after = before;
            one.field.at.set(after, anotherValue(one, before));
            QVERIFY2(one.field.at.get(after) != one.field.at.get(before), key);
            const LoadedProject read = parseProject(toJson(after), "p.wend");
            QVERIFY2(read.warnings.empty(), key);
            for (const Option& other : options())
                if (other.field.at.get)
                    QVERIFY2(other.field.at.get(*read.project) == other.field.at.get(after), key);
            QCOMPARE(toJson(*read.project), toJson(after));
            if (one.field.makes != Makes::Nothing)
                QVERIFY2(!sameSettings(before, after, one.field.makes), key);
            QVERIFY2(sameSettings(after, *read.project, one.field.makes), key);
            ++seen;
        }
        QVERIFY(seen >= 25);
    }

    void defaultsAreInRange() {
        for (const Option& one : options())
            if (defaultText(one).empty())
                continue;
            else if (one.kind == OptionKind::Number || one.kind == OptionKind::Integer)
                QVERIFY2(one.range.contains(defaultOf(one)), one.meaning.data());
            else if (one.kind == OptionKind::Choice)
                QVERIFY2(isChoice(one, defaultText(one)), one.meaning.data());
    }

    void everythingIsRead() {
        const LoadedProject loaded = parseProject(kFull, "p.wend");
        QCOMPARE(loaded.warnings.size(), std::size_t(0));
        const Project& project = *loaded.project;
        QCOMPARE(project.domain.outline, OutlineKind::Alpha);
        QCOMPARE(project.domain.alpha.smallest, 10.0);
        QCOMPARE(project.domain.edge, 2.5);
        const auto& material = planar(project).material;
        QCOMPARE(material.phi, std::numbers::pi / 2);
        QCOMPARE(material.smoothing.kind, SmoothingKind::Paper);
        QCOMPARE(material.memory, 2.5);
        Project elastic = project;
        elastic.design.material.memory = std::numeric_limits<double>::infinity();
        const std::string text = toJson(elastic);
        QVERIFY(text.find("\"memory\": \"elastic\"") != std::string::npos);
        QVERIFY(std::isinf(planar(*parseProject(text, "p.wend").project).material.memory));
        const std::vector<MaterialRegion> regions = test::regionsIn(planar(project));
        QCOMPARE(regions.size(), std::size_t(5));
        QCOMPARE(regions[0].feather, 12.0);
        QCOMPARE(regions[1].stiffness->ratio, 20.0);
        QCOMPARE(*regions[2].phi, std::numbers::pi - std::atan(0.5));
        QCOMPARE(material.cellB[1](0, 1), 0.5);
        const auto& handles = planar(project).handles;
        QCOMPARE(std::get<std::vector<int>>(handles[1].at), (std::vector<int>{3, 4}));
        QCOMPARE(handles[1].activeFrom, 0.1);
        QVERIFY(std::isinf(handles[1].activeTo));
        QCOMPARE(handles[2].motions.size(), std::size_t(4));
        QCOMPARE(handles[2].motions[0].ease, Ease::InOut);
        QCOMPARE(std::get<CurveMotion<3>>(handles[2].motions[2].kind).scale, 1.5);
        QCOMPARE(std::get<Recorded<3>>(handles[2].motions[3].kind).points[2].y(), 1.000000000000001);
        QCOMPARE(project.integration.method, Method::RungeKutta4);
        QVERIFY((project.settle == std::vector<SettleWindow>{{0.25, 0.5}, {1.9, 2.7}}));
        QVERIFY(integrationOf(project).settle == project.settle);
        QCOMPARE(integrationOf(project).end, 2.7);  // covers them
    }

    void writingKeepsEverything() {
        const std::string once = toJson(*parseProject(kFull, "p.wend").project);
        const std::string twice = toJson(*parseProject(once, "p.wend").project);
        QCOMPARE(twice, once);
        for (const char* piece :
             {"\"conf\"", "1.000000000000001", "-1.5707963267948966", "[0.1, null]", "\"inOut\"", "\"rk4\""})
            QVERIFY2(once.find(piece) != std::string::npos, piece);
    }

    /// The written file has every key of the input, with the same numbers and words.
    void writingKeepsEveryKey_data() {
        QTest::addColumn<QString>("text");
        // the stored end includes the time of settling
        QTest::newRow("plane") << QString::fromStdString(kFull).replace(QStringLiteral("\"end\": 2}"),
                                                                        QStringLiteral("\"end\": 2.7}"));
        QTest::newRow("mesh") << QString::fromStdString(projectText(
            "'domain': {'mesh': 'strip.obj', 'image': 'frog.png'}, 'material': {'phi': 1.5, 'cells': "
            "'cells.json'}, 'time': {'end': 3}"));
        QTest::newRow("space") << QString::fromStdString(projectText(
            "'domain': {'surface': 'bar.stl', 'quality': 1.5, 'maxVolume': 0.1, 'detail': 'fine.obj'}, "
            "'material': {'phi': 'conf', 'regions': [{'name': 'r', 'shape': {'sphere': {'centre': [0, 0, 0], "
            "'radius': 1}}, 'phi': 1, 'feather': 0.5, 'stiffness': {'axis': [0, 0, 1], 'ratio': 3}}]}, "
            "'handles': [{'name': 'tip', 'at': {'points': [[0, 0, 1]]}, 'motion': [ "
            "{'kind': 'rotate', 'centre': [0, 0, 0], 'axis': [0, 0, 1], 'angle': 3, 'time': [0, 0.25], "
            "'ease': "
            "'in'}, {'kind': 'curve', 'interpolation': 'spline', 'points': [[0, 0, 1], [1, 0, 1], [2, 1, "
            "1]], "
            "'frame': 'frenet', 'twist': 1.25, 'scale': 0.75, 'time': [0.25, 1], 'ease': 'out'}]}]"));
    }
    void writingKeepsEveryKey() {
        QFETCH(QString, text);
        const std::string input = text.toStdString();
        const auto read = [](const std::string& json) {
            return QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
        };
        const QStringList lost =
            missingFrom(read(toJson(*parseProject(input, "p.wend").project)), read(input), "");
        QVERIFY2(lost.isEmpty(), qPrintable(lost.join(", ")));
    }

    void spatialProject() {
        const std::string text = projectText(
            "'domain': {'surface': 'bar.stl', 'quality': 1.5, 'maxVolume': 0.1}, "
            "'material': {'phi': 'conf', 'regions': [{'shape': {'sphere': {'centre': [0, 0, 0], 'radius': "
            "1}}, 'phi': 1}]}, "
            "'handles': [{'at': {'points': [[0, 0, 1]]}, 'motion': [ "
            "{'kind': 'rotate', 'centre': [0, 0, 0], 'axis': [0, 0, 1], 'angle': 3}]}]");
        const Project project = *parseProject(text, "p.wend").project;
        QCOMPARE(project.dimension(), 3);
        const auto& design = project.design;
        QCOMPARE(design.material.phi, std::numbers::pi - std::atan(0.75));
        QCOMPARE(std::get<Rotate<3>>(design.handles[0].motions[0].kind).axis.z(), 1.0);
        const std::string once = toJson(project);
        QCOMPARE(toJson(*parseProject(once, "p.wend").project), once);
    }

    /// All that a surface's domain may say.
    void surfaceDomain() {
        const std::string text = projectText(
            "'domain': {'surface': 'bar.obj', 'vertices': 900, 'refineSurface': true, 'repair': "
            "{'largestHole': 12}, 'sizes': [{'values': 'paint.txt'}, {'shape': {'sphere': {'centre': [0, 0, "
            "0], "
            "'radius': 1}}, 'name': 'tip', 'feather': 0.5, 'factor': 0.25, 'hue': 3}], 'detail': "
            "'fine.obj'}");
        const LoadedProject loaded = parseProject(text, "p.wend");
        const Domain& domain = loaded.project->domain;
        QVERIFY(domain.refineSurface && domain.repair);
        QCOMPARE(domain.largestHole, 12);
        QCOMPARE(domain.sizesFile, std::string("paint.txt"));
        QCOMPARE(domain.sizes.at(0).value, 0.25);
        QCOMPARE(domain.sizes.at(0).name, std::string("tip"));
        QCOMPARE(domain.detail, std::string("fine.obj"));
        QCOMPARE(loaded.warnings.size(), std::size_t(1));
        const std::string once = toJson(*loaded.project);
        const Project again = *parseProject(once, "p.wend").project;
        QCOMPARE(toJson(again), once);
        QVERIFY(again.domain.sizes == domain.sizes);
        QVERIFY(once.find("\"hue\": 3") != std::string::npos);
        const std::string plain =
            projectText("'domain': {'surface': 'bar.obj', 'vertices': 900, 'repair': true, 'quality': 1.5}");
        QVERIFY(toJson(*parseProject(plain, "p.wend").project).find("\"repair\": true") != std::string::npos);
    }

    /// Sizes of a picture may be those of one part.
    void sizesOfAPart() {
        const std::string text = projectText(
            "'domain': {'image': 'a.png', 'vertices': 900, 'sizes': [{'shape': {'circle': {'centre': [5, 6], "
            "'radius': 2}}, 'factor': 0.5, 'part': 'arm'}, {'shape': {'circle': {'centre': [5, 6], 'radius': "
            "2}}, 'factor': 2}]}");
        const LoadedProject loaded = parseProject(text, "p.wend");
        QVERIFY(loaded.warnings.empty());
        const auto& sizes = loaded.project->domain.sizes;
        QCOMPARE(sizes.at(0).regions.at(0).part, std::string("arm"));
        QVERIFY(sizes.at(1).regions.at(0).part.empty());
        const std::string once = toJson(*loaded.project);
        QVERIFY(parseProject(once, "p.wend").project->domain.sizes == sizes);
        QVERIFY(once.find("\"part\": \"arm\"") != std::string::npos);
    }

    void cageOfASurface() {
        const auto domain = [](const std::string& cage) {
            return *parseProject(projectText("'domain': {'surface': 'bar.obj', " + cage + "'vertices': 9}"),
                                 "p.wend")
                        .project;
        };
        QCOMPARE(domain("").domain.fit, Fit::Automatic);
        QCOMPARE(domain("'cage': false, ").domain.fit, Fit::Exact);
        QCOMPARE(domain("'cage': true, ").domain.fit, Fit::Cage);
        const Domain fine = domain("'cage': {'detail': 2.5, 'offset': 0.5}, ").domain;
        QVERIFY(fine.fit == Fit::Cage && fine.cageDetail == 2.5 && fine.cageOffset == 0.5);
        for (const char* cage :
             {"", "'cage': false, ", "'cage': true, ", "'cage': {'detail': 2.5, 'offset': 0.5}, "}) {
            const std::string once = toJson(domain(cage));
            QCOMPARE(toJson(*parseProject(once, "p.wend").project), once);
        }
        QVERIFY_THROWS_EXCEPTION(InputError, domain("'cage': {'detail': 0}, "));
        QVERIFY_THROWS_EXCEPTION(InputError, domain("'cage': {'offset': -1}, "));
        QVERIFY_THROWS_EXCEPTION(InputError, domain("'cage': 3, "));
    }

    /// The number of coordinates gives the dimension if a mesh cannot be opened.
    void dimensionFromCoordinates() {
        const std::string head = "'domain': {'mesh': 'missing.msh'}, 'handles': [{'at': {'points':";
        QCOMPARE(dimensionOf(*parseProject(projectText(head + "[[1, 2]]}}]"), "p.wend").project), 2);
        QCOMPARE(dimensionOf(*parseProject(projectText(head + "[[1, 2, 3]]}}]"), "p.wend").project), 3);
    }

    void unknownKeysAreKept() {
        const std::string text = projectText(
            "'author': {'name': 'A', 'years': [1, 2]}, "
            "'domain': {'image': 'f.png', 'outline': {'from': 'frame', 'zz': 1}, 'tint': 'red'}, "
            "'material': {'regions': [{'shape': {'circle': {'centre': [1, 2], 'radius': 3, 'glow': true}}, "
            "'phi': 1, 'ink': 2}]}, "
            "'handles': [{'at': {'points': [[1, 2]], 'snap': 1}, 'tint': '#ff0000', "
            "'motion': [{'kind': 'translate', 'by': [1, 0], 'a/b': {'deep': null}}]}], "
            "'time': {'end': 1, 'fps': 25}");
        const LoadedProject loaded = parseProject(text, "p.wend");
        QCOMPARE(loaded.warnings.size(), std::size_t(9));
        const std::string once = toJson(*loaded.project);
        for (const char* piece :
             {"'author': {'name': 'A', 'years': [1, 2]}", "'zz': 1", "'tint': 'red'", "'glow': true",
              "'ink': 2", "'snap': 1", "'tint': '#ff0000'", "'a/b': {'deep': null}", "'fps': 25"})
            QVERIFY2(once.find(json(piece)) != std::string::npos, (piece + once).c_str());
        const LoadedProject again = parseProject(once, "p.wend");
        QCOMPARE(again.warnings.size(), std::size_t(9));
        QCOMPARE(toJson(*again.project), once);
    }

    /// All notations of one B are equivalent.
    void anisotropiesOfCells() {
        const auto read = [](const std::string& B) {
            return planar(*parseProject(withMaterial("'cells': {'B': " + B + "}"), "p.wend").project)
                .material.cellB;
        };
        const std::vector<Mat3> expected = read("[[1, 0, 0, 1], [2, 0.5, 0.5, 3]]");
        QCOMPARE(expected.size(), std::size_t(2));
        QCOMPARE(expected[1](0, 1), 0.5);
        for (const char* other : {"[[1, 1, 0], [2, 3, 0.5]]", "[[[1, 0], [0, 1]], [[2, 0.5], [0.5, 3]]]",
                                  "[1, 0, 0, 1, 2, 0.5, 0.5, 3]", "[1, 1, 0, 2, 3, 0.5]"})
            QVERIFY2(read(other) == expected, other);
        const auto solid =
            parseProject(projectText("'domain': {'surface': 's.obj'}, 'material': {'cells': {'B': [[1, "
                                     "2, 3, 0.1, 0.2, 0.3]]}}"),
                         "p.wend");
        Mat3 B;
        B << 1, 0.1, 0.3, 0.1, 2, 0.2, 0.3, 0.2, 3;
        QCOMPARE(solid.project->design.material.cellB.at(0), B);
        QVERIFY(reasonFor(withMaterial("'cells': {'B': [[1, 0, 0]]}")).contains("is not positive definite"));
        QVERIFY(reasonFor(withMaterial("'cells': {'B': [[1, 0]]}"))
                    .contains("has 2 numbers where a matrix needs 4, or 3"));
        QVERIFY(reasonFor(withMaterial("'cells': {'B': [[[1, 0], [0]]]}"))
                    .contains("has 1 numbers where a row has 2"));
        QVERIFY(reasonFor(withMaterial("'cells': {'B': [1, 0, 0, 1, 1]}")).contains("no multiple of 4 or 3"));
    }

    /// Whichever key is misspelt, the message names it and the intended one.
    void misspeltKeys() {
        const QJsonObject full = QJsonDocument::fromJson(QByteArray::fromStdString(kFull)).object();
        const std::vector<Misspelt> all = misspellings(full);
        QVERIFY(all.size() > 60);
        for (const Misspelt& one : all) {
            const std::string text = QJsonDocument(one.json.toObject()).toJson().toStdString();
            std::string said;
            try {
                for (const std::string& warning : parseProject(text, "p.wend").warnings)
                    said += warning + "\n";
            } catch (const InputError& error) {
                said = error.what();
            }
            const std::string wanted = "`" + one.wrong + "` is not known; `" + one.right + "`?";
            QVERIFY2(said.find(wanted) != std::string::npos, (wanted + "\n" + said).c_str());
        }
    }

    void nearestWords_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("expected");
        QTest::newRow("American") << "center"
                                  << "centre";
        QTest::newRow("capitals") << "maxvolume"
                                  << "maxVolume";
        QTest::newRow("underscore") << "max_volume"
                                    << "maxVolume";
        QTest::newRow("short") << "vert"
                               << "vertices";
        QTest::newRow("plural") << "motions"
                                << "motion";
        QTest::newRow("another word") << "mood"
                                      << "";
        QTest::newRow("one letter") << "a"
                                    << "";
        QTest::newRow("nothing") << ""
                                 << "";
    }

    void nearestWords() {
        QFETCH(QString, text);
        QFETCH(QString, expected);
        const std::vector<std::string> words{"centre", "maxVolume", "vertices", "motion", "at", "by"};
        QCOMPARE(QString::fromStdString(nearestWord(text.toStdString(), words)), expected);
        QCOMPARE(editDistance("center", "centre"), 1);
        QCOMPARE(editDistance("kitten", "sitting"), 3);
        QCOMPARE(editDistance("", "abc"), 3);
    }

    /// A file that gives no end stays so, whatever end follows from the motions; a given end is kept.
    void endIsLeftToTheMotions() {
        const std::string motion =
            "{'kind': 'translate', 'by': [1, 0], 'time': [0.5, 3]}, {'kind': 'translate', 'by': [1, 0], "
            "'time': "
            "[3, 4.5]}";
        const std::string open = toJson(*parseProject(withMotion(motion), "p.wend").project);
        QVERIFY2(open.find("\"time\": {") == std::string::npos, open.c_str());
        const LoadedProject again = parseProject(open, "p.wend");
        QCOMPARE(again.project->end, 4.5);
        QCOMPARE(toJson(*again.project), open);
        Project longer = *again.project;
        longer.end = 6;
        QCOMPARE(parseProject(toJson(longer), "p.wend").project->end, 6.0);
        const auto endOf = [](const std::string& rest) {
            return parseProject(projectText(kImage + rest), "p.wend").project->end;
        };
        QCOMPARE(endOf(""), 1.0);
        QCOMPARE(endOf(", 'settle': [{'time': [1, 2.5]}]"), 2.5);
        QCOMPARE(endOf(", 'time': {'end': 0.25}"), 0.25);
        QCOMPARE(endOf(", 'time': {'rate': 24}"), 1.0);
    }

    /// Unknown keys of a shape that is replaced are dropped instead of causing an error.
    void unknownKeysOfReplacedShapes() {
        Project project =
            *parseProject(withMaterial("'regions': [{'phi': 1, 'shape': "
                                       "{'circle': {'centre': [1, 2], 'radius': 3, 'glow': true}}}]"),
                          "p.wend")
                 .project;
        project.design.material.layers[0].regions[0].shape = Box<3>{{0, 0, 0}, {1, 1, 0}};
        QCOMPARE(toJson(project).find("glow"), std::string::npos);
    }

    void badInput_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char* name, const std::string& text, const char* reason) {
            QTest::newRow(name) << QString::fromStdString(text) << QString::fromUtf8(reason);
        };
        row("empty", "", "p.wend: is empty");
        row("broken", "{\n  \"format\": \"wend\",\n  \"version\" 1\n}", "line 3, column 13");
        row("a mesh", "OFF\n4 4 0\n", "is no project of Wend");
        row("truncated", "{'format': 'wend', 'version': 1, 'domain': {'image':", "is not valid JSON: line 1");
        const auto surfaceRow = [&](const char* name, const std::string& keys, const char* reason) {
            row(name, projectText("'domain': {'surface': 'b.obj', " + keys + "}"), reason);
        };
        surfaceRow("repair", "'repair': 3", "domain.repair: must be true or false");
        surfaceRow("hole", "'repair': {'largestHole': -1}", "domain.repair.largestHole: -1 is out of range");
        surfaceRow("fix", "'fixes': [{'mend': [1]}]", "domain.fixes[0]: ");
        surfaceRow("two fixes", "'fixes': [{'fill': [1, 2], 'drop': [1]}]", "domain.fixes[0]: ");
        surfaceRow("fixes", "'fixes': {'fill': [1, 2]}", "domain.fixes: must be a list");
        surfaceRow("edge", "'fixes': [{'fill': [1]}]",
                   "domain.fixes[0].fill: must be the two vertices of an edge");
        surfaceRow("triangle", "'fixes': [{'turn': [2]}, {'drop': [-1]}]",
                   "domain.fixes[1].drop[0]: must not be negative");
        surfaceRow("sizes", "'sizes': [{'factor': 0.5}]", "domain.sizes[0]");
        surfaceRow("factor",
                   "'sizes': [{'shape': {'sphere': {'centre': [0, 0, 0], 'radius': 1}}, 'factor': 0}]",
                   "domain.sizes[0].factor: 0 is out of range");
        surfaceRow("painted late",
                   "'sizes': [{'shape': {'sphere': {'centre': [0, 0, 0], 'radius': 1}}, 'factor': 1},"
                   "{'values': 'a.txt'}]",
                   "domain.sizes[1]: `values` may stand once only");
        const auto viewRow = [&](const char* name, const std::string& view, const char* reason) {
            row(name, projectText("'domain': {'surface': 'b.obj'}, 'view': " + view), reason);
        };
        viewRow("up axis", "{'up': 'w'}", "view.up: unknown value \"w\"; known are x, y, z");
        viewRow("camera", "{'camera': {'position': [0, 0, 1]}}", "view.camera: the key `target` is missing");
        viewRow("camera in the target",
                "{'camera': {'position': [0, 0, 1], 'target': [0, 0, 1], 'up': [0, 1, 0]}}",
                "view.camera: `position` and `target` are one point");
        viewRow("camera along up",
                "{'camera': {'position': [0, 0, 1], 'target': [0, 0, 0], 'up': [0, 0, 2]}}",
                "view.camera: `up` gives no direction across the view");
        surfaceRow("quality", "'quality': 1", "domain.quality: 1 is out of range");
        row("NaN", withMaterial("'phi': NaN"), "is not valid JSON: line 1");
        row("overflow", withMaterial("'phi': 1e999"), "number overflow");
        row("key twice", projectText(kImage + "," + kImage), "the key `domain` is given twice");
        row("deep", std::string(100000, '['), "nested deeper");
        row("not an object", "[1]", "must be an object, not a list");
        row("no format", "{'version': 1}", "the key `format` is missing");
        row("other format", "{'format': 'glTF', 'version': 1}", "its format is \"glTF\"");
        row("no version", "{'format': 'wend'}", "the key `version` is missing");
        row("newer", "{'format': 'wend', 'version': 2}", "reads versions up to 1");
        row("no domain", "{'format': 'wend', 'version': 1}", "the key `domain` is missing");
        row("empty domain", projectText("'domain': {}"),
            "domain: has none of the known kinds: image, parts, mesh, surface");
        row("two domains", projectText("'domain': {'image': 'a', 'surface': 'b'}"),
            "domain: has both `image` and `surface`");
        row("path type", projectText("'domain': {'image': 3}"), "domain.image: must be a text, not 3");
        row("path empty", projectText("'domain': {'image': ''}"), "domain.image: names no file");
        row("outline kind", projectText("'domain': {'image': 'a', 'outline': {'from': 'luma'}}"),
            "domain.outline.from: unknown value \"luma\"; known are frame, alpha");
        row("threshold",
            projectText("'domain': {'image': 'a', 'outline': {'from': 'alpha', 'threshold': 1}}"),
            "domain.outline.threshold: 1 is out of range: it must be in ]0, 1[");
        row("vertices", projectText("'domain': {'image': 'a', 'vertices': 2.5}"), "domain.vertices");
        row("few vertices", projectText("'domain': {'image': 'a', 'vertices': -1}"),
            "domain.vertices: -1 is out of range");
        row("polygon", projectText("'domain': {'image': 'a', 'outline': {'polygons': [[[0, 0], [1, 1]]]}}"),
            "domain.outline.polygons[0]: needs at least 3 points");
        row("phi high", withMaterial("'phi': 2.7"), "material.phi: phi = 2.7 is outside ]0, 2.677945045]");
        row("phi zero", withMaterial("'phi': 0"), "outside ]0, 2.677945045]");
        row("phi high 3D", projectText("'domain': {'surface': 'a.stl'}, 'material': {'phi': 2.6}"),
            "outside ]0, 2.498091545]");
        row("phi name", withMaterial("'phi': 'soft'"),
            "unknown name \"soft\"; known are equia, metr, akvf, conf");
        row("phi type", withMaterial("'phi': [1]"), "material.phi: must be a number, not a list");
        row("smoothing", withMaterial("'smoothing': {'kind': 'cubic'}"),
            "material.smoothing.kind: unknown value \"cubic\"");
        row("smoothing length", withMaterial("'smoothing': {'kind': 'invariant', 'length': -1}"),
            "in ]0, 1]");
        row("memory", withMaterial("'memory': -1"),
            "material.memory: -1 is out of range: it must be in [0, ∞[");
        row("memory's word", withMaterial("'memory': 'elastik'"),
            "material.memory: is neither a number nor \"elastic\"");
        const auto withSettling = [](const std::string& windows) {
            return projectText(kImage + ", 'settle': [" + windows + "]");
        };
        row("settle window", withSettling("{'time': [1]}"),
            "settle[0]: `time` must be two times, [from, to]");
        row("settle reversed", withSettling("{'time': [2, 1]}"),
            "settle: settle window 1 is reversed or empty");
        row("settle overlapping", withSettling("{'time': [1, 2]}, {'time': [1.5, 3]}"),
            "settle: settle window 2 begins before window 1 has ended");
        row("settle early", withSettling("{'time': [-1, 2]}"),
            "settle: settle window 1 begins before time 0");
        const auto withDepth = [](const std::string& rest) {
            return projectText(kImage + ", 'depth': [{" + rest + "}]");
        };
        row("depth without order", withDepth("'shape': {'circle': {'centre': [0, 0], 'radius': 1}}"),
            "depth[0]: the key `order` is missing");
        row("depth of a blend", withDepth("'shape': {'blend': {'from': [0, 0], 'to': [1, 0]}}, 'order': 1"),
            "depth[0].shape: a blend has no inside");
        row("order", withDepth("'shape': {'circle': {'centre': [0, 0], 'radius': 1}}, 'order': 1e9"),
            "depth[0].order: 1e9 is out of range: it must be in [-1000, 1000]");
        row("ratio",
            withMaterial("'regions': [{'shape': {'circle': {'centre': [0, 0], 'radius': 1}}, "
                         "'stiffness': {'axis': [1, 0], 'ratio': 0.5}}]"),
            "material.regions[0].stiffness.ratio: 0.5 is out of range");
        row("axis",
            withMaterial("'regions': [{'shape': {'circle': {'centre': [0, 0], 'radius': 1}}, "
                         "'stiffness': {'axis': [0, 0], 'ratio': 2}}]"),
            "material.regions[0].stiffness.axis: must not be the zero vector");
        row("shape kind", withMaterial("'regions': [{'shape': {'star': 5}}]"),
            "material.regions[0].shape: has none of the known");
        row("sphere in 2D",
            withMaterial("'regions': [{'shape': {'sphere': {'centre': [0, 0], 'radius': 1}}}]"),
            "material.regions[0].shape: `sphere` is not known; `circle`?");
        row("radius", withMaterial("'regions': [{'shape': {'circle': {'centre': [0, 0], 'radius': 0}}}]"),
            "material.regions[0].shape.circle.radius: 0 is out of range");
        row("box", withMaterial("'regions': [{'shape': {'box': {'min': [0, 0], 'max': [1, 0]}}}]"),
            "min must be less than max");
        row("B symmetric", withMaterial("'cells': {'B': [[1, 0, 0, 1], [1, 0.1, 0, 1]]}"),
            "material.cells.B[1]: B is not symmetric");
        row("B definite", withMaterial("'cells': {'B': [[1, 2, 2, 1]]}"),
            "material.cells.B[0]: B is not positive definite");
        row("B size", withMaterial("'cells': {'B': [[1, 2]]}"), "2 numbers where a matrix needs 4");
        row("cell phi", withMaterial("'cells': {'phi': [1, 9]}"),
            "material.cells.phi[1]: phi = 9 is outside");
        row("no at", withHandle("{'name': 'x'}"), "handles[0]: the key `at` is missing");
        row("at kind", withHandle("{'at': {'edges': [1]}}"), "handles[0].at: has none of the known kinds");
        row("place of another program", withHandle("{'at': {'label': 21}}"),
            "handles[0].at: `label` is not known; `group`?");
        row("place in a region", withHandle("{'at': {'region': {'label': 21}}}"),
            "handles[0].at.region: `label` is not known; `group`, in place of `region`?");
        row("group in a region", withHandle("{'at': {'region': {'group': 'load'}}}"),
            "handles[0].at.region: `group` stands in place of `region`, not in it");
        row("shape of space", withHandle("{'at': {'region': {'sphere': {'centre': [1, 2], 'radius': 1}}}}"),
            "handles[0].at.region: `sphere` is not known; `circle`?");
        row("shape unknown", withHandle("{'at': {'region': {'star': 5}}}"), "blend; `star` is not known");
        row("at both", withHandle("{'at': {'points': [[1, 2]], 'vertices': [1]}}"),
            "handles[0].at: has both");
        row("no points", withHandle("{'at': {'points': []}}"), "handles[0].at.points: has no point");
        row("dimension", withHandle("{'at': {'points': [[1, 2], [1, 2, 3]]}}"),
            "handles[0].at.points[1]: has 3 numbers");
        row("negative id", withHandle("{'at': {'vertices': [-1]}}"),
            "handles[0].at.vertices[0]: a vertex number");
        row("active", withHandle("{'at': {'points': [[1, 2]]}, 'active': [1, 0]}"),
            "handles[0].active: the window is reversed");
        row("locked", withHandle("{'at': {'points': [[1, 2]]}, 'locked': 1}"),
            "handles[0].locked: must be true or false, not 1");
        row("link", withHandle("{'at': {'points': [[1, 2]]}, 'link': 0}"),
            "handles[0].link: 0 is out of range");
        row("colour", withHandle("{'at': {'points': [[1, 2]]}, 'colour': '#12345g'}"),
            "handles[0].colour: must be a colour");
        row("blend handle", withHandle("{'at': {'region': {'blend': {'from': [0, 0], 'to': [1, 0]}}}}"),
            "handles[0].at.region");
        row("motion kind", withMotion("{'kind': 'jump'}"),
            "handles[0].motion[0].kind: unknown value \"jump\"");
        row("motion no kind", withMotion("{'by': [1, 2]}"),
            "handles[0].motion[0]: the key `kind` is missing");
        row("motion by", withMotion("{'kind': 'translate'}"),
            "handles[0].motion[0]: the key `by` is missing");
        row("window", withMotion("{'kind': 'translate', 'by': [1, 2], 'time': [1, 0.5]}"),
            "handles[0].motion[0].time: the window is reversed or empty: it goes from 1 to 0.5");
        row("overlap",
            withMotion("{'kind': 'translate', 'by': [1, 2], 'time': [0, 0.6]}, "
                       "{'kind': 'translate', 'by': [1, 2], 'time': [0.5, 1]}"),
            "handles[0].motion[1]: begins at 0.5, before");
        row("bezier",
            withMotion("{'kind': 'curve', 'interpolation': 'bezier', 'points': [[0, 0], [1, 1], [2, 0]]}"),
            "handles[0].motion[0].points: a bezier is a chain of cubics");
        row("curve", withMotion("{'kind': 'curve', 'interpolation': 'spline', 'points': [[0, 0]]}"),
            "at least 2 points");
        row("curve point",
            withMotion("{'kind': 'curve', 'interpolation': 'spline', 'points': [[0, 0], [0, 'a']]}"),
            "handles[0].motion[0].points[1][1]: must be a number");
        row("axis in 2D", withMotion("{'kind': 'rotate', 'centre': [0, 0], 'axis': [0, 1], 'angle': 1}"),
            "motion[0].axis");
        row("twist in 2D",
            withMotion(
                "{'kind': 'curve', 'interpolation': 'spline', 'points': [[0, 0], [1, 1]], 'twist': 1}"),
            "handles[0].motion[0].twist: is for curves in 3D");
        row("scale",
            withMotion(
                "{'kind': 'curve', 'interpolation': 'spline', 'points': [[0, 0], [1, 1]], 'scale': 0}"),
            "handles[0].motion[0].scale: 0 is out of range");
        row("times", withMotion("{'kind': 'recorded', 'times': [0, 0], 'points': [[0, 0], [1, 1]]}"),
            "handles[0].motion[0].times: must increase");
        row("times count", withMotion("{'kind': 'recorded', 'times': [0, 1], 'points': [[0, 0]]}"),
            "has 1 points for 2 times");
        row("end", projectText(kImage + ", 'time': {'end': 0}"),
            "time.end: 0 is out of range: it must be in ]0, ∞[");
        row("cycle of one time", projectText(kImage + ", 'time': {'cycle': [1]}"),
            "time.cycle: must be two times, [from, to]");
        row("cycle reversed", projectText(kImage + ", 'time': {'cycle': [2, 1]}"),
            "time.cycle: must be two times");
        row("cycle before the start", projectText(kImage + ", 'time': {'cycle': [-1, 1]}"),
            "time.cycle: must be two times from 0 on");
        row("marker without a time", projectText(kImage + ", 'time': {'markers': [{'name': 'a'}]}"),
            "time.markers[0]: the key `at` is missing");
        row("marker before the start", projectText(kImage + ", 'time': {'markers': [{'at': 1}, {'at': -1}]}"),
            "time.markers[1].at: -1 is out of range");
        row("frame rate", projectText(kImage + ", 'time': {'frameRate': 0}"),
            "time.frameRate: 0 is out of range");
        row("sound", projectText(kImage + ", 'time': {'audio': 3}"), "time.audio: ");
        row("method", projectText(kImage + ", 'integration': {'method': 'euler'}"),
            "integration.method: unknown value");
        row("tolerance", projectText(kImage + ", 'integration': {'tolerance': 0}"),
            "integration.tolerance: 0 is out of range");
    }
    void timeIsKept() {
        const std::string text =
            projectText(kImage + ", 'time': {'frameRate': 12.5, 'cycle': [0.5, 1.5], 'audio': 'a/song.ogg'}");
        const LoadedProject loaded = parseProject(text, "p.wend");
        QVERIFY(loaded.warnings.empty());
        const Project& project = *loaded.project;
        QCOMPARE(project.frameRate, 12.5);
        QVERIFY((*project.cycle == std::array{0.5, 1.5}));
        QCOMPARE(project.audio, std::string("a/song.ogg"));
        QVERIFY(!project.endIsGiven);
        const auto again = parseProject(toJson(project), "p.wend").project;
        QVERIFY(!again->endIsGiven && again->cycle == project.cycle && again->audio == project.audio &&
                again->frameRate == project.frameRate);
        const std::string plain = toJson(*parseProject(projectText(kImage), "p.wend").project);
        for (const char* key : {"frameRate", "cycle", "markers", "audio"})
            QCOMPARE(plain.find(key), std::string::npos);
    }

    /// Markers are kept in the order of time, with any keys that another program has added.
    void markersAreKept() {
        const LoadedProject loaded = parseProject(
            projectText(kImage + ", 'time': {'markers': [{'at': 2, 'name': 'b'}, {'at': 0.5, 'mood': 3}]}"),
            "p.wend");
        QCOMPARE(loaded.warnings.size(), std::size_t(1));
        const auto& markers = loaded.project->markers;
        QCOMPARE(markers.size(), std::size_t(2));
        QVERIFY(markers[0].at == 0.5 && markers[0].name.empty() && markers[1].at == 2 &&
                markers[1].name == "b");
        const std::string text = toJson(*loaded.project);
        QVERIFY(text.find("\"mood\": 3") != std::string::npos);
        QCOMPARE(toJson(*parseProject(text, "p.wend").project), text);
    }

    void badInput() {
        QFETCH(QString, text);
        QFETCH(QString, reason);
        const QString message = reasonFor(json(text.toStdString()));
        QVERIFY2(message.startsWith("p.wend: "), qPrintable(message));
        QVERIFY2(message.contains(reason), qPrintable(message));
        QVERIFY2(!message.contains('\n'), qPrintable(message));
    }

    void notUtf8() { QVERIFY(reasonFor("{\"a\": \"\xff\"}").contains("is not valid JSON: line 1")); }

    void files() {
        QTemporaryDir folder;
        const fs::path base = folder.path().toStdString();
        fs::create_directories(base / "sub");
        const Project project = *parseProject(kFull, "p.wend").project;
        const std::string path = (base / "a.wend").string();
        writeProject(path, project);
        QCOMPARE(toJson(*readProject(path).project), toJson(project));
        // saved in another folder, it names the same picture
        writeProject((base / "sub" / "b.wend").string(), project, base.string());
        QCOMPARE(domainOf(*readProject((base / "sub" / "b.wend").string()).project).path,
                 std::string("../frog.png"));
        // and all other files as well
        const std::string meshText = projectText(
            "'domain': {'mesh': 'in/strip.obj', 'image': 'in/frog.png'}, 'material': {'cells': "
            "'cells.json'}");
        writeProject((base / "sub" / "c.wend").string(), *parseProject(meshText, "p.wend").project,
                     base.string());
        const Project moved = *readProject((base / "sub" / "c.wend").string()).project;
        QCOMPARE(moved.domain.path, std::string("../in/strip.obj"));
        QCOMPARE(moved.domain.texture, std::string("../in/frog.png"));
        QCOMPARE(planar(moved).material.cellsFile, std::string("../cells.json"));
        const std::string solidText = projectText(
            "'domain': {'surface': 'in/bar.stl', 'detail': 'in/fine.obj', 'sizes': [{'values': "
            "'in/sizes.txt'}]}");
        writeProject((base / "sub" / "d.wend").string(), *parseProject(solidText, "p.wend").project,
                     base.string());
        const Domain solid = domainOf(*readProject((base / "sub" / "d.wend").string()).project);
        QCOMPARE(solid.path, std::string("../in/bar.stl"));
        QCOMPARE(solid.detail, std::string("../in/fine.obj"));
        QCOMPARE(solid.sizesFile, std::string("../in/sizes.txt"));
        Project absolute = project;
        absolute.domain.path = (base / "pictures" / "x.png").string();
        writeProject(path, absolute);
        QCOMPARE(domainOf(*readProject(path).project).path, std::string("pictures/x.png"));
    }

    void filesThatFail() {
        QTemporaryDir folder;
        const std::string base = folder.path().toStdString();
        const Project project = *parseProject(kFull, "p.wend").project;
        QVERIFY_THROWS_EXCEPTION(InputError, readProject(base + "/none.wend"));
        QVERIFY_THROWS_EXCEPTION(InputError, readProject(base));
        QVERIFY_THROWS_EXCEPTION(InputError, writeProject(base + "/no/folder.wend", project));
        writeProject(base + "/kept.wend", project);
        Project broken = project;
        broken.end = std::numeric_limits<double>::quiet_NaN();
        QVERIFY_THROWS_EXCEPTION(InputError, writeProject(base + "/kept.wend", broken));
        QCOMPARE(toJson(*readProject(base + "/kept.wend").project), toJson(project));
        QCOMPARE(std::distance(fs::directory_iterator(base), fs::directory_iterator{}),
                 1);  // no temporary is left
    }

    void cellsFile() {
        QTemporaryDir folder;
        const std::string path = folder.filePath("cells.json").toStdString();
        writeTextFile(path, json("{'phi': [0.5, 'conf'], 'B': [[1, 0, 0, 1], [3, 1, 1, 2]]}"));
        MaterialSpec spec;
        readCells(path, spec, 2);
        QCOMPARE(spec.cellPhi.size(), std::size_t(2));
        QCOMPARE(spec.cellPhi[1], phi::conformal(2));
        QCOMPARE(spec.cellB[1](1, 1), 2.0);
        writeTextFile(path, json("{'phi': [0.5, 7]}"));
        QVERIFY_THROWS_EXCEPTION(InputError, readCells(path, spec, 2));
    }

    /// A group's name is looked up and kept while the handle is where the group is, and written as ids once
    /// the handle is moved.
    void handlesOnGroups() {
        QTemporaryDir folder;
        const std::string base = folder.path().toStdString();
        writeTextFile(base + "/a.obj",
                      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng left\nf 1 2 3\ng right\nf 1 3 4\n");
        writeTextFile(base + "/ids.txt", "3, 1 # the first two\n\n2");
        const auto project = [&](const char* at) {
            writeTextFile(base + "/p.wend",
                          json(std::string("{'format': 'wend', 'version': 1, 'domain': {'mesh': 'a.obj'}, "
                                           "'handles': [{'at': ") +
                               at + "}]}"));
            return readProject(base + "/p.wend").project;
        };
        auto held = project("{'group': 'right'}");
        auto& handle = designOf(*held).handles[0];
        QCOMPARE(std::get<std::vector<int>>(handle.at), (std::vector<int>{0, 2, 3}));
        writeProject(base + "/kept.wend", *held);
        QVERIFY(readTextFile(base + "/kept.wend").find("\"group\": \"right\"") != std::string::npos);
        handle.at = std::vector<int>{0, 2};
        writeProject(base + "/moved.wend", *held);
        QCOMPARE(readTextFile(base + "/moved.wend").find("group"), std::string::npos);
        auto listed = project("{'vertices': 'ids.txt'}");
        QCOMPARE(std::get<std::vector<int>>(designOf(*listed).handles[0].at), (std::vector<int>{3, 1, 2}));
        fs::create_directory(base + "/deeper");
        writeProject(base + "/deeper/q.wend", *listed, base);
        QVERIFY(readTextFile(base + "/deeper/q.wend").find("../ids.txt") != std::string::npos);
        try {
            project("{'group': 'middle'}");
            QFAIL("was found");
        } catch (const InputError& error) {
            QVERIFY2(QString(error.what())
                         .endsWith("handles[0].at: there is no group 'middle' in the file; it has 'left' "
                                   "(surfaces), 'right' (surfaces)"),
                     error.what());
        }
        writeTextFile(base + "/ids.txt", "3\n-1\n");
        QVERIFY_THROWS_EXCEPTION(InputError, project("{'vertices': 'ids.txt'}"));
    }

    void numbers_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("text");
        QTest::newRow("one") << 1.0 << "1";
        QTest::newRow("tenth") << 0.1 << "0.1";
        QTest::newRow("small") << 1e-7 << "1e-7";
        QTest::newRow("large") << 1e22 << "1e22";
        QTest::newRow("third") << 1.0 / 3 << "0.3333333333333333";
    }
    void numbers() {
        QFETCH(double, value);
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(shortNumber(value)), text);
        QCOMPARE(text.toDouble(), value);
    }
};

QTEST_APPLESS_MAIN(TestProject)
#include "test_project.moc"
