// What the core says, in other languages.

#include <QCoreApplication>
#include <QDirIterator>
#include <QRegularExpression>
#include <QTest>
#include <QTranslator>

#include "app/document/said.h"
#include "core/mesh/error.h"
#include "core/meshing/planar_mesher.h"
#include "warp/image.h"
#include "warp/outline.h"

using namespace wend;

class TestSaid : public QObject {
    Q_OBJECT
  private slots:
    void initTestCase();
    void cleanup();
    void errorsSpeakTheLanguage_data();
    void errorsSpeakTheLanguage();
    void messagesAreFilledAfterTranslation();
    void sentencesAreTakenApart_data();
    void sentencesAreTakenApart();
    void othersStayAsTheyAre_data();
    void othersStayAsTheyAre();
    void everySentenceIsSaidSomewhere();

  private:
    void speak(const QString& language);

    QTranslator m_translator;
};

namespace {

/// The literals of all sources, each statement's joined; "|s" stands for one and for several.
QString literals() {
    static const QRegularExpression literal(QStringLiteral("\"((?:[^\"\\\\]|\\\\.)*)\""));
    QString all;
    for (const char* folder : {"core", "warp", "app/session", "app/document"}) {
        QDirIterator it(QStringLiteral(WEND_SOURCE_DIR "/") + folder, {"*.cpp", "*.h"}, QDir::Files,
                        QDirIterator::Subdirectories);
        while (it.hasNext()) {
            QFile file(it.next());
            if (file.fileName().endsWith("said.cpp") || !file.open(QIODevice::ReadOnly)) continue;
            QString text = QString::fromUtf8(file.readAll());
            text.replace(QRegularExpression(QStringLiteral("\"\\s*\n\\s*\"")), QString());
            for (auto match = literal.globalMatch(text); match.hasNext();) {
                const QString one = match.next().captured(1).replace("\\\"", "\"");
                all += one + '\n';
                if (one.contains("|s"))
                    all += QString(one).replace("|s", "") + '\n' + QString(one).replace("|s", "s") + '\n';
            }
        }
    }
    return all;
}

/// What the English table holds.
QStringList sentences() {
    QFile file(QStringLiteral(WEND_SOURCE_DIR "/app/document/said.cpp"));
    if (!file.open(QIODevice::ReadOnly)) return {};
    QString text = QString::fromUtf8(file.readAll());
    text.replace(QRegularExpression(QStringLiteral("\"\\s*\n\\s*\"")), QString());
    static const QRegularExpression entry(
        QStringLiteral("QT_TRANSLATE_NOOP\\(\"Core\",\\s*\"((?:[^\"\\\\]|\\\\.)*)\""));
    QStringList found;
    for (auto match = entry.globalMatch(text); match.hasNext();)
        found << match.next().captured(1).replace("\\\"", "\"");
    return found;
}

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

void TestSaid::initTestCase() {
    QVERIFY(sentences().size() > 100);
}

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

/// Thrown by the core itself, so that a sentence that changes there is missed here.
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

/// Messages within messages, and after their subject; a place in an argument is none.
void TestSaid::messagesAreFilledAfterTranslation() {
    const Message crash(sentence("Core", "its reader failed inside (signal %1)"), 11);
    const InputError reading("a%1.png", {sentence("Core", "cannot be read: %1"), crash});
    const InputError missing("b.png", sentence("Core", "does not exist"));
    const InputError pin(Message("handle \"%2\"") + ": " +
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

void TestSaid::sentencesAreTakenApart_data() {
    QTest::addColumn<QString>("english");
    QTest::addColumn<QString>("german");
    QTest::newRow("arguments")
        << "handle \"ear: left, 2\" and handle 3 move the point (1, 2) in different ways at time 0.5"
        << "Pin „ear: left, 2“ und Pin 3 bewegen den Punkt (1, 2) zur Zeit 0.5 verschieden";
    QTest::newRow("a reason")
        << "at time 0.4 handle \"tail\" cannot go on: the shape would fold over near (3, 4), in "
           "cell 17; move it less far or along another path, or release what holds the shape there"
        << "zur Zeit 0.4 kann Pin „tail“ nicht weiter: die Form würde sich bei (3, 4), in Zelle "
           "17, überschlagen; weniger weit oder anders führen, oder lösen, was die Form dort "
           "hält";
    QTest::newRow("after a file") << "/home/me: here/a b.png: is truncated or corrupt"
                                  << "/home/me: here/a b.png: ist abgeschnitten oder beschädigt";
    QTest::newRow("after a pin") << "handle \"x\": its region holds no vertex"
                                 << "Pin „x“: in seinem Bereich liegt kein Eckpunkt";
    QTest::newRow("a kind")
        << "a.xcf: is a GIMP picture (XCF). Wend opens PNG, JPEG, TIFF, EXR, WebP, GIF, "
           "PSD, OpenRaster, Krita, SVG, HEIC, AVIF, JPEG 2000, camera raw and other pictures"
        << "a.xcf: ist ein GIMP-Bild (XCF). Wend öffnet PNG, JPEG, TIFF, EXR, WebP, GIF, "
           "PSD, OpenRaster, Krita, SVG, HEIC, AVIF, JPEG 2000, Kamera-Rohdaten und andere Bilder";
    QTest::newRow("layers") << "a.ora: has 5 layers: opened flattened"
                            << "a.ora: hat 5 Ebenen: zusammengefasst geöffnet";
    QTest::newRow("a list in a reason")
        << "the surface is embedded in a cage of 1900 vertices, since it cannot be meshed as it is: the "
           "surface bounds no "
           "volume: 2 open edges (first: 1–2), 1 duplicate triangle (first: 7)"
        << "die Oberfläche ist in einen Käfig aus 1900 Eckpunkten eingebettet, denn so, wie sie ist, lässt "
           "sie sich "
           "nicht vernetzen: die Oberfläche begrenzt kein Volumen: 2 offene Kanten (zuerst 1–2), 1 doppeltes "
           "Dreieck (7)";
    QTest::newRow("a placeholder in a name")
        << "handle \"%2\" and handle \"%1\" move the point (1, 2) in different ways at time 0"
        << "Pin „%2“ und Pin „%1“ bewegen den Punkt (1, 2) zur Zeit 0 verschieden";
}

void TestSaid::sentencesAreTakenApart() {
    QFETCH(QString, english);
    QFETCH(QString, german);
    QCOMPARE(said(english.toStdString()), english);
    speak(QStringLiteral("de"));
    QCOMPARE(said(english.toStdString()), german);
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

/// Each clause of each sentence stands in the sources; else nobody says it any more.
void TestSaid::everySentenceIsSaidSomewhere() {
    static const QRegularExpression place(QStringLiteral("%[1-9]|[.,:;()]"));
    const QString all = literals();
    QVERIFY(all.size() > 20000);
    for (const QString& sentence : sentences())
        for (const QString& piece : sentence.split(place))
            QVERIFY2(all.contains(piece.trimmed()), qPrintable(sentence + ": " + piece));
}

QTEST_GUILESS_MAIN(TestSaid)
#include "test_said.moc"
