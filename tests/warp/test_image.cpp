#include <unistd.h>

#include <QColorSpace>
#include <QDate>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

#include "core/base/error.h"
#include "tests/support/pictures.h"
#include "warp/convert.h"
#include "warp/image_formats.h"
#include "warp/openimageio/image_metadata.h"
#include "warp/picture_metadata.h"

using namespace wend;
using namespace wend::test;

namespace {

Image blank(int width, int height, PixelLayout layout) {
    Image image{width, height, layout.channels, layout.type, layout.alpha, layout.unassociated, {}, nullptr};
    image.data.resize(image.rowBytes() * static_cast<std::size_t>(height));
    return image;
}

/// Returns random numbers, with colours under zero alpha as well.
Image chart(int width, int height, PixelLayout layout) {
    Image image = randomPicture(width, height, layout.channels, layout.type, layout.alpha);
    image.unassociated = layout.unassociated;
    return image;
}

/// Returns a smooth picture like a photograph, for the lossy formats.
Image smoothChart(int width, int height, PixelLayout layout) {
    Image image = blank(width, height, layout);
    std::vector<float> row(static_cast<std::size_t>(width * layout.channels));
    for (int y = 0; y < height; ++y) {
        for (int i = 0; i < width * layout.channels; ++i) {
            const int x = i / layout.channels, c = i % layout.channels;
            row[static_cast<std::size_t>(i)] =
                static_cast<float>(0.5 + 0.4 * std::sin(0.05 * x + c) * std::cos(0.06 * y - c));
        }
        storeRow(image, y, row.data());
    }
    return image;
}

float maxDifference(const Image& a, const Image& b) {
    std::vector<float> p(static_cast<std::size_t>(a.width * a.channels)), q(p);
    float maximum = 0;
    for (int y = 0; y < a.height; ++y) {
        loadRow(a, y, p.data());
        loadRow(b, y, q.data());
        for (std::size_t i = 0; i < p.size(); ++i) maximum = std::max(maximum, std::abs(p[i] - q[i]));
    }
    return maximum;
}

/// The bytes that OpenImageIO finds in an 8-bit file, whatever its format.
std::vector<std::byte> decoded(const std::string& path) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) return {};
    std::vector<std::byte> bytes(input->spec().image_bytes());
    input->read_image(0, 0, 0, -1, OIIO::TypeDesc::UINT8, bytes.data());
    return bytes;
}

