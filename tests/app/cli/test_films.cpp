// Films by the command line, read back by ffprobe and ffmpeg and compared with the frames one by one.

#include <sys/resource.h>

#include <QColorSpace>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>
#include <sstream>

#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"

using namespace wend;

namespace {

QByteArray outputOf(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    process.waitForFinished(60000);
    return process.readAllStandardOutput();
}

/// The properties that ffprobe reports for a film.
struct Probe {
    QJsonObject video, sound;
    int frames = 0;
    double rate = 0, seconds = 0;
    QSize size;
};

Probe probe(const QString& file) {
    const QByteArray text = outputOf(
        "ffprobe", {"-v", "error", "-count_frames", "-show_streams", "-show_format", "-of", "json", file});
    const QJsonObject all = QJsonDocument::fromJson(text).object();
    Probe found;
    for (const QJsonValue stream : all["streams"].toArray()) {
        const QJsonObject one = stream.toObject();
        (one["codec_type"].toString() == "video" ? found.video : found.sound) = one;
    }
    found.frames = found.video["nb_read_frames"].toString().toInt();
    const QStringList rate = found.video["avg_frame_rate"].toString().split('/');
    if (rate.size() == 2) found.rate = rate[0].toDouble() / rate[1].toDouble();
    found.seconds = all["format"].toObject()["duration"].toString().toDouble();
    found.size = {found.video["width"].toInt(), found.video["height"].toInt()};
    return found;
}

/// All pictures of a film, with their transparency.
QList<QImage> picturesOf(const QString& file) {
    QStringList words{"-v", "error"};
    if (file.endsWith(".webm"))
        words << "-c:v"
              << "libvpx-vp9";  // the other decoder skips transparency
    const QByteArray bytes =
        outputOf("ffmpeg", words + QStringList{"-i", file, "-fps_mode", "passthrough", "-f", "rawvideo",
                                               "-pix_fmt", "rgba", "pipe:1"});
    const QSize size = probe(file).size;
    const qsizetype one = qsizetype(4) * size.width() * size.height();
    QList<QImage> pictures;
    for (qsizetype at = 0; one > 0 && at + one <= bytes.size(); at += one)
        pictures << QImage(reinterpret_cast<const uchar*>(bytes.constData() + at), size.width(),
                           size.height(), 4 * size.width(), QImage::Format_RGBA8888)
                        .copy();
    return pictures;
}

/// Returns the picture on an opaque ground, cropped to the size.
QImage onGround(const QImage& picture, const QColor& ground, const QSize& size) {
    QImage flat(size, QImage::Format_RGB32);
    for (int y = 0; y < size.height(); ++y)
        for (int x = 0; x < size.width(); ++x) {
            const QColor c = picture.pixelColor(x, y);
            const double a = c.alphaF();
            const auto mixed = [&](int own, int under) {
                return int(std::lround(a * own + (1 - a) * under));
            };
            flat.setPixel(x, y,
                          qRgb(mixed(c.red(), ground.red()), mixed(c.green(), ground.green()),
                               mixed(c.blue(), ground.blue())));
        }
    return flat;
}

/// Returns the mean difference of the channels, of 255, as seen on white, and of alpha.
double difference(const QImage& one, const QImage& other, const QSize& size) {
    const QImage a = onGround(one, Qt::white, size), b = onGround(other, Qt::white, size);
    double sum = 0;
    for (int y = 0; y < size.height(); ++y)
        for (int x = 0; x < size.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            sum +=
                std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
        }
    return sum / (3.0 * size.width() * size.height());
}

/// A smooth disc, which lossy formats keep well.
Image smoothDisc(int width, int height, double radius) {
    Image image = discPicture(std::max(width, height), radius);
    Image part = image;
    part.width = width, part.height = height;
    part.data.clear();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            std::byte* pixel = image.row(y) + 4 * x;
            if (pixel[3] != std::byte(0)) {
                pixel[0] = std::byte(60 + x);
                pixel[1] = std::byte(40 + y);
                pixel[2] = std::byte(120);
            }
            part.data.insert(part.data.end(), pixel, pixel + 4);
        }
    return part;
}

