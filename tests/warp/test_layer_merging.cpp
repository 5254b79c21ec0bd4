// Layers that are combined with one another are shown as one: the shown layers, over one another, are the
// picture of all layers that Krita has written into its files (tests/data/pictures/groups_in_krita.py).

#include <QRect>
#include <QTest>

#include "core/base/input_file.h"
#include "tests/support/pictures.h"
#include "warp/blend_mode.h"
#include "warp/layer_merging.h"

using namespace wend;

namespace {

std::string given(const QString& name) {
    return (QStringLiteral(WEND_SOURCE_DIR "/tests/data/pictures/") + name).toStdString();
}

std::vector<PictureLayer> layersOf(const std::string& path) {
    return fromTheFront(fileMetadata(readImageHeader(path))->layers, pictureFormat(InputFile(path)));
}

MergedPicture shownPicture(const std::string& path, const std::vector<PictureLayer>& layers,
                           const ShownLayer& shown) {
    if (shown.merges.empty()) return {readLayer(path, shown.layer.name), shown.layer.x, shown.layer.y};
    return mergedPicture(
        layers, shown, [&](const std::string& name) { return readLayer(path, name); }, nullptr);
}

double sample(const Image& image, int x, int y, int c) {
    return std::to_integer<int>(
               image.row(y)[image.pixelBytes() * static_cast<std::size_t>(x) + static_cast<std::size_t>(c)]) /
           255.0;
}

/// A colour and its alpha, not multiplied with it.
using Colour = std::array<double, 4>;

/// Cs and Cb of the blend functions of https://www.w3.org/TR/compositing-1/#blending
double blended(const std::string& mode, double s, double b) {
    if (mode == "multiply") return s * b;
    if (mode == "screen") return s + b - s * b;
    return mode == "normal" || mode == "src-over" ? s : std::min(1.0, s + b);
}

Colour over(const Colour& top, double opacity, const std::string& mode, const Colour& below) {
    const double s = opacity * top[3], b = below[3], all = s + b * (1 - s);
    Colour result{0, 0, 0, all};
    for (std::size_t c = 0; all > 0 && c < 3; ++c)
        result[c] =
            (s * (1 - b) * top[c] + s * b * blended(mode, top[c], below[c]) + (1 - s) * b * below[c]) / all;
    return result;
}

}  // namespace

class TestLayerMerging : public QObject {
    Q_OBJECT

  private slots:
    void shownLayersAreThePicture_data();
    void shownLayersAreThePicture();
    void clippedLayersKeepTheAlpha();
    void placesAreThoseOfThePicture_data();
    void placesAreThoseOfThePicture();
};

void TestLayerMerging::shownLayersAreThePicture_data() {
    QTest::addColumn<QString>("name");
    const QStringList all{
        "glow = near, far; screen 0.784",   "off; normal 1 hidden", "arm = skin, shade, light; normal 1",
        "legs = left, right; normal 0.502", "torso; normal 1",      "ground; normal 1"};
    QTest::addColumn<QStringList>("expected");
    for (const char* name : {"groups.kra", "groups.ora", "groups.psd"}) QTest::newRow(name) << name << all;
}

/// Groups with an opacity or a mode, isolated ones with modes in them, and layers that inherit alpha.
void TestLayerMerging::shownLayersAreThePicture() {
    QFETCH(QString, name);
    QFETCH(QStringList, expected);
    const std::string path = given(name);
    const std::vector<PictureLayer> layers = layersOf(path);
    const std::vector<ShownLayer> shown = shownLayers(layers);
    QStringList found;
    for (const ShownLayer& one : shown) {
        QStringList merges;
        for (const std::string& layer : one.merges) merges << QString::fromStdString(layer);
        found << QString::fromStdString(one.layer.name) +
                     (merges.isEmpty() ? QString() : " = " + merges.join(", ")) +
                     QString("; %1 %2%3")
                         .arg(QString::fromStdString(one.layer.blend))
                         .arg(QString::number(one.layer.opacity, 'g', 3), one.layer.visible ? "" : " hidden");
    }
    found.replaceInStrings("src-over", "normal");  // its name in OpenRaster
    QCOMPARE(found, expected);
    const Image merged = readImage(path);
    std::vector<Colour> picture(static_cast<std::size_t>(merged.width) *
                                static_cast<std::size_t>(merged.height));
    for (std::size_t i = shown.size(); i-- > 0;) {
        if (!shown[i].layer.visible) continue;
        const auto [layer, left, top] = shownPicture(path, layers, shown[i]);
        for (int y = std::max(0, top); y < std::min(merged.height, top + layer.height); ++y)
            for (int x = std::max(0, left); x < std::min(merged.width, left + layer.width); ++x) {
                Colour colour{};
                for (int c = 0; c < 4; ++c)
                    colour[static_cast<std::size_t>(c)] = sample(layer, x - left, y - top, c);
                Colour& at = picture[static_cast<std::size_t>(y * merged.width + x)];
                at = over(colour, shown[i].layer.opacity, shown[i].layer.blend, at);
            }
    }
    for (int y = 0; y < merged.height; ++y)
        for (int x = 0; x < merged.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double is =
                    picture[static_cast<std::size_t>(y * merged.width + x)][static_cast<std::size_t>(c)];
                QVERIFY2(std::abs(is - sample(merged, x, y, c)) < 3.5 / 255,
                         qPrintable(QString("%1 %2 %3: %4, not %5")
                                        .arg(x)
                                        .arg(y)
                                        .arg(c)
                                        .arg(255 * is)
                                        .arg(255 * sample(merged, x, y, c))));
            }
}

