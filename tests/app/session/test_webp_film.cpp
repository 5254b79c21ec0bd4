// A motion as an animated WebP: by the command line, decoded by libwebp's player and compared with the frames
// one by one.

#include <QColorSpace>
#include <QtTest>
#include <algorithm>
#include <cmath>

#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/webp_frames.h"

using namespace wend;
using namespace wend::test;

class TestWebpFilm : public QObject {
    Q_OBJECT
  private slots:
    void initTestCase();
    void filmIsTheSequence_data();
    void filmIsTheSequence();
    void lossyFilmIsSmaller();
    void lossyStillIsSmaller();
    void restIsOneLongFrame();
    void profileIsKept();
    void impossibleFilmsAreRefused_data();
    void impossibleFilmsAreRefused();
    void inputIsNotReplaced();

  private:
    QString file(const QString& name) const { return m_folder.filePath(name); }
    void succeed(const QStringList& arguments) const {
        const CliResult result = runCli(m_folder.path(), arguments);
        QVERIFY2(result.code == 0 && result.error.isEmpty(), qPrintable(result.error));
    }

    QTemporaryDir m_folder;
};

void TestWebpFilm::initTestCase() {
    writeImage(file("disc.png").toStdString(), discPicture(200, 80));
    writeImage(file("disc.webp").toStdString(), discPicture(200, 80));
    writeMesh<3>(file("bar.mesh").toStdString(), barMesh(6));
    const std::string rest =
        "'outline': {'from': 'alpha'}, 'vertices': 400}, 'handles': [{'at': {'points': [[60, 100]]}},"
        "{'at': {'points': [[140, 100]]}, 'motion': [{'kind': 'translate', 'by': [20, 10], 'time': [0, "
        "1]}]}]";
    putProject(m_folder.path(), "disc.wend", "'domain': {'image': 'disc.png', " + rest);
    putProject(m_folder.path(), "webp.wend", "'domain': {'image': 'disc.webp', " + rest);
    putProject(m_folder.path(), "still.wend",
               "'domain': {'image': 'disc.png', 'outline': {'from': 'alpha'}, 'vertices': 200}");
    putProject(m_folder.path(), "bar.wend", "'domain': {'mesh': 'bar.mesh'}");
}

void TestWebpFilm::filmIsTheSequence_data() {
    QTest::addColumn<QStringList>("how");
    QTest::addColumn<double>("rate");
    QTest::newRow("plain") << QStringList() << 24.0;
    QTest::newRow("10 a second") << QStringList{"--fps", "10"} << 10.0;
    QTest::newRow("30 a second") << QStringList{"--fps", "30"} << 30.0;
    QTest::newRow("fit") << QStringList{"--canvas", "fit"} << 24.0;
    QTest::newRow("part") << QStringList{"--canvas", "40,30,90,70"} << 24.0;
    QTest::newRow("on white") << QStringList{"--outside", "white"} << 24.0;
}

/// Each frame has the pixels of the sequence as PNG, and the rounding of times does not add up.
void TestWebpFilm::filmIsTheSequence() {
    QFETCH(QStringList, how);
    QFETCH(double, rate);
    constexpr int kCount = 7;
    QStringList still = how;
    if (const auto at = still.indexOf("--fps"); at >= 0) still.remove(at, 2);
    const QStringList count{"--count", QString::number(kCount)};
    succeed(QStringList{"run", "disc.wend", "--frames", "f_#.png"} + count + still);
    succeed(QStringList{"run", "disc.wend", "--frames", "film.webp"} + count + how);
    const WebpFrames film = webpFrames(file("film.webp"));
    QCOMPARE(film.pictures.size(), std::size_t(kCount));
    QCOMPARE(film.loops, 0);
    for (int k = 0; k < kCount; ++k) {
        const QImage frame = QImage(file(QStringLiteral("f_%1.png").arg(k)));
        QVERIFY(!frame.isNull());
        QCOMPARE(seenDifference(film.pictures[std::size_t(k)], frame), 0);
        QCOMPARE(film.ends[std::size_t(k)], int(std::lround(1000 * (k + 1) / rate)));
    }
    QVERIFY(seenDifference(film.pictures.front(), film.pictures.back()) > 100);
}

