// The contents of a file determine its reader, never its name or a trial.

#include <dlfcn.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include "core/base/error.h"
#include "warp/image.h"
#include "warp/picture_format.h"
#include "warp/picture_library.h"

using namespace wend;

namespace {

/// 3 × 2 pixels of RGB, by hand from the format's description.
QByteArray tga() {
    QByteArray bytes("\0\0\2\0\0\0\0\0\0\0\0\0\3\0\2\0\x18\x20", 18);
    return bytes + QByteArray(18, '\x40');
}
QByteArray ppm() {
    return "P6\n3 2\n255\n" + QByteArray(18, '\x40');
}
QByteArray bmp() {
    QByteArray bytes("BM", 2);
    const auto number = [&](quint32 value, int size) {
        const quint32 little = qToLittleEndian(value);
        bytes.append(reinterpret_cast<const char*>(&little), size);
    };
    for (quint32 value : {78U, 0U, 54U, 40U, 3U, 2U}) number(value, 4);
    number(1, 2), number(24, 2);
    for (quint32 value : {0U, 24U, 0U, 0U, 0U, 0U}) number(value, 4);
    return bytes + QByteArray(24, '\x40');
}

}  // namespace

class TestPictureFormat : public QObject {
    Q_OBJECT

  private slots:
    void pluginsAreNotLoaded();
    void nameHasNoSay_data();
    void nameHasNoSay();
    void notRead_data();
    void notRead();
    void notTga_data();
    void notTga();
    void brokenBmp_data();
    void brokenBmp();
    void tgaPalettes_data();
    void tgaPalettes();

  private:
    std::string put(const QString& name, const QByteArray& bytes) {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("disk full");
        return file.fileName().toStdString();
    }
    QTemporaryDir m_folder;
};

/// This runs first: the library looks for plug-ins once, when it looks for a reader.
void TestPictureFormat::pluginsAreNotLoaded() {
    const QByteArray folder = QFileInfo(WEND_TEST_TRAP).path().toLocal8Bit();
    const QString sprung = m_folder.filePath("sprung");  // by a process that loads the plug-in
    qputenv("WEND_TEST_PLUGIN", sprung.toLocal8Bit());
    qputenv("OIIO_LIBRARY_PATH", folder);
    qputenv("LD_LIBRARY_PATH", folder);
    const std::string text = put("text.png", "no picture");
    QVERIFY_THROWS_EXCEPTION(InputError, readImage(text));
    const Image picture = readImage(put("a.ppm", ppm()));
    QCOMPARE(picture.width, 3);
    QVERIFY(!QFile::exists(sprung));
    lookForNoPlugins();
    for (const char* name : {"a.png", "a.tif", "a.exr"}) writeImage(put(name, {}), picture);
    QVERIFY(!QFile::exists(sprung));
    QCOMPARE(qgetenv("OIIO_LIBRARY_PATH"), folder);  // as it was
    QCOMPARE(qgetenv("LD_LIBRARY_PATH"), folder);
    void* trap = dlopen(WEND_TEST_TRAP, RTLD_NOW);  // that it would have been heard
    QVERIFY2(trap, dlerror());
    QVERIFY(QFile::exists(sprung));
}

void TestPictureFormat::nameHasNoSay_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("TGA") << tga();
    QTest::newRow("TGA with its footer")
        << tga() + QByteArray(8, '\0') + "TRUEVISION-XFILE." + QByteArray(1, '\0');
    QTest::newRow("PPM") << ppm();
    QTest::newRow("BMP") << bmp();
}

void TestPictureFormat::nameHasNoSay() {
    QFETCH(QByteArray, bytes);
    for (const char* name : {"a.png", "a.iff", "a.gif", "a", "a.tga", "a.exr", "a.jpg"}) {
        const Image image = readImage(put(name, bytes));
        QCOMPARE(image.width, 3);
        QCOMPARE(image.height, 2);
        QCOMPARE(image.channels, 3);
        for (std::byte value : image.data) QCOMPARE(std::to_integer<int>(value), 0x40);
    }
}

void TestPictureFormat::notRead_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("what");
    const auto row = [](const QByteArray& bytes, const char* what) { QTest::newRow(what) << bytes << what; };
    const QByteArray zeros(64, '\0');
    row(QByteArray("\0\0\0\x20", 4) + "ftypisom" + zeros, "a film");
    row("FORM" + QByteArray("\0\0\1\0", 4) + "ILBMBMHD" + zeros, "an IFF file");
    row("PK\3\4" + QByteArray("\x14\0\0\0", 4) + zeros, "a ZIP archive");
    row("%PDF-1.4\n" + zeros, "a PDF document");
    row("gimp xcf v011" + zeros, "a GIMP picture (XCF; export it from GIMP as PNG or OpenRaster)");
    row("P7\nWIDTH 4\n", "a PAM picture");
    row("qoif" + zeros, "a QOI picture");
    row("RIFF" + QByteArray("\0\0\1\0", 4) + "AVI LIST" + zeros, "a film");
    row("once upon a time\nthere was no picture", "a text file");
    row("0.5 1.25 -3e-2\n1 2 3\n", "a list of points without a surface");
    row(QByteArray(64, '\x03'), "not a picture that Wend knows");
    row("FAKE" + QByteArray("\0\0\1\0", 4) + "WEBP" + zeros, "not a picture that Wend knows");
}

void TestPictureFormat::notRead() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, what);
    for (const char* name : {"b.png", "b.iff", "b.tga", "b"}) try {
            readImage(put(name, bytes));
            QFAIL("was read");
        } catch (const InputError& error) {
            const QString reason = QString::fromStdString(error.reason());
            QVERIFY2(reason.startsWith("is " + what + ". Wend opens PNG"), qPrintable(reason));
        }
}

