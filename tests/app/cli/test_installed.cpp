#include <QDirIterator>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>

#include "app/base/program_files.h"
#include "app/session/opening.h"
#include "app/window/help/help.h"
#include "tests/app/cli/cli_harness.h"

using namespace wend;

/// The program that `cmake --install` makes runs where it was installed, and after the folder is moved.
class TestInstalled : public QObject {
    Q_OBJECT
  private slots:
    void initTestCase();
    void nothingIsMissing();
    void programRuns();
    void sampleIsRun();
    void surfaceIsMeshed();
    void filmIsWritten();
    void windowFindsSamplesAndManual();

  private:
    QString file(const QString& name) const { return m_moved + '/' + name; }
    CliResult run(const QStringList& arguments) const;

    QTemporaryDir m_folder;
    QString m_moved;
};

namespace {

const QString kLook = QStringLiteral("--look");

/// Returns the faults in the samples and the manual that the program's window would show, or an empty text.
/// It runs in place of the window, in a process of its own beside the program.
QString wrongInWindow() {
    const QString share = QDir(QCoreApplication::applicationDirPath() + "/../share/wend").canonicalPath();
    const QStringList samples = samplePaths();
    if (samples.size() < 5) return QStringLiteral("%1 samples").arg(samples.size());
    for (const QString& sample : samples)
        if (!sample.startsWith(share) || !missingFiles(sample).isEmpty()) return sample;
    if (!manualFolder().startsWith(share)) return manualFolder();
    ManualWindow manual(nullptr);
    manual.show();
    QTextDocument* page = manual.pages()->document();
    for (QTextBlock block = page->begin(); block.isValid(); block = block.next())
        for (auto piece = block.begin(); !piece.atEnd(); ++piece) {
            const QTextCharFormat format = piece.fragment().charFormat();
            if (!format.isImageFormat()) continue;
            const QUrl name(format.toImageFormat().name());
            const auto picture = page->resource(QTextDocument::ImageResource, name).value<QImage>();
            if (picture.width() > 100) return {};
        }
    return QStringLiteral("no picture in the manual");
}

}  // namespace

/// Runs the program without the folders in which it was built or first installed.
CliResult TestInstalled::run(const QStringList& arguments) const {
    return runCli(m_folder.path(), arguments, QProcessEnvironment::systemEnvironment(),
                  file(QStringLiteral("bin/wend")));
}

void TestInstalled::initTestCase() {
    const QString first = m_folder.filePath(QStringLiteral("first"));
    m_moved = m_folder.filePath(QStringLiteral("moved to/another place"));
    QProcess cmake;
    cmake.start(QStringLiteral(WEND_CMAKE), {"--install", QStringLiteral(WEND_BUILD), "--prefix", first});
    QVERIFY(cmake.waitForFinished(120000));
    QVERIFY2(cmake.exitCode() == 0, cmake.readAllStandardError().constData());
    QVERIFY(QDir().mkpath(m_folder.filePath(QStringLiteral("moved to"))));
    QVERIFY(QDir().rename(first, m_moved));
}

