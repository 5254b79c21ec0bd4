// Pictures as rigs of other programs, read as the formats' documents specify and independently of our code:
// places of vertices over time, the texture that they show, and the order of parts.

#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtEndian>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/output/rig.h"
#include "app/output/rig_files.h"
#include "app/output/run.h"
#include "app/project/file/project_reader.h"
#include "core/base/error.h"
#include "core/integration/deformer.h"
#include "tests/support/pictures.h"

using namespace wend;
using namespace wend::test;

namespace {

constexpr int kCount = 5;
constexpr double kRate = 8, kWidth = 80, kHeight = 60;

std::vector<double> numbersOf(const QJsonValue& value) {
    std::vector<double> numbers;
    for (const QJsonValue& one : value.toArray()) numbers.push_back(one.toDouble());
    return numbers;
}

/// Returns the place in the picture of the texture point in the middle of every triangle.
std::vector<QPointF> middles(const QJsonObject& mesh, const QSize& texture) {
    const auto uv = numbersOf(mesh["uvs"]), corners = numbersOf(mesh["triangles"]);
    std::vector<QPointF> places;
    for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
        QPointF sum;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto v = static_cast<std::size_t>(corners[t + k]);
            sum += QPointF(uv[2 * v] * texture.width(), uv[2 * v + 1] * texture.height());
        }
        places.push_back(sum / 3);
    }
    return places;
}

/// Returns twice the area that the triangles of a mesh cover.
double area(const QJsonObject& mesh) {
    const auto points = numbersOf(mesh["vertices"]), corners = numbersOf(mesh["triangles"]);
    double sum = 0;
    for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
        std::array<QPointF, 3> at;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto v = static_cast<std::size_t>(corners[t + k]);
            at[k] = {points[2 * v], points[2 * v + 1]};
        }
        const QPointF a = at[1] - at[0], b = at[2] - at[0];
        sum += std::abs(a.x() * b.y() - a.y() * b.x());
    }
    return sum;
}

/// Returns the names in drawing order after some are moved; the others fill the remaining places.
QStringList moved(const QStringList& names, const std::vector<std::pair<int, int>>& offsets) {
    QStringList order(names.size());
    QStringList others = names;
    for (const auto& [slot, by] : offsets) {
        order[slot + by] = names[slot];
        others.removeOne(names[slot]);
    }
    for (QString& place : order)
        if (place.isEmpty()) place = others.takeFirst();
    return order;
}

}  // namespace

class TestRig : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void spineMoves();
    void dragonBonesMoves();
    void gltfMoves();
    void ordersAreSaidAsOffsets();
    void longestOutlineComesFirst();
    void dragonBonesHasALimit();
    void wrongNames();

  private:
    QString at(const QString& name) const { return m_folder.filePath(name); }
    QJsonObject json(const QString& name) const {
        QFile file(at(name));
        return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                              : QJsonObject();
    }
    void run(const std::vector<const char*>& names) const;
    bool showsColour(const QJsonObject& mesh, const QImage& texture, QColor colour) const;
    /// Compares vertices with those at rest; only the bar moves, by (16, −8) pixels with y up.
    bool isMoved(const QString& part, const std::vector<double>& offsets, double part01, double up) const;

    QTemporaryDir m_folder;
};

/// A red bar in front of a green board moves right and down, and is behind it in the second half.
void TestRig::initTestCase() {
    writeImage(at("board.png").toStdString(), plainPicture(80, 60, {0, 255, 0}));
    writeImage(at("bar.png").toStdString(), plainPicture(50, 12, {255, 0, 0, 255}));
    run({"rig.json", "rig_ske.json", "rig.glb"});
}