std::string reasonOf(const std::string& path) {
    try {
        readImage(path);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

QByteArray bigEndian(quint32 value) {
    QByteArray bytes(4, '\0');
    qToBigEndian(value, bytes.data());
    return bytes;
}

QByteArray withoutChunk(const QByteArray& png, const char* name) {
    const qsizetype at = png.indexOf(name) - 4;
    if (at < 0) return png;
    const auto length = qFromBigEndian<quint32>(png.constData() + at);
    return png.left(at) + png.mid(at + 12 + length);
}

/// Returns a TIFF of one strip of 8 bits: grey or RGB, and a sample that is undeclared or "unspecified".
QByteArray plainTiff(quint16 width, quint16 height, quint16 samples, bool unspecified,
                     const QByteArray& pixels) {
    const auto number = [](quint32 value, int bytes) {
        QByteArray text;
        for (int k = 0; k < bytes; ++k) text += static_cast<char>(value >> 8 * k & 0xff);
        return text;
    };
    const auto entry = [&](quint16 tag, quint16 type, quint32 count, quint32 value) {
        return number(tag, 2) + number(type, 2) + number(count, 4) + number(value, 4);
    };
    const quint32 count = unspecified ? 10 : 9, end = 8 + 2 + 12 * count + 4;
    QByteArray file = QByteArray("II*\0", 4) + number(8, 4) + number(count, 2);
    file += entry(256, 3, 1, width) + entry(257, 3, 1, height) +
            entry(258, 3, samples, samples == 2 ? 0x80008 : end) + entry(259, 3, 1, 1) +
            entry(262, 3, 1, samples == 2 ? 1 : 2) + entry(273, 4, 1, end + 2U * samples) +
            entry(277, 3, 1, samples) + entry(278, 3, 1, height) +
            entry(279, 4, 1, static_cast<quint32>(pixels.size()));
    if (unspecified) file += entry(338, 3, 1, 0);
    file += number(0, 4);
    for (int k = 0; k < samples; ++k) file += number(8, 2);
    return file + pixels;
}

/// A TIFF of one strip, with rows of whole bytes.
struct TiffFacts {
    int width, height, bits, samples, photometric;
    bool isBig, namesBits;
};

/// Returns a TIFF of these samples; of two, the second is unassociated alpha.
QByteArray tiffOf(const TiffFacts& facts, const std::vector<unsigned>& values) {
    QByteArray pixels;
    const auto perRow = static_cast<std::size_t>(facts.width) * static_cast<std::size_t>(facts.samples);
    for (std::size_t row = 0; row < values.size(); row += perRow) {
        QByteArray line;
        int used = 0;
        for (std::size_t k = row; k < row + perRow; ++k) {
            if (facts.bits == 16) {
                line += static_cast<char>(values[k] & 0xffU);
                line += static_cast<char>(values[k] >> 8U);
                continue;
            }
            for (int bit = facts.bits - 1; bit >= 0; --bit, ++used) {
                if (used % 8 == 0) line += '\0';
                line.back() = static_cast<char>(line.back() | (values[k] >> bit & 1U) << (7 - used % 8));
            }
        }
        pixels += line;
    }
    const auto number = [](quint64 value, int bytes) {
        QByteArray text;
        for (int k = 0; k < bytes; ++k) text += static_cast<char>(value >> 8 * k & 0xff);
        return text;
    };
    const int offset = facts.isBig ? 8 : 4;
    QByteArray entries;
    int count = 0;
    const auto entry = [&](quint16 tag, quint16 type, quint64 many, quint64 value) {
        entries += number(tag, 2) + number(type, 2) + number(many, offset) + number(value, offset);
        ++count;
    };
    const quint64 head = facts.isBig ? 16 : 8, both = static_cast<quint64>(facts.bits) * 0x10001U;
    const bool hasAlpha = facts.samples == 2;
    entry(256, 3, 1, static_cast<quint64>(facts.width));
    entry(257, 3, 1, static_cast<quint64>(facts.height));
    if (facts.namesBits) entry(258, 3, hasAlpha ? 2 : 1, hasAlpha ? both : static_cast<quint64>(facts.bits));
    entry(259, 3, 1, 1);
    entry(262, 3, 1, static_cast<quint64>(facts.photometric));
    entry(273, 4, 1, head);
    entry(277, 3, 1, static_cast<quint64>(facts.samples));
    entry(278, 3, 1, static_cast<quint64>(facts.height));
    entry(279, 4, 1, static_cast<quint64>(pixels.size()));
    if (hasAlpha) entry(338, 3, 1, 2);
    const quint64 at = head + static_cast<quint64>(pixels.size());
    const QByteArray start = facts.isBig ? QByteArray("II+\0\x08\0\0\0", 8) : QByteArray("II*\0", 4);
    return start + number(at, offset) + pixels + number(static_cast<quint64>(count), facts.isBig ? 8 : 2) +
           entries + number(0, offset);
}

/// Returns whether a profile means the same colours, by some that Qt converts.
bool sameColours(const std::vector<std::byte>& profile, const QColorSpace& space) {
    const QColorSpace found = QColorSpace::fromIccProfile(
        QByteArray(reinterpret_cast<const char*>(profile.data()), static_cast<qsizetype>(profile.size())));
    if (!found.isValid()) return false;
    const QColorTransform ours = found.transformationToColorSpace(QColorSpace(QColorSpace::SRgb)),
                          theirs = space.transformationToColorSpace(QColorSpace(QColorSpace::SRgb));
    for (const QColor& colour :
         {QColor(200, 90, 60), QColor(70, 160, 90), QColor(80, 90, 200), QColor(128, 128, 128)}) {
        const QColor a = ours.map(colour), b = theirs.map(colour);
        if (std::abs(a.red() - b.red()) > 2 || std::abs(a.green() - b.green()) > 2 ||
            std::abs(a.blue() - b.blue()) > 2)
            return false;
    }
    return true;
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void store(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

/// An EXIF segment that holds the orientation tag alone, put after a JPEG's first two bytes.
QByteArray withOrientation(const QByteArray& jpeg, char orientation) {
    QByteArray tiff("II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0", 18);
    tiff.append(orientation).append(QByteArray(7, '\0'));
    const QByteArray body = QByteArray("Exif\0\0", 6) + tiff;
    QByteArray segment("\xff\xe1", 2);
    segment.append('\0').append(static_cast<char>(body.size() + 2)).append(body);
    return jpeg.left(2) + segment + jpeg.mid(2);
}

}  // namespace

class TestImage : public QObject {
    Q_OBJECT
    QTemporaryDir m_folder;
    std::string path(const QString& name) const { return m_folder.filePath(name).toStdString(); }

  private slots:
    /// The picture is large enough for large pages, whose borders are within it; the second call overwrites
    /// the old pixels.
    void madePixelsAreZero() {
        Image image{1500, 1100, 4, PixelType::Float, true, false, {}, nullptr};
        for (int i = 0; i < 2; ++i) {
            image.makePixels();
            QCOMPARE(image.data.size(), std::size_t(1500) * 1100 * 16);
            QVERIFY(std::all_of(image.data.begin(), image.data.end(),
                                [](std::byte b) { return b == std::byte(0); }));
            std::fill(image.data.begin(), image.data.end(), std::byte(7));
        }
        image.height = 0;
        image.makePixels();
        QVERIFY(image.data.empty());
    }
    void roundTripIsExact_data() {
        QTest::addColumn<QString>("extension");
        QTest::addColumn<int>("type");
        QTest::addColumn<int>("channels");
        QTest::addColumn<bool>("unassociated");
        const auto add = [](const char* extension, PixelType type, int channels, bool unassociated) {
            QTest::addRow("%s type %d channels %d %d", extension, int(type), channels, unassociated)
                << QString(extension) << int(type) << channels << unassociated;
        };
        for (int channels = 1; channels <= 4; ++channels) {
            const bool alpha = channels % 2 == 0;
            for (PixelType type : {PixelType::UInt8, PixelType::UInt16}) add("png", type, channels, alpha);
            for (PixelType type : {PixelType::UInt8, PixelType::UInt16, PixelType::Float}) {
                add("tif", type, channels, false);
                if (alpha) add("tiff", type, channels, true);
            }
            for (PixelType type : {PixelType::Half, PixelType::Float}) add("exr", type, channels, false);
        }
        for (int channels : {3, 4}) add("webp", PixelType::UInt8, channels, channels == 4);
        for (int channels : {1, 3, 4}) add("bmp", PixelType::UInt8, channels, channels == 4);
        for (int channels : {1, 3, 4}) add("tga", PixelType::UInt8, channels, channels == 4);
        add("ppm", PixelType::UInt8, 3, false);
        add("jp2", PixelType::UInt8, 3, false);
    }
    /// Qt's own reader of BMP, which leaves its alpha out, sees the colours as they are.
    void bmpKeepsItsColours() {
        const Image written = chart(61, 43, {PixelType::UInt8, 4, true, true});
        writeImage(path("a.bmp"), written);
        const QImage seen(QString::fromStdString(path("a.bmp")));
        QCOMPARE(seen.size(), QSize(61, 43));
        const Image read = readImage(path("a.bmp"));
        const auto* pixel = reinterpret_cast<const unsigned char*>(read.data.data());
        for (int y = 0; y < 43; ++y)
            for (int x = 0; x < 61; ++x, pixel += 4)
                QCOMPARE(QColor(pixel[0], pixel[1], pixel[2]).rgb(), seen.pixel(x, y) | 0xff000000);
    }

    /// A TIFF declares its three numbers as L*, a*, b*.
    void otherColoursAreRefused_data() {
        QTest::addColumn<int>("photometric");
        for (const int kind : {8, 9, 10}) QTest::addRow("%d", kind) << kind;
    }
    void otherColoursAreRefused() {
        QFETCH(int, photometric);
        writeImage(path("lab.tif"), chart(61, 43, {PixelType::UInt8, 3, false, false}));
        QFile file(QString::fromStdString(path("lab.tif")));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QByteArray bytes = file.readAll();
        const QByteArray tag("\x06\x01\x03\x00\x01\x00\x00\x00\x02\x00", 10);  // RGB
        QCOMPARE(bytes.count(tag), 1);
        QByteArray other = tag;
        other[8] = static_cast<char>(photometric);
        bytes.replace(tag, other);
        file.seek(0);
        file.write(bytes);
        file.close();
        QVERIFY_THROWS_EXCEPTION(InputError, readImage(path("lab.tif")));
    }

    void roundTripIsExact() {
        QFETCH(QString, extension);
        QFETCH(int, type);
        QFETCH(int, channels);
        QFETCH(bool, unassociated);
        const PixelLayout layout{PixelType(type), channels, channels % 2 == 0, unassociated};
        const Image written = chart(61, 43, layout);
        writeImage(path("a." + extension), written);
        if (extension == "jp2") {  // written, but not read again
            QVERIFY(decoded(path("a.jp2")) == written.data);
            return;
        }
        const Image read = readImage(path("a." + extension));
        QVERIFY(layoutOf(read) == layout);
        QCOMPARE(read.width, 61);
        QCOMPARE(read.height, 43);
        QVERIFY(read.data == written.data);
        const Image header = readImageHeader(path("a." + extension));
        QVERIFY(layoutOf(header) == layout && header.width == 61 && header.height == 43 &&
                header.data.empty());

        writeImage(path("b." + extension), read);  // with all the metadata that reading brought
        QVERIFY(readImage(path("b." + extension)).data == written.data);
    }

    void depthGoesToTheNearest_data() {
        QTest::addColumn<QString>("extension");
        QTest::addColumn<int>("from");
        QTest::addColumn<int>("to");
        QTest::newRow("float to png") << "png" << int(PixelType::Float) << int(PixelType::UInt16);
        QTest::newRow("half to png") << "png" << int(PixelType::Half) << int(PixelType::UInt16);
        QTest::newRow("8 bit to exr") << "exr" << int(PixelType::UInt8) << int(PixelType::Half);
        QTest::newRow("16 bit to exr") << "exr" << int(PixelType::UInt16) << int(PixelType::Float);
        QTest::newRow("half to tif") << "tif" << int(PixelType::Half) << int(PixelType::Half);
        QTest::newRow("16 bit to bmp") << "bmp" << int(PixelType::UInt16) << int(PixelType::UInt8);
    }
    void depthGoesToTheNearest() {
        QFETCH(QString, extension);
        QFETCH(int, from);
        QFETCH(int, to);
        const Image written = chart(32, 16, {PixelType(from), 3, false, false});
        writeImage(path("depth." + extension), written);
        const Image read = readImage(path("depth." + extension));
        const bool tiff = extension == "tif";  // halves may come back as floats
        QVERIFY(tiff ? read.type >= PixelType::Half : read.type == PixelType(to));
        const float step = PixelType(to) == PixelType::UInt8 ? 0.5f / 255 : 0.5f / 65535;
        const float halfStep = PixelType(to) == PixelType::Half ? 0x1p-12f : step;
        QVERIFY(maxDifference(read, written) <= halfStep * 1.001f);
        if (PixelType(from) == PixelType::UInt8)
            QVERIFY(converted(read, layoutOf(written)).data == written.data);
    }

    void alphaChangesConvention() {
        Image image = blank(2, 1, {PixelType::Float, 4, true, true});
        const std::vector<float> pixels{0.5f, 0.25f, 1.0f, 0.5f, 0.3f, 0.2f, 0.1f, 0.0f};
        storeRow(image, 0, pixels.data());
        std::vector<float> out(8);
        loadRow(converted(image, {PixelType::Float, 4, true, false}), 0, out.data());
        QCOMPARE(out, (std::vector<float>{0.25f, 0.125f, 0.5f, 0.5f, 0, 0, 0, 0}));
        out.resize(6);
        loadRow(converted(image, {PixelType::Float, 3, false, false}), 0, out.data());
        QCOMPARE(out, (std::vector<float>{0.75f, 0.625f, 1.0f, 1, 1, 1}));

        writeImage(path("assoc.exr"), image);
        const Image associated = readImage(path("assoc.exr"));
        QVERIFY(!associated.unassociated);
        out.resize(8);
        loadRow(associated, 0, out.data());
        QCOMPARE(out, (std::vector<float>{0.25f, 0.125f, 0.5f, 0.5f, 0, 0, 0, 0}));
        writeImage(path("separate.png"), associated);
        loadRow(readImage(path("separate.png")), 0, out.data());
        QVERIFY(std::abs(out[0] - 0.5f) < 1e-4f && std::abs(out[1] - 0.25f) < 1e-4f && out[2] == 1);
        writeImage(path("white.ppm"), image);
        QCOMPARE(int(readImage(path("white.ppm")).channels), 3);
    }

    void lossyFormatsAreClose_data() {
        QTest::addColumn<QString>("extension");
        QTest::addColumn<int>("channels");
        QTest::newRow("jpg") << "jpg" << 3;
        QTest::newRow("gray jpg") << "jpg" << 1;
    }
    void lossyFormatsAreClose() {
        QFETCH(QString, extension);
        QFETCH(int, channels);
        const Image written = smoothChart(120, 90, {PixelType::UInt8, channels, false, false});
        writeImage(path("lossy." + extension), written);
        const Image read = readImage(path("lossy." + extension));
        QCOMPARE(read.channels, channels);
        QVERIFY(maxDifference(read, written) < 8 / 255.0f);
    }

    void jpegIsLaidOverWhite() {
        Image image = blank(16, 16, {PixelType::UInt8, 4, true, true});  // black, transparent
        writeImage(path("white.jpg"), image);
        const Image read = readImage(path("white.jpg"));
        QCOMPARE(read.channels, 3);
        for (std::byte value : read.data) QVERIFY(value == std::byte(255));
    }

    void profileAndTextSurvive_data() {
        QTest::addColumn<QString>("extension");
        for (const char* extension : {"png", "tif", "jpg", "webp"})
            QTest::newRow(extension) << QString(extension);
    }
    void profileAndTextSurvive() {
        QFETCH(QString, extension);
        const QByteArray profile = QColorSpace(QColorSpace::AdobeRgb).iccProfile();
        QImage source(20, 10, QImage::Format_RGB888);
        source.fill(Qt::darkCyan);
        source.setColorSpace(QColorSpace(QColorSpace::AdobeRgb));
        source.setDotsPerMeterX(11811);
        source.setDotsPerMeterY(11811);
        source.setText("Description", "a chart");
        QVERIFY(source.save(m_folder.filePath("icc.png")));
        Image image = readImage(path("icc.png"));
        QCOMPARE(image.iccProfile().size(), std::size_t(profile.size()));
        writeImage(path("kept." + extension), image);
        const Image read = readImage(path("kept." + extension));
        QVERIFY(read.iccProfile() == image.iccProfile());
        const QImage seen(m_folder.filePath("kept." + extension));
        if (extension == "png" || extension == "jpg") {
            QVERIFY(std::abs(seen.dotsPerMeterX() - 11811) <= 40);    // JPEG holds whole dots per inch
            QVERIFY(seen.text("Description").startsWith("a chart"));  // JPEG's ends with a zero
        }
    }

    /// Numbers, lists of them, texts and lists of those are unpacked as they were packed.
    void descriptionIsPacked() {
        OIIO::ImageSpec spec(640, 480, 3, OIIO::TypeDesc::UINT8);
        spec.x = -3, spec.full_y = 7, spec.full_width = 700;
        const float matrix[16] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
        const char* texts[] = {"one", "", "three"};
        spec.attribute("matrix", OIIO::TypeDesc::TypeMatrix, matrix);
        spec.attribute("texts", OIIO::TypeDesc(OIIO::TypeDesc::STRING, 3), texts);
        spec.attribute("text", "line\nline");
        spec.attribute("number", -5);
        const OIIO::ImageSpec read = unpacked(packed(spec));
        QCOMPARE((std::array{read.x, read.full_y, read.full_width, read.width, read.height}),
                 (std::array{-3, 7, 700, 640, 480}));
        QCOMPARE(read.extra_attribs.size(), spec.extra_attribs.size());
        for (const OIIO::ParamValue& value : spec.extra_attribs) {
            const OIIO::ParamValue* found = read.find_attribute(value.name());
            QVERIFY(found && found->type() == value.type());
            QCOMPARE(found->get_string(), value.get_string());
        }
        QCOMPARE(unpacked("no description").extra_attribs.size(), std::size_t(0));
    }

    /// The metadata that a camera wrote are kept.
    void descriptionSurvives_data() {
        QTest::addColumn<QString>("extension");
        for (const char* extension : {"png", "tif", "jpg", "webp"})
            QTest::newRow(extension) << QString(extension);
    }
    void descriptionSurvives() {
        QFETCH(QString, extension);
        Image image = smoothChart(16, 16, {PixelType::UInt8, 3, false, false});
        OIIO::ImageSpec spec;
        spec.attribute("Artist", "A. Painter");
        spec.attribute("ImageDescription", "a small chart");
        spec.attribute("DateTime", "2024:05:06 07:08:09");
        auto metadata = std::make_shared<PictureMetadata>();
        metadata->description = packed(spec);
        image.metadata = metadata;
        writeImage(path("told." + extension), image);
        const Image read = readImage(path("told." + extension));
        const auto told = [&](const char* name) {
            return QString::fromStdString(
                std::string(unpacked(fileMetadata(read)->description).get_string_attribute(name)));
        };
        QVERIFY(told("Artist").startsWith("A. Painter"));
        QVERIFY(told("ImageDescription").startsWith("a small chart"));
        QVERIFY(told("DateTime").startsWith("2024:05:06 07:08:09"));
        QVERIFY(extension == "jpg" || read.data == image.data);
    }

    /// A picture is its display window; its export stores the same part of it again, or the part that is not
    /// zero.
    void displayWindowIsThePicture() {
        const Image part = chart(20, 16, {PixelType::Half, 4, true, false});
        writeExr("window.exr", part, {3, 5, 40, 30, -2, 1});
        std::vector<Message> notices;
        Image image = readImage(path("window.exr"), kMaxMegapixels, &notices);
        QCOMPARE(image.width, 40);
        QCOMPARE(image.height, 30);
        QVERIFY(notices.empty());
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 40; ++x) {
                const bool isStored = x >= 5 && x < 25 && y >= 4 && y < 20;
                for (int c = 0; c < 4; ++c)
                    QCOMPARE(static_cast<float>(valueAt<half>(image, x, y, c)),
                             isStored ? static_cast<float>(valueAt<half>(part, x - 5, y - 4, c)) : 0.0F);
            }
        QCOMPARE(windowsOf("window.exr", image), (std::array{3, 5, 20, 16, -2, 1, 40, 30}));
        reinterpret_cast<half*>(image.row(29))[4 * 30 + 3] = half(1);
        QCOMPARE(windowsOf("grown.exr", image), (std::array{3, 5, 26, 26, -2, 1, 40, 30}));
        writeImage(path("window.png"), image);
        QCOMPARE(QImage(m_folder.filePath("window.png")).size(), QSize(40, 30));
    }

    void overscanIsCutAndReported() {
        writeExr("over.exr", chart(20, 16, {PixelType::Half, 4, true, false}), {-4, 2, 10, 30, 0, 0});
        std::vector<Message> notices;
        const Image image = readImage(path("over.exr"), kMaxMegapixels, &notices);
        QCOMPARE(image.width, 10);
        QCOMPARE(notices.size(), std::size_t(1));
        QVERIFY(QString::fromStdString(notices[0]).contains("beyond its display window of 10 x 30"));
        QCOMPARE(windowsOf("over-out.exr", image), (std::array{0, 2, 10, 16, 0, 0, 10, 30}));
    }

    /// A canvas that fits a shape has its place in the picture.
    void placeIsWritten() {
        Image image = chart(20, 16, {PixelType::Half, 4, true, false});
        image.place = {-7, 3, 40, 30};
        QCOMPARE(windowsOf("place.exr", image), (std::array{-7, 3, 20, 16, 0, 0, 40, 30}));
        image = chart(20, 16, {PixelType::UInt8, 4, true, true});
        image.place = {-7, 3, 40, 30};
        writeImage(path("place.png"), image);
        const QByteArray bytes = contents(m_folder.filePath("place.png"));
        const qsizetype at = bytes.indexOf("oFFs");
        QVERIFY(at > 0);
        QCOMPARE(qFromBigEndian<qint32>(bytes.constData() + at + 4), -7);
        QCOMPARE(qFromBigEndian<qint32>(bytes.constData() + at + 8), 3);
        image.place.x = 7;
        writeImage(path("place.tif"), image);
        const auto input = OIIO::ImageInput::open(path("place.tif"));
        QVERIFY(input);
        QCOMPARE(input->spec().x, 7);
        QCOMPARE(input->spec().y, 3);
        QVERIFY(readImage(path("place.tif")).data == image.data);
    }

    void undeclaredSampleIsAlpha_data() {
        QTest::addColumn<int>("samples");
        QTest::addColumn<bool>("unspecified");
        for (int samples : {2, 4})
            for (bool unspecified : {false, true})
                QTest::addRow("%d samples, %s", samples, unspecified ? "unspecified" : "not named")
                    << samples << unspecified;
    }
    /// The last sample of a TIFF has no declared kind, with a tag that says so or without one.
    void undeclaredSampleIsAlpha() {
        QFETCH(int, samples);
        QFETCH(bool, unspecified);
        const QByteArray pixels = QByteArray("\x10\x20\x30\x40\x50\x60\x70\x80", 8).left(2 * samples);
        QFile file(m_folder.filePath("extra.tif"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(plainTiff(2, 1, static_cast<quint16>(samples), unspecified, pixels));
        file.close();
        std::vector<Message> notices;
        const Image image = readImage(path("extra.tif"), kMaxMegapixels, &notices);
        QVERIFY(image.alpha && image.unassociated);
        QCOMPARE(image.channels, samples);
        QVERIFY(std::memcmp(image.data.data(), pixels.constData(), static_cast<std::size_t>(pixels.size())) ==
                0);
        QCOMPARE(notices.size(), std::size_t(1));
        QVERIFY(QString::fromStdString(notices[0]).contains("taken as alpha"));
    }

    void whiteIsZeroInSomeTiffs_data() {
        QTest::addColumn<int>("bits");
        QTest::addColumn<int>("samples");
        QTest::addColumn<bool>("big");
        for (const int bits : {1, 2, 4, 6, 8, 10, 12, 14, 16})
            for (const bool big : {false, true}) {
                QTest::addRow("%d bits%s", bits, big ? ", BigTIFF" : "") << bits << 1 << big;
                if (bits >= 8 && bits % 8 == 0)
                    QTest::addRow("%d bits, alpha%s", bits, big ? ", BigTIFF" : "") << bits << 2 << big;
            }
    }
    /// The samples of PhotometricInterpretation 0, by the numbers that are written.
    void whiteIsZeroInSomeTiffs() {
        QFETCH(int, bits);
        QFETCH(int, samples);
        QFETCH(bool, big);
        constexpr int kWidth = 11, kHeight = 3;
        const unsigned most = (1U << bits) - 1;
        std::vector<unsigned> values;
        for (int k = 0; k < kWidth * kHeight * samples; ++k)
            values.push_back(static_cast<unsigned>(k * 2654435761U >> 16U) & most);
        const QByteArray bytes = tiffOf({kWidth, kHeight, bits, samples, 0, big, bits > 1}, values);
        QFile file(m_folder.filePath("white.tif"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        const Image image = readImage(path("white.tif"));
        QCOMPARE(image.channels, samples);
        std::vector<float> row(static_cast<std::size_t>(kWidth) * static_cast<std::size_t>(samples));
        for (int y = 0; y < kHeight; ++y) {
            loadRow(image, y, row.data());
            for (std::size_t k = 0; k < row.size(); ++k) {
                const double stored = 1.0 * values[static_cast<std::size_t>(y) * row.size() + k] / most;
                const bool isAlpha = samples == 2 && k % 2 == 1;
                QVERIFY2(std::abs(row[k] - (isAlpha ? stored : 1 - stored)) < 0.005,
                         qPrintable(QString("%1 %2: %3").arg(y).arg(k).arg(row[k])));
            }
        }
    }

    /// TIFF 6.0: BitsPerSample is 1 by default.
    void oneBitIsTheDefaultOfTiffs() {
        for (const int photometric : {0, 1})
            for (const bool big : {false, true}) {
                std::vector<unsigned> values;
                for (unsigned k = 0; k < 40 * 24; ++k) values.push_back(k * k / 7 % 2);
                QFile file(m_folder.filePath("default.tif"));
                QVERIFY(file.open(QIODevice::WriteOnly));
                file.write(tiffOf({40, 24, 1, 1, photometric, big, false}, values));
                file.close();
                const Image image = readImage(path("default.tif"));
                QCOMPARE(image.channels, 1);
                std::vector<float> row(40);
                for (int y = 0; y < 24; ++y) {
                    loadRow(image, y, row.data());
                    for (std::size_t x = 0; x < 40; ++x) {
                        const bool isSet = values[static_cast<std::size_t>(y) * 40 + x] != 0;
                        QCOMPARE(row[x], isSet == (photometric == 1) ? 1.0F : 0.0F);
                    }
                }
            }
    }

    /// A directory that refers to itself is one page.
    void circlesOfTiffDirectoriesEnd() {
        const std::vector<unsigned> values{1, 0, 1, 1, 0, 0, 1, 0};
        QByteArray bytes = tiffOf({8, 1, 1, 1, 0, false, false}, values);
        bytes = bytes.chopped(4) + bytes.mid(4, 4);  // the place of the first one
        QFile file(m_folder.filePath("circle.tif"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        const Image image = readImage(path("circle.tif"));
        for (std::size_t x = 0; x < 8; ++x)
            QCOMPARE(image.data[x], values[x] != 0 ? std::byte(0) : std::byte(255));
    }

    void furtherChannelsAndPicturesAreNamed() {
        OIIO::ImageSpec spec(4, 4, 6, OIIO::TypeDesc::HALF);
        spec.channelnames = {"R", "G", "B", "A", "Z", "id"};
        spec.alpha_channel = 3, spec.z_channel = 4;
        const std::vector<half> values(4 * 4 * 6, half(0.5F));
        const auto exr = OIIO::ImageOutput::create("exr");
        QVERIFY(exr->open(path("deep.exr"), spec) && exr->write_image(OIIO::TypeDesc::HALF, values.data()) &&
                exr->close());
        std::vector<Message> notices;
        const Image image = readImage(path("deep.exr"), kMaxMegapixels, &notices);
        QVERIFY(image.metadata->leftOut == (std::vector<std::string>{"Z", "id"}));
        QCOMPARE(notices.size(), std::size_t(1));
        QVERIFY(QString::fromStdString(notices[0]).contains("Z, id"));

        const OIIO::ImageSpec first(6, 4, 3, OIIO::TypeDesc::UINT8), second(5, 3, 1, OIIO::TypeDesc::UINT8);
        const std::vector<unsigned char> bytes(6 * 4 * 3, 90);
        const auto tiff = OIIO::ImageOutput::create("tif");
        QVERIFY(tiff->open(path("pages.tif"), first) &&
                tiff->write_image(OIIO::TypeDesc::UINT8, bytes.data()) &&
                tiff->open(path("pages.tif"), second, OIIO::ImageOutput::AppendSubimage) &&
                tiff->write_image(OIIO::TypeDesc::UINT8, bytes.data()) && tiff->close());
        notices.clear();
        const Image page = readImage(path("pages.tif"), kMaxMegapixels, &notices);
        QCOMPARE(page.width, 6);
        QVERIFY(page.metadata->pictures == (std::vector<std::string>{"1: 6 x 4", "2: 5 x 3"}));
        QVERIFY(QString::fromStdString(notices.at(0)).contains("has 2 pictures"));
    }

    void numbersThatAreNotFiniteAreReported() {
        Image image = chart(9, 7, {PixelType::Float, 4, true, false});
        writeImage(path("finite.exr"), image);
        std::vector<Message> notices;
        readImage(path("finite.exr"), kMaxMegapixels, &notices);
        QVERIFY(notices.empty());
        auto* row = reinterpret_cast<float*>(image.row(4));
        row[4 * 6] = std::numeric_limits<float>::infinity();
        row[4 * 8 + 3] = std::numeric_limits<float>::quiet_NaN();
        writeImage(path("odd.exr"), image);
        QVERIFY(readImage(path("odd.exr"), kMaxMegapixels, &notices).data == image.data);
        QCOMPARE(QString::fromStdString(notices.at(0)),
                 QString::fromStdString(path("odd.exr")) +
                     ": 2 pixels are not finite numbers (NaN or infinity), the first at x 6, y 4");
    }

    void coloursByNumbersBecomeAProfile_data() {
        QTest::addColumn<QByteArray>("chunks");
        QTest::addColumn<QColorSpace>("space");
        QByteArray primaries;
        for (const quint32 value : {31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000})
            primaries += bigEndian(value);
        const QByteArray chrm = chunk("cHRM", primaries);
        QTest::newRow("cHRM and gAMA")
            << chrm + chunk("gAMA", bigEndian(45455)) << QColorSpace(QColorSpace::Primaries::DciP3D65, 2.2F);
        QTest::newRow("cHRM alone") << chrm << QColorSpace(QColorSpace::DisplayP3);
        QTest::newRow("gAMA alone") << chunk("gAMA", bigEndian(100000))
                                    << QColorSpace(QColorSpace::SRgbLinear);
        QTest::newRow("cICP") << chunk("cICP", QByteArray("\x0c\x0d\0\x01", 4))
                              << QColorSpace(QColorSpace::DisplayP3);
        QTest::newRow("cICP wins") << chunk("cICP", QByteArray("\x0c\x0d\0\x01", 4)) +
                                          chunk("gAMA", bigEndian(100000))
                                   << QColorSpace(QColorSpace::DisplayP3);
    }
    /// Qt reads the profile, of the picture and of all files that hold one; nothing beside it says otherwise.
    void coloursByNumbersBecomeAProfile() {
        QFETCH(QByteArray, chunks);
        QFETCH(QColorSpace, space);
        writeImage(path("plain.png"), smoothChart(8, 8, {PixelType::UInt8, 3, false, false}));
        QByteArray bytes = contents(m_folder.filePath("plain.png"));
        for (const char* name : {"sRGB", "gAMA", "cHRM"}) bytes = withoutChunk(bytes, name);
        bytes.insert(33, chunks);
        QFile file(m_folder.filePath("numbers.png"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        file.close();
        const Image image = readImage(path("numbers.png"));
        QVERIFY(sameColours(image.iccProfile(), space));
        for (const char* extension : {"png", "tif", "jpg", "webp"}) {
            writeImage(path(QStringLiteral("numbers-out.") + extension), image);
            QVERIFY(
                sameColours(readImage(path(QStringLiteral("numbers-out.") + extension)).iccProfile(), space));
        }
        const QByteArray out = contents(m_folder.filePath("numbers-out.png"));
        for (const char* name : {"sRGB", "gAMA", "cHRM"}) QVERIFY(!out.contains(name));
    }

    void chromaticitiesOfExrAreKept() {
        OIIO::ImageSpec spec(4, 4, 3, OIIO::TypeDesc::HALF);
        const std::array numbers{0.68F, 0.32F, 0.265F, 0.69F, 0.15F, 0.06F, 0.3127F, 0.329F};
        spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), numbers.data());
        const std::vector<half> values(4 * 4 * 3, half(0.5F));
        const auto exr = OIIO::ImageOutput::create("exr");
        QVERIFY(exr->open(path("p3.exr"), spec) && exr->write_image(OIIO::TypeDesc::HALF, values.data()) &&
                exr->close());
        const Image image = readImage(path("p3.exr"));
        const QColorSpace linear(QColorSpace::Primaries::DciP3D65, QColorSpace::TransferFunction::Linear);
        QVERIFY(sameColours(image.iccProfile(), linear));
        writeImage(path("p3-out.exr"), image);
        QVERIFY(sameColours(readImage(path("p3-out.exr")).iccProfile(), linear));
        QVERIFY(!losesProfile("a.exr", image));
        QVERIFY(losesProfile("a.bmp", image));
    }

    /// The same picture gives the same file on another day: no library writes the time.
    void filesAreNotDated_data() {
        QTest::addColumn<QString>("extension");
        for (const char* extension : {"png", "tif", "exr", "jpg", "webp", "bmp", "tga", "jp2", "ppm", "hdr"})
            QTest::newRow(extension) << QString(extension);
    }
    void filesAreNotDated() {
        QFETCH(QString, extension);
        writeImage(path("dated." + extension), smoothChart(32, 32, {PixelType::UInt8, 3, false, false}));
        QFile file(m_folder.filePath("dated." + extension));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY(bytes.size() > 100);
        for (const char* way : {"yyyy:MM:dd", "yyyy-MM-dd", "yyyyMMdd"})
            for (const int days : {-1, 0, 1})
                QVERIFY(!bytes.contains(QDate::currentDate().addDays(days).toString(way).toLatin1()));
    }

    /// OpenJPEG would write an empty file.
    void tooSmallForJpeg2000() {
        const PixelLayout layout{PixelType::UInt8, 3, false, false};
        writeImage(path("small.jp2"), smoothChart(32, 33, layout));
        QVERIFY_THROWS_EXCEPTION(InputError, writeImage(path("smaller.jp2"), smoothChart(40, 31, layout)));
        QVERIFY(!QFile::exists(m_folder.filePath("smaller.jp2")));
    }

    /// A line drawing of few colours is packed a second time, beyond deflate.
    void packedPixelsAreRead_data() {
        QTest::addColumn<int>("format");
        QTest::newRow("1 bit gray") << int(QImage::Format_Mono);
        QTest::newRow("palette") << int(QImage::Format_Indexed8);
    }
    void packedPixelsAreRead() {
        QFETCH(int, format);
        QImage source(3000, 3000, QImage::Format(format));
        if (format == QImage::Format_Mono)
            source.setColorTable({qRgb(0, 0, 0), qRgb(255, 255, 255)});
        else
            source.setColorTable({qRgb(200, 0, 30), qRgb(10, 20, 250)});
        source.fill(1);
        for (int i = 0; i < 3000; i += 617) source.setPixel(i, i, 0);  // 1234 is the third
        QVERIFY(source.save(m_folder.filePath("packed.png"), nullptr, 0));
        const Image image = readImage(path("packed.png"));
        QCOMPARE(image.width, 3000);
        std::vector<float> row(static_cast<std::size_t>(3000 * image.channels));
        loadRow(image, 1234, row.data());
        const QRgb line = source.colorTable()[0], ground = source.colorTable()[1];
        QCOMPARE(std::lround(255 * row[static_cast<std::size_t>(1234 * image.channels)]), long(qRed(line)));
        QCOMPARE(std::lround(255 * row[0]), long(qRed(ground)));
        QCOMPARE(std::lround(255 * row[static_cast<std::size_t>(image.colours() - 1)]), long(qBlue(ground)));
    }

    void brokenProfileIsDropped() {
        QImage source(8, 8, QImage::Format_Grayscale8);
        source.fill(100);
        QVERIFY(source.save(m_folder.filePath("g.png")));
        QByteArray png = contents(m_folder.filePath("g.png"));
        QVERIFY(!png.isEmpty());
        QImage colour(8, 8, QImage::Format_RGB888);
        colour.fill(Qt::red);
        colour.setColorSpace(QColorSpace(QColorSpace::SRgb));
        QVERIFY(colour.save(m_folder.filePath("c.jpg"), "JPG"));
        QByteArray jpeg = contents(m_folder.filePath("c.jpg"));
        const int at = jpeg.indexOf("acsp");
        QVERIFY(at > 0);
        jpeg.replace(at, 4, "xxxx");
        store(m_folder.filePath("c.jpg"), jpeg);
        const Image read = readImage(path("c.jpg"));
        QVERIFY(read.iccProfile().empty());
        writeImage(path("c.png"), read);
        QVERIFY(readImage(path("c.png")).data == read.data);
    }

    /// Crop windows are near the limits of 32 bits: sums of places and rows would overflow.
    void farAwayIsRefused_data() {
        QTest::addColumn<QString>("extension");
        QTest::addColumn<int>("x");
        QTest::addColumn<int>("y");
        for (const char* extension : {"png", "tif"}) {
            QTest::addRow("%s, down", extension) << QString(extension) << 0 << 0x7fff0000;
            QTest::addRow("%s, right", extension) << QString(extension) << 0x7fff0000 << 0;
        }
    }
    void farAwayIsRefused() {
        QFETCH(QString, extension);
        QFETCH(int, x);
        QFETCH(int, y);
        const std::string name = path("far." + extension);
        if (extension == "png") {
            QImage(23, 17, QImage::Format_RGB888).save(QString::fromStdString(name));
            QByteArray offset(9, '\0');
            qToBigEndian(x, offset.data());
            qToBigEndian(y, offset.data() + 4);
            QByteArray png = contents(QString::fromStdString(name));
            store(QString::fromStdString(name), png.insert(33, chunk("oFFs", offset)));
        } else {
            OIIO::ImageSpec spec(23, 17, 3, OIIO::TypeDesc::UINT8);
            spec.x = x, spec.y = y;
            const auto output = OIIO::ImageOutput::create(name);
            const std::vector<float> pixels(23 * 17 * 3);
            QVERIFY(output->open(name, spec) && output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) &&
                    output->close());
        }
        const std::string said = reasonOf(name);
        QVERIFY2(said.find("from its origin") != std::string::npos, said.c_str());
    }

    void oddProfilesAreWrittenWithoutAWord_data() {
        QTest::addColumn<int>("at");
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("sound") << 0 << QByteArray();
        QTest::newRow("device") << 12 << QByteArray("abst");
        QTest::newRow("connection space") << 20 << QByteArray("RGB ");
        QTest::newRow("intent") << 64 << QByteArray("\0\0\0\7", 4);
        QTest::newRow("light") << 68 << QByteArray(12, '\0');
        QTest::newRow("number of tags") << 128 << QByteArray("\0\0\x10\0", 4);
        QTest::newRow("place of a tag") << 136 << QByteArray("\0\1\0\0", 4);
        QTest::newRow("size of a tag") << 140 << QByteArray("\0\1\0\0", 4);
    }
    /// Formats that cannot hold such a profile leave it out; no library prints a line, and the pixels are the
    /// same.
    void oddProfilesAreWrittenWithoutAWord() {
        QFETCH(int, at);
        QFETCH(QByteArray, bytes);
        QImage colour(8, 8, QImage::Format_RGB888);
        colour.fill(Qt::red);
        colour.setColorSpace(QColorSpace(QColorSpace::SRgb));
        QVERIFY(colour.save(m_folder.filePath("odd.jpg"), "JPG", 100));
        QByteArray jpeg = contents(m_folder.filePath("odd.jpg"));
        const auto profile = jpeg.indexOf("acsp") - 36;
        QVERIFY(profile > 0);
        store(m_folder.filePath("odd.jpg"), jpeg.replace(profile + at, bytes.size(), bytes));
        const Image image = readImage(path("odd.jpg"));
        QVERIFY(!image.iccProfile().empty());
        QFile said(m_folder.filePath("said"));
        QVERIFY(said.open(QIODevice::ReadWrite | QIODevice::Truncate));
        std::fflush(stderr);
        const int before = dup(STDERR_FILENO);
        dup2(said.handle(), STDERR_FILENO);
        for (const char* extension : {"png", "tif", "exr", "jpg", "webp", "bmp", "tga", "ppm", "hdr"})
            writeImage(path(QStringLiteral("odd-out.") + extension), image);
        std::fflush(stderr);
        dup2(before, STDERR_FILENO);
        ::close(before);
        QCOMPARE(contents(said.fileName()), QByteArray());
        const Image read = readImage(path("odd-out.png"));
        QVERIFY(read.data == image.data);
        QCOMPARE(read.iccProfile().empty(), !bytes.isEmpty());
        QVERIFY(readImage(path("odd-out.tif")).iccProfile() == image.iccProfile());
    }

    /// A write that ends before the first pixels, as on Ctrl+C, prints nothing and leaves no file.
    void abandonedPicturesPrintNothing() {
        QFile said(m_folder.filePath("said"));
        QVERIFY(said.open(QIODevice::ReadWrite | QIODevice::Truncate));
        std::fflush(stderr);
        const int before = dup(STDERR_FILENO);
        dup2(said.handle(), STDERR_FILENO);
        int abandoned = 0;
        const Image header = chart(300, 200, {PixelType::UInt8, 3, false, false});
        for (const char* extension : {"png", "tif", "exr", "jpg", "webp", "bmp", "tga", "ppm", "hdr", "jp2"})
            for (const int rows : {0, 100}) try {
                    writeImage(path(QStringLiteral("abandoned.") + extension), header, 50,
                               [rows](int top, Image&) {
                                   if (top >= rows) throw Cancelled();
                               });
                } catch (const Cancelled&) {
                    ++abandoned;
                }
        std::fflush(stderr);
        dup2(before, STDERR_FILENO);
        ::close(before);
        QCOMPARE(abandoned, 20);
        QCOMPARE(contents(said.fileName()), QByteArray());
        QVERIFY(!QFile::exists(m_folder.filePath("abandoned.png")));
    }

    void orientationIsHonoured_data() {
        QTest::addColumn<int>("orientation");
        for (int i = 1; i <= 8; ++i) QTest::addRow("%d", i) << i;
    }
    void orientationIsHonoured() {
        QFETCH(int, orientation);
        writeImage(path("up.jpg"), smoothChart(48, 32, {PixelType::UInt8, 3, false, false}));
        store(m_folder.filePath("turned.jpg"),
              withOrientation(contents(m_folder.filePath("up.jpg")), static_cast<char>(orientation)));
        const Image stored = readImage(path("up.jpg")), shown = readImage(path("turned.jpg"));
        const Image header = readImageHeader(path("turned.jpg"));
        QCOMPARE(header.width, shown.width);
        QCOMPARE(shown.width, orientation < 5 ? 48 : 32);
        // Where the stored pixel (u, v) is seen, by the table of the EXIF standard.
        for (int v = 0; v < 32; ++v)
            for (int u = 0; u < 48; ++u) {
                const std::array<std::array<int, 2>, 8> places{{{u, v},
                                                                {47 - u, v},
                                                                {47 - u, 31 - v},
                                                                {u, 31 - v},
                                                                {v, u},
                                                                {31 - v, u},
                                                                {31 - v, 47 - u},
                                                                {v, 47 - u}}};
                const auto [x, y] = places[static_cast<std::size_t>(orientation - 1)];
                QVERIFY(std::memcmp(stored.row(v) + 3 * u, shown.row(y) + 3 * x, 3) == 0);
            }
        writeImage(path("again.jpg"), shown);  // the tag must be gone, or it would be turned twice
        QCOMPARE(readImage(path("again.jpg")).width, shown.width);
        QVERIFY(maxDifference(readImage(path("again.jpg")), shown) < 8 / 255.0f);
    }

    void damagedFilesAreRefused_data() {
        QTest::addColumn<QString>("extension");
        QTest::addColumn<double>("kept");
        for (const QString extension : {"png", "tif", "exr", "jpg", "webp", "bmp", "tga", "ppm"})
            for (double kept : {0.97, 0.5, 0.02})
                QTest::newRow(qPrintable(extension + ' ' + QString::number(kept))) << extension << kept;
    }
    void damagedFilesAreRefused() {
        QFETCH(QString, extension);
        QFETCH(double, kept);
        writeImage(path("whole." + extension), chart(300, 200, {PixelType::UInt8, 3, false, false}));
        QVERIFY(reasonOf(path("whole." + extension)).empty());
        const QByteArray bytes = contents(m_folder.filePath("whole." + extension));
        const QString name = m_folder.filePath("cut." + extension);
        store(name, bytes.left(int(bytes.size() * kept)));
        const std::string reason = reasonOf(name.toStdString());
        QVERIFY2(reason.starts_with(name.toStdString() + ": "), reason.c_str());
        QCOMPARE(reason.find('\n'), std::string::npos);
    }

    void corruptFilesAreRefused_data() {
        QTest::addColumn<QString>("extension");
        for (const char* extension : {"png", "exr", "jpg"}) QTest::newRow(extension) << QString(extension);
    }
    void corruptFilesAreRefused() {
        QFETCH(QString, extension);
        writeImage(path("sound." + extension), chart(300, 200, {PixelType::UInt8, 3, false, false}));
        QByteArray bytes = contents(m_folder.filePath("sound." + extension));
        for (int i = int(bytes.size() / 2); i < bytes.size() / 2 + 200; ++i) bytes[i] = bytes[i] ^ 0x5a;
        store(m_folder.filePath("corrupt." + extension), bytes);
        QVERIFY(!reasonOf(path("corrupt." + extension)).empty());
    }

    void paddingInJpegIsAccepted() {  // some cameras leave bytes before the end
        writeImage(path("plain.jpg"), smoothChart(64, 48, {PixelType::UInt8, 3, false, false}));
        QByteArray bytes = contents(m_folder.filePath("plain.jpg"));
        bytes.insert(bytes.size() - 2, QByteArray("\x01\x02\x03\x04", 4));
        store(m_folder.filePath("padded.jpg"), bytes);
        QVERIFY(readImage(path("padded.jpg")).data == readImage(path("plain.jpg")).data);
    }

    void otherFilesAreRefused() {
        store(m_folder.filePath("empty.png"), {});
        store(m_folder.filePath("text.png"), "hello there, this is not a picture\n");
        QVERIFY(reasonOf(path("empty.png")).ends_with("is empty"));
        QVERIFY(!reasonOf(path("text.png")).empty());
        QVERIFY(reasonOf(path("missing.png")).ends_with("does not exist"));
        QVERIFY(reasonOf(m_folder.path().toStdString()).ends_with("is a folder"));
        QVERIFY(canWriteImage("a.JPG") && !canWriteImage("a.dpx") && !canWriteImage("tif"));
        QVERIFY_THROWS_EXCEPTION(InputError, writeImage(path("a.xyz"), blank(2, 2, {})));
        QVERIFY_THROWS_EXCEPTION(InputError, writeImage(path("a"), blank(2, 2, {})));
        QVERIFY_THROWS_EXCEPTION(InputError, writeImage(path("none/a.png"), blank(2, 2, {})));
        QVERIFY_THROWS_EXCEPTION(InputError, writeImage(path("a.png"), Image()));
    }

    /// Each file is damaged in one way, with valid checksums: it is refused before libpng prints a line of
    /// its own.
    void brokenPngStructure_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("reason");
        const auto header = [](int depth, int type) {
            QByteArray data("\0\0\0\2\0\0\0\2", 8);
            data.append(char(depth)).append(char(type)).append(QByteArray(3, '\0'));
            return chunk("IHDR", data);
        };
        const QByteArray start("\x89PNG\r\n\x1a\n"), end = chunk("IEND", {});
        const auto pixels = [](const QByteArray& raw) { return chunk("IDAT", qCompress(raw).mid(4)); };
        const QByteArray good = pixels(QByteArray(14, '\0')), rgb = header(8, 2);
        const auto row = [&](const char* name, const QByteArray& chunks, const char* reason) {
            QTest::newRow(name) << start + chunks << reason;
        };
        row("depth", header(3, 2) + good + end, "header that makes no sense");
        row("no palette", header(8, 3) + good + end, "has no palette");
        row("needed and unknown", rgb + chunk("ABCD", "x") + good + end, "is not known");
        row("no name", rgb + chunk("te\x1bt", "x") + good + end, "no name of one");
        row("twice", rgb + rgb + good + end, "header that makes no sense");
        row("no pixels", rgb + end, "holds no pixels");
        row("apart", rgb + chunk("IDAT", {}) + chunk("tIME", QByteArray(7, '\1')) + good + end, "apart");
        row("filter", rgb + pixels(QByteArray(14, '\x09')) + end, "damaged");
        row("no zlib", rgb + chunk("IDAT", "hello world hello") + end, "damaged");
        row("too short", rgb + pixels(QByteArray(9, '\0')) + end, "too few data");
        // All scanlines come out, and more; the end of the compressed data is missing.
        row("no end of the data",
            rgb + chunk("IDAT", qCompress(QByteArray(90000, '\0')).mid(4).chopped(12)) + end, "too few data");
        row("no end", rgb + good, "its end is missing");
        row("checksum", rgb + good.chopped(1) + '\x55' + end, "its checksum is another");
    }
    void brokenPngStructure() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, reason);
        store(m_folder.filePath("broken.png"), bytes);
        const std::string said = reasonOf(path("broken.png"));
        QVERIFY2(QString::fromStdString(said).contains(reason), said.c_str());
    }

    void hugeClaimsAreRefused() {
        writeImage(path("small.png"), blank(100, 100, {PixelType::UInt8, 1, false, false}));
        QVERIFY_THROWS_EXCEPTION(InputError, readImage(path("small.png"), 0.001));
        QByteArray bytes = contents(m_folder.filePath("small.png"));
        const QByteArray header("\0\0\x4e\x20\0\0\x4e\x20",
                                8);  // 20000 x 20000: within the limit, not within the file
        bytes.replace(16, 8, header);
        const quint32 crc = crcOf(bytes.mid(12, 17));
        for (int i = 0; i < 4; ++i) bytes[29 + i] = static_cast<char>(crc >> (24 - 8 * i));
        store(m_folder.filePath("claims.png"), bytes);
        const std::string reason = reasonOf(path("claims.png"));
        QVERIFY2(reason.find("claims more pixels") != std::string::npos, reason.c_str());
    }

    void aFailedWriteLeavesTheOldFile() {
        const Image image = chart(20, 20, {PixelType::UInt8, 3, false, false});
        writeImage(path("old.png"), image);
        const QByteArray before = contents(m_folder.filePath("old.png"));
        QVERIFY_THROWS_EXCEPTION(InputError, writeImage(path("old.png"), Image()));
        QCOMPARE(contents(m_folder.filePath("old.png")), before);
    }

  private:
    /// Writes an EXR file with x, y of the pixels and the size of the display window, and its x and y.
    void writeExr(const QString& name, const Image& image, const std::array<int, 6>& window) {
        OIIO::ImageSpec spec(image.width, image.height, 4, OIIO::TypeDesc::HALF);
        spec.x = window[0], spec.y = window[1], spec.full_width = window[2], spec.full_height = window[3];
        spec.full_x = window[4], spec.full_y = window[5];
        const auto output = OIIO::ImageOutput::create("exr");
        const bool isWritten = output->open(path(name), spec) &&
                               output->write_image(OIIO::TypeDesc::HALF, image.data.data()) &&
                               output->close();
        if (!isWritten) qFatal("no EXR");
    }
    /// Writes the picture; returns data window and display window of the file, each with its place first.
    std::array<int, 8> windowsOf(const QString& name, const Image& image) {
        writeImage(path(name), image);
        const auto input = OIIO::ImageInput::open(path(name));
        if (!input) return {};
        const OIIO::ImageSpec& is = input->spec();
        return {is.x, is.y, is.width, is.height, is.full_x, is.full_y, is.full_width, is.full_height};
    }
    static QByteArray chunk(const QByteArray& name, const QByteArray& data) {
        const auto number = [](quint32 value) {
            QByteArray bytes;
            for (int i = 0; i < 4; ++i) bytes.append(char(value >> (24 - 8 * i)));
            return bytes;
        };
        return number(quint32(data.size())) + name + data + number(crcOf(name + data));
    }
    static quint32 crcOf(const QByteArray& bytes) {
        quint32 crc = 0xffffffffu;
        for (char c : bytes) {
            crc ^= static_cast<unsigned char>(c);
            for (int i = 0; i < 8; ++i) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
        }
        return ~crc;
    }
};

QTEST_GUILESS_MAIN(TestImage)
#include "test_image.moc"