/// A WAV file of one channel with 8000 samples a second, each of which is its number modulo 20000.
std::string countingSound(int samples) {
    const auto number = [](std::uint32_t value, int bytes) {
        std::string text;
        for (int k = 0; k < bytes; ++k) text += static_cast<char>(value >> (8 * k) & 0xff);
        return text;
    };
    std::string data;
    for (int k = 0; k < samples; ++k) data += number(std::uint32_t(k % 20000), 2);
    const auto size = static_cast<std::uint32_t>(data.size());
    return "RIFF" + number(36 + size, 4) + "WAVEfmt " + number(16, 4) + number(1, 2) + number(1, 2) +
           number(8000, 4) + number(16000, 4) + number(2, 2) + number(16, 2) + "data" + number(size, 4) +
           data;
}

const QString kFormats[] = {"mp4", "webm", "mov", "gif", "png", "webp"};

}  // namespace

class TestFilms : public QObject {
    Q_OBJECT
  private slots:
    void initTestCase();
    void filmIsTheSequence_data();
    void filmIsTheSequence();
    void sizesAreEvenWhereTheCodecAsks_data();
    void sizesAreEvenWhereTheCodecAsks();
    void picturesAreScaled();
    void fittedFramesAreEven();
    void filmLastsAsLongAsTheMotion_data();
    void filmLastsAsLongAsTheMotion();
    void loopHasNoFrameTwice();
    void cycleIsWhatLoops();
    void walkerWalksOn();
    void soundIsThatOfTheTime_data();
    void soundIsThatOfTheTime();
    void soundOfAShortFileEnds();
    void sameFilmTwiceIsTheSameFile();
    void severalFilmsAtOnce();
    void ffmpegIsMissing();
    void ffmpegFails_data();
    void ffmpegFails();
    void filesMayNotGrow();
    void filmIsCancelled();
    void versionIsReported();
    void impossibleFilmsAreRefused_data();
    void impossibleFilmsAreRefused();
    void inputsAreNotReplaced();

