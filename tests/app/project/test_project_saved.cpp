// The saved file is compared with the opened one as plain JSON, by a parser that is independent of projects.
// (A writer that is compared with itself could lose keys unnoticed.)

#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/project/file/project_reader.h"
#include "app/project/file/project_writer.h"
#include "app/project/file/text_file.h"
#include "app/project/project.h"
#include "core/energy/material.h"
#include "tests/support/quoted.h"

using namespace wend;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

std::string projectText(const std::string& rest) {
    return json("{'format': 'wend', 'version': 1, " + rest + "}");
}

/// A picture's project with every key, none at its default.
const std::string kFlat = projectText(
    "'domain': {'image': 'frog.png', 'outline': {'from': 'alpha', 'threshold': 0.25, 'margin': 3, 'gap': "
    "1.5, "
    "'smallest': 10, 'simplify': 0.5}, 'edge': 2.5, 'border': 'slide', 'sizes': [{'name': 'face', 'shape': "
    "{'circle': {'centre': [1, 2], "
    "'radius': 3}}, 'feather': 0.5, 'factor': 0.25}]}, "
    "'material': {'phi': 'akvf', 'smoothing': {'kind': 'paper', 'lambda': 0.3}, "
    "'regions': [ "
    "{'name': 'leg', 'shape': {'polygon': [[10, 20], [90, 20], [90, 80]]}, 'feather': 12, 'phi': 2.2}, "
    "{'name': 'bone', 'shape': {'circle': {'centre': [50, 50], 'radius': 20}}, 'stiffness': {'axis': [1, 0], "
    "'ratio': 20}}, "
    "{'shape': {'box': {'min': [0, 1], 'max': [2, 3]}}, 'phi': 'conf'}, "
    "{'shape': {'halfspace': {'point': [0, 1], 'normal': [0, 1]}}, 'phi': 'equia'}, "
    "{'shape': {'blend': {'from': [0, 1], 'to': [0, 2]}}, 'phi': 0.1}], "
    "'cells': {'phi': [0.1, 0.2], 'B': [[1, 0, 0, 1], [2, 0.5, 0.5, 2]]}}, "
    "'handles': [ "
    "{'name': 'foot', 'at': {'points': [[12, 90], [30, 92]]}}, "
    "{'at': {'vertices': [3, 4]}, 'active': [0.1, null]}, "
    "{'name': 'hand', 'at': {'region': {'circle': {'centre': [5, 5], 'radius': 2}}}, 'active': [0, 2], "
    "'motion': [ "
    "{'kind': 'translate', 'by': [1, 0.1], 'time': [0, 0.5], 'ease': 'inOut'}, "
    "{'kind': 'rotate', 'centre': [0, 3], 'angle': -1.5707963267948966, 'time': [0.5, 1], 'ease': 'in'}, "
    "{'kind': 'curve', 'interpolation': 'bezier', 'points': [[80, 10], [95, 10], [110, 30], [110, 50]], "
    "'frame': 'minimal', 'scale': 1.5, 'time': [1, 1.5], 'ease': 'out'}, "
    "{'kind': 'recorded', 'times': [0, 0.1, 0.4], 'points': [[0, 0], [1, 1], [2, 1.000000000000001]], "
    "'time': [1.5, 2]}]}], "
    "'depth': [{'name': 'hand', 'shape': {'circle': {'centre': [5, 5], 'radius': 2}}, 'order': 2}, "
    "{'shape': {'halfspace': {'point': [0, 1], 'normal': [0, 1]}}, 'order': -0.5}], "
    "'time': {'end': 2}, "
    "'integration': {'method': 'rk4', 'tolerance': 1e-5, 'steps': 12, 'smallestStep': 1e-5}");

/// A solid's project with every key.
const std::string kSolid = projectText(
    "'domain': {'surface': 'bar.obj', 'quality': 1.6, 'maxVolume': 0.1, 'refineSurface': true, "
    "'fixes': [{'fill': [3, 17]}, {'drop': [4, 8]}, {'turn': [5]}], "
    "'repair': {'largestHole': 12}, 'detail': 'fine.obj', "
    "'sizes': [{'values': 'sizes.txt'}, {'name': 'tip', 'shape': {'sphere': {'centre': [0, 1, 2], 'radius': "
    "3}}, 'feather': 0.5, 'factor': 0.25}]}, "
    "'material': {'phi': 1.25, 'smoothing': {'kind': 'invariant', 'length': 0.05}, 'cells': 'cells.json', "
    "'regions': [{'shape': {'box': {'min': [0, 1, 2], 'max': [3, 4, 5]}}, 'stiffness': {'axis': [0, 0, 1], "
    "'ratio': 5}}]}, "
    "'handles': [{'at': {'points': [[0, 0, 1]]}, 'motion': [ "
    "{'kind': 'rotate', 'centre': [0, 0, 4], 'axis': [0, 0, 1], 'angle': 3, 'time': [0, 1]}, "
    "{'kind': 'curve', 'interpolation': 'spline', 'points': [[0, 0, 1], [1, 1, 1], [2, 0, 1]], 'frame': "
    "'frenet', 'twist': 0.75, 'scale': 0.5, 'time': [1, 2]}]}], "
    "'view': {'up': 'y', 'camera': {'position': [1, 2, 3.25], 'target': [0.5, 0, -1e-3], 'up': [0, 1, 0.5], "
    "'pivot': [0.25, 0, 0], 'parallel': true}}, "
    "'time': {'end': 3}, 'integration': {'method': 'dopri5', 'tolerance': 1e-6}");

