#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>

#include "core/mesh/error.h"
#include "tests/support/pictures.h"

using namespace wend;
using namespace wend::test;

class TestImage : public QObject {
    Q_OBJECT
  private slots:
    void roundTrip_data();
    void roundTrip();
    void alphaIsLaidOverWhiteForJpeg();
    void depthIsConvertedToWhatTheFormatHolds();
    void damagedFilesAreErrors_data();
    void damagedFilesAreErrors();
    void tooLargeIsAnError();
    void failedWriteLeavesNothing();
    void headerNeedsNoPixels();

  private:
    std::string path(const QString& name) const { return m_folder.filePath(name).toStdString(); }
    QTemporaryDir m_folder;
};

void TestImage::roundTrip_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("channels");
    const auto row = [](const QString& extension, PixelType type, std::initializer_list<int> counts) {
        for (int channels : counts)
            QTest::addRow("%s type %d channels %d", qPrintable(extension), static_cast<int>(type), channels)
                << extension << static_cast<int>(type) << channels;
    };
    row("png", PixelType::UInt8, {1, 2, 3, 4});
    row("png", PixelType::UInt16, {1, 2, 3, 4});
    row("tif", PixelType::UInt8, {1, 2, 3, 4});
    row("tif", PixelType::UInt16, {1, 3, 4});
    row("tif", PixelType::Float, {1, 3, 4});
    row("exr", PixelType::Half, {3, 4});
    row("exr", PixelType::Float, {3, 4});
    row("webp", PixelType::UInt8, {3, 4});
}

void TestImage::roundTrip() {
    QFETCH(QString, extension);
    QFETCH(int, type);
    QFETCH(int, channels);
    const bool alpha = channels % 2 == 0;
    Image image = randomPicture(37, 23, channels, static_cast<PixelType>(type), alpha);
    if (extension == "exr") image.unassociated = false;  // EXR's colours are associated
    const std::string file = path("round." + extension);
    writeImage(file, image);
    const Image back = readImage(file);
    QCOMPARE(back.width, 37);
    QCOMPARE(back.height, 23);
    QCOMPARE(back.channels, channels);
    QCOMPARE(static_cast<int>(back.type), type);
    QCOMPARE(back.alpha, alpha);
    QCOMPARE(back.unassociated, image.unassociated);
    QVERIFY(back.data == image.data);
}

void TestImage::alphaIsLaidOverWhiteForJpeg() {
    writeImage(path("clear.jpg"), plainPicture(16, 16, {0, 0, 0, 0}));
    const Image back = readImage(path("clear.jpg"));
    QCOMPARE(back.channels, 3);
    for (int c = 0; c < 3; ++c) QVERIFY(valueAt<std::uint8_t>(back, 8, 8, c) >= 254);
}

void TestImage::depthIsConvertedToWhatTheFormatHolds() {
    const Image image = randomPicture(8, 8, 3, PixelType::Float, false);
    writeImage(path("deep.png"), image);
    const Image back = readImage(path("deep.png"));
    QCOMPARE(static_cast<int>(back.type), static_cast<int>(PixelType::UInt16));
    for (int c = 0; c < 3; ++c)
        QVERIFY(std::abs(valueAt<std::uint16_t>(back, 3, 3, c) / 65535.0 - valueAt<float>(image, 3, 3, c)) <
                1.0 / 65535);
}

void TestImage::damagedFilesAreErrors_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<double>("kept");
    for (const QString extension : {"png", "tif", "exr", "jpg", "webp"})
        for (double kept : {0.0, 0.001, 0.3, 0.9})
            QTest::addRow("%s %g", qPrintable(extension), kept) << extension << kept;
}

void TestImage::damagedFilesAreErrors() {
    QFETCH(QString, extension);
    QFETCH(double, kept);
    const bool exr = extension == "exr";
    writeImage(path("whole." + extension),
               randomPicture(120, 90, 3, exr ? PixelType::Half : PixelType::UInt8, false));
    QFile file(QString::fromStdString(path("whole." + extension)));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    QFile cut(QString::fromStdString(path("cut." + extension)));
    QVERIFY(cut.open(QIODevice::WriteOnly));
    cut.write(bytes.left(static_cast<int>(bytes.size() * kept)));
    cut.close();
    QVERIFY_EXCEPTION_THROWN(readImage(path("cut." + extension)), InputError);
}

void TestImage::tooLargeIsAnError() {
    writeImage(path("large.png"), randomPicture(200, 200, 1, PixelType::UInt8, false));
    QVERIFY_EXCEPTION_THROWN(readImage(path("large.png"), 0.03), InputError);
    QVERIFY_EXCEPTION_THROWN(readImage(path("missing.png")), InputError);
    QVERIFY_EXCEPTION_THROWN(readImage(m_folder.path().toStdString()), InputError);
}

void TestImage::failedWriteLeavesNothing() {
    const Image image = randomPicture(8, 8, 3, PixelType::UInt8, false);
    QVERIFY_EXCEPTION_THROWN(writeImage("/nowhere/at/all.png", image), InputError);
    QVERIFY_EXCEPTION_THROWN(writeImage(path("picture.nosuchformat"), image), InputError);
    for (const auto& entry : std::filesystem::directory_iterator(m_folder.path().toStdString()))
        QVERIFY2(entry.path().filename().string().find("part") == std::string::npos, entry.path().c_str());
}

void TestImage::headerNeedsNoPixels() {
    writeImage(path("head.tif"), randomPicture(50, 40, 4, PixelType::UInt16, true));
    const Image header = readImageHeader(path("head.tif"));
    QCOMPARE(header.width, 50);
    QCOMPARE(header.height, 40);
    QVERIFY(header.data.empty() && header.alpha);
}

QTEST_GUILESS_MAIN(TestImage)
#include "test_image.moc"
