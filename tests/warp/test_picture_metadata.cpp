// Metadata of a photograph that violate their bounds.

#include <QBuffer>
#include <QColorSpace>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include "core/base/input_file.h"
#include "warp/image.h"
#include "warp/metadata_check.h"
#include "warp/picture_format.h"
#include "warp/png_check.h"

using namespace wend;

namespace {

constexpr int kWidth = 24, kHeight = 16;

template <class Number>
QByteArray number(Number value, bool big) {
    QByteArray bytes(sizeof value, '\0');
    big ? qToBigEndian(value, bytes.data()) : qToLittleEndian(value, bytes.data());
    return bytes;
}

struct Entry {
    quint16 tag, type;
    quint32 count, value;
};

constexpr Entry kTurned{0x112, 3, 1, 6};
constexpr quint32 kDirectory = 8;  // where the first one begins

/// Returns a TIFF of one directory and the given data behind it.
QByteArray tiff(bool big, const QList<Entry>& entries, const QByteArray& after = QByteArray(16, '\0')) {
    QByteArray bytes(big ? "MM" : "II");
    bytes += number<quint16>(42, big) + number<quint32>(kDirectory, big);
    bytes += number<quint16>(static_cast<quint16>(entries.size()), big);
    for (const Entry& entry : entries) {
        bytes += number(entry.tag, big) + number(entry.type, big) + number(entry.count, big);
        const auto shortOne = static_cast<quint16>(entry.value);
        bytes += entry.type == 3 && entry.count == 1 ? number(shortOne, big) + QByteArray(2, '\0')
                                                     : number(entry.value, big);
    }
    return bytes + after;
}

QByteArray drawn(const char* format) {
    QImage image(kWidth, kHeight, QImage::Format_RGB888);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) image.setPixelColor(x, y, QColor(10 * x, 15 * y, 128));
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!image.save(&buffer, format)) qFatal("no %s", format);
    return bytes;
}

QByteArray segment(int kind, const QByteArray& data) {
    return QByteArray(1, '\xff') + static_cast<char>(kind) +
           number<quint16>(static_cast<quint16>(data.size() + 2), true) + data;
}

QByteArray jpegWith(int kind, const QByteArray& data) {
    static const QByteArray plain = drawn("JPG");
    return plain.left(2) + segment(kind, data) + plain.mid(2);
}

/// The checksum of PNG, bit by bit as its standard has it.
quint32 checksum(const QByteArray& bytes) {
    quint32 sum = 0xffffffff;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int k = 0; k < 8; ++k) sum = (sum & 1) ? 0xedb88320 ^ sum >> 1 : sum >> 1;
    }
    return ~sum;
}

/// Returns the PNG file with one chunk more, behind its header.
QByteArray withChunk(const QByteArray& png, const char* name, const QByteArray& data) {
    constexpr int headerEnd = 33;
    const QByteArray named = name + data;
    return png.left(headerEnd) + number(static_cast<quint32>(data.size()), true) + named +
           number(checksum(named), true) + png.mid(headerEnd);
}

QByteArray pngWith(const QByteArray& exif) {
    static const QByteArray plain = drawn("PNG");
    return withChunk(plain, "eXIf", exif);
}

const QByteArray kExif("Exif\0\0", 6), kPhotoshop("Photoshop 3.0\0", 14);

}  // namespace

class TestPictureMetadata : public QObject {
    Q_OBJECT

  private slots:
    void segments_data();
    void segments();
    void segmentsBehindPixels();
    void oddEntries_data();
    void oddEntries();
    void valuesOfMillions();
    void uselessExif();
    void textsOfAllLanguages();
    void profilesLeftOutAreReported();

  private:
    std::string put(const QString& name, const QByteArray& bytes) {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("disk full");
        return file.fileName().toStdString();
    }
    QByteArray sound(const QString& name, const QByteArray& bytes, PictureFormat format) {
        return QByteArray::fromStdString(bytesWithSoundMetadata(InputFile(put(name, bytes)), format));
    }

