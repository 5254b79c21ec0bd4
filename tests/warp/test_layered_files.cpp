// Files with layers are opened as the picture of all of them. tests/data/pictures/make.py has written them.

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

#include "core/base/error.h"
#include "warp/image.h"
#include "warp/krita_pixels.h"
#include "warp/open_raster.h"
#include "warp/picture_metadata.h"

using namespace wend;

namespace {

constexpr int kWidth = 8, kHeight = 6;

std::string given(const QString& name) {
    return (QStringLiteral(WEND_SOURCE_DIR "/tests/data/pictures/") + name).toStdString();
}

/// Returns the pixel that the script has written.
std::array<int, 4> pixel(int x, int y) {
    return {20 * x + 5, 40 * y + 3, 7 * x * y, 255 - 30 * x};
}

int sample(const Image& image, int x, int y, int c) {
    const std::byte* at = image.row(y) + image.pixelBytes() * static_cast<std::size_t>(x);
    if (image.type == PixelType::UInt8) return std::to_integer<int>(at[c]);
    return reinterpret_cast<const std::uint16_t*>(at)[c];
}

}  // namespace

class TestLayeredFiles : public QObject {
    Q_OBJECT

  private slots:
    void pictureOfAllLayers_data();
    void pictureOfAllLayers();
    void layersAreListed_data();
    void layersAreListed();
    void layersAreRead_data();
    void layersAreRead();
    void masksAreApplied();
    void masksOfGroupsAreApplied();
    void greyLayers();
    void pagesAreFlattened();
    void groupsAreLayers();
    void drawingsAreComposited();
    void blursAreDrawn();
    void usedLayersAreComposited();
    void drawingsAreClippedByBoxes();
    void clipsAreNotDrawn();
    void damagedDrawings();
    void layersOfOtherKinds();
    void lzf();
    void damagedTiles();
    void impossibleOpacities();
    void damagedFiles_data();
    void damagedFiles();

  private:
    static QByteArray contents(const QString& name) {
        QFile file(QString::fromStdString(given(name)));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    std::string written(const QString& name, const QByteArray& text) const {
        QFile file(m_folder.filePath(name));
        if (file.open(QIODevice::WriteOnly)) file.write(text);
        return file.fileName().toStdString();
    }
    QTemporaryDir m_folder;
};

void TestLayeredFiles::pictureOfAllLayers_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("layers");
    QTest::addColumn<bool>("exact");
    QTest::newRow("OpenRaster") << "layers.ora" << 3 << true;
    QTest::newRow("Krita") << "layers.kra" << 5 << true;
    QTest::newRow("Photoshop") << "layers.psd" << 3 << false;
    QTest::newRow("Photoshop, 16 bits") << "layers16.psd" << 3 << false;
    QTest::newRow("Photoshop, large, opaque") << "layers.psb" << 3 << true;
}

/// A Photoshop file has transparent colours over white, rounded: with the white removed they are within a
/// step of 255 / alpha of the originals.
void TestLayeredFiles::pictureOfAllLayers() {
    QFETCH(QString, name);
    QFETCH(int, layers);
    QFETCH(bool, exact);
    std::vector<Message> notices;
    const Image image = readImage(given(name), kMaxMegapixels, &notices);
    QCOMPARE(std::pair(image.width, image.height), std::pair(kWidth, kHeight));
    QCOMPARE(image.type, name.contains("16") ? PixelType::UInt16 : PixelType::UInt8);
    QVERIFY(image.channels == 3 || (image.alpha && image.unassociated));
    const int scale = image.type == PixelType::UInt8 ? 1 : 257;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            for (int c = 0; c < image.channels; ++c) {
                const auto colour = pixel(x, y);
                const double step = exact || c == 3 ? 0 : 1.0 + 255.0 / colour[3];
                const int expected = scale * colour[static_cast<std::size_t>(c)], is = sample(image, x, y, c);
                QVERIFY2(
                    std::abs(is - expected) <= step,
                    qPrintable(QString("%1 %2 %3: %4, not %5").arg(x).arg(y).arg(c).arg(is).arg(expected)));
            }
    QCOMPARE(notices.size(), std::size_t(1));
    QCOMPARE(
        QString::fromStdString(notices[0]),
        QString("%1: has %2 layers: opened flattened").arg(QString::fromStdString(given(name))).arg(layers));
}