void TestRig::run(const std::vector<const char*>& names) const {
    const std::string text = R"({"format": "wend", "version": 1, "domain": {"vertices": 120, "parts": [
        {"name": "bar", "image": "bar.png", "at": [10, 20], "blend": "add", "order": [{"time": 0.5, "place": 2}]},
        {"name": "board", "image": "board.png"}]}, "handles": [
        {"name": "a", "at": {"part": "bar", "points": [[15, 25], [50, 26]]},
         "motion": [{"kind": "translate", "by": [16, 8], "time": [0, 1]}]},
        {"name": "b", "at": {"part": "board", "points": [[10, 10], [70, 10]]}}]})";
    const LoadedProject loaded = parseProject(text, at("project.wend").toStdString());
    RunOptions options;
    for (const char* name : names) options.outputs.frames.push_back(at(name).toStdString());
    options.outputs.count = kCount;
    options.outputs.framesPerSecond = kRate;
    options.backEnd = BackEndKind::Cpu;
    QCOMPARE(runProject(*loaded.project, at("project.wend").toStdString(), options).outcome, Outcome::Done);
}

bool TestRig::showsColour(const QJsonObject& mesh, const QImage& texture, QColor colour) const {
    const auto places = middles(mesh, texture.size());
    return places.size() > 10 && std::ranges::all_of(places, [&](const QPointF& place) {
               return texture.pixelColor(static_cast<int>(place.x()), static_cast<int>(place.y())) == colour;
           });
}

bool TestRig::isMoved(const QString& part, const std::vector<double>& offsets, double part01,
                      double up) const {
    const double x = part == "bar" ? 16 * part01 : 0, y = part == "bar" ? 8 * part01 * up : 0;
    for (std::size_t i = 0; i + 1 < offsets.size(); i += 2)
        if (std::hypot(offsets[i] - x, offsets[i + 1] - y) > 1e-3) return false;
    return !offsets.empty();
}

