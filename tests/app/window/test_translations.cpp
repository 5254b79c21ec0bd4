// Every language is complete, compared with the texts that lupdate finds in the sources, and fits in the
// window.

#include <QApplication>
#include <QDir>
#include <QProcess>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QTranslator>
#include <QXmlStreamReader>

#include "app/window/actions/toolbox.h"
#include "app/window/files/start_page.h"
#include "app/window/properties.h"
#include "tests/support/solid_fixture.h"
#include "tests/support/whole_texts.h"

using namespace wend;
using namespace wend::test;

namespace {

struct Entry {
    QString context, source, comment;
    QStringList texts;  // several where the number decides
    bool finished = true;

    QString place() const { return context + ": " + source; }
};

std::vector<Entry> messagesOf(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return {};
    QXmlStreamReader xml(&file);
    std::vector<Entry> messages;
    QString context;
    bool counted = false;  // it has a text for each of the language's numbers
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        const auto name = xml.name();
        if (name == u"name") context = xml.readElementText();
        if (name == u"message") {
            messages.push_back({context, {}, {}, {}, true});
            counted = xml.attributes().hasAttribute(QStringLiteral("numerus"));
        }
        if (name == u"source") messages.back().source = xml.readElementText();
        if (name == u"comment") messages.back().comment = xml.readElementText();
        if (name == u"numerusform") messages.back().texts << xml.readElementText();
        if (name == u"translation") {
            messages.back().finished = !xml.attributes().hasAttribute(QStringLiteral("type"));
            if (!counted) messages.back().texts << xml.readElementText();
        }
    }
    return xml.hasError() ? std::vector<Entry>() : messages;
}

QStringList found(const QRegularExpression& what, const QString& in) {
    QStringList all;
    for (auto match = what.globalMatch(in); match.hasNext();) all << match.next().captured();
    all.sort();
    return all;
}

QStringList sourcesOf(const std::vector<Entry>& messages) {
    QStringList sources;
    for (const Entry& message : messages) sources << message.place() + '|' + message.comment;
    sources.sort();
    return sources;
}

}  // namespace

class TestTranslations : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void everythingIsTranslated_data() { languages(); }
    void everythingIsTranslated();
    void startPageIsWhole_data() { languages(); }
    void startPageIsWhole();
    void nothingIsCutOff_data();
    void nothingIsCutOff();

  private:
    void languages() const;

    QDir m_folder{QStringLiteral(WEND_SOURCE_DIR "/translations")};
    QTemporaryDir m_temporary;
    QStringList m_sources;  // that lupdate finds
};

void TestTranslations::initTestCase() {
    const QString path = m_temporary.filePath(QStringLiteral("sources.ts"));
    QProcess lupdate;
    lupdate.setWorkingDirectory(QStringLiteral(WEND_SOURCE_DIR));
    lupdate.start(QStringLiteral(WEND_LUPDATE),
                  {"-tr-function-alias", "QT_TRANSLATE_NOOP+=sentence", "-locations", "none", "-I", ".",
                   "app", "core", "warp", "-ts", path});
    QVERIFY(lupdate.waitForFinished(120000) && lupdate.exitCode() == 0);
    m_sources = sourcesOf(messagesOf(path));
    QVERIFY(m_sources.size() > 1000);
}

void TestTranslations::languages() const {
    QTest::addColumn<QString>("file");
    for (const QString& file : m_folder.entryList({QStringLiteral("*.ts")}))
        QTest::newRow(qPrintable(file)) << file;
}

/// The translations have exactly the texts of the sources, with the same placeholders, and a key for the same
/// entries.
void TestTranslations::everythingIsTranslated() {
    QFETCH(QString, file);
    const std::vector<Entry> messages = messagesOf(m_folder.filePath(file));
    const QStringList known = sourcesOf(messages);
    for (const QString& source : m_sources) QVERIFY2(known.contains(source), qPrintable(source));
    QCOMPARE(known.size(), m_sources.size());
    static const QRegularExpression placeholder(QStringLiteral("%L?\\d|%n")),
        key(QStringLiteral("&(?=[^&\\s])"));
    static const QRegularExpression tag(QStringLiteral("</?[a-z]+"));
    for (const Entry& message : messages) {
        QVERIFY2(message.finished && !message.texts.isEmpty(), qPrintable(message.place()));
        for (const QString& text : message.texts) {
            const QByteArray place = (message.place() + " -> " + text).toUtf8();
            QVERIFY2(!text.trimmed().isEmpty(), place);
            QVERIFY2(found(tag, text) == found(tag, message.source), place);
            QVERIFY2(found(key, text).size() == found(key, message.source).size(), place);
            if (message.texts.size() == 1)
                QVERIFY2(found(placeholder, text) == found(placeholder, message.source), place);
        }
    }
}

void TestTranslations::nothingIsCutOff_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<bool>("solid");
    for (const QString& file : QStringList{QString()} + m_folder.entryList({QStringLiteral("*.ts")}))
        for (const bool solid : {false, true})
            QTest::addRow("%s, %s", file.isEmpty() ? "English" : qPrintable(file),
                          solid ? "solid" : "picture")
                << file << solid;
}

/// The start page has the cards of the samples.
void TestTranslations::startPageIsWhole() {
    QFETCH(QString, file);
    QTranslator translator;
    QVERIFY(translator.load(":/i18n/" + QFileInfo(file).completeBaseName() + ".qm"));
    QVERIFY(QApplication::installTranslator(&translator));
    const auto back = qScopeGuard([&translator] { QApplication::removeTranslator(&translator); });
    SolidFixture fixture;
    settleLayout(fixture.window());
    const auto cards = fixture.window().findChildren<FileCard*>();
    QVERIFY(cards.size() >= 6);
    for (const FileCard* card : cards) {
        QFont title = card->font(), line = card->font();
        title.setWeight(QFont::DemiBold);
        line.setPixelSize(12);
        QVERIFY2(QFontMetrics(title).horizontalAdvance(card->text()) <= card->room(),
                 qPrintable(card->text()));
        QVERIFY2(QFontMetrics(line).horizontalAdvance(card->accessibleDescription()) <= card->room(),
                 qPrintable(card->accessibleDescription()));
    }
    const QStringList wrong = cutOff(fixture.window());
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QStringLiteral("; "))));
}

/// Nothing is cut off on a small screen, in any step.
void TestTranslations::nothingIsCutOff() {
    QFETCH(QString, file);
    QFETCH(bool, solid);
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    QTranslator translator;
    if (!file.isEmpty()) {
        QVERIFY(translator.load(":/i18n/" + QFileInfo(file).completeBaseName() + ".qm"));
        QVERIFY(QApplication::installTranslator(&translator));
    }
    const auto back = qScopeGuard([&translator] { QApplication::removeTranslator(&translator); });
    SolidFixture fixture;
    fixture.window().resize(1366, 768);
    QVERIFY(solid ? fixture.open() : fixture.openPicture());
    for (const Mode mode : kModes) {
        fixture.window().tools().setMode(mode);
        settleLayout(fixture.window().properties());
        const QStringList wrong = cutOff(fixture.window());
        QVERIFY2(wrong.isEmpty(),
                 qPrintable(QStringLiteral("step %1: ").arg(int(mode)) + wrong.join(QStringLiteral("; "))));
    }
}

QTEST_MAIN(TestTranslations)
#include "test_translations.moc"