void TestLayeredFiles::layersAreListed_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QStringList>("layers");
    const QStringList photoshop{"Körper 0 0 8 6 1 normal shown", "masked 0 0 8 6 1 plus shown clipped",
                                "arm -2 1 4 3 0.2 multiply hidden"};
    QTest::newRow("OpenRaster") << "layers.ora"
                                << QStringList{"head 3 1 4 3 0.5 multiply shown",
                                               "arm & hand -2 0 4 3 1 normal hidden",
                                               "Körper 0 0 8 6 1 normal shown"};
    QTest::newRow("Krita") << "layers.kra"
                           << QStringList{
                                  "words 0 0 0 0 1 normal shown: is a vector layer",
                                  "arm -2 -1 4 3 0.2 multiply hidden: its filter mask",
                                  "ink 0 0 0 0 1 normal shown: has colours of the kind CMYKA, not RGB or "
                                  "grey of 8 or 16 bits",
                                  "masked 0 0 8 6 1 add shown clipped", "Körper 0 0 8 6 1 normal shown"};
    QTest::newRow("TIFF") << "layers.tif" << QStringList{"Körper 0 0 8 6 1  shown", "arm 5 4 4 3 1  shown"};
    QTest::newRow("TIFF of pages without names") << "pages.tif" << QStringList{};
    for (const char* name : {"layers.psd", "layers16.psd", "layers.psb"})
        QTest::newRow(name) << name << photoshop;
}

/// Groups are not listed.
void TestLayeredFiles::layersAreListed() {
    QFETCH(QString, name);
    QFETCH(QStringList, layers);
    const Image image = readImage(given(name));
    QStringList found;
    for (const PictureLayer& layer : fileMetadata(image)->layers) {
        QStringList also;
        if (!layer.unread.empty()) also << QString::fromStdString(layer.unread);
        for (const std::string& what : layer.leftOut) also << QString::fromStdString(what);
        found << QString("%1 %2 %3 %4 %5 %6 %7 %8")
                         .arg(QString::fromStdString(layer.name))
                         .arg(layer.x)
                         .arg(layer.y)
                         .arg(layer.width)
                         .arg(layer.height)
                         .arg(layer.opacity)
                         .arg(QString::fromStdString(layer.blend))
                         .arg(layer.visible ? "shown" : "hidden") +
                     (layer.clipped ? " clipped" : "") + (also.empty() ? "" : ": " + also.join(", "));
    }
    QCOMPARE(found, layers);
}

void TestLayeredFiles::layersAreRead_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("layer");
    QTest::addColumn<int>("scale");
    QTest::newRow("OpenRaster") << "layers.ora"
                                << "arm & hand" << 1;
    QTest::newRow("Krita") << "layers.kra"
                           << "arm" << 1;
    QTest::newRow("Krita, 16 bits") << "layers16.kra"
                                    << "arm" << 257;
    QTest::newRow("Krita, written by itself") << "by_krita.kra"
                                              << "arm & hand" << 1;
    QTest::newRow("TIFF") << "layers.tif"
                          << "arm" << 1;
    QTest::newRow("Photoshop, runs") << "layers.psd"
                                     << "arm" << 1;
    QTest::newRow("Photoshop, zip") << "layers16.psd"
                                    << "arm" << 257;
    QTest::newRow("Photoshop, large") << "layers.psb"
                                      << "arm" << 1;
}

/// Every layer has the script's pixels, as they are in the file.
void TestLayeredFiles::layersAreRead() {
    QFETCH(QString, name);
    QFETCH(QString, layer);
    QFETCH(int, scale);
    const Image image = readLayer(given(name), layer.toStdString());
    const bool isWhole = name == "by_krita.kra";  // all of a tile
    QCOMPARE(QSize(image.width, image.height), isWhole ? QSize(64, 64) : QSize(4, 3));
    QCOMPARE(image.channels, 4);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 4; ++c) {
                const bool isInside = x < 4 && y < 3;
                QCOMPARE(sample(image, x, y, c), isInside ? scale * pixel(x, y)[std::size_t(c)] : 0);
            }
    const Image ground = readLayer(given(name), "Körper");
    QCOMPARE(QSize(ground.width, ground.height), isWhole ? QSize(64, 64) : QSize(kWidth, kHeight));
    const auto reasonFor = [&](const std::string& file, const std::string& one) {
        try {
            readLayer(file, one);
        } catch (const InputError& error) {
            return QString::fromStdString(error.reason());
        }
        return QString();
    };
    QCOMPARE(reasonFor(given(name), "tail"), QString("has no layer \"tail\""));
}