void TestRig::spineMoves() {
    const QJsonObject spine = json("rig.json");
    QFile atlas(at("rig.atlas"));
    QVERIFY(atlas.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(atlas.readAll()).split('\n');
    const QImage texture(at(lines[0]));
    QCOMPARE(lines[1], QStringLiteral("size: %1, %2").arg(texture.width()).arg(texture.height()));
    QStringList names;
    const QJsonObject animation = spine["animations"]["deformation"].toObject();
    for (const QJsonValue& slot : spine["slots"].toArray()) {
        const QString name = slot["name"].toString();
        names << name;
        QCOMPARE(slot["blend"].toString(), name == "bar" ? "additive" : "");
        const QJsonObject mesh =
            spine["skins"][0]["attachments"][name][slot["attachment"].toString()].toObject();
        QCOMPARE(mesh["path"].toString(), lines[4]);
        QVERIFY(showsColour(mesh, texture, name == "bar" ? Qt::red : Qt::green));
        QVERIFY(std::abs(area(mesh) - 2 * (name == "bar" ? 50 * 12 : 80 * 60)) < 1e-2);
        const auto rest = numbersOf(mesh["vertices"]);
        QVERIFY(name == "bar" || std::ranges::min(rest) == 0);
        const QJsonArray keys = animation["attachments"]["default"][name][name]["deform"].toArray();
        QCOMPARE(keys.size(), kCount);
        for (int k = 0; k < kCount; ++k) {
            QCOMPARE(keys[k]["time"].toDouble(), k / kRate);
            QVERIFY(isMoved(name, numbersOf(keys[k]["vertices"]), k / (kCount - 1.0), -1));
        }
        // The bar at rest is from y = 20 to 32 with y down.
        if (name == "bar") {
            double low = 1e9;
            for (std::size_t i = 1; i < rest.size(); i += 2) low = std::min(low, rest[i]);
            QVERIFY(std::abs(low - (kHeight - 32)) < 1e-3);
        }
    }
    QCOMPARE(names, QStringList({"board", "bar"}));
    const QJsonArray orders = animation["drawOrder"].toArray();
    QCOMPARE(orders.size(), 1);
    QCOMPARE(orders[0]["time"].toDouble(), 2 / kRate);
    std::vector<std::pair<int, int>> offsets;
    for (const QJsonValue& one : orders[0]["offsets"].toArray())
        offsets.emplace_back(names.indexOf(one["slot"].toString()), one["offset"].toInt());
    QCOMPARE(moved(names, offsets), QStringList({"bar", "board"}));
}

void TestRig::dragonBonesMoves() {
    const QJsonObject armature = json("rig_ske.json")["armature"][0].toObject();
    const QJsonObject atlas = json("rig_tex.json");
    const QImage texture(at(atlas["imagePath"].toString()));
    QCOMPARE(atlas["SubTexture"][0]["width"].toInt(), texture.width());
    QCOMPARE(armature["frameRate"].toDouble(), kRate);
    QStringList names;
    for (const QJsonValue& slot : armature["slot"].toArray()) {
        names << slot["name"].toString();
        QCOMPARE(slot["blendMode"].toString(), names.last() == "bar" ? "add" : "");
    }
    const QJsonObject animation = armature["animation"][0].toObject();
    QCOMPARE(animation["duration"].toInt(), kCount - 1);
    for (const QJsonValue& slot : armature["skin"][0]["slot"].toArray()) {
        const QJsonObject mesh = slot["display"][0].toObject();
        const QString name = slot["name"].toString();
        QCOMPARE(mesh["path"], atlas["SubTexture"][0]["name"]);
        QVERIFY(showsColour(mesh, texture, name == "bar" ? Qt::red : Qt::green));
        for (const QJsonValue& timeline : animation["ffd"].toArray()) {
            if (timeline["slot"].toString() != name) continue;
            int frame = 0;
            for (const QJsonValue& key : timeline["frame"].toArray()) {
                QVERIFY(isMoved(name, numbersOf(key["vertices"]), frame / (kCount - 1.0), 1));
                frame += key["duration"].toInt();
            }
            QCOMPARE(frame, kCount - 1);
        }
    }
    const QJsonArray orders = animation["zOrder"]["frame"].toArray();
    QCOMPARE(orders.size(), 2);
    QVERIFY(orders[0]["zOrder"].toArray().isEmpty());
    QCOMPARE(orders[0]["duration"].toInt(), 2);
    const auto pairs = numbersOf(orders[1]["zOrder"]);
    std::vector<std::pair<int, int>> offsets;
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2)
        offsets.emplace_back(static_cast<int>(pairs[i]), static_cast<int>(pairs[i + 1]));
    QCOMPARE(moved(names, offsets), QStringList({"bar", "board"}));
}

