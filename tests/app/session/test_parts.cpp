// Pictures of several parts: their place, opacity and order, embedding in another part, cutting out, and the
// file of layers, which Python's zipfile and Qt read.

#include <OpenImageIO/imageio.h>
#include <Eigen/Geometry>

#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include "app/engine/shape/shape_builder.h"
#include "app/output/run.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/file/project_reader.h"
#include "app/project/file/project_writer.h"
#include "app/session/part_making.h"
#include "core/base/error.h"
#include "core/integration/deformer.h"
#include "core/meshing/outline_combination.h"
#include "tests/support/layers.h"
#include "tests/support/pictures.h"
#include "warp/convert.h"
#include "warp/inpaint.h"
#include "warp/matte.h"
#include "warp/open_raster.h"
#include "warp/picture_metadata.h"

using namespace wend;
using namespace wend::test;

namespace {

using Rgba = std::array<double, 4>;

Rgba pixelOf(const QImage& image, int x, int y) {
    const QColor colour = image.pixelColor(x, y);
    return {colour.redF(), colour.greenF(), colour.blueF(), colour.alphaF()};
}

/// Porter–Duff "over"; colours are not multiplied with alpha.
Rgba over(const Rgba& top, const Rgba& below) {
    const double alpha = top[3] + (1 - top[3]) * below[3];
    Rgba result{0, 0, 0, alpha};
    for (std::size_t c = 0; c < 3 && alpha > 0; ++c)
        result[c] = (top[c] * top[3] + (1 - top[3]) * below[3] * below[c]) / alpha;
    return result;
}

/// The general formula of https://www.w3.org/TR/compositing-1/, in associated colours, and then not.
Rgba blended(const std::string& mode, const Rgba& top, const Rgba& below) {
    const double as = top[3], ab = below[3];
    Rgba result{0, 0, 0, as + ab - as * ab};
    for (std::size_t c = 0; c < 3 && result[3] > 0; ++c) {
        const double cs = top[c], cb = below[c];
        const double mixed = mode == "multiply" ? cs * cb
                             : mode == "screen" ? 1 - (1 - cs) * (1 - cb)
                                                : std::min(1.0, cs + cb);
        result[c] = (as * (1 - ab) * cs + as * ab * mixed + (1 - as) * ab * cb) / result[3];
    }
    return result;
}

/// Colours of transparent pixels do not count.
bool isNear(const Rgba& a, const Rgba& b, double tolerance = 1.6 / 255) {
    if (a[3] == 0 && b[3] == 0) return true;
    for (std::size_t c = 0; c < 4; ++c)
        if (std::abs(a[c] - b[c]) > tolerance) return false;
    return true;
}

constexpr Rgba kRed{1, 0, 0, 1}, kGreen{0, 1, 0, 1}, kBlue{0, 0, 1, 1}, kNothing{0, 0, 0, 0};

}  // namespace

class TestParts : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void projectsAreKept();
    void wrongProjects_data();
    void wrongProjects();
    void partsLieOverOneAnother();
    void partsBlend_data();
    void partsBlend();
    void blendedEdgesAreSoft();
    void layersBlendAsTheirFileSays();
    void orderChanges();
    void limbTurnsAtItsJoint();
    void ridersFollow();
    void cutsBecomeParts();
    void groundsAreFilled();
    void mattesAddUp();
    void mattesAreSoftWithinAShape();
    void limbsHangOnSeams();
    void layersAreWritten();
    void layersOfPhotoshop();
    void partsAreChannels();

  private:
    QString at(const QString& name) const { return m_folder.filePath(name); }
    LoadedProject project(const std::string& parts, const std::string& rest = "") const {
        return parseProject(R"({"format": "wend", "version": 1, "domain": {"vertices": 300, "parts": [)" +
                                parts + "]}" + rest + "}",
                            at("project.wend").toStdString());
    }
    QImage run(const LoadedProject& loaded, std::optional<double> time = {},
               const QString& name = "out.png") const {
        RunOptions options;
        options.outputs.image = {at(name).toStdString()};
        options.at = time;
        options.backEnd = BackEndKind::Cpu;
        const AdvanceResult result = runProject(*loaded.project, at("project.wend").toStdString(), options);
        if (result.outcome != Outcome::Done) qWarning("%s", result.message.text().c_str());
        return QImage(at(name));
    }

    QTemporaryDir m_folder;
};

/// A green board, a red bar, and a blue square of half opacity.
void TestParts::initTestCase() {
    const auto write = [&](const char* name, int width, int height, const std::vector<std::uint8_t>& colour) {
        writeImage(at(name).toStdString(), plainPicture(width, height, colour));
    };
    write("board.png", 80, 60, {0, 255, 0});
    write("bar.png", 50, 12, {255, 0, 0, 255});
    write("square.png", 16, 16, {0, 0, 255, 128});
}