void TestWebpFilm::lossyFilmIsSmaller() {
    succeed({"run", "disc.wend", "--frames", "whole.webp", "--count", "4"});
    succeed({"run", "disc.wend", "--frames", "small.webp", "--count", "4", "--webp", "lossy"});
    QVERIFY(2 * QFileInfo(file("small.webp")).size() < QFileInfo(file("whole.webp")).size());
    const WebpFrames whole = webpFrames(file("whole.webp")), small = webpFrames(file("small.webp"));
    QCOMPARE(small.pictures.size(), std::size_t(4));
    const QRgb there = small.pictures[3].pixel(150, 110), own = whole.pictures[3].pixel(150, 110);
    QCOMPARE(qAlpha(there), 255);
    QVERIFY(std::abs(qGray(there) - qGray(own)) < 60);  // a noisy disc
    QCOMPARE(qAlpha(small.pictures[3].pixel(3, 3)), 0);
}

void TestWebpFilm::lossyStillIsSmaller() {
    succeed({"run", "disc.wend", "--image", "one.webp"});
    succeed({"run", "disc.wend", "--image", "two.webp", "--webp", "lossy"});
    QVERIFY(2 * QFileInfo(file("two.webp")).size() < QFileInfo(file("one.webp")).size());
    QCOMPARE(readImage(file("two.webp").toStdString()).width, 200);
}

/// Where nothing moves the player shows the same picture as long as the film lasts.
void TestWebpFilm::restIsOneLongFrame() {
    succeed({"run", "still.wend", "--frames", "still.webp", "--count", "5", "--fps", "10"});
    const WebpFrames film = webpFrames(file("still.webp"));
    QVERIFY(!film.ends.empty());
    QCOMPARE(film.ends.back(), 500);
    QCOMPARE(seenDifference(film.pictures.back(), QImage(file("disc.png"))), 0);
}

void TestWebpFilm::profileIsKept() {
    QImage picture(file("disc.png"));
    picture.setColorSpace(QColorSpace(QColorSpace::AdobeRgb));
    QVERIFY(picture.save(file("wide.png")));
    putProject(m_folder.path(), "wide.wend", "'domain': {'image': 'wide.png', 'vertices': 200}");
    succeed({"run", "wide.wend", "--frames", "wide.webp", "--count", "2"});
    const auto own = readImage(file("wide.png").toStdString()).iccProfile();
    const QByteArray profile = webpFrames(file("wide.webp")).profile;
    QVERIFY(!own.empty());
    QCOMPARE(profile, QByteArray(reinterpret_cast<const char*>(own.data()), qsizetype(own.size())));
}

void TestWebpFilm::impossibleFilmsAreRefused_data() {
    QTest::addColumn<QStringList>("how");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("why");
    const QStringList film{"--frames", "no.webp"};
    QTest::newRow("solid") << QStringList{"bar.wend"} + film << 3 << "picture of a solid";
    QTest::newRow("too quick") << QStringList{"disc.wend", "--fps", "5000"} + film << 3
                               << "1000 frames per second";
    QTest::newRow("too slow") << QStringList{"disc.wend", "--fps", "1e-9"} + film << 3 << "frames per second";
    QTest::newRow("too deep") << QStringList{"disc.wend", "--depth", "16"} + film << 3 << "--depth";
    QTest::newRow("no folder") << QStringList{"disc.wend", "--frames", "none/no.webp"} << 3 << "none/no.webp";
    QTest::newRow("too large") << QStringList{"disc.wend", "--canvas", "0,0,16400,2"} + film << 3
                               << "16383 pixels";
    QTest::newRow("no number") << QStringList{"disc.wend", "--frames", "no.png"} << 3 << "needs ####";
    QTest::newRow("rate of a sequence")
        << QStringList{"disc.wend", "--frames", "no_#.png", "--fps", "9"} << 2 << "--fps is for";
}

/// A film that cannot be written is refused in one line, with its name, and no file is left.
void TestWebpFilm::impossibleFilmsAreRefused() {
    QFETCH(QStringList, how);
    QFETCH(int, code);
    QFETCH(QString, why);
    const CliResult result = runCli(m_folder.path(), QStringList{"run"} + how + QStringList{"--quiet"});
    QCOMPARE(result.code, code);
    QVERIFY2(result.error.contains(why) && result.error.count('\n') == 1, qPrintable(result.error));
    QVERIFY(QDir(m_folder.path()).entryList({"no*", ".*"}, QDir::Files | QDir::Hidden).isEmpty());
}

void TestWebpFilm::inputIsNotReplaced() {
    const CliResult result = runCli(m_folder.path(), {"run", "webp.wend", "--frames", "disc.webp"});
    QCOMPARE(result.code, 2);
    QVERIFY2(result.error.contains("would replace"), qPrintable(result.error));
}

QTEST_GUILESS_MAIN(TestWebpFilm)
#include "test_webp_film.moc"