/// The values are those of make.py: the pixel (20 x + 5, 40 y + 3, 7 x y, 255 − 30 x), and the same above it,
/// masked by 51 x′ / 255 at x′ = x − 1, y in [0, 3), added within the alpha below.
void TestLayerMerging::clippedLayersKeepTheAlpha() {
    const std::string path = given("layers.psd");
    const std::vector<PictureLayer> layers = layersOf(path);
    const std::vector<ShownLayer> shown = shownLayers(layers);
    QCOMPARE(shown.size(), std::size_t{2});
    QCOMPARE(QString::fromStdString(shown[1].layer.name), QString("Körper + masked"));
    QCOMPARE(QString::fromStdString(shown[1].name), QString("Körper"));
    const MergedPicture merged = shownPicture(path, layers, shown[1]);
    QCOMPARE(std::pair(merged.picture.width, merged.picture.height), std::pair(8, 6));
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 8; ++x) {
            const std::array<int, 3> rgb{20 * x + 5, 40 * y + 3, 7 * x * y};
            const double alpha = (255 - 30 * x) / 255.0;
            const double mask = (x == 1 || x == 2) && y < 3 ? 51 * (x - 1) / 255.0 : 1;
            QVERIFY(std::abs(sample(merged.picture, x, y, 3) - alpha) < 0.6 / 255);
            for (int c = 0; c < 3; ++c) {
                const double b = rgb[static_cast<std::size_t>(c)] / 255.0, s = alpha * mask;
                const double expected = (1 - s) * b + s * std::min(1.0, 2 * b);
                QVERIFY2(std::abs(sample(merged.picture, x, y, c) - expected) < 1.5 / 255,
                         qPrintable(QString("%1 %2 %3").arg(x).arg(y).arg(c)));
            }
        }
}

/// A letter for each layer, from the front to the back: c is clipped, a atop, h hidden, n none of these; a
/// large one in an isolated group with an opacity.
void TestLayerMerging::placesAreThoseOfThePicture_data() {
    QTest::addColumn<QString>("layers");
    for (const char* layers : {"cn", "ccnn", "CN", "NN", "AN", "NCN", "CHN", "CHNn", "cNN", "ACN", "NAN"})
        QTest::newRow(layers) << layers;
}

/// Clipped layers reach beyond their clipping layer on all sides.
void TestLayerMerging::placesAreThoseOfThePicture() {
    QFETCH(QString, layers);
    std::vector<PictureLayer> file;
    LayerGroup group{1, "group", "normal", 0.5};
    for (int k = 0; k < layers.size(); ++k) {
        const QChar kind = layers[k].toLower();
        PictureLayer& layer = file.emplace_back();
        layer.name = std::to_string(k);
        layer.blend = "normal";
        layer.clipped = kind == 'c', layer.atop = kind == 'a', layer.visible = kind != 'h';
        const int beyond = kind == 'n' ? 0 : 9;
        layer.x = 20 + k - beyond, layer.y = 30 - 2 * k - beyond;
        layer.width = 10 + 2 * beyond, layer.height = 12 + 2 * beyond;
        if (layers[k].isUpper()) layer.groups = {group};
    }
    const auto read = [&](const std::string& name) {
        const PictureLayer& layer = file[std::stoul(name)];
        return test::plainPicture(layer.width, layer.height, {200, 100, 50, 255});
    };
    int merged = 0;
    for (const ShownLayer& shown : shownLayers(file)) {
        if (shown.merges.empty()) continue;
        ++merged;
        const MergedPicture is = mergedPicture(file, shown, read, nullptr);
        QCOMPARE(QRect(shown.layer.x, shown.layer.y, shown.layer.width, shown.layer.height),
                 QRect(is.x, is.y, is.picture.width, is.picture.height));
    }
    QCOMPARE(merged, 1);
}

QTEST_GUILESS_MAIN(TestLayerMerging)
#include "test_layer_merging.moc"
