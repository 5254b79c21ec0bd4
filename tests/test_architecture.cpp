#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

/// Reads the #include lines of the source tree and fails on any arrow that ARCHITECTURE.md does not allow.
class TestArchitecture : public QObject {
    Q_OBJECT
  private slots:
    void includesGoOneWay();
    void foldersWithinGoOneWay();
    void coreKnowsNoQtAndNoOpenCl();
    void installedHeadersStandAlone();
    void everyFolderIsKnown();
    void headersRebuildFewFiles_data();
    void headersRebuildFewFiles();
};

namespace {

const QString kRoot = QStringLiteral(WEND_SOURCE_DIR);

/// Folder → the other folders that it may include from.
const QMap<QString, QStringList> kAllowed = {
    {"core/base", {}},
    {"core/mesh", {"core/base"}},
    {"core/meshing", {"core/base", "core/mesh"}},
    {"core/motion", {"core/base", "core/mesh"}},
    {"core/energy", {"core/base", "core/mesh"}},
    {"core/factor", {"core/base"}},
    {"core/assembly", {"core/base", "core/mesh", "core/energy", "core/factor"}},
    {"core/solver", {"core/base", "core/mesh", "core/factor", "core/assembly"}},
    {"core/integration",
     {"core/base", "core/mesh", "core/energy", "core/assembly", "core/solver", "core/motion"}},
    {"kernels", {"core/base", "core/mesh", "core/energy", "core/assembly", "warp"}},
    {"warp", {"core/base", "core/mesh", "core/meshing"}},
    {"api", {"core/*", "warp"}},
    {"python", {"core/*", "kernels", "api", "app/project", "app/engine", "app/cli"}},
    {"app/base", {"core/base"}},
    {"app/project", {"core/*", "warp", "app/base"}},
    {"app/engine", {"core/*", "kernels", "warp", "app/base", "app/project"}},
    {"app/output", {"core/*", "kernels", "warp", "app/project", "app/engine"}},
    {"app/cli", {"core/*", "kernels", "warp", "app/project", "app/engine", "app/output"}},
    {"app/session", {"core/*", "warp", "app/base", "app/project", "app/engine"}},
    {"app/style", {"core/*", "app/project", "app/engine", "app/session"}},
    {"app/tools", {"core/*", "warp", "app/base", "app/project", "app/engine", "app/session", "app/style"}},
    {"app/panels", {"core/*", "warp", "app/base", "app/project", "app/engine", "app/session", "app/style"}},
    {"app/views",
     {"core/*", "warp", "app/base", "app/project", "app/engine", "app/session", "app/style", "app/tools",
      "app/panels"}},
    {"app/window",
     {"core/*", "warp", "app/base", "app/project", "app/engine", "app/output", "app/session", "app/style",
      "app/tools", "app/panels", "app/views"}},
    {"app", {"core/base", "app/cli", "app/window", "kernels", "warp"}},
    {"mpi", {"core/*", "kernels", "warp", "app/output", "app/cli"}},
    {"bench",
     {"core/*", "kernels", "warp", "app/base", "app/project", "app/engine", "app/output", "app/session",
      "app/cli", "app/views", "app/window"}},
};

const QStringList kTops{"core", "kernels", "warp", "api", "python", "app", "mpi", "bench"};

struct Include {
    QString file, target;
};

/// The library's headers are below api: "wend/flow.h".
QString folderOf(const QString& file) {
    const QStringList parts = file.split('/');
    if (parts[0] == "wend") return QStringLiteral("api");
    if (parts[0] == "core") return parts[0] + '/' + parts[1];
    if (parts[0] == "app") return parts.size() > 2 ? parts[0] + '/' + parts[1] : parts[0];
    return parts[0];
}

QList<Include> includesBelow(const QString& folder) {
    static const QRegularExpression line(QStringLiteral("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]"),
                                         QRegularExpression::MultilineOption);
    QList<Include> found;
    QDirIterator it(kRoot + '/' + folder, {"*.h", "*.cpp", "*.cl"}, QDir::Files,
                    QDirIterator::Subdirectories);
    while (it.hasNext()) {
        QFile file(it.next());
        if (!file.open(QIODevice::ReadOnly)) continue;
        const QString text = QString::fromUtf8(file.readAll());
        const QString name = it.filePath().mid(kRoot.size() + 1);
        for (auto match = line.globalMatch(text); match.hasNext();)
            found.append({name, match.next().captured(1)});
    }
    return found;
}

/// Returns the source files that include a header, directly or by other headers.
QSet<QString> rebuiltBy(const QString& header) {
    QMultiMap<QString, QString> includers;
    for (const QString& top : kTops + QStringList("tests"))
        for (const Include& include : includesBelow(top)) {
            const QString beside = include.file.left(include.file.lastIndexOf('/') + 1) + include.target;
            includers.insert(include.target.contains('/') ? include.target : beside, include.file);
        }
    QSet<QString> seen{header};
    for (QStringList open{header}; !open.isEmpty();)
        for (const QString& file : includers.values(open.takeFirst()))
            if (!seen.contains(file)) {
                seen.insert(file);
                open << file;
            }
    seen.removeIf([](const QString& file) { return !file.endsWith(QStringLiteral(".cpp")); });
    return seen;
}

bool isOurs(const QString& target) {
    static const QRegularExpression ours(QStringLiteral("^(core|kernels|warp|app|mpi|bench|api|wend)/"));
    return ours.match(target).hasMatch();
}

bool allowed(const QString& from, const QString& to) {
    if (from == to) return true;
    const QStringList list = kAllowed.value(from);
    return list.contains(to) || (to.startsWith("core/") && list.contains("core/*"));
}

}  // namespace

