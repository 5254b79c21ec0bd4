// Photoshop files: by Wend's reader, by OpenImageIO, and byte by byte by a reader of the specification.

#include <OpenImageIO/imageio.h>

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>

#include "core/base/error.h"
#include "tests/support/pictures.h"
#include "warp/colour_space.h"
#include "warp/convert.h"
#include "warp/photoshop_file.h"
#include "warp/picture_metadata.h"

using namespace wend;
using namespace wend::test;

class TestPhotoshopFile : public QObject {
    Q_OBJECT

  private slots:
    void layersAreRead_data();
    void layersAreRead();
    void pictureOfAllLayers_data();
    void pictureOfAllLayers();
    void bytesFollowTheSpecification_data();
    void bytesFollowTheSpecification();
    void namesOfAnyLength();
    void limits();

  private:
    std::string at(const char* name) const { return m_folder.filePath(name).toStdString(); }
    /// Returns the lines that the reader in Python prints.
    QStringList readByScript(const char* name) const;
    QTemporaryDir m_folder;
};

namespace {

/// Numbers as the file has them, the most significant byte first.
QString hex(const Image& image) {
    QByteArray bytes(reinterpret_cast<const char*>(image.data.data()), qsizetype(image.data.size()));
    if (image.type == PixelType::UInt16)
        for (qsizetype k = 0; k + 1 < bytes.size(); k += 2) std::swap(bytes[k], bytes[k + 1]);
    return bytes.toHex();
}

/// Rows of equal, of different and of few equal bytes.
Image pictureOfRuns(int width, int height) {
    Image image = plainPicture(width, height, {7, 8, 9, 255});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                image.row(y)[4 * static_cast<std::size_t>(x) + c] =
                    std::byte((y % 3 == 0   ? 5
                               : y % 3 == 1 ? x * (y + 3)
                                            : x / (1 + y % 4)) &
                              0xff);
    return image;
}

}  // namespace

QStringList TestPhotoshopFile::readByScript(const char* name) const {
    QProcess python;
    python.start("python3",
                 {QStringLiteral(WEND_SOURCE_DIR "/tests/warp/read_photoshop.py"), m_folder.filePath(name)});
    if (!python.waitForFinished() || python.exitCode() != 0) return {python.readAllStandardError()};
    return QString::fromUtf8(python.readAllStandardOutput()).trimmed().split('\n');
}

void TestPhotoshopFile::layersAreRead_data() {
    QTest::addColumn<PixelType>("type");
    QTest::addColumn<int>("channels");
    QTest::addColumn<bool>("unassociated");
    QTest::newRow("8 bits") << PixelType::UInt8 << 4 << true;
    QTest::newRow("8 bits, associated") << PixelType::UInt8 << 4 << false;
    QTest::newRow("16 bits") << PixelType::UInt16 << 4 << true;
    QTest::newRow("halves") << PixelType::Half << 4 << false;
    QTest::newRow("grey") << PixelType::UInt8 << 2 << true;
    QTest::newRow("grey, 16 bits") << PixelType::UInt16 << 2 << true;
}