/// The same mask, on a group, applies to all its layers.
void TestLayeredFiles::masksOfGroupsAreApplied() {
    for (const char* name : {"masked_group.psd", "masked_group16.psd"})
        for (const auto& [layer, left, top] :
             {std::tuple("masked", 0, 0), {"Körper", 0, 0}, {"arm", -2, 1}}) {
            const Image image = readLayer(given(name), layer);
            const int scale = image.type == PixelType::UInt8 ? 1 : 257;
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x) {
                    const int column = x + left, row = y + top;
                    const bool isMasked = column >= 1 && column < 3 && row >= 0 && row < 3;
                    const double factor = isMasked ? 51 * (column - 1) / 255.0 : 1;
                    QVERIFY(std::abs(sample(image, x, y, 3) - factor * pixel(x, y)[3] * scale) <= 0.51);
                    QCOMPARE(sample(image, x, y, 1), scale * pixel(x, y)[1]);
                }
            const Image whole = readImage(given(name));
            for (const PictureLayer& one : fileMetadata(whole)->layers) QVERIFY(one.leftOut.empty());
        }
}

/// Both have the numbers 51 x of the mask, from (1, 0) on, and white beside it.
void TestLayeredFiles::masksAreApplied() {
    const auto check = [](const char* name, int width, int height, int maskWidth) {
        const Image image = readLayer(given(name), "masked");
        QCOMPARE(QSize(image.width, image.height), QSize(width, height));
        const int scale = image.type == PixelType::UInt8 ? 1 : 257;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const bool isMasked = x >= 1 && x < 1 + maskWidth && y < 3;
                const double factor = isMasked ? 51 * (x - 1) / 255.0 : 1;
                const int alpha = pixel(x, y)[3] * scale;
                QVERIFY(std::abs(sample(image, x, y, 3) - factor * alpha) <= 0.51);
                for (int c = 0; c < 3; ++c)
                    QCOMPARE(sample(image, x, y, c), scale * pixel(x, y)[static_cast<std::size_t>(c)]);
            }
    };
    check("layers.kra", kWidth, kHeight, 4);
    check("layers16.kra", kWidth, kHeight, 4);
    check("layers.psd", kWidth, kHeight, 2);
    check("layers16.psd", kWidth, kHeight, 2);
    check("layers.psb", kWidth, kHeight, 2);
}

void TestLayeredFiles::greyLayers() {
    const Image image = readLayer(given("grey.kra"), "arm");
    QCOMPARE(image.channels, 2);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            QCOMPARE(sample(image, x, y, 0), pixel(x, y)[1]);
            QCOMPARE(sample(image, x, y, 1), pixel(x, y)[3]);
        }
}

/// The first page is below, and the picture reaches as far as both.
void TestLayeredFiles::pagesAreFlattened() {
    std::vector<Message> notices;
    const std::string path = given("layers.tif");
    const Image image = readImage(path, kMaxMegapixels, &notices);
    QCOMPARE(QSize(image.width, image.height), QSize(9, 7));
    QCOMPARE(readImageHeader(path).width, 9);
    QCOMPARE(textsOf(notices), std::vector{path + ": has 2 layers: opened flattened"});
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 9; ++x) {
            const bool isBody = x < 8 && y < 6, isArm = x >= 5 && y >= 4;
            std::array<int, 4> body{}, arm{};
            if (isBody) body = pixel(x, y);
            if (isArm) arm = pixel(x - 5, y - 4);
            const double through = 1 - arm[3] / 255.0, alpha = arm[3] + through * body[3];
            QVERIFY(std::abs(sample(image, x, y, 3) - alpha) <= 0.51);
            for (int c = 0; c < 3 && alpha > 0; ++c) {
                const double colour =
                    (arm[std::size_t(c)] * arm[3] + through * body[std::size_t(c)] * body[3]) / alpha;
                QVERIFY(std::abs(sample(image, x, y, c) - colour) <= 1 + 255 / alpha);
            }
        }
    QCOMPARE(readImage(given("pages.tif")).width, kWidth);
}