void TestInstalled::nothingIsMissing() {
    for (const char* name : {"bin/wend",
                             "lib/wend/wend-tetgen",
                             "lib/wend/wend-pictures.so",
                             "share/applications/wend.desktop",
                             "share/icons/hicolor/scalable/apps/wend.svg",
                             "share/mime/packages/wend.xml",
                             "share/metainfo/wend.metainfo.xml",
                             "share/doc/wend/LICENSE",
                             "share/wend/manual/manual.md",
                             "share/wend/manual/pictures/window.png",
                             "share/wend/samples/eagle-plumage.png",
                             "share/man/man1/wend-run.1.gz",
                             "share/bash-completion/completions/wend",
                             "share/zsh/vendor-completions/_wend",
                             "share/fish/vendor_completions.d/wend.fish",
                             "share/thumbnailers/wend.thumbnailer",
                             "share/inkscape/extensions/wend_bend.inx",
                             "share/blender/scripts/addons/wend_bend.py",
                             "share/krita/pykrita/wend_bend.desktop",
                             "share/krita/pykrita/wend_bend/docker.py",
                             "share/wend/paraview/wend_project.xml"})
        QVERIFY2(QFile::exists(file(QLatin1String(name))), name);
    // Every program or library that Wend starts or loads must be listed here.
    const QStringList helpers = QDir(QStringLiteral(WEND_BUILD))
                                    .entryList({QStringLiteral("wend-*")}, QDir::Files | QDir::Executable);
    QVERIFY(helpers.size() >= 3);
    for (const QString& helper : helpers) {
        const bool isCommand = helper == QStringLiteral("wend-mpi");
        QVERIFY2(QFile::exists(file((isCommand ? "bin/" : "lib/wend/") + helper)), qPrintable(helper));
    }
    QDirIterator all(m_moved, QDir::Files, QDirIterator::Subdirectories);
    while (all.hasNext()) {
        const QString name = all.next();
        // Plug-ins are scripts.
        if (name.contains("/inkscape/") || name.contains("/blender/") || name.contains("/krita/")) continue;
        QVERIFY2(!name.endsWith(".py") && !name.endsWith(".sh") && !name.endsWith(".a"), qPrintable(name));
    }
}

void TestInstalled::programRuns() {
    const CliResult result = run({"--version"});
    QCOMPARE(result.code, 0);
    QVERIFY2(result.out.contains(QStringLiteral("0.")), qPrintable(result.out));
}

/// The picture equals that of the program in its build folder.
void TestInstalled::sampleIsRun() {
    const QString sample = file(QStringLiteral("share/wend/samples/strip.wend"));
    const QStringList rest{"--backend", "cpu", "--quiet", "--image"};
    const CliResult here = run(QStringList{"run", sample} + rest + QStringList{"here.png"});
    QVERIFY2(here.code == 0, qPrintable(here.error));
    QCOMPARE(runCli(m_folder.path(), QStringList{"run", sample} + rest + QStringList{"there.png"}).code, 0);
    const QImage picture(m_folder.filePath(QStringLiteral("here.png")));
    QVERIFY(picture.width() > 100);
    QCOMPARE(picture, QImage(m_folder.filePath(QStringLiteral("there.png"))));
}

/// A surface is meshed by the installed helper program.
void TestInstalled::surfaceIsMeshed() {
    const CliResult result = run(
        {"mesh", file(QStringLiteral("share/wend/samples/bar.obj")), "--vertices", "600", "-o", "bar.msh"});
    QVERIFY2(result.code == 0, qPrintable(result.error));
    QVERIFY(QFileInfo(m_folder.filePath(QStringLiteral("bar.msh"))).size() > 10000);
}

void TestInstalled::filmIsWritten() {
    const CliResult result = run({"run", file(QStringLiteral("share/wend/samples/strip.wend")), "--backend",
                                  "cpu", "--quiet", "--frames", "strip.webp", "--count", "3"});
    QVERIFY2(result.code == 0, qPrintable(result.error));
    QVERIFY(QFileInfo(m_folder.filePath(QStringLiteral("strip.webp"))).size() > 1000);
}

/// This test program runs in place of the installed one.
void TestInstalled::windowFindsSamplesAndManual() {
    const QString looker = file(QStringLiteral("bin/looker"));
    QVERIFY(QFile::copy(QCoreApplication::applicationFilePath(), looker));
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
    const CliResult result = runCli(m_folder.path(), {kLook}, environment, looker);
    QVERIFY2(result.code == 0 && !result.crashed, qPrintable(result.error));
}

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    if (QCoreApplication::arguments().value(1) != kLook) {
        TestInstalled test;
        return QTest::qExec(&test, argc, argv);
    }
    const QString wrong = wrongInWindow();
    if (!wrong.isEmpty()) qWarning("%s", qPrintable(wrong));
    return wrong.isEmpty() ? 0 : 1;
}
#include "test_installed.moc"
