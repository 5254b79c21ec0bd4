// Messages of the core in other languages.

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>

#include "app/base/said.h"
#include "core/base/error.h"
#include "core/meshing/planar_mesher.h"
#include "core/meshing/volume_mesher.h"
#include "warp/image.h"
#include "warp/outline.h"

using namespace wend;

class TestSaid : public QObject {
    Q_OBJECT
  private slots:
    void cleanup();
    void errorsSpeakTheLanguage_data();
    void errorsSpeakTheLanguage();
    void messagesAreFilledAfterTranslation();
    void problemsAreListed();
    void picturesThatAreNotRead();
    void stops();
    void messagesTravelAsBytes();
    void othersStayAsTheyAre_data();
    void othersStayAsTheyAre();

  private:
    void speak(const QString& language);

    QTranslator m_translator;
};

namespace {

template <class Work>
QString saidOf(const Work& work) {
    try {
        work();
    } catch (const std::exception& error) {
        return said(error);
    }
    return {};
}

}  // namespace

void TestSaid::cleanup() {
    QCoreApplication::removeTranslator(&m_translator);
}

void TestSaid::speak(const QString& language) {
    QVERIFY(m_translator.load(QStringLiteral(":/i18n/wend_") + language + QStringLiteral(".qm")));
    QVERIFY(QCoreApplication::installTranslator(&m_translator));
}

void TestSaid::errorsSpeakTheLanguage_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("opaque");
    QTest::addColumn<QString>("crossing");
    QTest::newRow("English") << ""
                             << "the picture has no alpha channel to take an outline from"
                             << "the outline crosses or overlaps itself near ";
    QTest::newRow("German") << "de"
                            << "das Bild hat keinen Alphakanal, aus dem ein Umriss werden könnte"
                            << "der Umriss kreuzt oder überdeckt sich bei ";
    QTest::newRow("Japanese") << "ja"
                              << "画像には輪郭のもとになるアルファチャンネルがありません"
                              << "輪郭が (";
}

/// The core itself throws the errors, so that a changed sentence fails here.
void TestSaid::errorsSpeakTheLanguage() {
    QFETCH(QString, language);
    QFETCH(QString, opaque);
    QFETCH(QString, crossing);
    if (!language.isEmpty()) speak(language);
    Image picture;
    picture.width = picture.height = 2;
    picture.channels = 3;
    picture.makePixels();
    QCOMPARE(saidOf([&] { outlineFromAlpha(picture); }), opaque);
    const Outline bow{{{{0, 0}, {10, 10}, {10, 0}, {0, 10}}}};
    QVERIFY(saidOf([&] { meshOutline(bow, {}); }).startsWith(crossing));
}

/// Messages are filled in within messages and after their subject; placeholders in an argument are left
/// alone.
void TestSaid::messagesAreFilledAfterTranslation() {
    const Message crash(sentence("Core", "its reader failed inside (signal %1)"), 11);
    const InputError reading("a%1.png", {sentence("Core", "cannot be read: %1"), crash});
    const InputError missing("b.png", sentence("Core", "does not exist"));
    const InputError pin(Message(sentence("Core", "handle \"%1\""), "%2") + ": " +
                         Message(sentence("Core", "its region holds no vertex")));
    QCOMPARE(reading.what(), "a%1.png: cannot be read: its reader failed inside (signal 11)");
    QCOMPARE(said(reading), QString(reading.what()));
    QCOMPARE(pin.what(), "handle \"%2\": its region holds no vertex");
    speak(QStringLiteral("de"));
    QCOMPARE(said(reading),
             "a%1.png: kann nicht gelesen werden: das Leseprogramm ist abgestürzt (Signal 11)");
    QCOMPARE(said(missing), QStringLiteral("b.png: existiert nicht"));
    QCOMPARE(said(pin), QStringLiteral("Pin „%2“: in seinem Bereich liegt kein Eckpunkt"));
    QCOMPARE(said(InputError("c\n%3.png", crash)),
             QStringLiteral("c %3.png: das Leseprogramm ist abgestürzt (Signal 11)"));
}