/// The last group is in front. A small drawing is drawn larger, by a whole number: 16 pixels for one.
void TestLayeredFiles::groupsAreLayers() {
    const std::string path = written("drawing.svg", R"svg(<?xml version="1.0"?><!-- a drawing -->
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
     width="64" height="32" viewBox="0 0 64 32"><title>all</title><g transform="translate(8, 0)">
 <g id="g1" inkscape:label="body"><rect x="16" y="8" width="32" height="16" fill="#00ff00"/></g>
 <rect id="loose" x="40" y="4" width="4" height="4" fill="#0000ff"/><rect x="40" y="8" width="4" height="4"/>
 <g id="arm" style="mix-blend-mode:multiply"><rect y="4" width="20" height="8" fill="#ff0000" fill-opacity="0.5"/></g>
 <g id="ghost" style="display:none"><rect x="2" y="2" width="4" height="4" fill="#808080"/></g>
</g></svg>)svg");
    const Image image = readImage(path);
    QCOMPARE(QSize(image.width, image.height), QSize(1024, 512));
    QStringList found;
    for (const PictureLayer& layer : fileMetadata(image)->layers)
        found << QString("%1 %2 %3 %4 %5 %6 %7")
                     .arg(QString::fromStdString(layer.name))
                     .arg(layer.x)
                     .arg(layer.y)
                     .arg(layer.width)
                     .arg(layer.height)
                     .arg(QString::fromStdString(layer.blend))
                     .arg(layer.visible);
    QCOMPARE(found, (QStringList{"ghost 160 32 64 64 normal 0", "arm 128 64 320 128 multiply 1",
                                 "loose 768 64 64 128 normal 1", "body 384 128 512 256 normal 1"}));
    const auto colour = [](const Image& one, int x, int y) {
        std::array<int, 4> values{};
        for (int c = 0; c < 4; ++c) values[static_cast<std::size_t>(c)] = sample(one, x, y, c);
        return values;
    };
    const Image arm = readLayer(path, "arm"), body = readLayer(path, "body"),
                ghost = readLayer(path, "ghost");
    QCOMPARE(QSize(arm.width, arm.height), QSize(320, 128));
    const auto half = colour(arm, 100, 50);
    QVERIFY(half[0] >= 254 && half[1] == 0 && std::abs(half[3] - 128) <= 1);
    QCOMPARE(colour(body, 0, 0), (std::array{0, 255, 0, 255}));
    QCOMPARE(colour(ghost, 10, 10), (std::array{128, 128, 128, 255}));
    QCOMPARE(colour(image, 600, 200), (std::array{0, 255, 0, 255}));
    QCOMPARE(colour(image, 170, 40)[3], 0);  // hidden
}