void TestArchitecture::includesGoOneWay() {
    QStringList wrong;
    int seen = 0;
    for (const QString& top : kTops) {
        for (const Include& include : includesBelow(top)) {
            if (!isOurs(include.target)) continue;
            ++seen;
            if (!allowed(folderOf(include.file), folderOf(include.target)))
                wrong << include.file + " includes " + include.target;
        }
    }
    QVERIFY(seen > 50);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
}

/// No folder within a folder of the table depends on itself, counting the files directly in the outer one as
/// a folder.
void TestArchitecture::foldersWithinGoOneWay() {
    QMap<QString, QSet<QString>> below;
    for (const Include& include : includesBelow(QStringLiteral("app"))) {
        const QString from = include.file.section('/', 0, -2), to = include.target.section('/', 0, -2);
        if (from != to && folderOf(include.file) == folderOf(include.target)) below[from].insert(to);
    }
    QVERIFY(below.size() > 15);
    for (auto it = below.cbegin(); it != below.cend(); ++it) {
        QSet<QString> reached = it.value();
        for (QStringList open = reached.values(); !open.isEmpty();)
            for (const QString& next : below.value(open.takeFirst()))
                if (!reached.contains(next)) {
                    reached.insert(next);
                    open << next;
                }
        QVERIFY2(!reached.contains(it.key()), qPrintable(it.key()));
    }
}

void TestArchitecture::coreKnowsNoQtAndNoOpenCl() {
    static const QRegularExpression foreign(QStringLiteral("^(Q[A-Z]|Qt|CL/|OpenImageIO/)"));
    QStringList wrong;
    for (const Include& include : includesBelow("core"))
        if (foreign.match(include.target).hasMatch()) wrong << include.file + " includes " + include.target;
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
}

/// Headers that libwend installs include only one another and the standard library.
void TestArchitecture::installedHeadersStandAlone() {
    static const QRegularExpression own(QStringLiteral("^(wend/[a-z_]+\\.h|[a-z_]+)$"));
    const QList<Include> includes = includesBelow("api/wend");
    QVERIFY(includes.size() > 10);
    for (const Include& include : includes)
        QVERIFY2(own.match(include.target).hasMatch(),
                 qPrintable(include.file + " includes " + include.target));
}

void TestArchitecture::everyFolderIsKnown() {
    for (const QString& top : kTops)
        for (const Include& include : includesBelow(top))
            QVERIFY2(kAllowed.contains(folderOf(include.file)), qPrintable(include.file));
}

void TestArchitecture::headersRebuildFewFiles_data() {
    QTest::addColumn<QString>("header");
    QTest::addColumn<int>("program");  // files, at most …
    QTest::addColumn<int>("all");      // … and with those of the tests
    QTest::newRow("distortion") << "core/energy/distortion.h" << 20 << 34;
    QTest::newRow("warp") << "warp/warp.h" << 24 << 34;
    QTest::newRow("mesh file") << "core/mesh/mesh_file.h" << 54 << 66;
    QTest::newRow("project") << "app/project/project.h" << 30 << 48;
    QTest::newRow("options") << "app/project/options/options.h" << 61 << 72;
    QTest::newRow("settings") << "app/project/options/settings.h" << 15 << 20;
    QTest::newRow("solver") << "core/solver/velocity_solver.h" << 32 << 65;
    QTest::newRow("reader") << "app/project/file/project_reader.h" << 11 << 32;
    QTest::newRow("mesh formats") << "core/mesh/mesh_formats.h" << 38 << 40;
}

/// A change of one of these rebuilds that many files; a header that only names their types declares them
/// itself.
void TestArchitecture::headersRebuildFewFiles() {
    QFETCH(QString, header);
    QFETCH(int, program);
    QFETCH(int, all);
    QSet<QString> files = rebuiltBy(header);
    QVERIFY2(files.size() > 3 && files.size() <= all, qPrintable(QString::number(files.size())));
    files.removeIf([](const QString& file) { return file.startsWith(QStringLiteral("tests/")); });
    QVERIFY2(files.size() <= program, qPrintable(QString::number(files.size())));
}

QTEST_APPLESS_MAIN(TestArchitecture)
#include "test_architecture.moc"