    /// Returns a WebP with the metadata behind the pixels, as its container specifies.
    QByteArray webpWith(const QByteArray& exif) {
        const auto chunk = [](const char* name, const QByteArray& data) {
            return name + number(static_cast<quint32>(data.size()), false) + data +
                   QByteArray(data.size() % 2, '\0');
        };
        QByteArray size("\x08\0\0\0", 4);  // there is EXIF
        size += number<quint32>(kWidth - 1, false).left(3) + number<quint32>(kHeight - 1, false).left(3);
        const QByteArray body =
            "WEBP" + chunk("VP8X", size) + chunk("VP8L", webpPixels()) + chunk("EXIF", exif);
        return "RIFF" + number(static_cast<quint32>(body.size()), false) + body;
    }
    QByteArray webpPixels() {
        const std::string path = m_folder.filePath("w.webp").toStdString();
        writeImage(path, readImage(put("w.png", drawn("PNG"))));
        QFile file(QString::fromStdString(path));
        if (!file.open(QIODevice::ReadOnly)) qFatal("no WebP");
        const QByteArray bytes = file.readAll();
        const qsizetype at = bytes.indexOf("VP8L") + 4;
        return bytes.mid(at + 4, qFromLittleEndian<quint32>(bytes.data() + at));
    }

    QTemporaryDir m_folder;
};

void TestPictureMetadata::segments_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<QByteArray>("data");
    QTest::addColumn<bool>("fits");
    const QByteArray iptc("8BIM\x04\x04\0\0\0\0", 10), record("\x1c\x02\x78\0\3abc", 8);
    const auto sized = [](quint16 size) { return number(size, true); };
    QTest::newRow("EXIF") << 0xe1 << kExif + tiff(false, {kTurned}) << true;
    QTest::newRow("a name alone") << 0xe1 << QByteArray("Exif") << false;
    QTest::newRow("nothing") << 0xe1 << QByteArray() << false;
    QTest::newRow("EXIF without a header") << 0xe1 << kExif + "II*" << false;
    QTest::newRow("EXIF of no order of bytes")
        << 0xe1 << kExif + tiff(false, {kTurned}).replace(0, 1, "M") << false;
    QTest::newRow("EXIF, directory outside")
        << 0xe1 << kExif + tiff(false, {kTurned}).replace(4, 1, "\x7f") << false;
    QTest::newRow("EXIF, more entries than there are")
        << 0xe1 << kExif + tiff(false, {kTurned}).replace(8, 1, "\x09") << false;
    QTest::newRow("name of XMP without an end")
        << 0xe1 << QByteArray("http://ns.adobe.com/xap/1.0/") << false;
    QTest::newRow("XMP") << 0xe1 << QByteArray("http://ns.adobe.com/xap/1.0/\0<x/>", 33) << true;
    QTest::newRow("IPTC") << 0xed << kPhotoshop + iptc + sized(8) + record << true;
    QTest::newRow("IPTC, two records") << 0xed << kPhotoshop + iptc + sized(16) + record + record << true;
    QTest::newRow("IPTC beyond the segment") << 0xed << kPhotoshop + iptc + sized(9) + record << false;
    QTest::newRow("a record beyond IPTC") << 0xed << kPhotoshop + iptc + sized(7) + record << false;
    QTest::newRow("IPTC without a size") << 0xed << kPhotoshop + iptc << false;
    QTest::newRow("another resource")
        << 0xed << kPhotoshop + QByteArray("8BIM\x04\x0c\0\0\0\0\xff\xff", 12) << true;
    QTest::newRow("Photoshop's name alone") << 0xed << QByteArray("Photoshop 3.0") << false;
    QTest::newRow("read by nobody") << 0xe5 << QByteArray("Exif") << true;
}

/// Metadata that violate their bounds become a segment that nothing reads; all other bytes stay.
void TestPictureMetadata::segments() {
    QFETCH(int, kind);
    QFETCH(QByteArray, data);
    QFETCH(bool, fits);
    const QByteArray bytes = jpegWith(kind, data);
    QCOMPARE(sound("s.jpg", bytes, PictureFormat::Jpeg),
             fits ? QByteArray() : QByteArray(bytes).replace(3, 1, "\xef"));
    const Image plain = readImage(put("p.jpg", drawn("JPG"))), image = readImage(put("s.jpg", bytes));
    QCOMPARE(image.data.size(), plain.data.size());
    QVERIFY(image.width != plain.width || image.data == plain.data);  // turned by the EXIF that fits
}