void TestParts::projectsAreKept() {
    const std::string parts = R"(
        {"name": "arm", "image": "bar.png", "at": [10, 5.5], "opacity": 0.5, "hidden": true, "locked": true, "mood": 1, "blend": "screen",
         "outline": {"from": "alpha", "threshold": 0.25}, "vertices": 77,
         "order": [{"time": 0.25, "place": 3}, {"time": 0.5, "place": -1}],
         "joints": [{"to": "board", "at": [12, 8], "radius": 2, "of": "leather"}]},
        {"name": "eye", "layer": {"file": "face.ora", "name": "left eye"}, "ridesOn": "arm"},
        {"name": "board", "image": "board.png"},
        {"name": "hole", "cut": {"from": "board", "polygons": [[[1, 1], [9, 1], [9, 9]]], "feather": 2}})";
    const LoadedProject first = project(parts, R"(, "handles": [{"at": {"part": "arm", "points": [[12, 8]]}}],
                        "depth": [{"shape": {"circle": {"centre": [9, 9], "radius": 4}}, "order": 2, "part": "arm"}],
                        "material": {"regions": [{"shape": {"circle": {"centre": [9, 9], "radius": 4}}, "phi": 1,
                                                  "part": "arm"}]})");
    QVERIFY(domainOf(*first.project).parts.front().locked);
    QCOMPARE(depthOf(*first.project).front().regions.front().part, std::string("arm"));
    QCOMPARE(regionsIn(designOf(*first.project)).front().part, std::string("arm"));
    QCOMPARE(first.warnings.size(), std::size_t{2});  // mood, of
    const std::string text = toJson(*first.project);
    const LoadedProject second = parseProject(text, at("project.wend").toStdString());
    QVERIFY(domainOf(*first.project).parts == domainOf(*second.project).parts);
    QCOMPARE(designOf(*second.project).handles.front().part, std::string("arm"));
    QCOMPARE(toJson(*second.project), text);
    QVERIFY(text.find("\"mood\": 1") != std::string::npos && text.find("leather") != std::string::npos);
    QVERIFY(
        toJson(*parseProject(R"({"format": "wend", "version": 1, "domain": {"image": "a.png"}})", "a.wend")
                    .project)
            .find("parts") == std::string::npos);
}

void TestParts::wrongProjects_data() {
    QTest::addColumn<QString>("parts");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* name, const QString& parts, const QString& reason) {
        QTest::newRow(name) << parts << reason;
    };
    const QString a = R"({"name": "a", "image": "bar.png")";
    row("empty", "", "domain.parts: has no part");
    row("two sources", a + R"(, "cut": {"from": "a", "polygons": []}})", "domain.parts[0]");
    row("same name", a + "}," + a + "}", "domain.parts[1]: a part before it has the name \"a\", too");
    row("unknown joint", a + R"(, "joints": [{"to": "b", "at": [1, 1]}]})",
        "domain.parts[0]: `joints`: there is no part \"b\"");
    row("own joint", a + R"(, "joints": [{"to": "a", "at": [1, 1]}]})", "domain.parts[0]: `joints`");
    row("unknown host", a + R"(, "ridesOn": "b"})", "domain.parts[0]: `ridesOn`: there is no part \"b\"");
    row("riders only", a + R"(, "ridesOn": "b"}, {"name": "b", "image": "bar.png", "ridesOn": "a"})",
        "domain.parts[0]: `ridesOn` leads back to the part \"a\"");
    row("cut of itself", R"({"name": "a", "cut": {"from": "a", "polygons": [[[0, 0], [9, 0], [9, 9]]]}})",
        "domain.parts[0]: `cut` leads back to the part \"a\"");
    row("joint of a rider",
        a + R"(, "ridesOn": "b", "joints": [{"to": "b", "at": [1, 1]}]}, {"name": "b", "image": "bar.png"})",
        "domain.parts[0]: `joints`: \"a\" rides on another part and has no mesh");
    row("order of times", a + R"(, "order": [{"time": 1, "place": 1}, {"time": 1, "place": 2}]})",
        "domain.parts[0].order[1]");
    row("opacity", a + R"(, "opacity": 1.5})", "domain.parts[0].opacity: must be in [0, 1]");
    row("blend mode", a + R"(, "blend": "dodge"})",
        "domain.parts[0].blend: must be \"normal\", \"multiply\"");
    row("handle of no part",
        a + R"(}]}, "handles": [{"name": "h", "at": {"part": "b", "points": [[1, 1]]}}], "with": {"more": [{"x": 1})",
        "handle \"h\": there is no part \"b\"");
    row("joint outside",
        a + R"(, "joints": [{"to": "b", "at": [70, 30]}]}, {"name": "b", "image": "board.png"})",
        "domain.parts[0].joints[0]: point (70, 30) lies outside the part \"a\"");
}