/// A tetrahedron lacks one of its faces, and another face is there twice.
void TestSaid::problemsAreListed() {
    Surface surface{Points3(3, 4), {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {1, 2, 3}}, {}};
    surface.points << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
    const auto mesh = [&] { meshVolume(surface, {}); };
    QCOMPARE(saidOf(mesh),
             QStringLiteral("the surface bounds no volume: 3 open edges (first: 0–2), 1 duplicate "
                            "triangle (first: 3)"));
    speak(QStringLiteral("de"));
    QCOMPARE(saidOf(mesh),
             QStringLiteral("die Oberfläche begrenzt kein Volumen: 3 offene Kanten (zuerst 0–2), 1 "
                            "doppeltes Dreieck (3)"));
}

void TestSaid::picturesThatAreNotRead() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.xcf"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("gimp xcf v011") > 0);
    file.close();
    speak(QStringLiteral("de"));
    QCOMPARE(
        saidOf([&] { readImage(path.toStdString()); }),
        path + QStringLiteral(": ist ein GIMP-Bild (XCF; aus GIMP als PNG oder OpenRaster exportieren). Wend "
                              "öffnet PNG, JPEG, TIFF, EXR, WebP, GIF, PSD, OpenRaster, Krita, SVG, HEIC, "
                              "AVIF, JPEG 2000, Kamera-Rohdaten und andere Bilder"));
}

void TestSaid::stops() {
    const Message fold(
        sentence("Core",
                 "the shape would fold over near %1, in cell %2; move it less far or along another "
                 "path, or release what holds the shape there"),
        "(3, 4)", 17);
    const Message stop(sentence("Core", "at time %1 %2 cannot go on: %3"), "0.4",
                       Message(sentence("Core", "handle \"%1\""), "tail"), fold);
    speak(QStringLiteral("de"));
    QCOMPARE(
        said(stop),
        QStringLiteral("zur Zeit 0.4 kann Pin „tail“ nicht weiter: die Form würde sich bei (3, 4), in Zelle "
                       "17, überschlagen; weniger weit oder anders führen, oder lösen, was die Form dort "
                       "hält"));
}

/// A message keeps its parts through a pipe, and no other bytes are taken for one.
void TestSaid::messagesTravelAsBytes() {
    const Message inner(sentence("Core", "has a damaged %1"), std::string("a\0:9%1", 6)),
        outer(sentence("Core", "cannot be read: %1"), inner);
    for (const Message& message : {outer, inner, outer + ": " + inner, Message("plain"), Message()}) {
        const std::string bytes = packed(message);
        const Message back = unpackedMessage(bytes);
        QCOMPARE(back.text(), message.text());
        QCOMPARE(said(back), said(message));
        QCOMPARE(packed(back), bytes);
        for (std::size_t length = 0; length < bytes.size(); ++length)
            QVERIFY_EXCEPTION_THROWN(unpackedMessage(bytes.substr(0, length)), InputError);
        QVERIFY_EXCEPTION_THROWN(unpackedMessage(bytes + "0:0:"), InputError);
    }
    std::string deep;
    for (int k = 0; k < 100'000; ++k) deep += "0:2:";
    QVERIFY_EXCEPTION_THROWN(unpackedMessage(deep), InputError);
}

void TestSaid::othersStayAsTheyAre_data() {
    QTest::addColumn<QString>("text");
    for (const char* text :
         {"", ": ", "a.json: is not valid JSON: line 3, column 4: unexpected end of input",
          "the field \"phi\" has 4 values where the mesh has 3 cells", "100 %", "%1", "vertex"})
        QTest::newRow(text) << text;
}

void TestSaid::othersStayAsTheyAre() {
    QFETCH(QString, text);
    speak(QStringLiteral("de"));
    QCOMPARE(said(text.toStdString()), text);
}

QTEST_GUILESS_MAIN(TestSaid)
#include "test_said.moc"