void TestPhotoshopFile::layersAreRead() {
    QFETCH(PixelType, type);
    QFETCH(int, channels);
    QFETCH(bool, unassociated);
    const auto picture = [&](int width, int height, unsigned seed) {
        Image image = randomPicture(width, height, channels, type, true, seed);
        image.unassociated = unassociated;
        return image;
    };
    const std::vector<LayerToWrite> layers{{"Körper, links", picture(9, 70, 1), 31, 9, 0.5},
                                           {"eye", picture(5, 4, 2), 0, 3, 1, false},
                                           {"b", picture(30, 20, 3), 6, 4, 1, true, BlendMode::Multiply},
                                           {"c", picture(1, 1, 4), 0, 0, 1, true, BlendMode::Screen},
                                           {"d", picture(300, 3, 5), -3, -2, 0, true, BlendMode::Add}};
    const std::string path = at("layers.psd");
    writePhotoshopFile(path, layers, picture(40, 80, 6));
    const Image header = readImageHeader(path);
    const auto& found = fileMetadata(header)->layers;
    QCOMPARE(found.size(), layers.size());
    const std::array blends{"normal", "normal", "multiply", "screen", "plus"};
    for (std::size_t k = 0; k < layers.size(); ++k) {
        const PictureLayer& layer = found[layers.size() - 1 - k];
        QCOMPARE(layer.name, layers[k].name);
        QCOMPARE(QRect(layer.x, layer.y, layer.width, layer.height),
                 QRect(layers[k].x, layers[k].y, layers[k].picture.width, layers[k].picture.height));
        QVERIFY(std::abs(layer.opacity - layers[k].opacity) < 0.5 / 255 + 1e-12);
        QCOMPARE(layer.visible, layers[k].visible);
        QCOMPARE(layer.blend, std::string(blends[k]));
        QVERIFY(!layer.clipped && layer.groups.empty() && layer.leftOut.empty());
        const Image read = readLayer(path, layer.name);
        const PixelLayout layout{type == PixelType::UInt8 ? type : PixelType::UInt16, channels, true, true};
        QVERIFY(layoutOf(read) == layout);
        QVERIFY(read.data == converted(layers[k].picture, layout).data);
        ColourSpace space;
        if (type == PixelType::Half) space.curve = ColourSpace::Curve::Power;
        space.name = type == PixelType::Half ? "Linear sRGB" : "sRGB";
        QVERIFY(read.iccProfile() == iccProfileOf(space, channels == 2));
    }
    writePhotoshopFile(at("again.psd"), layers, picture(40, 80, 6));
    QFile one(m_folder.filePath("layers.psd")), other(m_folder.filePath("again.psd"));
    QVERIFY(one.open(QIODevice::ReadOnly) && other.open(QIODevice::ReadOnly));
    QCOMPARE(one.readAll(), other.readAll());
}

void TestPhotoshopFile::pictureOfAllLayers_data() {
    QTest::addColumn<PixelType>("type");
    QTest::addColumn<int>("channels");
    QTest::addColumn<std::optional<PixelType>>("wanted");
    QTest::newRow("8 bits") << PixelType::UInt8 << 4 << std::optional<PixelType>();
    QTest::newRow("16 bits") << PixelType::UInt16 << 4 << std::optional<PixelType>();
    QTest::newRow("8 of 16 bits") << PixelType::UInt16 << 4 << std::optional(PixelType::UInt8);
    QTest::newRow("16 of 8 bits") << PixelType::UInt8 << 4 << std::optional(PixelType::UInt16);
    QTest::newRow("without alpha") << PixelType::UInt8 << 3 << std::optional<PixelType>();
    QTest::newRow("grey without alpha") << PixelType::UInt16 << 1 << std::optional<PixelType>();
}

/// The layers are the same over any ground up to rounding, both as OpenImageIO reads them and as Wend does.
void TestPhotoshopFile::pictureOfAllLayers() {
    QFETCH(PixelType, type);
    QFETCH(int, channels);
    QFETCH(std::optional<PixelType>, wanted);
    const bool alpha = channels == 4;
    Image merged = randomPicture(37, 11, channels, type, alpha, 9);
    merged.unassociated = alpha;
    const std::string path = at("merged.psd");
    writePhotoshopFile(path, {{"one", merged}}, merged, wanted);
    const bool isNarrow = wanted.value_or(type) == PixelType::UInt8;
    const auto input = OIIO::ImageInput::open(path);
    QVERIFY(input);
    QCOMPARE(input->spec().format, isNarrow ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16);
    QCOMPARE(input->spec().nchannels, channels);
    std::vector<float> pixels(static_cast<std::size_t>(merged.width * merged.height * channels));
    QVERIFY(input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, pixels.data()));
    const Image expected = converted(merged, {PixelType::Float, channels, alpha, false});
    const double rounding = isNarrow || type == PixelType::UInt8 ? 1.6 / 255 : 1.6 / 65535;
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        float value{};
        std::copy_n(expected.data.data() + sizeof value * k, sizeof value,
                    reinterpret_cast<std::byte*>(&value));
        QVERIFY2(std::abs(static_cast<double>(pixels[k] - value)) < rounding,
                 qPrintable(QString("%1 %2 %3").arg(k).arg(pixels[k]).arg(value)));
    }
    const Image read = readImage(path);
    QVERIFY(read.width == 37 && read.height == 11 && read.alpha == alpha);
}