void TestParts::wrongProjects() {
    QFETCH(QString, parts);
    QFETCH(QString, reason);
    try {
        run(project(parts.toStdString()));
        QFAIL("accepted");
    } catch (const InputError& error) {
        QVERIFY2(QString::fromStdString(error.reason()).startsWith(reason), error.what());
    }
}

/// At rest the picture is the sheets over one another, pixel by pixel, by Porter and Duff's formula.
void TestParts::partsLieOverOneAnother() {
    const QImage image = run(project(R"({"name": "square", "image": "square.png", "at": [20, 10]},
                                        {"name": "bar", "image": "bar.png", "at": [4, 14], "opacity": 0.75},
                                        {"name": "board", "image": "board.png"})"));
    QCOMPARE(image.size(), QSize(80, 60));
    const Rgba blue{0, 0, 1, 128 / 255.0}, red{1, 0, 0, 0.75};
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) {
            Rgba expected = kGreen;
            if (x >= 4 && x < 54 && y >= 14 && y < 26) expected = over(red, expected);
            if (x >= 20 && x < 36 && y >= 10 && y < 26) expected = over(blue, expected);
            QVERIFY2(isNear(pixelOf(image, x, y), expected), qPrintable(QString("%1 %2").arg(x).arg(y)));
        }
}

void TestParts::partsBlend_data() {
    QTest::addColumn<QString>("mode");
    for (const char* mode : {"multiply", "screen", "add"}) QTest::newRow(mode) << mode;
}

/// Of sheets of several colours and opacities the upper two blend, over an opaque one, a half transparent
/// one, and nothing.
void TestParts::partsBlend() {
    QFETCH(QString, mode);
    const auto write = [&](const char* name, int width, int height, const std::vector<std::uint8_t>& colour) {
        writeImage(at(name).toStdString(), plainPicture(width, height, colour));
    };
    write("top.png", 30, 30, {200, 90, 30, 255});
    write("middle.png", 40, 20, {120, 160, 240, 150});
    write("half.png", 40, 40, {90, 220, 60, 100});
    write("full.png", 20, 60, {140, 70, 200, 255});
    const QString parts =
        R"({"name": "top", "image": "top.png", "at": [10, 6], "blend": "%1", "opacity": 0.6},
                             {"name": "middle", "image": "middle.png", "at": [4, 14], "blend": "%1"},
                             {"name": "half", "image": "half.png", "at": [16, 2]},
                             {"name": "full", "image": "full.png", "at": [24, 0]})";
    const QImage image = run(project(parts.arg(mode).toStdString()));
    const Rgba top{200 / 255.0, 90 / 255.0, 30 / 255.0, 0.6},
        middle{120 / 255.0, 160 / 255.0, 240 / 255.0, 150 / 255.0},
        thin{90 / 255.0, 220 / 255.0, 60 / 255.0, 100 / 255.0}, full{140 / 255.0, 70 / 255.0, 200 / 255.0, 1};
    const std::string name = mode.toStdString();
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            Rgba expected = x >= 24 && x < 44 ? full : kNothing;
            if (x >= 16 && x < 56 && y >= 2 && y < 42) expected = over(thin, expected);
            if (x >= 4 && x < 44 && y >= 14 && y < 34) expected = blended(name, middle, expected);
            if (x >= 10 && x < 40 && y >= 6 && y < 36) expected = blended(name, top, expected);
            QVERIFY2(isNear(pixelOf(image, x, y), expected, 3.5 / 255),
                     qPrintable(QString("%1 %2").arg(x).arg(y)));
        }
    const QImage plain = run(project(parts.arg("normal").toStdString()));
    QVERIFY(isNear(pixelOf(plain, 30, 20), over(top, over(middle, over(thin, full)))));
}