/// The opacity of a group applies to all of its contents at once, also within another one; clip paths and
/// masks are applied in their elements' coordinates, also by style sheets. Elements before and after keep
/// their place in the order.
void TestLayeredFiles::drawingsAreComposited() {
    const std::string path = written("composited.svg", R"svg(<svg xmlns="http://www.w3.org/2000/svg"
     width="128" height="32" viewBox="0 0 128 32"><style>.cut { clip-path: url(#disc) }</style>
<defs><clipPath id="disc" transform="translate(2 0)"><circle cx="10" cy="16" r="8" fill="none"/></clipPath>
<mask id="half"><rect width="8" height="32" fill="#fff"/><rect x="8" width="8" height="32" fill="#fff" opacity=".5"/></mask></defs>
<rect width="4" height="4" fill="#00f"/>
<g opacity=".5"><rect x="2" y="2" width="10" height="10" fill="#f00"/><g opacity=".5"><rect x="6" y="6" width="10" height="10" fill="#0f0"/>
<rect x="8" y="8" width="10" height="10" fill="#0f0"/></g></g>
<g transform="translate(32 0)"><rect class="cut" width="24" height="32" fill="#f0f"/></g>
<g transform="translate(64 0)" mask="url(#half)"><rect width="24" height="32" fill="#ff0"/></g>
<rect x="2" y="2" width="2" height="2" fill="#000"/></svg>)svg");
    const Image image = readImage(path);
    const int scale = image.width / 128;
    const auto isAt = [&](double x, double y, const std::array<int, 4>& colour) {
        for (int c = 0; c < 4; ++c) {
            const int seen = sample(image, static_cast<int>(scale * x), static_cast<int>(scale * y), c);
            const bool counts = c == 3 || colour[3] > 0;
            if (counts && std::abs(seen - colour[static_cast<std::size_t>(c)]) > 3) return false;
        }
        return true;
    };
    QVERIFY(isAt(4.5, 4.5, {255, 0, 0, 128}));
    QVERIFY(isAt(2.5, 5, {255, 0, 0, 128}));
    QVERIFY(isAt(3.5, 1, {0, 0, 255, 255}));
    QVERIFY(isAt(3, 3, {0, 0, 0, 255}));        // drawn last
    QVERIFY(isAt(17, 17, {0, 255, 0, 64}));     // both opacities
    QVERIFY(isAt(13, 13, {0, 255, 0, 64}));     // of both rectangles
    QVERIFY(isAt(10, 10, {128, 128, 0, 128}));  // over the red one, within the group
    QVERIFY(isAt(44, 16, {255, 0, 255, 255}));
    QVERIFY(isAt(44 + 7.7, 16, {255, 0, 255, 255}) && isAt(44 - 8.4, 16, {0, 0, 0, 0}));
    QVERIFY(isAt(44 + 6, 16 + 6, {0, 0, 0, 0}));
    QVERIFY(isAt(66, 20, {255, 255, 0, 255}) && isAt(76, 20, {255, 255, 0, 128}));
    QVERIFY(isAt(84, 20, {0, 0, 0, 0}));
}

/// Clips, masks and opacities apply to the targets of uses, also through other uses; a use of itself ends.
void TestLayeredFiles::usedLayersAreComposited() {
    const std::string path = written("used.svg", R"svg(<svg xmlns="http://www.w3.org/2000/svg"
     xmlns:xlink="http://www.w3.org/1999/xlink" width="128" height="32" viewBox="0 0 128 32"><defs>
<clipPath id="disc"><circle cx="10" cy="16" r="8"/></clipPath>
<g id="cut"><rect clip-path="url(#disc)" width="24" height="32"/></g>
<g id="twice"><use href="#cut"/><use xlink:href="#cut" x="24"/></g>
<use id="drawn" href="#cut" y="99"/><g id="a" opacity=".5"><use href="#b"/></g><g id="b"><use href="#a"/></g>
<g id="self"><g opacity=".5"><rect width="2" height="2"/><use href="#self"/></g></g></defs>
<use href="#cut" x="2" fill="#f00"/>
<use href="#twice" transform="translate(32 0)" style="fill:#00f"/>
<use href="#cut" x="90" opacity=".5"/><use href="#self" x="120"/><use href="#b"/><use href="#drawn" x="110" y="-99"/></svg>)svg");
    const Image image = readImage(path);
    const int scale = image.width / 128;
    const auto isAt = [&](double x, double y, const std::array<int, 4>& colour) {
        for (int c = 0; c < 4; ++c) {
            const int seen = sample(image, static_cast<int>(scale * x), static_cast<int>(scale * y), c);
            if ((c == 3 || colour[3] > 0) && std::abs(seen - colour[static_cast<std::size_t>(c)]) > 3)
                return false;
        }
        return true;
    };
    for (const auto& [x, blue] : {std::pair{12.0, 0}, {42.0, 255}, {66.0, 255}}) {
        QVERIFY2(isAt(x, 16, {255 - blue, 0, blue, 255}), qPrintable(QString::number(x)));
        QVERIFY(isAt(x - 7, 16, {255 - blue, 0, blue, 255}) && isAt(x + 7, 16, {255 - blue, 0, blue, 255}));
        QVERIFY(isAt(x - 9, 16, {0, 0, 0, 0}) && isAt(x + 9, 16, {0, 0, 0, 0}) && isAt(x, 4, {0, 0, 0, 0}));
    }
    QVERIFY(isAt(100, 16, {0, 0, 0, 128}) && isAt(100, 4, {0, 0, 0, 0}));
    QVERIFY(!isAt(121, 1, {0, 0, 0, 0}) && isAt(120, 16, {0, 0, 0, 255}) && isAt(120, 4, {0, 0, 0, 0}));
    std::string doubled = R"(<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><defs>
        <g id="g0" opacity=".5"><rect width="9" height="9"/><rect width="5" height="5"/></g>)";
    for (int k = 1; k < 40; ++k) {
        const std::string used = "<use href=\"#g" + std::to_string(k - 1) + "\"/>";
        doubled += "<g id=\"g" + std::to_string(k) + "\">" + used + used + "</g>";
    }
    QVERIFY(readImage(written("doubled.svg", (doubled + R"(</defs><use href="#g3"/></svg>)").c_str())).alpha);
}

/// A blur is a Gaussian across an edge, with the scale of its element; it is clipped afterwards, and masks
/// may be blurred. Filters that do more than that are left out.
void TestLayeredFiles::blursAreDrawn() {
    const std::string path = written("blurred.svg", R"svg(<svg xmlns="http://www.w3.org/2000/svg"
     width="256" height="64" viewBox="0 0 256 64"><defs>
<filter id="soft"><feGaussianBlur in="SourceGraphic" stdDeviation="4"/></filter>
<filter id="endless"><feGaussianBlur stdDeviation="1e200"/></filter>
<filter id="across"><feGaussianBlur stdDeviation="4 0"/></filter>
<filter id="shadow"><feOffset dx="9"/><feGaussianBlur stdDeviation="4"/></filter>
<clipPath id="right"><rect x="48" width="48" height="64"/></clipPath>
<mask id="mask"><rect x="112" y="-40" width="28" height="200" fill="#fff" filter="url(#soft)"/></mask></defs>
<g transform="scale(.5)"><rect x="-200" y="-200" width="240" height="600" filter="url(#soft)"/></g>
<g clip-path="url(#right)"><rect x="40" width="24" height="64" style="filter:url(#across)"/></g>
<rect x="100" width="40" height="64" mask="url(#mask)"/>
<rect x="200" y="16" width="24" height="24" filter="url(#shadow)"/>
<rect x="240" width="9" height="9" filter="url(#endless)" transform="scale(1e200)"/></svg>)svg");
    const Image image = readImage(path);
    const int scale = image.width / 256;
    const auto isNear = [&](double x, double y, double alpha) {
        return std::abs(sample(image, static_cast<int>(scale * x), static_cast<int>(scale * y), 3) -
                        255 * alpha) < 7;
    };
    const auto upTo = [](double deviations) { return std::erfc(deviations / std::numbers::sqrt2) / 2; };
    for (const double by : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
        QVERIFY2(isNear(20 + 2 * by, 32, upTo(by)), qPrintable(QString::number(by)));
        QVERIFY2(isNear(64 + 4 * by, 32, upTo(by)), qPrintable(QString::number(by)));
        QVERIFY2(isNear(112 + 4 * by, 32, upTo(-by)), qPrintable(QString::number(by)));
    }
    QVERIFY(isNear(47, 32, 0) && isNear(49, 1, 1));
    QVERIFY(isNear(201, 30, 1) && isNear(199, 30, 0) && isNear(223, 30, 1) && isNear(225, 30, 0));
}

/// Clip paths and masks measure in the box around a group, a use or a text; the used element may have been
/// drawn before.
void TestLayeredFiles::drawingsAreClippedByBoxes() {
    const std::string path = written("boxed.svg", R"svg(<svg xmlns="http://www.w3.org/2000/svg"
     width="128" height="64" viewBox="0 0 128 64"><defs>
<clipPath id="middle" clipPathUnits="objectBoundingBox"><rect x=".25" y=".25" width=".5" height=".5"/></clipPath>
<clipPath id="moved" clipPathUnits="objectBoundingBox" transform="translate(4 0)"><rect width=".5" height="1"/></clipPath>
<mask id="left" maskContentUnits="objectBoundingBox"><rect width=".5" height="1" fill="#fff"/></mask></defs>
<g clip-path="url(#middle)" transform="translate(0 8)"><rect width="16" height="32" fill="#f00"/><rect x="16" width="16" height="32" fill="#00f" stroke="#000" stroke-width="9"/></g>
<rect id="drawn" x="40" width="16" height="16" fill="#0f0"/>
<use href="#drawn" y="32" clip-path="url(#moved)"/>
<g mask="url(#left)"><rect x="80" y="8" width="16" height="16" fill="#f0f"/><circle cx="100" cy="40" r="12" fill="#f0f"/></g></svg>)svg");
    const Image image = readImage(path);
    const int scale = image.width / 128;
    const auto alphaAt = [&](double x, double y) {
        return sample(image, static_cast<int>(scale * x), static_cast<int>(scale * y), 3);
    };
    for (const double x : {8.5, 15.5, 16.5, 23.5}) QCOMPARE(alphaAt(x, 24), 255);
    for (const double x : {7.5, 24.5, 34.0}) QCOMPARE(alphaAt(x, 24), 0);
    QCOMPARE(alphaAt(16, 16.5), 255);
    QCOMPARE(alphaAt(16, 15.5), 0);
    QCOMPARE(alphaAt(16, 32.5), 0);
    QCOMPARE(alphaAt(48, 8), 255);
    QCOMPARE(alphaAt(44.5, 40), 255);
    QCOMPARE(alphaAt(51.5, 40), 255);
    QCOMPARE(alphaAt(43.5, 40), 0);
    QCOMPARE(alphaAt(52.5, 40), 0);
    QCOMPARE(alphaAt(88, 16), 255);  // the box reaches from 80 to 112
    QCOMPARE(alphaAt(95.5, 40), 255);
    QCOMPARE(alphaAt(96.5, 40), 0);
}

/// Clip paths and masks are among the drawn elements, and clip by elements that they use, as Illustrator
/// writes them.
void TestLayeredFiles::clipsAreNotDrawn() {
    const std::string path = written("among.svg", R"svg(<svg xmlns="http://www.w3.org/2000/svg"
     xmlns:xlink="http://www.w3.org/1999/xlink" width="128" height="32" viewBox="0 0 128 32">
<g><defs><rect id="shape" x="4" y="4" width="24" height="24"/></defs><clipPath id="clip"><use xlink:href="#shape"/></clipPath>
<g clip-path="url(#clip)"><rect width="16" height="32" fill="#f00"/></g></g>
<mask id="unused"><rect x="40" width="16" height="32" fill="#fff"/></mask></svg>)svg");
    const Image image = readImage(path);
    const int scale = image.width / 128;
    const auto at = [&](double x, double y) {
        const auto channel = [&](int c) {
            return sample(image, static_cast<int>(scale * x), static_cast<int>(scale * y), c);
        };
        return std::array{channel(0), channel(1), channel(2), channel(3)};
    };
    QVERIFY((at(10, 10) == std::array{255, 0, 0, 255}));
    for (const double x : {2.0, 20.0, 30.0, 48.0}) QCOMPARE(at(x, 10)[3], 0);
    const std::string alone =
        written("alone.svg", R"svg(<svg xmlns="http://www.w3.org/2000/svg" width="128" height="32"
     viewBox="0 0 128 32"><clipPath id="c"><rect width="9" height="9"/></clipPath><rect x="64" width="9" height="9"/></svg>)svg");
    const Image plain = readImage(alone);
    QCOMPARE(sample(plain, 4 * scale, 4 * scale, 3), 0);
    QCOMPARE(sample(plain, 68 * scale, 4 * scale, 3), 255);
}

void TestLayeredFiles::damagedDrawings() {
    for (const char* text : {"<svg", "<svg xmlns='http://www.w3.org/2000/svg'>", "<svg></g>", "<svg/>"})
        QVERIFY_EXCEPTION_THROWN(readImage(written("damaged.svg", text)), InputError);
}

void TestLayeredFiles::layersOfOtherKinds() {
    const auto reasonFor = [&](const char* file, const std::string& layer) {
        try {
            readLayer(given(file), layer);
        } catch (const InputError& error) {
            return QString::fromStdString(error.reason());
        }
        return QString();
    };
    QCOMPARE(reasonFor("layers.kra", "words"),
             QString("its layer \"words\" is a vector layer and cannot be read"));
    QVERIFY(reasonFor("layers.kra", "ink").contains("CMYKA"));
}

/// The data are the shortest examples of each kind of its parts, and damaged ones.
void TestLayeredFiles::lzf() {
    QCOMPARE(fromLzf({"\2abc", 4}, 3), std::string("abc"));
    QCOMPARE(fromLzf({"\2abc\x20\2", 6}, 6), std::string("abcabc"));     // three bytes from three back
    QCOMPARE(fromLzf({"\0a\xe0\1\0", 5}, 11), std::string(11, 'a'));     // 7 + 1 + 2 times the last one
    QVERIFY_EXCEPTION_THROWN(fromLzf({"\2ab", 3}, 3), InputError);       // too few literals
    QVERIFY_EXCEPTION_THROWN(fromLzf({"\0a\x20\1", 4}, 4), InputError);  // from before the first byte
    QVERIFY_EXCEPTION_THROWN(fromLzf({"\0a\x20", 3}, 4), InputError);    // no distance
    QVERIFY_EXCEPTION_THROWN(fromLzf({"\2abc", 4}, 2), InputError);      // more than there should be
    QVERIFY_EXCEPTION_THROWN(fromLzf({"\2abc", 4}, 4), InputError);      // fewer
}

/// Damaged tiles of a layer are read or refused, whatever the fault. The zip archive around them has
/// checksums, which a deliberately made file has, too.
void TestLayeredFiles::damagedTiles() {
    const std::string head = "VERSION 2\nTILEWIDTH 4\nTILEHEIGHT 3\nPIXELSIZE 2\nDATA 2\n";
    const std::string packed("\1\0a\xe0\16\0", 6);
    const std::string sound =
        head + "0,0,LZF,25\n" + std::string(1, '\0') + std::string(24, 'x') + "-4,3,LZF,6\n" + packed;
    const KritaPixels pixels(sound, "");
    QCOMPARE(pixels.rows({-4, 0, 8, 1}), std::string(8, '\0') + std::string(8, 'x'));
    QCOMPARE(pixels.rows({-4, 3, 2, 2}), std::string(8, 'a'));
    std::mt19937 random(5);
    int refused = 0;
    for (int k = 0; k < 20000; ++k) {
        std::string bytes = sound;
        for (unsigned changes = 1 + random() % 3; changes > 0; --changes)
            bytes[random() % bytes.size()] =
                static_cast<char>(random() % 3 == 0 ? '0' + random() % 10 : random());
        if (random() % 4 == 0) bytes.resize(random() % bytes.size());
        try {
            const KritaPixels changed(bytes, "");
            const PixelBox& box = changed.box();
            if (1e-6 * box.width * box.height < 1) changed.rows(box);
        } catch (const InputError&) {
            ++refused;
        }
    }
    QVERIFY(refused > 5000);
}

/// Opacities beyond 0 … 1 are limited, also those of groups, and one that is not a number is full.
void TestLayeredFiles::impossibleOpacities() {
    const Image picture = readImage(given("layers.ora"));
    const std::string path = m_folder.filePath("opacities.ora").toStdString();
    std::vector<LayerToWrite> layers;
    for (const double opacity : {7.0, std::nan(""), -0.5, 0.25}) {
        LayerToWrite& layer = layers.emplace_back();
        layer.name = std::to_string(layers.size());
        layer.picture = picture;
        layer.opacity = opacity;
    }
    writeOpenRaster(path, layers, picture);
    std::vector<Message> notices;
    const Image read = readImage(path, kMaxMegapixels, &notices);
    std::vector<double> opacities;
    for (const PictureLayer& layer : fileMetadata(read)->layers) opacities.push_back(layer.opacity);
    QCOMPARE(opacities, (std::vector<double>{1, 1, 0, 0.25}));
    QCOMPARE(notices.size(), std::size_t(4));  // the last one: it has layers
    for (std::size_t k = 0; k < 3; ++k)
        QVERIFY2(QString::fromStdString(notices[k])
                     .contains(QString("has a layer \"%1\" with an opacity out of range").arg(k + 1)),
                 std::string(notices[k]).c_str());
}

void TestLayeredFiles::damagedFiles_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("reason");
    const QByteArray ora = contents("layers.ora"), psd = contents("layers.psd");
    QTest::newRow("ZIP cut off") << ora.left(ora.size() / 2) << "is a damaged ZIP archive";
    QByteArray bytes = ora;
    QTest::newRow("no picture") << bytes.replace("mergedimage.png", "mergedimage.pnk")
                                << "holds no picture of all its layers (mergedimage.png): save it with one";
    bytes = ora;
    bytes[bytes.indexOf("mergedimage.png") + 40] = bytes[bytes.indexOf("mergedimage.png") + 40] ^ 0x5a;
    QTest::newRow("picture damaged") << bytes << "has a damaged mergedimage.png";
    bytes = ora;
    QTest::newRow("no description") << bytes.replace("stack.xml", "stick.xml") << "has a damaged stack.xml";
    QTest::newRow("header cut off") << psd.left(20) << "is truncated in its header";
    QTest::newRow("layers cut off") << psd.left(300) << "is truncated before its picture";
    QTest::newRow("picture cut off") << psd.left(psd.size() - 50) << "is truncated or corrupt";
    bytes = psd;
    bytes[bytes.indexOf("8BIM") + 16] = 0;
    QTest::newRow("Photoshop without a picture")
        << bytes << "holds no picture of all its layers (Maximize Compatibility): save it with one";
    bytes = psd;
    bytes.replace(bytes.indexOf("8BIM\4\x21") + 12 + 18 + 8, 2, "\x7f\xff");
    QTest::newRow("more layers than there are") << bytes << "is truncated or corrupt";
}

void TestLayeredFiles::damagedFiles() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, reason);
    QFile file(m_folder.filePath("damaged"));
    QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    file.write(bytes);
    file.close();
    try {
        readImage(file.fileName().toStdString());
        QFAIL("was read");
    } catch (const InputError& error) {
        QVERIFY2(QString::fromStdString(error.reason()).startsWith(reason), error.what());
    }
}

QTEST_GUILESS_MAIN(TestLayeredFiles)
#include "test_layered_files.moc"