void TestPictureMetadata::segmentsBehindPixels() {
    const QByteArray plain = drawn("JPG"), odd = segment(0xe1, "Exif");
    const QByteArray bytes = plain.chopped(2) + odd + plain.right(2);
    QCOMPARE(sound("b.jpg", bytes, PictureFormat::Jpeg),
             QByteArray(bytes).replace(plain.size() - 2, odd.size(), segment(0xef, "Exif")));
    QCOMPARE(sound("e.jpg", plain + odd, PictureFormat::Jpeg),
             QByteArray());  // nothing is read behind the end
}

void TestPictureMetadata::oddEntries_data() {
    QTest::addColumn<QList<Entry>>("entries");
    QTest::addColumn<int>("odd");  // which; -1: none
    const Entry exif{0x8769, 4, 1, kDirectory};
    const auto row = [](const char* name, const QList<Entry>& entries, int odd) {
        QTest::newRow(name) << entries << odd;
    };
    row("none", {kTurned, {0x10e, 2, 10, 30}}, -1);
    row("a text outside", {{0x10e, 2, 10, 1000}, kTurned}, 0);
    row("a text whose end is outside", {kTurned, {0x10e, 2, 500, 30}}, 1);
    row("a length that goes round", {kTurned, {0x10e, 2, 0xfffffff0, 30}}, 1);
    row("no known type", {kTurned, {0x10e, 200, 1, 0}}, 1);
    row("a fraction outside", {kTurned, {0x11a, 5, 1, 60}}, 1);
    row("nothing of it", {kTurned, {0x10e, 2, 0, 0}}, 1);
    row("a directory in itself", {kTurned, exif}, 1);
    row("a directory outside", {kTurned, {0x8825, 4, 1, 0xffff}}, 1);
    row("a maker's note that is none", {{0x927c, 7, 10, 36}, kTurned}, 0);
}

/// The valid entries are kept, in any byte order and in every format.
void TestPictureMetadata::oddEntries() {
    QFETCH(QList<Entry>, entries);
    QFETCH(int, odd);
    for (const bool big : {false, true}) {
        const QByteArray block = tiff(big, entries), bytes = jpegWith(0xe1, kExif + block);
        const QByteArray mended = sound("o.jpg", bytes, PictureFormat::Jpeg);
        QCOMPARE(mended.isEmpty(), odd < 0);
        const qsizetype entry = 2 + 4 + kExif.size() + kDirectory + 2 + 12LL * odd;
        for (qsizetype k = 0; k < mended.size(); ++k)
            QVERIFY(mended[k] == bytes[k] || (k >= entry && k < entry + 12));
        if (odd >= 0) QCOMPARE(mended.mid(entry, 2), QByteArray("\xff\xff"));
        for (const auto& [name, file] :
             {std::pair{"o.jpg", bytes}, {"o.png", pngWith(block)}, {"o.webp", webpWith(block)}}) {
            const std::string path = put(name, file);
            const Image image = readImage(path), header = readImageHeader(path);
            QCOMPARE(std::pair(image.width, image.height), std::pair(kHeight, kWidth));
            QCOMPARE(header.width, kHeight);
        }
        if (odd < 0) continue;
        const QByteArray png = sound("o.png", pngWith(block), PictureFormat::Png);
        QCOMPARE(pngProblem(InputFile(put("m.png", png))), std::string());  // its checksums are right
    }
}

/// A chunk may be as long as it likes.
void TestPictureMetadata::valuesOfMillions() {
    constexpr quint32 count = 2000000;
    const QByteArray block = tiff(false, {kTurned, {0x829a, 5, count, 38}}, QByteArray(8 * count, '\1'));
    for (const auto& [name, file] : {std::pair{"v.png", pngWith(block)}, {"v.webp", webpWith(block)}})
        QCOMPARE(readImage(put(name, file)).width, kHeight);
    // The library does not always fall over it; it never sees it.
    const QByteArray entry = "\x9a\x82\x05";
    QVERIFY(pngWith(block).contains(entry));
    const QByteArray mended = sound("v.png", pngWith(block), PictureFormat::Png);
    QCOMPARE(mended.size(), pngWith(block).size());  // nothing, if there were nothing to mend
    QVERIFY(!mended.contains(entry));
}