/// An opaque sheet whose edge halves a pixel is blended at half strength there.
void TestParts::blendedEdgesAreSoft() {
    const QImage image =
        run(project(R"({"name": "bar", "image": "bar.png", "at": [4, 14.5], "blend": "multiply"},
                                        {"name": "board", "image": "board.png"})"));
    QVERIFY(isNear(pixelOf(image, 20, 20), {0, 0, 0, 1}));
    QVERIFY(isNear(pixelOf(image, 20, 14), {0, 0.5, 0, 1}));
    QVERIFY(isNear(pixelOf(image, 20, 26), {0, 0.5, 0, 1}));
    QVERIFY(isNear(pixelOf(image, 20, 27), kGreen));
}

/// A layer has the mode of its file unless the project overrides it; exported files record it.
void TestParts::layersBlendAsTheirFileSays() {
    writeOpenRaster(
        at("shade.ora").toStdString(),
        {{"shade", plainPicture(40, 30, {128, 128, 128, 255}), 10, 10, 1, true, BlendMode::Multiply},
         {"ground", plainPicture(80, 60, {200, 100, 50, 255})}},
        plainPicture(80, 60, {0, 0, 0, 255}));
    const auto parts = [](const char* more) {
        return R"({"layer": {"file": "shade.ora", "name": "shade"})" + std::string(more) +
               R"(}, {"layer": {"file": "shade.ora", "name": "ground"}})";
    };
    const Rgba dark{100 / 255.0, 50 / 255.0, 25 / 255.0, 1}, grey{128 / 255.0, 128 / 255.0, 128 / 255.0, 1};
    QVERIFY(isNear(pixelOf(run(project(parts(""))), 20, 20), dark));
    QVERIFY(isNear(pixelOf(run(project(parts(R"(, "blend": "normal")"))), 20, 20), grey));
    run(project(parts(R"(, "blend": "add")")), {}, "shade-out.ora");
    const Image written = readImageHeader(at("shade-out.ora").toStdString());
    const auto& layers = fileMetadata(written)->layers;
    QCOMPARE(layers.at(0).blend, std::string("plus"));
    QCOMPARE(layers.at(1).blend, std::string("src-over"));
    const Image merged = readImage(at("shade-out.ora").toStdString());
    QCOMPARE(std::to_integer<int>(merged.row(20)[merged.pixelBytes() * 20]), 255);  // 200 + 128
}

void TestParts::orderChanges() {
    const LoadedProject loaded = project(R"({"name": "bar", "image": "bar.png", "at": [4, 14],
                                             "order": [{"time": 0.5, "place": 5}]},
                                            {"name": "board", "image": "board.png"})");
    QVERIFY(isNear(pixelOf(run(loaded, 0.0), 30, 20), kRed));
    QVERIFY(isNear(pixelOf(run(loaded, 0.49), 30, 20), kRed));
    QVERIFY(isNear(pixelOf(run(loaded, 0.5), 30, 20), kGreen));
    QVERIFY(isNear(pixelOf(run(loaded), 30, 20), kGreen));
}

/// A bar is pinned by a joint at its left end and rotated down by its right one: its pixels follow a rigid
/// rotation, and the board stays.
void TestParts::limbTurnsAtItsJoint() {
    const LoadedProject loaded = project(
        R"({"name": "bar", "image": "bar.png", "at": [10, 14], "joints": [{"to": "board", "at": [14, 20]}]},
           {"name": "board", "image": "board.png"})",
        R"(, "handles": [
            {"at": {"part": "board", "points": [[5, 5], [70, 50]]}},
            {"at": {"points": [[56, 20]]}, "motion": [{"kind": "rotate", "centre": [14, 20], "angle": 0.7}]}],
            "integration": {"tolerance": 1e-6})");
    const QImage image = run(loaded);
    int inside = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) {
            const Vec2 p = Vec2(14, 20) + Eigen::Rotation2Dd(-0.7) * (Vec2(x + 0.5, y + 0.5) - Vec2(14, 20));
            const double border = std::max({10 - p.x(), p.x() - 60, 14 - p.y(), p.y() - 26});
            if (std::abs(border) < 1.5) continue;
            inside += border < 0;
            QVERIFY2(isNear(pixelOf(image, x, y), border < 0 ? kRed : kGreen),
                     qPrintable(QString("%1 %2").arg(x).arg(y)));
        }
    QVERIFY(inside > 300);
}

/// An embedded part follows its host, even where it reaches beyond it.
void TestParts::ridersFollow() {
    const LoadedProject loaded = project(
        R"({"name": "square", "image": "square.png", "at": [20, 8], "ridesOn": "bar"},
           {"name": "bar", "image": "bar.png", "at": [10, 14]},
           {"name": "board", "image": "board.png", "hidden": true})",
        R"(, "handles": [{"at": {"part": "bar", "points": [[12, 20], [56, 20]]},
                          "motion": [{"kind": "translate", "by": [8, 20]}]}])");
    const QImage image = run(loaded);
    const Rgba blue{0, 0, 1, 128 / 255.0};
    QVERIFY(isNear(pixelOf(image, 36, 30), blue));              // above the bar
    QVERIFY(isNear(pixelOf(image, 36, 40), over(blue, kRed)));  // on it
    QVERIFY(isNear(pixelOf(image, 60, 40), kRed));
    QVERIFY(isNear(pixelOf(image, 28, 10), kNothing));  // where it was
}

