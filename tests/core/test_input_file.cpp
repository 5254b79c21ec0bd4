// The reading of all input files, and texts from files made safe to print.

#include <QtTest>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/printable.h"
#include "test_folder.h"

using namespace wend;

class TestInputFile : public QObject {
    Q_OBJECT

  private slots:
    void readsParts() {
        const samples::Folder folder;
        const InputFile file(folder.put("a", "0123456789"));
        QCOMPARE(file.size(), std::uint64_t(10));
        QCOMPARE(file.bytes(), std::string("0123456789"));
        QCOMPARE(file.bytes(3, 4), std::string("3456"));
        QCOMPARE(file.bytes(8, 40), std::string("89"));
        QCOMPARE(file.bytes(20, 1), std::string());
    }

    void stops() {
        const samples::Folder folder;
        const std::string path = folder.put("a", "0123456789");
        stopReading(true);
        QVERIFY_THROWS_EXCEPTION(Cancelled, readInput(path));
        stopReading(false);
        QCOMPARE(readInput(path).size(), std::size_t(10));
    }

    void printable_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("shown");
        const auto row = [](const char* name, const QByteArray& text, const QByteArray& shown) {
            QTest::newRow(name) << text << shown;
        };
        row("plain", "a b-c_d~", "a b-c_d~");
        row("languages", "Größe Ωμέγα 大きさ 🐸 naïve", "Größe Ωμέγα 大きさ 🐸 naïve");
        row("escape", "a\x1b[31mb", "a\\x1b[31mb");
        row("NUL", QByteArray("a\0b", 3), "a\\x00b");
        row("delete",
            "a\x7f"
            "b",
            "a\\x7fb");
        row("tab", "a\tb", "a\\x09b");
        row("lines", "a\r\nb\nc", "a  b c");
        row("C1",
            "a\xc2\x9b"
            "31mb",
            "a\\u{9b}31mb");
        row("right to left",
            "a\xe2\x80\xae"
            "b",
            "a\\u{202e}b");
        row("isolate",
            "a\xe2\x81\xa7"
            "b",
            "a\\u{2067}b");
        row("line separator",
            "a\xe2\x80\xa8"
            "b",
            "a\\u{2028}b");
        row("Latin-1",
            "Gr\xf6\xdf"
            "e",
            "Gr\\xf6\\xdfe");
        row("lone byte", "a\x80", "a\\x80");
        row("cut off", "a\xe2\x82", "a\\xe2\\x82");
        row("longer than needed", "\xc0\x9b[", "\\xc0\\x9b[");
        row("surrogate", "\xed\xa0\x80", "\\xed\\xa0\\x80");
        row("beyond Unicode", "\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80");
    }
    void printable() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, shown);
        const std::string result = wend::printable(text.toStdString());
        QCOMPARE(QByteArray::fromStdString(result), shown);
        QCOMPARE(wend::printable(result), result);
        QCOMPARE(QString::fromStdString(result).toUtf8(), shown);
    }

    void messages() {
        const std::string name("a\0b", 3);
        QCOMPARE(messageOf(InputError(name, "does not exist")), std::string("a\\x00b: does not exist"));
        QCOMPARE(messageOf(InputError("line 3\n")), std::string("line 3 "));
        QCOMPARE(messageOf(std::runtime_error("\x1b")), std::string("\\x1b"));
    }
};

QTEST_APPLESS_MAIN(TestInputFile)
#include "test_input_file.moc"
