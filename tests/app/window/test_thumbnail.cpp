#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QPainter>
#include <QThreadPool>

#include "app/window/files/start_page.h"
#include "app/window/files/thumbnail.h"
#include "app/window/main_window.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// Small pictures of files that are not open.
class TestThumbnail : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cutOutFillsIt();
    void photographIsWhole();
    void projectShowsItsPicture();
    void keptOneIsShown();
    void changedPictureIsReadAnew();
    void keptOnesAreTheOwnersAlone();
    void keptOnesDoNotPileUp();
    void nothingIsKeptOfWhatCannotBeRead();
    void folderThatCannotBeMadeIsNoHarm();
    void cardsReadOnceTheyAreSeen();
    void savedProjectShowsWhatWasSeen();

  private:
    QString at(const QString& name) const { return m_folder->filePath(name); }
    void write(const QString& name, const QByteArray& text) const;
    void writeDisc(const QString& name, const QColor& colour) const;
    QStringList kept() const { return QDir(at("cache")).entryList(QDir::Files); }
    Thumbnail thumbnail(const QString& name) const { return thumbnailOf(at(name), at("cache")); }

    std::unique_ptr<TestFolder> m_folder;
};

void TestThumbnail::init() {
    m_folder = std::make_unique<TestFolder>();
    QCoreApplication::setApplicationName(QStringLiteral("TestThumbnail"));  // a cache of its own
}

void TestThumbnail::write(const QString& name, const QByteArray& text) const {
    QFile file(at(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
}

/// Writes a picture of 200 × 100 with a disc of diameter 50 off its middle.
void TestThumbnail::writeDisc(const QString& name, const QColor& colour) const {
    QImage image(200, 100, QImage::Format_ARGB32);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(120, 30, 50, 50);
    painter.end();
    QVERIFY(image.save(at(name)));
    QVERIFY(QFile::resize(at(name), 4096));  // what follows a PNG's end is of no matter
}

void TestThumbnail::cutOutFillsIt() {
    writeDisc("disc.png", Qt::red);
    const QImage picture = thumbnail("disc.png").picture;
    QVERIFY2(qAbs(picture.width() - picture.height()) <= 6, "the disc alone is shown");
    QCOMPARE(picture.height(), 300);
    QCOMPARE(picture.pixelColor(picture.rect().center()), QColor(Qt::red));
    QCOMPARE(picture.pixelColor(0, 0).alpha(), 0);
}

void TestThumbnail::photographIsWhole() {
    QImage image(600, 300, QImage::Format_RGB32);
    image.fill(Qt::blue);
    QVERIFY(image.save(at("photo.png")));
    const Thumbnail shown = thumbnail("photo.png");
    QCOMPARE(shown.picture.size(), QSize(344, 172));
    QVERIFY(!shown.isSolid);
}

void TestThumbnail::projectShowsItsPicture() {
    writeDisc("disc.png", Qt::green);
    write("disc.wend", R"({"format": "wend", "version": 1, "domain": {"image": "disc.png"}})");
    const Thumbnail shown = thumbnail("disc.wend");
    QCOMPARE(shown.picture.pixelColor(shown.picture.rect().center()), QColor(Qt::green));
    QVERIFY(!shown.isSolid);
    write("solid.wend", R"({"format": "wend", "version": 1, "domain": {"surface": "solid.obj"}})");
    QVERIFY(thumbnail("solid.wend").isSolid);
}

void TestThumbnail::keptOneIsShown() {
    writeDisc("disc.png", Qt::red);
    const QImage first = thumbnail("disc.png").picture;
    QCOMPARE(kept().size(), 1);
    QCOMPARE(thumbnail("disc.png").picture.convertToFormat(first.format()), first);
    // A picture in the cache is used, whatever the file is.
    QImage other(30, 40, QImage::Format_ARGB32);
    other.fill(Qt::cyan);
    QVERIFY(other.save(QDir(at("cache")).filePath(kept().first())));
    QCOMPARE(thumbnail("disc.png").picture.size(), QSize(30, 40));
    QCOMPARE(kept().size(), 1);
}

void TestThumbnail::changedPictureIsReadAnew() {
    writeDisc("disc.png", Qt::red);
    write("disc.wend", R"({"format": "wend", "version": 1, "domain": {"image": "disc.png"}})");
    thumbnail("disc.png");
    thumbnail("disc.wend");
    writeDisc("disc.png", Qt::blue);  // as many bytes: only the time tells
    QFile file(at("disc.png"));
    QVERIFY(file.open(QIODevice::ReadWrite));
    QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(60), QFile::FileModificationTime));
    for (const char* name : {"disc.png", "disc.wend"}) {
        const QImage now = thumbnail(name).picture;
        QCOMPARE(now.pixelColor(now.rect().center()), QColor(Qt::blue));
    }
}