/// A cut is invisible at rest, whatever its feather; once moved, it leaves a hole.
void TestParts::cutsBecomeParts() {
    const std::string parts = R"({"name": "piece", "cut": {"from": "board", "feather": 3,
                                  "polygons": [[[20, 20], [50, 20], [50, 40], [20, 40]]]}},
                                 {"name": "board", "image": "board.png"})";
    const QImage rest = run(project(parts));
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x)
            QVERIFY2(isNear(pixelOf(rest, x, y), kGreen), qPrintable(QString("%1 %2").arg(x).arg(y)));
    const QImage moved = run(project(parts, R"(, "handles": [
        {"at": {"part": "board", "points": [[2, 2], [78, 58]]}},
        {"at": {"part": "piece", "points": [[25, 30], [45, 30]]}, "motion": [{"kind": "translate", "by": [200, 0]}]}])"));
    QVERIFY(isNear(pixelOf(moved, 35, 30), kNothing));
    QVERIFY(isNear(pixelOf(moved, 10, 30), kGreen));
}

/// A blue disc is in front of stripes. At rest the cut is invisible; when the disc has moved, the ground is
/// striped as around it, without a hole and without blue.
void TestParts::groundsAreFilled() {
    if (!canInpaint()) QSKIP("gmic is not installed");
    constexpr int kSize = 96;
    const auto isDisc = [](int x, int y) { return std::hypot(x - 47.5, y - 47.5) < 14; };
    const auto striped = [&](int x, int y, bool withDisc) {
        if (withDisc && isDisc(x, y)) return std::array<std::uint8_t, 3>{20, 40, 230};
        return y / 8 % 2 == 0 ? std::array<std::uint8_t, 3>{240, 220, 60}
                              : std::array<std::uint8_t, 3>{120, 60, 20};
    };
    Image picture = plainPicture(kSize, kSize, {0, 0, 0});
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            std::ranges::copy(striped(x, y, true), reinterpret_cast<std::uint8_t*>(picture.row(y)) + 3 * x);
    writeImage(at("stripes.png").toStdString(), picture);
    std::string corners;
    for (int k = 0; k < 24; ++k) {
        const double angle = 2 * std::numbers::pi * k / 24;
        corners += (k > 0 ? ", [" : "[") + std::to_string(48 + 18 * std::cos(angle)) + ", " +
                   std::to_string(48 + 18 * std::sin(angle)) + "]";
    }
    const std::string parts =
        R"({"name": "disc", "cut": {"from": "stripes", "feather": 3, "fill": true, "polygons": [[)" +
        corners + R"(]]}}, {"name": "stripes", "image": "stripes.png"})";
    const QImage rest = run(project(parts));
    const auto expected = [&](int x, int y, bool withDisc) {
        const auto c = striped(x, y, withDisc);
        return Rgba{c[0] / 255.0, c[1] / 255.0, c[2] / 255.0, 1};
    };
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            QVERIFY2(isNear(pixelOf(rest, x, y), expected(x, y, true), 2.6 / 255),
                     qPrintable(QString("%1 %2").arg(x).arg(y)));
    const QImage moved = run(project(parts, R"(, "handles": [
        {"at": {"part": "stripes", "points": [[2, 2], [90, 90]]}},
        {"at": {"part": "disc", "points": [[42, 48], [54, 48]]}, "motion": [{"kind": "translate", "by": [300, 0]}]}])"));
    int wrong = 0;
    for (int y = 28; y < 68; ++y)
        for (int x = 28; x < 68; ++x) {
            QCOMPARE(moved.pixelColor(x, y).alpha(), 255);
            QVERIFY(moved.pixelColor(x, y).blue() < 150);
            wrong += !isNear(pixelOf(moved, x, y), expected(x, y, false), 0.2);
        }
    // Of a hole of 18² π pixels, one colour would have half wrong.
    QVERIFY2(wrong < 18 * 18 * 3.14 / 4, qPrintable(QString::number(wrong)));
}