void TestPhotoshopFile::bytesFollowTheSpecification_data() {
    QTest::addColumn<PixelType>("type");
    QTest::addColumn<int>("channels");
    QTest::newRow("8 bits") << PixelType::UInt8 << 4;
    QTest::newRow("16 bits") << PixelType::UInt16 << 4;
    QTest::newRow("grey") << PixelType::UInt8 << 2;
}

void TestPhotoshopFile::bytesFollowTheSpecification() {
    QFETCH(PixelType, type);
    QFETCH(int, channels);
    const PixelLayout layout{type, channels, true, true}, colours{type, channels - 1, false, false};
    const Image front = converted(pictureOfRuns(290, 13), layout),
                back = converted(pictureOfRuns(7, 3), layout);
    Image merged = randomPicture(31, 9, channels, type, true, 4);
    merged.unassociated = true;
    PictureMetadata metadata;
    metadata.iccProfile.resize(133, std::byte(3));
    std::copy_n(reinterpret_cast<const std::byte*>(channels == 2 ? "GRAY" : "RGB "), 4,
                metadata.iccProfile.data() + 16);
    merged.metadata = std::make_shared<PictureMetadata>(metadata);
    writePhotoshopFile(at("bytes.psd"),
                       {{"Auge 👁", front, -4, 5, 0.25, false, BlendMode::Add}, {"abc", back, 1, 2}},
                       merged);
    const QStringList lines = readByScript("bytes.psd");
    QVERIFY2(lines.size() == 5, qPrintable(lines.join('\n')));
    QCOMPARE(lines[0], QString("31|9|%1|%2|%3")
                           .arg(channels)
                           .arg(type == PixelType::UInt8 ? 8 : 16)
                           .arg(channels == 2 ? 1 : 3));
    const QByteArray profile(reinterpret_cast<const char*>(metadata.iccProfile.data()), 133);
    QCOMPARE(lines[1], "1039|" + profile.toHex());
    QCOMPARE(lines[2], "abc|abc|1|2|8|5|norm|255|8|" + hex(back));
    QCOMPARE(lines[3], QStringLiteral("Auge 👁|Auge ?|-4|5|286|18|lddg|64|10|") + hex(front));
    Image last = converted(merged, layout);
    const Image overWhite = converted(merged, colours);
    const std::size_t size = overWhite.pixelBytes();
    for (int y = 0; y < 9; ++y)
        for (std::size_t x = 0; x < 31; ++x)
            std::copy_n(overWhite.row(y) + size * x, size, last.row(y) + last.pixelBytes() * x);
    QCOMPARE(lines[4], hex(last));
}

/// Photoshop's names have at most 255 units of UTF-16; none is cut within a letter.
void TestPhotoshopFile::namesOfAnyLength() {
    const Image dot = plainPicture(1, 1, {1, 2, 3, 255});
    const std::string many(254, 'x');
    writePhotoshopFile(at("names.psd"), {{"", dot}, {many + "ö and more", dot}, {many + "👁", dot}}, dot);
    const QStringList lines = readByScript("names.psd");
    QCOMPARE(lines.size(), 6);
    const QString x(254, 'x');
    QVERIFY(lines[2].startsWith(x + '|' + x + '|'));
    QVERIFY(lines[3].startsWith(x + QStringLiteral("ö|") + x + "?|"));
    QVERIFY(lines[4].startsWith("||"));
}

void TestPhotoshopFile::limits() {
    const Image dot = plainPicture(1, 1, {1, 2, 3, 255}), wide = plainPicture(30001, 1, {1, 2, 3, 255});
    const std::string path = at("wide.psd");
    try {
        writePhotoshopFile(path, {{"dot", dot}}, wide);
        QFAIL("written");
    } catch (const InputError& error) {
        QCOMPARE(error.what(),
                 path + ": cannot be written: a Photoshop file has at most 30000 pixels a side");
    }
    QVERIFY(!QFile::exists(m_folder.filePath("wide.psd")));
    writePhotoshopFile(path, {{"dot", dot}}, plainPicture(30000, 1, {1, 2, 3, 255}));
    QCOMPARE(readImageHeader(path).width, 30000);
}

QTEST_GUILESS_MAIN(TestPhotoshopFile)
#include "test_photoshop_file.moc"