  private:
    QString file(const QString& name) const { return m_folder.filePath(name); }
    QStringList listing() const {
        return QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
    void succeed(const QStringList& arguments) const {
        const CliResult result = runCli(m_folder.path(), arguments);
        QVERIFY2(result.code == 0 && result.error.isEmpty(), qPrintable(result.error));
    }
    void putDisc(const char* name, const std::string& picture, const std::string& time,
                 const std::string& motion) const;

    QTemporaryDir m_folder;
};

void TestFilms::putDisc(const char* name, const std::string& picture, const std::string& time,
                        const std::string& motion) const {
    putProject(
        m_folder.path(), name,
        "'domain': {'image': '" + picture +
            "', 'outline': {'from': 'alpha'}, 'vertices': 300}, 'time': " + time +
            ", 'handles': [{'at': {'points': [[50, 60]]}}, {'at': {'points': [[100, 60]]}, 'motion': [" +
            motion + "]}]");
}

void TestFilms::initTestCase() {
    writeImage(file("disc.png").toStdString(), smoothDisc(160, 120, 50));
    writeImage(file("odd.png").toStdString(), smoothDisc(161, 121, 50));
    writeMesh<3>(file("bar.mesh").toStdString(), barMesh(6));
    put(m_folder.path(), "count.wav", countingSound(5 * 8000));
    put(m_folder.path(), "short.wav", countingSound(4000));
    const std::string there = "{'kind': 'translate', 'by': [20, 10], 'time': [0, 1]}";
    const std::string around =
        "{'kind': 'translate', 'by': [20, 10], 'time': [0, 1]}, {'kind': 'translate', 'by': [-20, -10], "
        "'time': "
        "[1, 2]}";
    putDisc("disc.wend", "disc.png", "{'end': 1}", there);
    putDisc("odd.wend", "odd.png", "{'end': 1}", there);
    putDisc("slow.wend", "disc.png", "{'end': 2, 'frameRate': 12}", around);
    putDisc("cycle.wend", "disc.png", "{'end': 2, 'frameRate': 10, 'cycle': [0.5, 1.5]}", around);
    putDisc("sound.wend", "disc.png", "{'end': 2, 'frameRate': 25, 'audio': 'count.wav'}", around);
    putDisc("late.wend", "disc.png", "{'end': 2, 'frameRate': 25, 'audio': 'count.wav', 'cycle': [0.5, 1.5]}",
            around);
    putDisc("short.wend", "disc.png", "{'end': 2, 'frameRate': 25, 'audio': 'short.wav'}", around);
    putDisc("deaf.wend", "disc.png", "{'end': 1, 'audio': 'none.wav'}", there);
    putDisc("dumb.wend", "disc.png", "{'end': 1, 'audio': 'disc.png'}", there);
    putDisc("over.wend", "disc.png", "{'end': 1, 'cycle': [3, 4]}", there);
    putProject(m_folder.path(), "bar.wend", "'domain': {'mesh': 'bar.mesh'}");
    putProject(m_folder.path(), "bare.wend",
               "'domain': {'image': 'disc.png', 'vertices': 300}, 'handles': []");
}

void TestFilms::filmIsTheSequence_data() {
    QTest::addColumn<QString>("codec");
    QTest::addColumn<bool>("alpha");
    QTest::addColumn<double>("error");  // mean, of 255
    QTest::newRow("mp4") << "h264" << false << 2.0;
    QTest::newRow("webm") << "vp9" << true << 3.0;
    QTest::newRow("mov") << "prores" << true << 2.0;
    QTest::newRow("gif") << "gif" << true << 5.0;  // 256 colours
    QTest::newRow("png") << "apng" << true << 0.0;
}

/// The frames equal those of the sequence as PNG, on white where there is no transparency.
void TestFilms::filmIsTheSequence() {
    QFETCH(QString, codec);
    QFETCH(bool, alpha);
    QFETCH(double, error);
    const QString name = QString("film.") + QTest::currentDataTag();
    constexpr int kCount = 7;
    succeed({"run", "disc.wend", "--film", name, "--frames", "f_#.png", "--count", "7", "--fps", "10"});
    const Probe found = probe(file(name));
    QCOMPARE(found.video["codec_name"].toString(), codec);
    QCOMPARE(found.frames, kCount);
    QVERIFY2(std::abs(found.rate - 10) < 0.01, qPrintable(QString::number(found.rate)));
    QCOMPARE(found.size, QSize(160, 120));
    if (codec == "h264") QCOMPARE(found.video["pix_fmt"].toString(), "yuv420p");
    const QList<QImage> pictures = picturesOf(file(name));
    QCOMPARE(pictures.size(), kCount);
    for (int k = 0; k < kCount; ++k) {
        const QImage frame(file(QString("f_%1.png").arg(k)));
        const double off = difference(pictures[k], frame, frame.size());
        QVERIFY2(off <= error, qPrintable(QString("%1: %2").arg(k).arg(off)));
        QCOMPARE(qAlpha(pictures[k].pixel(2, 2)), alpha ? 0 : 255);
        QVERIFY(qAlpha(pictures[k].pixel(80, 60)) > 250);
    }
    QVERIFY(difference(pictures.first(), pictures.last(), found.size) > error + 3);
}

void TestFilms::sizesAreEvenWhereTheCodecAsks_data() {
    QTest::addColumn<QSize>("size");
    for (const QString& format : kFormats) {
        const bool even = format == "mp4" || format == "webm" || format == "mov";
        QTest::newRow(qPrintable(format)) << (even ? QSize(160, 120) : QSize(161, 121));
    }
}

/// The last column and row are left out; the others stay in their places.
void TestFilms::sizesAreEvenWhereTheCodecAsks() {
    QFETCH(QSize, size);
    const QString name = QString("odd_film.") + QTest::currentDataTag();
    succeed({"run", "odd.wend", "--film", name, "--image", "odd_end.png", "--count", "3"});
    if (name.endsWith("webp")) {
        const Image film = readImage(file(name).toStdString());
        QCOMPARE(QSize(film.width, film.height), size);
        return;
    }
    const Probe found = probe(file(name));
    QCOMPARE(found.size, size);
    const QImage end(file("odd_end.png"));
    QVERIFY(difference(picturesOf(file(name)).last(), end, size) < 5);
}

void TestFilms::picturesAreScaled() {
    succeed({"run", "disc.wend", "--film", "half.mp4", "--frames", "h_#.png", "--image", "half.png",
             "--scale", "51", "--count", "3"});
    QCOMPARE(probe(file("half.mp4")).size, QSize(82, 62));  // even
    QCOMPARE(QImage(file("h_2.png")).size(), QSize(82, 62));
    QCOMPARE(QImage(file("half.png")).size(), QSize(82, 61));
    succeed({"run", "disc.wend", "--film", "wide.mp4", "--width", "320", "--report", "wide.json", "--count",
             "3"});
    QCOMPARE(probe(file("wide.mp4")).size, QSize(320, 240));
    const QByteArray text = QByteArray::fromStdString(readTextFile(file("wide.json").toStdString()));
    QCOMPARE(QJsonDocument::fromJson(text)["canvas"]["scale"].toDouble(), 2.0);
    // The small picture is the large one, averaged.
    succeed({"run", "disc.wend", "--image", "whole.png"});
    succeed({"run", "disc.wend", "--image", "small.png", "--scale", "50"});
    const QImage whole(file("whole.png")), small(file("small.png"));
    QCOMPARE(small.size(), QSize(80, 60));
    const QImage mean = onGround(whole, Qt::white, whole.size())
                            .scaled(small.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    QVERIFY(difference(mean, small, small.size()) < 2);
}

/// The canvas of a sequence that fits grows by a pixel where it must; that of a picture does not.
void TestFilms::fittedFramesAreEven() {
    int odd = 0;
    for (const char* project : {"disc.wend", "odd.wend"})
        for (const char* at : {"0.2", "0.5", "1"}) {
            succeed({"run", project, "--canvas", "fit", "--at", at, "--frames", "e_#.png", "--film", "e.mp4",
                     "--image", "e.png", "--count", "2"});
            const QSize size = QImage(file("e_1.png")).size(), own = QImage(file("e.png")).size();
            QVERIFY(size.width() % 2 == 0 && size.height() % 2 == 0);
            QCOMPARE(probe(file("e.mp4")).size, size);
            odd += own.width() % 2 + own.height() % 2;
        }
    QVERIFY(odd > 0);
}

void TestFilms::filmLastsAsLongAsTheMotion_data() {
    QTest::addColumn<QStringList>("how");
    QTest::addColumn<int>("frames");
    QTest::addColumn<double>("rate");
    QTest::newRow("the project's rate") << QStringList() << 25 << 12.0;
    QTest::newRow("another rate") << QStringList{"--fps", "5"} << 11 << 5.0;
    QTest::newRow("a part") << QStringList{"--at", "1.5"} << 19 << 12.0;
    QTest::newRow("a number") << QStringList{"--count", "4"} << 4 << 12.0;
    QTest::newRow("a loop") << QStringList{"--loop"} << 24 << 12.0;
}

void TestFilms::filmLastsAsLongAsTheMotion() {
    QFETCH(QStringList, how);
    QFETCH(int, frames);
    QFETCH(double, rate);
    succeed(QStringList{"run", "slow.wend", "--film", "slow.mp4"} + how);
    const Probe found = probe(file("slow.mp4"));
    QCOMPARE(found.frames, frames);
    QCOMPARE(found.rate, rate);
    QVERIFY(std::abs(found.seconds - frames / rate) < 0.002);
}

/// The motion goes there and back, so the last frame of a loop is the one before the first.
void TestFilms::loopHasNoFrameTwice() {
    succeed({"run", "slow.wend", "--loop", "--film", "loop.png", "--frames", "l_#.png", "--count", "8"});
    succeed({"run", "slow.wend", "--frames", "w_#.png", "--count", "9"});
    const QList<QImage> pictures = picturesOf(file("loop.png"));
    QCOMPARE(pictures.size(), 8);
    const QSize size(160, 120);
    for (int k = 0; k < 8; ++k) {
        const QImage whole(file(QString("w_%1.png").arg(k)));
        QCOMPARE(difference(pictures[k], whole, size), 0.0);
        QCOMPARE(difference(QImage(file(QString("l_%1.png").arg(k))), whole, size), 0.0);
    }
    QVERIFY(!QFile::exists(file("l_8.png")));
    const double step = difference(pictures[0], pictures[1], size);
    QVERIFY(difference(QImage(file("w_8.png")), pictures[0], size) < 0.3 * step);  // the motion is closed
    QVERIFY(difference(pictures[7], pictures[0], size) > 0.5 * step);
}

void TestFilms::cycleIsWhatLoops() {
    succeed({"run", "cycle.wend", "--loop", "--film", "cycle.png"});
    const QList<QImage> pictures = picturesOf(file("cycle.png"));
    QCOMPARE(pictures.size(), 10);  // a second at the project's rate
    for (const int k : {0, 3, 9}) {
        succeed({"run", "cycle.wend", "--image", "there.png", "--at", QString::number(0.5 + 0.1 * k)});
        QVERIFY(difference(pictures[k], QImage(file("there.png")), {160, 120}) < 0.1);
    }
    succeed({"run", "cycle.wend", "--film", "all.png"});
    QCOMPARE(probe(file("all.png")).frames, 21);
}

/// The first of the 24 frames of the sample's walk follows the last as any other follows its predecessor. At
/// the end every vertex is where it began; hands swing against the feet of their side, and the two sides are
/// half a cycle apart.
void TestFilms::walkerWalksOn() {
    const QString walker = QStringLiteral(WEND_SOURCE_DIR "/resources/samples/walker.wend");
    succeed({"run", walker, "--frames", "walk_##.obj", "--count", "25", "--quiet"});
    const auto pointsOf = [this](int k) {
        std::vector<QPointF> points;
        std::istringstream lines(
            readTextFile(file(QStringLiteral("walk_%1.obj").arg(k, 2, 10, QChar('0'))).toStdString()));
        for (std::string line; std::getline(lines, line);)
            if (double x = 0, y = 0; std::sscanf(line.c_str(), "v %lf %lf", &x, &y) == 2)
                points.emplace_back(x, y);
        return points;
    };
    const auto farthest = [](const std::vector<QPointF>& a, const std::vector<QPointF>& b) {
        double most = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            most = std::max(most, std::hypot(a[i].x() - b[i].x(), a[i].y() - b[i].y()));
        return most;
    };
    const auto first = pointsOf(0);
    QVERIFY(first.size() > 1000);
    double least = 1e9, most = 0;
    auto before = first;
    for (int k = 1; k < 24; ++k) {
        const auto now = pointsOf(k);
        least = std::min(least, farthest(now, before));
        most = std::max(most, farthest(now, before));
        before = now;
    }
    const double joint = farthest(first, before), back = farthest(first, pointsOf(24));
    qInfo("steps of frames from %.1f to %.1f pixels, at the joint %.1f; back within %.1e", least, most, joint,
          back);
    QVERIFY(joint > 0.5 * least && joint < most && back < 1e-5);
    const QJsonArray handles =
        QJsonDocument::fromJson(QByteArray::fromStdString(readTextFile(walker.toStdString())))["handles"]
            .toArray();
    const auto wayOf = [&](const QString& name, double until) {
        double x = 0;
        for (const auto handle : handles)
            for (const auto motion : handle.toObject()["motion"].toArray())
                if (handle.toObject()["name"] == name &&
                    motion.toObject()["time"].toArray()[1].toDouble() <= until + 1e-9)
                    x += motion.toObject()["by"].toArray()[0].toDouble();
        return x;
    };
    QVERIFY(wayOf("near heel", 0.5) < -200 && wayOf("far heel", 0.5) > 200);
    QVERIFY(wayOf("near hand", 0.5) > 200 && wayOf("far hand", 0.5) < -200);
    for (const char* name :
         {"chest", "head", "near hand", "far hand", "near heel", "near toe", "far heel", "far toe"})
        QVERIFY(std::abs(wayOf(QString::fromLatin1(name), 1)) < 1e-9);
}

void TestFilms::soundIsThatOfTheTime_data() {
    QTest::addColumn<QString>("film");
    QTest::addColumn<QString>("codec");
    QTest::newRow("mp4") << "sound.mp4"
                         << "aac";
    QTest::newRow("webm") << "sound.webm"
                          << "opus";
    QTest::newRow("mov") << "sound.mov"
                         << "pcm_s16le";
    QTest::newRow("gif") << "sound.gif" << QString();
}

/// The sound lasts as long as the film. QuickTime keeps the samples unchanged, and each value identifies its
/// sample.
void TestFilms::soundIsThatOfTheTime() {
    QFETCH(QString, film);
    QFETCH(QString, codec);
    for (const bool late : {false, true}) {
        succeed(QStringList{"run", late ? "late.wend" : "sound.wend", "--film", film} +
                (late ? QStringList{"--loop"} : QStringList()));
        const Probe found = probe(file(film));
        QCOMPARE(found.sound["codec_name"].toString(), codec);
        if (codec.isEmpty()) continue;
        QCOMPARE(found.frames, late ? 25 : 51);
        QVERIFY2(std::abs(found.seconds - found.frames / 25.0) < 0.03,
                 qPrintable(QString::number(found.seconds)));
        if (codec != "pcm_s16le") continue;
        const QByteArray sound =
            outputOf("ffmpeg", {"-v", "error", "-i", file(film), "-map", "0:a", "-f", "s16le", "pipe:1"});
        const int samples = found.frames * 8000 / 25, first = late ? 4000 : 0;
        QCOMPARE(sound.size(), 2 * samples);
        for (int k = 0; k < samples; ++k) {
            std::int16_t value = 0;
            std::memcpy(&value, sound.constData() + 2 * k, 2);
            QCOMPARE(int(value), (first + k) % 20000);
        }
    }
}

void TestFilms::soundOfAShortFileEnds() {
    succeed({"run", "short.wend", "--film", "short.mov"});
    const Probe found = probe(file("short.mov"));
    QCOMPARE(found.frames, 51);
    QCOMPARE(found.sound["duration"].toString().toDouble(), 0.5);
}

void TestFilms::sameFilmTwiceIsTheSameFile() {
    for (const QString& format : kFormats) {
        std::string before;
        for (int k = 0; k < 2; ++k) {
            succeed({"run", "disc.wend", "--film", "same." + format, "--count", "5"});
            const std::string now = readTextFile(file("same." + format).toStdString());
            if (k == 1) QVERIFY2(now == before, qPrintable(format));
            before = now;
        }
    }
}

void TestFilms::severalFilmsAtOnce() {
    succeed({"run", "disc.wend", "--film", "a.mp4", "--film", "b.gif", "--film", "c.webp", "--count", "3"});
    QCOMPARE(probe(file("a.mp4")).frames, 3);
    QCOMPARE(probe(file("b.gif")).frames, 3);
    QVERIFY(QFileInfo(file("c.webp")).size() > 1000);
}

/// A missing ffmpeg is detected at run time and reported in one line with an alternative; WebP does not need
/// it.
void TestFilms::ffmpegIsMissing() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", m_folder.path());
    const QStringList before = listing();
    const CliResult result = runCli(m_folder.path(), {"run", "disc.wend", "--film", "no.mp4"}, environment);
    QCOMPARE(result.code, 3);
    QVERIFY2(result.error.startsWith("wend: no.mp4: ") &&
                 result.error.contains("ffmpeg, which is not installed") &&
                 result.error.contains("apt install") && result.error.count('\n') == 1,
             qPrintable(result.error));
    QCOMPARE(listing(), before);
    QVERIFY(runCli(m_folder.path(), {"--version"}, environment).out.contains("ffmpeg is not installed"));
    QCOMPARE(runCli(m_folder.path(), {"run", "disc.wend", "--film", "yes.webp"}, environment).code, 0);
}

void TestFilms::ffmpegFails_data() {
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("why");
    QTest::newRow("at once") << QByteArray("echo '[x @ 0x1] Unknown encoder' >&2; exit 1") << 3
                             << "ffmpeg failed (Unknown encoder)";
    QTest::newRow("in the middle") << QByteArray("head -c 100000 >/dev/null; echo Broken >&2; exit 1") << 3
                                   << "ffmpeg failed (Broken)";
    QTest::newRow("at the end") << QByteArray("cat >/dev/null; exit 7") << 3 << "ffmpeg failed";
    QTest::newRow("killed") << QByteArray("head -c 100000 >/dev/null; kill -9 $$") << 3 << "signal 9";
    QTest::newRow("without a file") << QByteArray("cat >/dev/null") << 3 << "no.mp4";
    QTest::newRow("full disk")
        << QByteArray(
               "for file; do :; done; head -c 100000 >\"${file#file:}\"; echo \"$file: No "
               "space left on device\" >&2; exit 1")
        << 5 << "the disk is full";
    QTest::newRow("text") << QByteArray("printf 'a\\033[31mb\\n' >&2; exit 1") << 3 << "a\\x1b[31mb";
}

/// The failure is reported in one line; an old file stays as it was, and no other file is left.
void TestFilms::ffmpegFails() {
    QFETCH(QByteArray, script);
    QFETCH(int, code);
    QFETCH(QString, why);
    const QTemporaryDir programs;
    QFile fake(programs.filePath("ffmpeg"));
    QVERIFY(fake.open(QIODevice::WriteOnly));
    fake.write("#!/bin/sh\n" + script + "\n");
    fake.close();
    fake.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", programs.path() + ":" + environment.value("PATH"));
    put(m_folder.path(), "no.mp4", "old");
    const QStringList before = listing();
    const CliResult result =
        runCli(m_folder.path(), {"run", "disc.wend", "--film", "no.mp4", "--quiet"}, environment);
    QCOMPARE(result.code, code);
    QVERIFY2(result.error.startsWith("wend: no.mp4: ") && result.error.contains(why) &&
                 result.error.count('\n') == 1 && !result.error.contains(".wend-"),
             qPrintable(result.error));
    QCOMPARE(listing(), before);
    QCOMPARE(readTextFile(file("no.mp4").toStdString()), std::string("old"));
    QFile::remove(file("no.mp4"));
}

/// The real ffmpeg runs into a limit on the size of files.
void TestFilms::filesMayNotGrow() {
    for (const QString& format : kFormats) {
        const QString name = "limit." + format;
        succeed({"run", "disc.wend", "--film", name, "--count", "5"});
        const qint64 size = QFileInfo(file(name)).size();
        put(m_folder.path(), qPrintable(name), "old");
        const QStringList before = listing();
        for (const qint64 most : {size - 1, size / 2, qint64(1)}) {
            QProcess process;
            process.setWorkingDirectory(m_folder.path());
            process.setChildProcessModifier([most] {
                const struct rlimit limit { static_cast<rlim_t>(most), static_cast<rlim_t>(most) };
                setrlimit(RLIMIT_FSIZE, &limit);
            });
            process.start(WEND_BINARY, {"run", "disc.wend", "--film", name, "--count", "5", "--quiet"});
            QVERIFY(process.waitForFinished(120000));
            const QByteArray error = process.readAllStandardError();
            QVERIFY2(process.exitCode() == 3 && error.count('\n') == 1 && error.contains("cannot be written"),
                     error.constData());
            QCOMPARE(listing(), before);
            QCOMPARE(readTextFile(file(name).toStdString()), std::string("old"));
        }
    }
}

/// A film that is cancelled while its frames are written leaves neither a file nor a process.
void TestFilms::filmIsCancelled() {
    putProject(m_folder.path(), "endless.wend",
               "'domain': {'image': 'disc.png', 'vertices': 300}, 'time': {'end': 10000}, 'handles': [{'at': "
               "{'points': [[50, 60]]}}, {'at': {'points': [[100, 60]]}, " +
                   endlessMotion("[20, 10]", "[-20, -10]") + "}]");
    for (const char* name : {"endless.mp4", "endless.gif"}) {
        const QStringList before = listing();
        QProcess process;
        process.setWorkingDirectory(m_folder.path());
        process.start(WEND_BINARY, {"run", "endless.wend", "--film", name, "--count", "9000", "--fps", "25"});
        const auto parts = [&] {
            return QDir(m_folder.path()).entryList({".wend-*"}, QDir::AllEntries | QDir::Hidden);
        };
        const auto films = [&] {
            return parts().isEmpty() ? QStringList() : QDir(file(parts().first())).entryList(QDir::Files);
        };
        QVERIFY(QTest::qWaitFor([&] { return !films().isEmpty(); }, 60000));
        process.terminate();
        QVERIFY(process.waitForFinished(60000));
        QCOMPARE(process.exitCode(), 4);
        QVERIFY(process.readAllStandardError().contains("cancelled"));
        QCOMPARE(listing(), before);
    }
}

void TestFilms::versionIsReported() {
    const QString own = QString::fromUtf8(outputOf("ffmpeg", {"-version"})).section(' ', 2, 2);
    QVERIFY(!own.isEmpty());
    const QStringList lines = runCli(m_folder.path(), {"--version"}).out.split('\n');
    QVERIFY(lines[0].startsWith("wend "));
    QCOMPARE(lines[1], "ffmpeg " + own);
}

void TestFilms::impossibleFilmsAreRefused_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("why");
    QTest::newRow("solid") << "bar.wend --film no.mp4" << 3 << "a film of a solid";
    QTest::newRow("format") << "disc.wend --film no.avi" << 3
                            << "films cannot be written as .avi (known: mp4, webm";
    QTest::newRow("no format") << "disc.wend --film no" << 3 << "no extension that says the film format";
    QTest::newRow("sequence") << "disc.wend --frames no.mp4" << 3 << "for a film take --film";
    QTest::newRow("output") << "disc.wend --film -" << 2 << "--film cannot go to standard output";
    QTest::newRow("quick GIF") << "disc.wend --film no.gif --fps 60" << 3
                               << "gif films have from 0.01 to 50 frames";
    QTest::newRow("too quick") << "disc.wend --film no.mp4 --fps 2000" << 3 << "to 1000 frames per second";
    QTest::newRow("too slow") << "disc.wend --film no.mp4 --fps 0.001 --count 3" << 3 << "from 0.01";
    QTest::newRow("no sound") << "deaf.wend --film no.mp4" << 3 << "none.wav";
    QTest::newRow("no sound in it") << "dumb.wend --film no.mp4" << 3 << "ffmpeg failed";
    QTest::newRow("cycle") << "over.wend --film no.mp4 --loop" << 3 << "time.cycle: begins at 3";
    QTest::newRow("loop of nothing") << "disc.wend --loop --image no.png" << 2 << "--loop is for";
    QTest::newRow("rate of nothing") << "disc.wend --fps 9 --image no.png" << 2 << "--fps is for --film";
    QTest::newRow("two sizes") << "disc.wend --film no.mp4 --scale 50 --width 80" << 2
                               << "--scale and --width";
    QTest::newRow("one pixel") << "disc.wend --film no.mp4 --canvas 0,0,1,9" << 3
                               << "at least 2 pixels a side";
    QTest::newRow("too large") << "disc.wend --image no.png --scale 1000 --canvas 0,0,9000,9000" << 3
                               << "million";
    QTest::newRow("no folder") << "disc.wend --film none/no.mp4" << 3 << "none/no.mp4";
}

void TestFilms::impossibleFilmsAreRefused() {
    QFETCH(QString, line);
    QFETCH(int, code);
    QFETCH(QString, why);
    const QStringList before = listing();
    const CliResult result = runCli(m_folder.path(), QStringList{"run", "--quiet"} + line.split(' '));
    QVERIFY2(result.code == code && result.error.contains(why) && result.error.count('\n') == 1,
             qPrintable(QString::number(result.code) + result.error));
    QCOMPARE(listing(), before);
}

void TestFilms::inputsAreNotReplaced() {
    for (const char* name : {"disc.png", "count.wav"}) {
        const CliResult result = runCli(m_folder.path(), {"run", "sound.wend", "--film", name});
        QVERIFY2(result.code == 2 && result.error.contains("would replace"), qPrintable(result.error));
    }
}

QTEST_GUILESS_MAIN(TestFilms)
#include "test_films.moc"