/// C = T + (1 − t) G for random pictures, grounds and shares; T is a colour, and has its share at least.
void TestParts::mattesAddUp() {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0, 1);
    Image picture = plainPicture(64, 64, {0, 0, 0, 0});
    picture.type = PixelType::Float, picture.unassociated = false;
    picture.makePixels();
    Image ground = picture;
    std::vector<float> share(64 * 64);
    const auto at = [](const Image& image, std::size_t i) {
        return reinterpret_cast<const float*>(image.data.data()) + 4 * i;
    };
    const auto fill = [&](Image& image, std::size_t i, bool opaque) {
        float* pixel = const_cast<float*>(at(image, i));
        pixel[3] = opaque ? 1 : unit(random);
        for (int c = 0; c < 3; ++c) pixel[c] = pixel[3] * unit(random);
    };
    for (std::size_t i = 0; i < share.size(); ++i) {
        fill(picture, i, i % 2 == 0);
        fill(ground, i, true);
        share[i] = i % 5 == 0 ? 0 : i % 5 == 1 ? 1 : unit(random);
    }
    const Matte matte = separated(picture, ground, share);
    for (std::size_t i = 0; i < share.size(); ++i) {
        const float *whole = at(picture, i), *top = at(matte.top, i), *below = at(matte.ground, i);
        QVERIFY(top[3] >= share[i] * whole[3] - 1e-6F && top[3] <= 1);
        // Where the picture is not opaque, its alpha is kept exactly, and colours as far as they are defined.
        for (int c = 3; c >= (i % 2 == 0 ? 0 : 3); --c) {
            QVERIFY(top[c] >= 0 && top[c] <= top[3] + 1e-5F);
            QVERIFY(std::abs(top[c] + (1 - top[3]) * below[c] - whole[c]) < 1e-5F);
        }
    }
}

/// A cut across something bright in front of a dark ground has a soft edge, although only white with full
/// alpha gives white over black; a little of it stays in the ground.
void TestParts::mattesAreSoftWithinAShape() {
    constexpr int kWide = 9;
    Image picture = plainPicture(kWide, 1, {0, 0, 0, 0});
    picture.type = PixelType::Float, picture.unassociated = false;
    picture.makePixels();
    Image ground = picture;
    std::vector<float> share;
    for (int x = 0; x < kWide; ++x) {
        float* pixel = reinterpret_cast<float*>(picture.data.data()) + 4 * x;
        std::fill_n(pixel, 4, 1.0F);
        reinterpret_cast<float*>(ground.data.data())[4 * x + 3] = 1;
        share.push_back(static_cast<float>(x) / (kWide - 1));
    }
    const Matte matte = separated(picture, ground, share);
    for (int x = 0; x < kWide; ++x) {
        const float* top = reinterpret_cast<const float*>(matte.top.data.data()) + 4 * x;
        const float* below = reinterpret_cast<const float*>(matte.ground.data.data()) + 4 * x;
        QVERIFY(std::abs(top[3] - std::min(1.0F, 2 * share[static_cast<std::size_t>(x)])) < 1e-6F);
        QVERIFY(std::abs(top[0] + (1 - top[3]) * below[0] - 1) < 1e-6F);
        QVERIFY(x <= kWide / 2 ? below[0] == 1 || top[3] == 1 : below[0] == 0);
    }
}

/// A bar on a block is attached at its end; the middle of the block is attached to nothing in particular.
void TestParts::limbsHangOnSeams() {
    Image picture = plainPicture(100, 60, {0, 0, 0, 0});
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 100; ++x)
            if (x < 40 || (x < 90 && y >= 20 && y < 32)) picture.row(y)[4 * x + 3] = std::byte(255);
    const Sheet sheet{std::make_shared<const Image>(picture)};
    const auto box = [](double x, double y, double right, double bottom) {
        return Outline{{{{x, y}, {right, y}, {right, bottom}, {x, bottom}}}};
    };
    const auto seam = seamOf(box(44, 10, 96, 44), sheet);
    QVERIFY(seam);
    QVERIFY2((seam->middle - Vec2(44, 26)).norm() < 1, qPrintable(QString::number(seam->middle.y())));
    QVERIFY(std::abs(seam->radius - 6) < 1);
    QVERIFY(!seamOf(box(5, 5, 30, 30), sheet));
    const Outline capped = withCap(box(44, 10, 96, 44), *seam);
    QVERIFY(isInside(capped, {40, 26}) && !isInside(capped, {40, 33}));
    QVERIFY(std::abs(coveredArea(box(44, 10, 96, 44), sheet) - 46 * 12) < 40);
}