/// Only the bar of two parts moves; it becomes the farther one.
void TestRig::gltfMoves() {
    QFile file(at("rig.glb"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    const auto textLength = static_cast<int>(qFromLittleEndian<quint32>(bytes.constData() + 12));
    const QJsonObject gltf = QJsonDocument::fromJson(bytes.mid(20, textLength)).object();
    const auto floats = [&](const QJsonValue& index, int components) {
        const QJsonValue accessor = gltf["accessors"][index.toInt()];
        const QJsonValue view = gltf["bufferViews"][accessor["bufferView"].toInt()];
        std::vector<float> values(static_cast<std::size_t>(accessor["count"].toInt() * components));
        std::memcpy(values.data(), bytes.constData() + 28 + textLength + view["byteOffset"].toInt(),
                    values.size() * sizeof(float));
        return values;
    };
    QVERIFY(gltf["extensionsUsed"].toArray().contains("KHR_materials_unlit"));
    QCOMPARE(gltf["images"].toArray().size(), 1);
    QCOMPARE(gltf["materials"].toArray().size(), 2);
    const QJsonValue primitive = gltf["meshes"][0]["primitives"][0];
    QCOMPARE(primitive["targets"].toArray().size(), kCount);
    const auto rest = floats(primitive["attributes"]["POSITION"], 3);
    const auto last = floats(primitive["targets"][kCount - 1]["POSITION"], 3);
    int bars = 0;
    for (std::size_t i = 0; i < rest.size(); i += 3) {
        const bool isBar = rest[i + 2] > 0;  // in front at rest
        bars += isBar ? 1 : 0;
        const double x = isBar ? 0.016 : 0, y = isBar ? -0.008 : 0, z = isBar ? -0.00008 : 0.00008;
        QVERIFY(std::abs(last[i] - x) < 1e-6 && std::abs(last[i + 1] - y) < 1e-6 &&
                std::abs(last[i + 2] - z) < 1e-7);
    }
    QVERIFY(bars > 3);
}

void TestRig::ordersAreSaidAsOffsets() {
    QVERIFY(offsetsOf({0, 1, 2}).empty());
    const QStringList names{"a", "b", "c", "d"};
    std::vector<int> order{0, 1, 2, 3};
    do {
        QStringList expected;
        for (const int part : order) expected << names[part];
        QCOMPARE(moved(names, offsetsOf(order)), expected);
    } while (std::ranges::next_permutation(order).found);
}

/// The outer outline of a square with a square hole is the hull, and comes first.
void TestRig::longestOutlineComesFirst() {
    Shape<2> shape;
    SimplicialMesh<2> mesh;
    mesh.points.resize(2, 8);
    mesh.points << 2, 4, 4, 2, 0, 6, 6, 0,  //
        2, 2, 4, 4, 0, 0, 6, 6;
    for (int k = 0; k < 4; ++k) {
        const int next = (k + 1) % 4;
        mesh.cells.push_back({4 + k, 4 + next, k});
        mesh.cells.push_back({4 + next, next, k});
    }
    shape.rest = std::make_shared<const SimplicialMesh<2>>(mesh);
    shape.picture = std::make_shared<const Image>(plainPicture(6, 6, {0, 0, 0}));
    const Rig rig = makeRig(shape, {mesh.points}, {}, {}, 24);
    QCOMPARE(rig.parts.size(), std::size_t{1});
    const RigPart& part = rig.parts[0];
    QCOMPARE(part.hull, 4);
    for (int k = 0; k < 4; ++k) {
        const Vec2 from = mesh.points.col(part.vertices[static_cast<std::size_t>(k)]),
                   to = mesh.points.col(part.vertices[static_cast<std::size_t>((k + 1) % 4)]);
        QCOMPARE((to - from).norm(), 6.0);
    }
}

void TestRig::dragonBonesHasALimit() {
    Rig rig;
    rig.parts = {{"a", std::vector<int>(1000), 0, {}}, {"b", std::vector<int>(1000), 0, {}}};
    rig.poses.resize(32);
    QVERIFY(lostInRig("a_ske.json", rig).empty());
    rig.poses.resize(33);
    QVERIFY(lostInRig("a_ske.json", rig).find("66000") != std::string::npos);
    QVERIFY(lostInRig("a.json", rig).empty());
}

void TestRig::wrongNames() {
    const LoadedProject solid =
        parseProject(R"({"format": "wend", "version": 1, "domain": {"surface": "box.obj"}})",
                     at("solid.wend").toStdString());
    RunOutputs outputs;
    outputs.frames = {at("a.json").toStdString()};
    QVERIFY_THROWS_EXCEPTION(InputError, requirePossible(*solid.project, outputs));
    outputs.frames = {at("none/a.json").toStdString()};
    const LoadedProject picture = parseProject(
        R"({"format": "wend", "version": 1, "domain": {"image": "bar.png"}})", at("flat.wend").toStdString());
    QVERIFY_THROWS_EXCEPTION(InputError, requirePossible(*picture.project, outputs));
    outputs.frames = {at("a_ske.json").toStdString()};
    requirePossible(*picture.project, outputs);
    const FileNames all = outputs.singleFiles();
    QVERIFY(std::ranges::find(all, at("a_tex.png").toStdString()) != all.end());
}

QTEST_GUILESS_MAIN(TestRig)
#include "test_rig.moc"