/// Each breaks one rule of the header of a good file.
void TestPictureFormat::notTga_data() {
    QTest::addColumn<QByteArray>("bytes");
    const auto row = [](const char* name, int at, const QByteArray& value) {
        QTest::newRow(name) << tga().replace(at, value.size(), value);
    };
    row("palette that is none", 1, "\2");
    row("unknown type", 2, "\4");
    row("palette asked for", 2, "\1");
    row("palette left over", 5, "\7");
    row("no width", 12, QByteArray(2, '\0'));
    row("no height", 14, QByteArray(2, '\0'));
    row("depth", 16, "\x11");
    row("interleaved", 17, "\x40");
    row("more pixels than it holds", 12, "\4");
    QTest::newRow("cut off") << tga().left(35);
    QTest::newRow("no header") << tga().left(17);
}

void TestPictureFormat::notTga() {
    QFETCH(QByteArray, bytes);
    const std::string path = put("c.tga", bytes);
    QVERIFY_THROWS_EXCEPTION(InputError, pictureFormat(InputFile(path)));
}

/// Each breaks one rule of the header of a good file, before the library opens it.
void TestPictureFormat::brokenBmp_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* name, int at, const QByteArray& value, const char* reason) {
        QTest::newRow(name) << bmp().replace(at, value.size(), value) << reason;
    };
    const QByteArray four("\0\0\0\x80", 4);
    row("length of the header", 14, "\x29", "makes no sense");
    row("no width", 18, QByteArray(4, '\0'), "no pixels");
    row("negative width", 18, four, "no pixels");
    row("no height", 22, QByteArray(4, '\0'), "no pixels");
    row("planes", 26, "\2", "makes no sense");
    row("depth", 28, "\x11", "makes no sense");
    row("runs of another depth", 30, "\1", "makes no sense");
    row("a JPEG in it", 30, "\4", "makes no sense");
    row("masks of another depth", 30, "\3", "makes no sense");
    row("packed from the top", 22, QByteArray("\xfe\xff\xff\xff\1\0\x8\0\1", 9), "makes no sense");
    row("colours", 28, QByteArray("\x8\0\0\0\0\0", 6) + QByteArray(12, '\0') + QByteArray("\1\1\0\0", 4),
        "makes no sense");
    row("more pixels than it holds", 22, "\3", "more pixels");
    row("more packed ones", 22,
        QByteArray("\0\1\0\0\1\0\x8\0\1", 9).replace(0, 4, QByteArray("\0\x10\0\0", 4)), "more pixels");
    row("pixels behind its end", 10, "\x40", "more pixels");
    QTest::newRow("cut off") << bmp().left(77) << "more pixels";
    QTest::newRow("no header") << bmp().left(20) << "truncated";
}

void TestPictureFormat::brokenBmp() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, reason);
    QVERIFY(!readImage(put("good.bmp", bmp())).data.empty());
    try {
        readImage(put("c.bmp", bytes));
        QFAIL("it was read");
    } catch (const InputError& error) {
        QVERIFY2(QString::fromStdString(error.reason()).contains(reason), error.what());
    }
}

void TestPictureFormat::tgaPalettes_data() {
    QTest::addColumn<QByteArray>("type");
    QTest::addColumn<QByteArray>("pixels");
    QTest::newRow("stored") << QByteArray("\1") << QByteArray("\0\1\2\2\1\0", 6);
    QTest::newRow("packed") << QByteArray("\x9") << QByteArray("\1\0\1\x81\2\1\1\0", 8);
}

/// Each pixel names one of three colours. One that is not in the palette is not looked up in the memory
/// behind it.
void TestPictureFormat::tgaPalettes() {
    QFETCH(QByteArray, type);
    QFETCH(QByteArray, pixels);
    const QByteArray header = tga()
                                  .left(18)
                                  .replace(1, 1, "\1")
                                  .replace(2, 1, type)
                                  .replace(5, 1, "\3")
                                  .replace(7, 1, "\x18")
                                  .replace(16, 1, "\x8");
    const QByteArray palette = QByteArray::fromHex("0000ff00ff00ff0000");  // red, green and blue, as BGR
    const Image image = readImage(put("c.tga", header + palette + pixels));
    QCOMPARE(image.channels, 3);
    const int expected[] = {0, 1, 2, 2, 1, 0};
    for (int p = 0; p < 6; ++p)
        for (int c = 0; c < 3; ++c)
            QCOMPARE(int(image.data[static_cast<std::size_t>(3 * p + c)]), c == expected[p] ? 255 : 0);
    const auto reason = [&](const QByteArray& bytes) -> std::string {
        try {
            readImage(put("c.tga", bytes));
        } catch (const InputError& error) {
            return error.reason();
        }
        return {};
    };
    for (int at = 0; at < pixels.size(); ++at) {
        if (pixels.size() == 8 && (at == 0 || at == 3 || at == 5)) continue;  // heads of packets
        const std::string said = reason(header + palette + QByteArray(pixels).replace(at, 1, "\3"));
        QVERIFY2(said.find("a pixel has colour 3 of a palette of 3") != std::string::npos, said.c_str());
    }
    const std::string said = reason(QByteArray(header).replace(3, 1, "\1") + palette + pixels);
    QVERIFY2(said.find("does not begin with colour 0") != std::string::npos, said.c_str());
}

QTEST_GUILESS_MAIN(TestPictureFormat)
#include "test_picture_format.moc"