/// Each layer is a part in its moved place; all of them over one another are the flat picture.
void TestParts::layersAreWritten() {
    const LoadedProject loaded = project(
        R"({"name": "square <1>", "image": "square.png", "at": [20, 8], "opacity": 0.5},
           {"name": "bar", "image": "bar.png", "at": [10, 14], "hidden": true, "opacity": 0.3},
           {"name": "board", "image": "board.png"})",
        R"(, "handles": [{"at": {"part": "square <1>", "points": [[22, 10], [34, 22]]},
                          "motion": [{"kind": "translate", "by": [30, 20]}]}])");
    writeOpenRaster(
        at("twins.ora").toStdString(),
        {{"hand", plainPicture(4, 3, {9, 9, 9, 255})}, {"hand", plainPicture(5, 3, {9, 9, 9, 255})}},
        plainPicture(5, 3, {9, 9, 9, 255}));
    QCOMPARE(readLayer(at("twins.ora").toStdString(), "hand (2)").width, 5);  // equal names are told apart
    run(loaded, {}, "out.ora");
    const QImage flat = run(loaded);
    QProcess python;
    python.start("python3", {"-m", "zipfile", "-e", at("out.ora"), at("out")});
    QVERIFY(python.waitForFinished() && python.exitCode() == 0);
    QFile archive(at("out.ora")), stack(at("out/stack.xml")), kind(at("out/mimetype"));
    QVERIFY(archive.open(QIODevice::ReadOnly) && stack.open(QIODevice::ReadOnly) &&
            kind.open(QIODevice::ReadOnly));
    QCOMPARE(kind.readAll(), QByteArray("image/openraster"));
    QCOMPARE(archive.read(54).mid(30), QByteArray("mimetypeimage/openraster"));  // first, and not packed
    QXmlStreamReader xml(&stack);
    QStringList names;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement || xml.name() != u"layer") continue;
        const auto attributes = xml.attributes();
        names << attributes.value("name").toString();
        const QImage layer(at("out/" + attributes.value("src").toString()));
        QVERIFY(!layer.isNull());
        const QPoint place(attributes.value("x").toInt(), attributes.value("y").toInt());
        if (names.size() == 1) {
            QVERIFY(isNear(pixelOf(layer, 58 - place.x(), 36 - place.y()), {0, 0, 1, 128 / 255.0}));
            QVERIFY(layer.width() < 25 && layer.height() < 25);
        }
        QCOMPARE(attributes.value("opacity"), QStringList({"0.5", "0.3", "1"})[names.size() - 1]);
        QCOMPARE(attributes.value("visibility") == u"hidden", names.size() == 2);
    }
    QVERIFY(!xml.hasError());
    QCOMPARE(names, (QStringList{"square <1>", "bar", "board"}));
    const QImage merged(at("out/mergedimage.png"));
    QCOMPARE(merged.convertToFormat(QImage::Format_RGBA8888), flat.convertToFormat(QImage::Format_RGBA8888));
    QVERIFY(!QImage(at("out/Thumbnails/thumbnail.png")).isNull());
}

/// Layers equal those of an OpenRaster file, and the part's own export, to the bit.
void TestParts::layersOfPhotoshop() {
    const char* const motion = R"(, "handles": [{"at": {"part": "square", "points": [[22, 10], [34, 22]]},
        "motion": [{"kind": "rotate", "centre": [40, 30], "angle": 1.5}]}])";
    const auto parts = [](const char* ofSquare, const char* ofBar, const char* ofBoard) {
        return QString(R"({"name": "square", "image": "square.png", "at": [20, 8]%1},
                          {"name": "bar", "image": "bar.png", "at": [10, 14]%2},
                          {"name": "board", "image": "board.png"%3})")
            .arg(ofSquare, ofBar, ofBoard)
            .toStdString();
    };
    const char* const faint = R"(, "opacity": 0.5)";
    const LoadedProject loaded = project(parts("", R"(, "opacity": 0.5, "blend": "screen")", faint), motion);
    RunOptions options;
    options.outputs.image = {at("out.psd").toStdString(), at("same.ora").toStdString(),
                             at("flat.png").toStdString()};
    options.backEnd = BackEndKind::Cpu;
    std::vector<std::string> told;
    RunWatch watch;
    watch.notice = [&](const Message& text) { told.push_back(text.text()); };
    QVERIFY(runProject(*loaded.project, at("project.wend").toStdString(), options, watch).outcome ==
            Outcome::Done);
    QVERIFY(told.empty());
    const auto& [written, other, flat] =
        std::tie(options.outputs.image[0], options.outputs.image[1], options.outputs.image[2]);
    const auto layers = fileMetadata(readImageHeader(written))->layers;
    const auto others = fileMetadata(readImageHeader(other))->layers;
    QCOMPARE(layers.size(), std::size_t(3));
    for (std::size_t k = 0; k < 3; ++k) {
        const PictureLayer& same = others[2 - k];
        QCOMPARE(layers[k].name, same.name);
        QCOMPARE(QPoint(layers[k].x, layers[k].y), QPoint(same.x, same.y));
        QVERIFY(std::abs(layers[k].opacity - same.opacity) < 0.5 / 255);
        QCOMPARE(layers[k].blend, std::string(k == 1 ? "screen" : "normal"));
        const PixelLayout layout{PixelType::UInt8, 4, true, true};
        QCOMPARE(converted(readLayer(written, layers[k].name), layout).data,
                 converted(readLayer(other, layers[k].name), layout).data);
    }
    const PixelLayout onWhite{PixelType::UInt8, 3, false, false};
    const Image seen = converted(readImage(written), onWhite), expected = converted(readImage(flat), onWhite);
    QCOMPARE(seen.data.size(), expected.data.size());
    for (std::size_t k = 0; k < seen.data.size(); ++k)
        QVERIFY(std::abs(std::to_integer<int>(seen.data[k]) - std::to_integer<int>(expected.data[k])) <= 1);
    const char* const hidden = R"(, "hidden": true)";
    const QImage alone = run(project(parts("", hidden, hidden), motion));
    const Image square = readLayer(written, "square");
    for (int y = 0; y < alone.height(); ++y)
        for (int x = 0; x < alone.width(); ++x) {
            const int i = x - layers[2].x, j = y - layers[2].y;
            const bool isIn = i >= 0 && j >= 0 && i < square.width && j < square.height;
            const auto value = [&](std::size_t c) {
                return std::to_integer<int>(square.row(j)[4 * static_cast<std::size_t>(i) + c]);
            };
            QCOMPARE(qAlpha(alone.pixel(x, y)), isIn ? value(3) : 0);
            if (isIn && value(3) > 0)
                QCOMPARE(alone.pixelColor(x, y), QColor(value(0), value(1), value(2), value(3)));
        }
    options.outputs.image.resize(1);
    options.depth = PixelType::UInt16;
    QCOMPARE(runProject(*loaded.project, at("project.wend").toStdString(), options).outcome, Outcome::Done);
    QCOMPARE(readLayer(written, "bar").type, PixelType::UInt16);
    options.depth = PixelType::Half;
    QVERIFY_EXCEPTION_THROWN(runProject(*loaded.project, at("project.wend").toStdString(), options),
                             InputError);
    RunOptions frames;
    frames.outputs.frames = {at("f_##.psd").toStdString()};
    QVERIFY_EXCEPTION_THROWN(requirePossible(*loaded.project, frames.outputs), InputError);
}