void TestThumbnail::keptOnesAreTheOwnersAlone() {
    writeDisc("disc.png", Qt::red);
    thumbnail("disc.png");
    const auto others = QFile::ReadGroup | QFile::WriteGroup | QFile::ExeGroup | QFile::ReadOther |
                        QFile::WriteOther | QFile::ExeOther;
    QCOMPARE(QFile::permissions(at("cache")) & others, QFile::Permissions());
    QCOMPARE(QFile::permissions(QDir(at("cache")).filePath(kept().first())) & others, QFile::Permissions());
}

void TestThumbnail::keptOnesDoNotPileUp() {
    for (int i = 0; i < 120; ++i) {
        writeDisc(QStringLiteral("disc%1.png").arg(i), Qt::red);
        thumbnail(QStringLiteral("disc%1.png").arg(i));
    }
    QCOMPARE(kept().size(), 100);
}

void TestThumbnail::nothingIsKeptOfWhatCannotBeRead() {
    write("broken.png", "no picture");
    QVERIFY(thumbnail("broken.png").picture.isNull());
    QVERIFY(thumbnail("missing.png").picture.isNull());
    QVERIFY(thumbnail("missing.wend").picture.isNull());
    QVERIFY(kept().isEmpty());
}

void TestThumbnail::folderThatCannotBeMadeIsNoHarm() {
    writeDisc("disc.png", Qt::red);
    write("cache", "a file is in the way");
    QCOMPARE(thumbnail("disc.png").picture.height(), 300);
}

void TestThumbnail::cardsReadOnceTheyAreSeen() {
    QDir(thumbnailFolder()).removeRecursively();
    writeDisc("seen.png", Qt::red);
    const auto keptNow = [] { return QDir(thumbnailFolder()).entryList(QDir::Files).size(); };
    FileCard card(at("seen.png"), FileCard::Kind::Recent, nullptr);
    QVERIFY(QThreadPool::globalInstance()->waitForDone(20000));
    QCOMPARE(keptNow(), 0);
    card.show();
    QTRY_COMPARE(keptNow(), 1);
}

/// A bar of 200 × 40 has its right end pulled far up, through its reachable places. The thumbnail has the
/// width and height of the saved pose; once another program has changed the file, it shows the picture again.
void TestThumbnail::savedProjectShowsWhatWasSeen() {
    MainWindow window;
    window.resize(1200, 800);
    window.show();
    window.openPath(writeCutOut(*m_folder));
    ShapeSession& session = window.session();
    QTRY_VERIFY_WITH_TIMEOUT(!session.document().isEmpty(), 20000);
    QVERIFY(settle(session));
    session.addPin({40, 80, 0});
    session.selection().set({session.addPin({200, 80, 0})});
    session.gestures().begin();
    session.gestures().moveBy({60, -120, 0});
    session.gestures().end(0.3);
    QVERIFY(settle(session));
    session.document().save(at("bent.wend"));
    const Thumbnail bent = thumbnailOf(at("bent.wend"));
    const Points2& pose = session.motion().frame<2>()->pose;
    const Vec2 size = pose.rowwise().maxCoeff() - pose.rowwise().minCoeff();
    const double ratio = double(bent.picture.width()) / bent.picture.height();
    QVERIFY2(std::abs(ratio / (size.x() / size.y()) - 1) < 0.1, qPrintable(QString::number(ratio)));
    QVERIFY(ratio < 2.5);
    QFile file(at("bent.wend"));
    QVERIFY(file.open(QIODevice::Append) && file.write("\n") == 1);
    file.close();
    const Thumbnail anew = thumbnailOf(at("bent.wend"));
    QVERIFY(double(anew.picture.width()) / anew.picture.height() > 4);
}

QTEST_MAIN(TestThumbnail)
#include "test_thumbnail.moc"