/// Returns the places where `saved` lacks or changes something of `given`.
QStringList lost(const Json& given, const Json& saved, const std::string& where = {}) {
    QStringList all;
    if (given.is_object()) {
        for (const auto& [key, value] : given.items())
            if (!saved.contains(key))
                all << QString::fromStdString(where + "/" + key);
            else
                all << lost(value, saved[key], where + "/" + key);
    } else if (given.is_array() && saved.is_array() && given.size() == saved.size()) {
        for (std::size_t i = 0; i < given.size(); ++i)
            all << lost(given[i], saved[i], where + "/" + std::to_string(i));
    } else if (given != saved) {
        all << QString::fromStdString(where + ": " + given.dump() + " became " + saved.dump());
    }
    return all;
}

}  // namespace

class TestProjectSaved : public QObject {
    Q_OBJECT

  private slots:
    void everyKeyIsSaved_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("picture") << QString::fromStdString(kFlat);
        QTest::newRow("solid") << QString::fromStdString(kSolid);
    }

    void everyKeyIsSaved() {
        QFETCH(QString, text);
        const LoadedProject loaded = parseProject(text.toStdString(), "p.wend");
        QVERIFY(loaded.warnings.empty());
        const QStringList missing =
            lost(Json::parse(text.toStdString()), Json::parse(toJson(*loaded.project)));
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join("\n")));
    }

    /// Unknown keys of the view are kept, even if it has no other keys, and so are those in its camera.
    void unknownKeysOfTheViewAreKept() {
        const std::string start = "'domain': {'surface': 'bar.obj'}, 'view': ";
        for (const std::string view :
             {"{'grid': [1, 2]}",
              "{'camera': {'position': [1, 2, 3], 'target': [0, 0, 0], 'up': [0, 0, 1], 'lens': 35}}"}) {
            const std::string text = projectText(start + view);
            const LoadedProject loaded = parseProject(text, "p.wend");
            QCOMPARE(loaded.warnings.size(), std::size_t(1));
            QCOMPARE(Json::parse(toJson(*loaded.project))["view"], Json::parse(text)["view"]);
        }
    }

    void viewIsNotWrittenWithoutNeed() {
        const std::string text = projectText("'domain': {'surface': 'bar.obj'}, 'view': {'up': 'z'}");
        QVERIFY(!Json::parse(toJson(*parseProject(text, "p.wend").project)).contains("view"));
    }

    /// Every path of a project that is saved in another folder still names the same file.
    void everyFileIsNamedFromTheNewFolder() {
        QTemporaryDir folder;
        const fs::path base = folder.path().toStdString();
        fs::create_directories(base / "new" / "deep");
        Project project = *parseProject(kSolid, "p.wend").project;
        project.domain.kind = DomainKind::Mesh;
        project.domain.texture = "paint/skin.png";
        const std::string path = (base / "new" / "deep" / "b.wend").string();
        writeProject(path, project, base.string());
        const Json mesh = Json::parse(readTextFile(path));
        project.domain.kind = DomainKind::Surface;
        writeProject(path, project, base.string());
        const Json surface = Json::parse(readTextFile(path));
        const std::pair<std::string, Json> files[] = {{"bar.obj", mesh["domain"]["mesh"]},
                                                      {"paint/skin.png", mesh["domain"]["image"]},
                                                      {"fine.obj", mesh["domain"]["detail"]},
                                                      {"cells.json", mesh["material"]["cells"]},
                                                      {"bar.obj", surface["domain"]["surface"]},
                                                      {"sizes.txt", surface["domain"]["sizes"][0]["values"]}};
        for (const auto& [name, saved] : files) {
            QVERIFY2(saved.is_string(), name.c_str());
            const fs::path there = fs::path(path).parent_path() / saved.get<std::string>();
            QCOMPARE(there.lexically_normal().string(), (base / name).string());
        }
    }
};

QTEST_APPLESS_MAIN(TestProjectSaved)
#include "test_project_saved.moc"