/// An EXR file has each part's picture and map at its place in the pose, complete even where another part
/// covers it.
void TestParts::partsAreChannels() {
    const LoadedProject loaded = project(
        R"({"name": "bar", "image": "bar.png", "at": [10, 14]}, {"name": "board", "image": "board.png"})",
        R"(, "handles": [{"at": {"part": "board", "points": [[5, 5], [70, 50]]}},
            {"at": {"part": "bar", "points": [[12, 20], [56, 20]]},
             "motion": [{"kind": "translate", "by": [8, 20]}]}])");
    RunOptions options;
    options.outputs.image = {at("parts.exr").toStdString()};
    options.outputs.stMap = {at("map.exr").toStdString()};
    options.backEnd = BackEndKind::Cpu;
    QCOMPARE(runProject(*loaded.project, at("project.wend").toStdString(), options).outcome, Outcome::Done);
    const auto value = [&](const char* file, const std::string& channel, int x, int y) {
        const auto input = OIIO::ImageInput::open(at(file).toStdString());
        const OIIO::ImageSpec spec = input->spec();
        std::vector<float> pixels(static_cast<std::size_t>(spec.width * spec.height * spec.nchannels));
        input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data());
        const auto found = std::ranges::find(spec.channelnames, channel);
        if (found == spec.channelnames.end()) return -1.0F;
        const auto pixel = static_cast<std::size_t>(y * spec.width + x);
        return pixels[pixel * static_cast<std::size_t>(spec.nchannels) +
                      static_cast<std::size_t>(found - spec.channelnames.begin())];
    };
    QCOMPARE(value("parts.exr", "R", 40, 40), 1.0F);
    QCOMPARE(value("parts.exr", "G", 40, 40), 0.0F);
    QCOMPARE(value("parts.exr", "board.G", 40, 40), 1.0F);  // behind the bar
    QCOMPARE(value("parts.exr", "bar.A", 40, 40), 1.0F);
    QCOMPARE(value("parts.exr", "bar.A", 40, 20), 0.0F);
    const auto isNearTo = [](float a, double b) { return std::abs(static_cast<double>(a) - b) < 1e-5; };
    for (const char* channel : {"R", "bar.R"})
        QVERIFY(isNearTo(value("map.exr", channel, 40, 40), 32.5 / 80));
    QVERIFY(isNearTo(value("map.exr", "bar.G", 40, 40), 1 - 20.5 / 60));
    QVERIFY(isNearTo(value("map.exr", "board.R", 40, 40), 40.5 / 80));
    QVERIFY(isNearTo(value("map.exr", "board.A", 2, 2), 1));
}

QTEST_GUILESS_MAIN(TestParts)
#include "test_parts.moc"