void TestPictureMetadata::uselessExif() {
    for (const QByteArray& block :
         {QByteArray("II"), QByteArray("II*\0\x08\0", 6), QByteArray("MM\0*\0\0\x7f\xff", 8)}) {
        const QByteArray bytes = pngWith(block), mended = sound("u.png", bytes, PictureFormat::Png);
        QCOMPARE(mended.size(), bytes.size());
        QVERIFY(!mended.contains("eXIf"));
        QCOMPARE(pngProblem(InputFile(put("u.png", mended))), std::string());
        for (const auto& [name, file] : {std::pair{"u.png", bytes}, {"u.webp", webpWith(block)}})
            QCOMPARE(readImage(put(name, file)).width, kWidth);
    }
}

/// Qt writes and reads texts of PNG files as its standard says: tEXt is Latin-1, iTXt is UTF-8.
void TestPictureMetadata::textsOfAllLanguages() {
    const QList<std::pair<QString, QString>> texts{{"Title", QString::fromUtf8("頭の絵 🦒")},
                                                   {"Author", QString::fromUtf8("José Ñandú")},
                                                   {"Description", QString::fromUtf8("Жираф")},
                                                   {"Comment", "plain"}};
    QImage image(kWidth, kHeight, QImage::Format_RGB888);
    image.fill(Qt::darkGreen);
    for (const auto& [key, text] : texts) image.setText(key, text);
    const QString from = m_folder.filePath("texts.png"), to = m_folder.filePath("written.png");
    QVERIFY(image.save(from));
    writeImage(to.toStdString(), readImage(from.toStdString()));
    const QImage written(to);
    QCOMPARE(written.size(), image.size());
    for (const auto& [key, text] : texts) QCOMPARE(written.text(key), text);
    writeImage(m_folder.filePath("by.tif").toStdString(), readImage(from.toStdString()));
    writeImage(to.toStdString(), readImage(m_folder.filePath("by.tif").toStdString()));
    QCOMPARE(QImage(to).text("Author"), texts[1].second);
    QCOMPARE(QImage(to).text("Description"), texts[2].second);
}

/// libpng drops profiles that it does not like without a word.
void TestPictureMetadata::profilesLeftOutAreReported() {
    QImage grey(kWidth, kHeight, QImage::Format_Grayscale8);
    grey.fill(90);
    QByteArray greyPng;
    QBuffer buffer(&greyPng);
    QVERIFY(grey.save(&buffer, "PNG"));
    const QByteArray rgb = QColorSpace(QColorSpace::AdobeRgb).iccProfile();
    const auto noticesOf = [&](const QByteArray& png, const QByteArray& profile) {
        const QByteArray data = QByteArray("a profile\0\0", 11) + profile;
        std::vector<Message> notices;
        readImage(put("profile.png", withChunk(png, "iCCP", data)), kMaxMegapixels, &notices);
        return notices;
    };
    const auto packed = [](const QByteArray& bytes) { return qCompress(bytes).mid(4); };
    QVERIFY(noticesOf(drawn("PNG"), packed(rgb)).empty());
    for (const auto& [png, profile] : {std::pair{greyPng, packed(rgb)},
                                       {drawn("PNG"), packed(rgb.left(200))},
                                       {drawn("PNG"), packed(QByteArray(500, 'x'))},
                                       {drawn("PNG"), QByteArray("not compressed")}}) {
        const std::vector<Message> notices = noticesOf(png, profile);
        QCOMPARE(notices.size(), std::size_t(1));
        QVERIFY(QString::fromStdString(notices[0]).contains("colour profile that does not fit"));
    }
}

QTEST_GUILESS_MAIN(TestPictureMetadata)
#include "test_picture_metadata.moc"
