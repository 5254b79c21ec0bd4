// TIFF files with layers as pages: by Wend's reader, and by Pillow where it is installed.

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "core/base/error.h"
#include "tests/support/pictures.h"
#include "warp/layered_tiff.h"
#include "warp/picture_metadata.h"

using namespace wend;
using namespace wend::test;

class TestLayeredTiff : public QObject {
    Q_OBJECT

  private slots:
    void pagesAreLayers_data();
    void pagesAreLayers();
    void otherReaders();
    void placesAtAnyResolution();
    void lossesAreTold();

  private:
    std::string at(const char* name) const { return m_folder.filePath(name).toStdString(); }
    QTemporaryDir m_folder;
};

void TestLayeredTiff::pagesAreLayers_data() {
    QTest::addColumn<PixelType>("type");
    QTest::addColumn<int>("channels");
    QTest::addColumn<bool>("unassociated");
    QTest::newRow("8 bits") << PixelType::UInt8 << 4 << true;
    QTest::newRow("8 bits, associated") << PixelType::UInt8 << 4 << false;
    QTest::newRow("16 bits") << PixelType::UInt16 << 4 << true;
    QTest::newRow("floats") << PixelType::Float << 4 << false;
    QTest::newRow("grey") << PixelType::UInt8 << 2 << true;
}

/// From back to front, with names and places, to the bit; the backmost one has the size of the picture.
void TestLayeredTiff::pagesAreLayers() {
    QFETCH(PixelType, type);
    QFETCH(int, channels);
    QFETCH(bool, unassociated);
    const auto picture = [&](int width, int height, unsigned seed) {
        Image image = randomPicture(width, height, channels, type, true, seed);
        image.unassociated = unassociated;
        return image;
    };
    const std::vector<LayerToWrite> layers{{"Körper, links", picture(9, 70, 1), 31, 9},
                                           {"eye", picture(5, 4, 2), 0, 3},
                                           {"b", picture(30, 20, 3), 6, 4}};
    const std::string path = at("layers.tif");
    writeLayeredTiff(path, picture(40, 80, 4), layers);
    const Image header = readImageHeader(path);
    QCOMPARE(QSize(header.width, header.height), QSize(40, 80));
    const auto& found = fileMetadata(header)->layers;
    QCOMPARE(found.size(), layers.size());
    for (std::size_t k = 0; k < 3; ++k) {
        const LayerToWrite& layer = layers[2 - k];
        const bool isBack = k == 0;
        QCOMPARE(found[k].name, layer.name);
        QCOMPARE(QPoint(found[k].x, found[k].y), isBack ? QPoint(0, 0) : QPoint(layer.x, layer.y));
        const Image read = readLayer(path, layer.name);
        QVERIFY(read.type == type && read.channels == channels && read.unassociated == unassociated);
        QCOMPARE(read.width, isBack ? 40 : layer.picture.width);
        const int x = isBack ? layer.x : 0, y = isBack ? layer.y : 0;
        for (int row = 0; row < layer.picture.height; ++row)
            QVERIFY(std::equal(layer.picture.row(row), layer.picture.row(row) + layer.picture.rowBytes(),
                               read.row(y + row) + read.pixelBytes() * static_cast<std::size_t>(x)));
        const std::byte* first = read.row(0);
        if (isBack)
            QVERIFY(std::all_of(first, first + read.rowBytes(), [](auto b) { return b == std::byte(0); }));
    }
    writeLayeredTiff(at("again.tif"), picture(40, 80, 4), layers);
    QFile one(m_folder.filePath("layers.tif")), other(m_folder.filePath("again.tif"));
    QVERIFY(one.open(QIODevice::ReadOnly) && other.open(QIODevice::ReadOnly));
    QCOMPARE(one.readAll(), other.readAll());
}

void TestLayeredTiff::otherReaders() {
    const Image arm = randomPicture(6, 5, 4, PixelType::UInt8, true, 7),
                body = randomPicture(20, 16, 4, PixelType::UInt8, true, 8);
    writeLayeredTiff(at("pages.tif"), body, {{"left arm", arm, 3, 11}, {"body", body}});
    QProcess python;
    const QString script = R"(import sys
try: from PIL import Image
except ImportError: sys.exit(77)
file = Image.open(sys.argv[1])
print(file.n_frames)
for k in range(file.n_frames):
    file.seek(k)
    tags, size = file.tag_v2, file.size
    x, y = (round(float(tags.get(p, 0)) * float(tags[r])) for p, r in ((286, 282), (287, 283)))
    print(f"{tags[285]}|{x}|{y}|{size[0]}|{size[1]}|{tags[338]}|{file.convert('RGBA').tobytes().hex()}"))";
    for (const char* program : {"python3", "/usr/bin/python3"}) {
        python.start(program, {"-c", script, m_folder.filePath("pages.tif")});
        if (python.waitForFinished() && python.exitCode() == 0) break;
    }
    if (python.error() == QProcess::FailedToStart || python.exitCode() == 77)
        QSKIP("Pillow is not installed");
    const auto hex = [](const Image& image) {
        return QByteArray(reinterpret_cast<const char*>(image.data.data()), qsizetype(image.data.size()))
            .toHex();
    };
    QCOMPARE(python.readAllStandardOutput().trimmed(),
             "2\nbody|0|0|20|16|(2,)|" + hex(body) + "\nleft arm|3|11|6|5|(2,)|" + hex(arm));
}

/// Places are stored in units of the resolution, which a picture brings along.
void TestLayeredTiff::placesAtAnyResolution() {
    const Image back = plainPicture(3000, 10, {9, 9, 9, 255});
    for (const int x : {1, 7, 1333, 2999}) {
        writeLayeredTiff(at("far.tif"), back,
                         {{"dot", plainPicture(1, 1, {1, 2, 3, 255}), x, 7}, {"back", back}});
        QCOMPARE(fileMetadata(readImageHeader(at("far.tif")))->layers.at(1).x, x);
    }
}

void TestLayeredTiff::lossesAreTold() {
    const Image dot = plainPicture(1, 1, {1, 2, 3, 255});
    QVERIFY(lostInLayeredTiff({{"a", dot}, {"b", dot}}).isEmpty());
    const std::string seen =
        lostInLayeredTiff({{"a", dot, 0, 0, 0.5}, {"b", dot}, {"c", dot, 0, 0, 1, false}});
    QCOMPARE(seen, std::string("layers of a TIFF have no opacity, visibility and blend mode: those of \"a\", "
                               "\"c\" are left out"));
    const std::vector<LayerToWrite> twins{{"a", dot}, {"a", dot}, {std::string(998, 'x') + "ö", dot}};
    QCOMPARE(lostInLayeredTiff(twins).text(),
             "layers of a TIFF need names of their own: \"a (2)\", \"" + std::string(998, 'x') + "\"");
    writeLayeredTiff(at("twins.tif"), dot, twins);
    QCOMPARE(fileMetadata(readImageHeader(at("twins.tif")))->layers.at(1).name, std::string("a (2)"));
}

QTEST_GUILESS_MAIN(TestLayeredTiff)
#include "test_layered_tiff.moc"
