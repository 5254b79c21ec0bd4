#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalSpy>

#include "app/output/run_options.h"
#include "app/panels/fields/option_field.h"
#include "app/project/domain.h"
#include "app/project/edits/film_edits.h"
#include "app/views/canvas/canvas.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/toolbox.h"
#include "app/window/export/export_panel.h"
#include "app/window/export/exporter.h"
#include "app/window/export/picture_dialog.h"
#include "app/window/main_window.h"
#include "tests/support/projects.h"
#include "tests/support/webp_frames.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// The dialogs for export options, and the files that they write.
class TestExportDialog : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void optionsComeFromTheTable();
    void everyOptionOfARunIsThere();
    void formatsDecideWhatIsAsked();
    void transparencyIsOfferedWhereItIsHeld();
    void cropIsReportedAndFits();
    void littleThatIsCutOffIsReportedToo();
    void cropsAreReportedSideBySide();
    void aLoopFitsItsCycle();
    void previewIsWhatIsWritten();
    void opaqueFormatsArePreviewedOnTheirGround_data();
    void opaqueFormatsArePreviewedOnTheirGround();
    void typedWidthIsTakenWhole();
    void choicesAreRemembered();
    void framesAreNumbered();
    void depthsAreWritten_data();
    void depthsAreWritten();
    void backgroundsAreWritten();
    void softEdgesAtRestAreTheSourcesOwn();
    void framesFollowTheirRate();
    void filmIsOneFile();
    void framesAreOfTheShapeThatIsThere();
    void exportIsTheMainButton();

  private:
    void open(const QString& picture);
    void bend(double dx, double dy);
    std::unique_ptr<ExportDialog> dialog(ExportKind kind);
    std::shared_ptr<const FrameExport> shape();
    bool written(ExportKind kind, const QString& path, const OptionValues& values);
    QString file(const char* name) const { return m_folder->filePath(QString::fromLatin1(name)); }
    ShapeSession& session() { return m_window->session(); }

    std::unique_ptr<TestFolder> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

namespace {

const ExportKind kKinds[] = {ExportKind::Picture, ExportKind::Film, ExportKind::Frames, ExportKind::StMap,
                             ExportKind::Mesh};

OptionValues with(const std::string& flag, const std::string& value) {
    OptionValues values;
    values.set(flag, value);
    return values;
}

bool waitForPreview(ExportDialog& dialog) {
    return QTest::qWaitFor([&] { return dialog.form().preview().isCurrent(); }, 30000);
}

/// Activates a dialog, whose fields have the focus only then.
bool activate(ExportDialog& dialog) {
    return QTest::qWaitFor(
        [&] {
            dialog.activateWindow();
            return dialog.isActiveWindow();
        },
        20000);
}

void choose(ExportDialog& dialog, const char* extension) {
    auto* format = dialog.findChild<QComboBox*>(QStringLiteral("format"));
    format->setCurrentIndex(format->findData(QString::fromLatin1(extension)));
}

/// Saves a screenshot for inspection.
void keepPicture(QWidget& widget, const char* name) {
    if (qEnvironmentVariableIsSet("WEND_TEST_PICTURES"))
        widget.grab().save(qEnvironmentVariable("WEND_TEST_PICTURES") + '/' + QLatin1String(name));
}

}  // namespace

void TestExportDialog::init() {
    m_folder = std::make_unique<TestFolder>();
    m_window = std::make_unique<MainWindow>();
    if (qEnvironmentVariableIsSet("WEND_TEST_DARK")) m_window->actions().darkLook->trigger();
    m_window->resize(1100, 760);
    m_window->show();
}

void TestExportDialog::cleanup() {
    if (!session().document().isEmpty()) session().document().undoStack()->setClean();
    m_window.reset();
}

void TestExportDialog::open(const QString& picture) {
    m_window->openPath(picture);
    QVERIFY(QTest::qWaitFor([&] { return !session().document().isEmpty(); }, 20000));
    setVertices(session().document(), 300);
    QVERIFY(settle(session()));
}

/// Pins two points and drags the right one.
void TestExportDialog::bend(double dx, double dy) {
    session().addPin({40, 80, 0});
    session().addPin({200, 80, 0});
    QVERIFY(settle(session()));
    session().gestures().begin();
    session().gestures().moveBy({dx, dy, 0});
    session().gestures().end(0.5);
    QVERIFY(settle(session()));
}

std::shared_ptr<const FrameExport> TestExportDialog::shape() {
    const double seconds = session().playback().end() * Playback::kSecondsPerUnit;
    return std::make_shared<const FrameExport>(session().document(), session().motion().frame(),
                                               session().motion().track().frames(), seconds);
}

std::unique_ptr<ExportDialog> TestExportDialog::dialog(ExportKind kind) {
    auto made = std::make_unique<ExportDialog>(ExportSubject{kind, shape()}, m_window->exporter().choices(),
                                               m_window.get());
    made->show();
    return made;
}

bool TestExportDialog::written(ExportKind kind, const QString& path, const OptionValues& values) {
    QSignalSpy done(&m_window->exporter(), &Exporter::done), failed(&m_window->exporter(), &Exporter::failed);
    m_window->exporter().write(kind, path, runOptionsFrom(values));
    return QTest::qWaitFor([&] { return done.count() + failed.count() > 0; }, 60000) && done.count() == 1;
}

/// Choices, ranges and defaults are those of the command line, not a list of their own.
void TestExportDialog::optionsComeFromTheTable() {
    open(writeCutOut(*m_folder));
    bend(0, 10);
    int seen = 0;
    for (const ExportKind kind : kKinds) {
        const auto asked = dialog(kind);
        for (const OptionField* field : asked->findChildren<OptionField*>()) {
            ++seen;
            const Option& known = option(field->flag());
            QVERIFY2(!field->label().isEmpty(), known.flag.data());
            QVERIFY2(!field->focusProxy()->toolTip().isEmpty(), known.flag.data());
            if (known.kind != OptionKind::Choice) continue;
            for (const QString& choice : field->choices())
                QVERIFY2(isChoice(known, choice.toStdString()), known.flag.data());
            if (field->flag() != "--depth")  // formats hold some depths only
                QCOMPARE(field->choices().join('|').toStdString(), std::string(known.choices));
            QCOMPARE(field->value(), defaultText(known));
        }
    }
    QVERIFY(seen >= 20);
}

/// Every output option of `wend run` has a field in a dialog.
void TestExportDialog::everyOptionOfARunIsThere() {
    // Left out are the project's own settings, those that only a command line needs, and those that only
    // solids have.
    const QStringList others{"--phi",      "--method", "--tolerance", "--steps",   "--at",       "--partial",
                             "--memory",   "--settle", "--backend",   "--threads", "--progress", "--quiet",
                             "--velocity", "--report", "--border",    "--shard",   "--solver",   "--strict",
                             "--shells",   "--points", "--inverse",   "--width",   "--size"};
    open(writeCutOut(*m_folder));
    bend(0, 10);
    QStringList asked;
    for (const ExportKind kind : kKinds) {
        const auto one = dialog(kind);
        auto* format = one->findChild<QComboBox*>(QStringLiteral("format"));
        for (int i = 0; i < format->count(); ++i) {
            format->setCurrentIndex(i);
            for (const OptionField* field : one->findChildren<OptionField*>())
                if (field->isVisible()) asked << QString::fromStdString(field->flag());
        }
    }
    for (const Option& one : options()) {
        const QString flag = QString::fromUtf8(one.flag.data(), static_cast<qsizetype>(one.flag.size()));
        const bool ofRun = (' ' + std::string(one.commands) + ' ').find(" run ") != std::string::npos;
        if (!ofRun || one.kind == OptionKind::File || one.kind == OptionKind::Output || others.contains(flag))
            continue;
        QVERIFY2(asked.contains(flag), qPrintable(flag + " is to be had on the command line only"));
    }
}

void TestExportDialog::formatsDecideWhatIsAsked() {
    open(writeCutOut(*m_folder));
    const auto picture = dialog(ExportKind::Picture);
    const auto depths = [&] { return picture->form().field("--depth")->choices(); };
    QCOMPARE(depths(), QStringList({"picture", "8", "16"}));
    choose(*picture, ".exr");
    QCOMPARE(depths(), QStringList({"picture", "half", "float"}));
    choose(*picture, ".jpg");
    QCOMPARE(depths(), QStringList({"picture", "8"}));
    const auto mesh = dialog(ExportKind::Mesh);
    QVERIFY(!mesh->form().field("--encoding")->isVisible() && !mesh->form().field("--canvas")->isVisible());
    choose(*mesh, ".msh");
    QVERIFY(mesh->form().field("--encoding")->isVisible() && mesh->form().field("--msh")->isVisible());
    mesh->form().field("--msh")->setValue("2.2");
    QCOMPARE(runOptionsFrom(mesh->form().values()).meshes.gmshVersion, 2);
    choose(*mesh, ".vtu");
    QVERIFY(mesh->form().field("--fields")->isVisible() && !mesh->form().field("--msh")->isVisible());
    QCOMPARE(runOptionsFrom(mesh->form().values()).meshes.gmshVersion, 4);  // what is hidden says nothing
    if (waitForPreview(*mesh)) keepPicture(*mesh, "export-mesh.png");
}

/// Formats without transparency show and write white. The choice returns with a format that supports it,
/// unless the user has made another one.
void TestExportDialog::transparencyIsOfferedWhereItIsHeld() {
    open(writeCutOut(*m_folder));
    bend(-10, 25);
    for (const auto& [kind, without, with] :
         {std::tuple{ExportKind::Film, ".mp4", ".webm"}, std::tuple{ExportKind::Picture, ".jpg", ".png"}}) {
        m_window->exporter().choices() = {};
        const auto asked = dialog(kind);
        OptionField* background = asked->form().field("--outside");
        auto* list = background->findChild<QComboBox*>();
        const auto offered = [list] {
            return list->model()->index(0, 0).flags().testFlag(Qt::ItemIsEnabled);
        };
        const auto written = [&] { return asked->form().values().text("--outside"); };
        choose(*asked, without);
        QCOMPARE(written(), std::string("white"));
        QCOMPARE(list->currentText(), QStringLiteral("White"));
        QVERIFY(!offered());
        QVERIFY(list->itemData(0, Qt::ToolTipRole).toString().contains(QStringLiteral("white")));
        choose(*asked, with);
        QCOMPARE(written(), std::string("transparent"));
        QVERIFY(offered());
        choose(*asked, without);
        background->setValue("black");
        choose(*asked, with);
        QCOMPARE(written(), std::string("black"));
        background->setValue("white");  // as chosen by hand
        choose(*asked, without);
        choose(*asked, with);
        QCOMPARE(written(), std::string("white"));
    }
}

/// Returns false if the letter is already in use; a text may have none.
static bool addLetter(QSet<QString>& letters, const QString& text) {
    const QString letter = QKeySequence::mnemonic(text).toString();
    const bool isNew = letter.isEmpty() || !letters.contains(letter);
    letters << letter;
    return isNew;
}

void TestExportDialog::cropIsReportedAndFits() {
    open(writeCutOut(*m_folder));
    auto still = dialog(ExportKind::Picture);
    QVERIFY(!still->findChild<QWidget*>(QStringLiteral("cropNote"))->isVisible());
    still.reset();
    bend(60, 30);  // beyond the right border at 240
    const auto asked = dialog(ExportKind::Picture);
    auto* note = asked->findChild<QWidget*>(QStringLiteral("cropNote"));
    QVERIFY(note->isVisible());
    QVERIFY(note->findChild<QLabel*>()->text().contains(QStringLiteral("right")));
    QVERIFY(!note->findChild<QLabel*>()->text().contains(QStringLiteral("left")));
    if (waitForPreview(*asked)) keepPicture(*asked, "export-crop.png");
    // No two controls share a letter, and the buttons have the same height.
    QSet<QString> letters;
    for (const QLabel* one : asked->findChildren<QLabel*>())
        if (one->buddy() && one->isVisible())
            QVERIFY2(addLetter(letters, one->text()), qPrintable(one->text()));
    for (const QPushButton* one : asked->findChildren<QPushButton*>())
        if (one->isVisible()) QVERIFY2(addLetter(letters, one->text()), qPrintable(one->text()));
    QSet<int> heights;
    for (const QAbstractButton* one : asked->findChild<QDialogButtonBox*>()->buttons())
        heights << one->height();
    QCOMPARE(heights.size(), 1);
    note->findChild<QPushButton*>()->click();
    QVERIFY(!note->isVisible());
    QCOMPARE(asked->form().values().text("--canvas"), std::string("fit"));
    keepPicture(*asked, "export-fit.png");
    const QString path = file("fit.png");
    QVERIFY(written(ExportKind::Picture, path, asked->form().values()));
    const QImage all(path);
    const QString told = asked->findChild<QLabel*>(QStringLiteral("facts"))->text();
    QVERIFY2(told.startsWith(QStringLiteral("%1 × %2 pixels").arg(all.width()).arg(all.height())),
             qPrintable(told));
    // The bar's right end is whole: 40 high in the middle, and no part of it touches the border.
    for (int y = 0; y < all.height(); ++y)
        QVERIFY(qAlpha(all.pixel(0, y)) < 128 && qAlpha(all.pixel(all.width() - 1, y)) < 128);
    QVERIFY(written(ExportKind::Picture, file("crop.png"), {}));
    const QImage cut(file("crop.png"));
    QCOMPARE(cut.size(), QSize(240, 160));
    int touching = 0;
    for (int y = 0; y < cut.height(); ++y) touching += qAlpha(cut.pixel(239, y)) > 128;
    QVERIFY(touching > 20);
}

/// A crop of less than the outline's margin still cuts parts that had reached the outline.
void TestExportDialog::littleThatIsCutOffIsReportedToo() {
    open(writeCutOut(*m_folder));
    bend(0, 60);
    const double below = session().motion().frame<2>()->pose.row(1).maxCoeff() - 160;
    QVERIFY2(below > 0.5 && below < 4, qPrintable(QString::number(below)));
    const auto asked = dialog(ExportKind::Picture);
    const auto* note = asked->findChild<QWidget*>(QStringLiteral("cropNote"));
    QVERIFY(note->isVisible() && note->findChild<QLabel*>()->text().contains(QStringLiteral("bottom")));
}

/// Each side is reported with its own number: of the pose for a picture, of the whole motion for a film.
void TestExportDialog::cropsAreReportedSideBySide() {
    open(writeCutOut(*m_folder));
    const auto told = [&](ExportKind kind) {
        const auto asked = dialog(kind);
        const auto* note = asked->findChild<QWidget*>(QStringLiteral("cropNote"));
        return note->isVisible() ? note->findChild<QLabel*>()->text() : QString();
    };
    bend(0, -110);
    const double top = -session().motion().frame<2>()->pose.row(1).minCoeff();
    QVERIFY(top > 10);
    const QString atTop = QStringLiteral("%1 px at the top").arg(std::ceil(top));
    QVERIFY2(told(ExportKind::Picture).endsWith(": " + atTop + '.'), qPrintable(told(ExportKind::Picture)));
    session().gestures().begin();
    session().gestures().moveBy({0, 220, 0});
    session().gestures().moveBy({0, 110, 0});
    session().gestures().end(0.5);
    QVERIFY(settle(session()));
    QCOMPARE(told(ExportKind::Picture), QString());
    double above = 0, below = 0;
    for (const FramePtr& frame : session().motion().track().frames()) {
        above = std::max(above, -posed<2>(frame)->pose.row(1).minCoeff());
        below = std::max(below, posed<2>(frame)->pose.row(1).maxCoeff() - 160);
    }
    QVERIFY(above > 10 && below > 10);
    const QString film = told(ExportKind::Frames);
    QVERIFY2(film.contains(QStringLiteral("%1 px at the top").arg(std::ceil(above))), qPrintable(film));
    QVERIFY2(film.contains(QStringLiteral("%1 px at the bottom").arg(std::ceil(below))), qPrintable(film));
    QVERIFY2(!film.contains(QStringLiteral("left")), qPrintable(film));
}

/// The width of a film is even, but only the complete number is rounded, not what is typed so far.
void TestExportDialog::typedWidthIsTakenWhole() {
    open(writeCutOut(*m_folder));
    bend(0, 10);
    const auto asked = dialog(ExportKind::Film);
    auto* width = qobject_cast<QSpinBox*>(asked->form().field("--width")->focusProxy());
    QVERIFY(width);
    QVERIFY(activate(*asked));
    for (const auto& [typed, expected] : {std::pair{"450", 450}, {"333", 334}, {"640", 640}}) {
        width->setFocus();
        width->selectAll();
        QTest::keyClicks(width, QString::fromLatin1(typed));
        QTest::keyClick(width, Qt::Key_Tab);
        QCOMPARE(width->value(), expected);
    }
}

/// The next dialog, and the panel, begin with the choices of the last export; another document does not.
void TestExportDialog::choicesAreRemembered() {
    open(writeCutOut(*m_folder));
    bend(0, 10);
    const auto rateOf = [](const ExportDialog& one) { return one.form().field("--fps")->number(); };
    const auto loops = [](const ExportDialog& one) { return one.form().field("--loop")->number() != 0; };
    {
        const auto asked = dialog(ExportKind::Film);
        choose(*asked, ".webm");
        auto* loop = qobject_cast<QCheckBox*>(asked->form().field("--loop")->focusProxy());
        loop->click();
        QVERIFY(activate(*asked));
        auto* rate = asked->form().field("--fps")->findChild<QAbstractSpinBox*>();
        rate->setFocus();
        rate->selectAll();
        QTest::keyClicks(rate, QStringLiteral("12"));
        QTest::keyClick(rate, Qt::Key_Tab);
        QCOMPARE(rateOf(*asked), 12.);
    }
    {
        const auto asked = dialog(ExportKind::Film);
        QCOMPARE(asked->form().extension(), QStringLiteral(".webm"));
        QVERIFY(loops(*asked));
        QCOMPARE(rateOf(*asked), 12.);
    }
    m_window->tools().setMode(Mode::Export);
    auto* panel = m_window->findChild<ExportPanel*>();
    QTRY_VERIFY(panel->isVisible());
    QCOMPARE(panel->form().field("--fps")->number(), 12.);
    session().document().close();
    open(writeCutOut(*m_folder));
    bend(0, 10);
    const auto asked = dialog(ExportKind::Film);
    QCOMPARE(asked->form().extension(), QStringLiteral(".webm"));
    QVERIFY(!loops(*asked));
    QCOMPARE(rateOf(*asked), 24.);
}

void TestExportDialog::opaqueFormatsArePreviewedOnTheirGround_data() {
    QTest::addColumn<std::string>("outside");
    QTest::newRow("white") << std::string("white");
    QTest::newRow("the picture") << std::string("original");
}

/// White replaces transparency around the shape, and that of the picture itself.
void TestExportDialog::opaqueFormatsArePreviewedOnTheirGround() {
    QFETCH(std::string, outside);
    open(writeCutOut(*m_folder));
    bend(-10, 25);
    const auto asked = dialog(ExportKind::Picture);
    choose(*asked, ".jpg");
    asked->form().field("--outside")->setValue(outside);
    QVERIFY(waitForPreview(*asked));
    QVERIFY(written(ExportKind::Picture, file("ground.jpg"), asked->form().values()));
    const QImage is(file("ground.jpg")), seen = asked->form().preview().image();
    QCOMPARE(seen.size(), is.size());
    for (const QPoint& at : {QPoint(3, 3), QPoint(230, 150), QPoint(60, 80), QPoint(120, 30)}) {
        const QColor a = seen.pixelColor(at), b = is.pixelColor(at);
        QVERIFY2(
            std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) <
                24,
            qPrintable(a.name() + ' ' + b.name()));
    }
}

/// A canvas that fits a film of the cycle contains the frames of the cycle only.
void TestExportDialog::aLoopFitsItsCycle() {
    open(writeCutOut(*m_folder));
    bend(-10, 45);
    session().document().change(QStringLiteral("Cycle"), withCycle(*session().document().project(), 0, 0.3));
    QVERIFY(settle(session()));
    CanvasChoice fit;
    fit.kind = Canvas::Fit;
    const auto heightUpTo = [&](double end) {
        double low = 1e9, high = -1e9;
        for (const FramePtr& frame : session().motion().track().frames()) {
            const auto flat = posed<2>(frame);
            low = std::min(low, flat->pose.row(1).minCoeff());
            high = std::max(high, flat->pose.row(1).maxCoeff());
            if (frame->time >= end) break;
        }
        return high - low;
    };
    const int loop = shape()->view(ExportKind::Film, fit, true).height;
    const int all = shape()->view(ExportKind::Film, fit, false).height;
    QVERIFY2(std::abs(loop - heightUpTo(0.3)) <= 6, qPrintable(QString::number(loop)));
    QVERIFY2(std::abs(all - heightUpTo(1)) <= 6, qPrintable(QString::number(all)));
    QVERIFY(all > loop + 12);
}

/// The preview at full size equals the file, decoded by Qt.
void TestExportDialog::previewIsWhatIsWritten() {
    open(writeCutOut(*m_folder));
    bend(-10, 25);
    const auto asked = dialog(ExportKind::Picture);
    asked->form().field("--filter")->setValue("nearest");
    auto* preview = asked->findChild<ExportPreview*>();
    QVERIFY(!preview->isCurrent());
    QVERIFY(QTest::qWaitFor([&] { return preview->isCurrent(); }, 30000));
    QCOMPARE(preview->image().width(), 240);
    const QString path = file("out.png");
    QVERIFY(written(ExportKind::Picture, path, asked->form().values()));
    const QImage seen = preview->image().convertToFormat(QImage::Format_ARGB32_Premultiplied);
    const QImage is = QImage(path).convertToFormat(QImage::Format_ARGB32_Premultiplied);
    QCOMPARE(seen.size(), is.size());
    int off = 0;
    for (int y = 0; y < is.height(); ++y)
        for (int x = 0; x < is.width(); ++x) {
            const QRgb a = seen.pixel(x, y), b = is.pixel(x, y);
            off += std::abs(qAlpha(a) - qAlpha(b)) > 2 || std::abs(qRed(a) - qRed(b)) > 2;
        }
    QCOMPARE(off, 0);
}

/// A file name without a place for the number gets one.
void TestExportDialog::framesAreNumbered() {
    open(writeCutOut(*m_folder));
    bend(-10, 25);
    QVERIFY(written(ExportKind::Frames, file("film.png"), with("--count", "3")));
    QCOMPARE(QDir(m_folder->path()).entryList({QStringLiteral("film*")}),
             QStringList({"film_0000.png", "film_0001.png", "film_0002.png"}));
}

/// The picture is neither read nor meshed again.
void TestExportDialog::framesAreOfTheShapeThatIsThere() {
    const QString picture = writeCutOut(*m_folder);
    open(picture);
    bend(-10, 25);
    QVERIFY(written(ExportKind::Frames, file("a_#.png"), with("--count", "3")));
    QVERIFY(QFile::remove(picture));
    QVERIFY(written(ExportKind::Frames, file("b_#.png"), with("--count", "3")));
    for (int k = 0; k < 3; ++k) {
        QFile before(file(qPrintable(QString("a_%1.png").arg(k)))),
            after(file(qPrintable(QString("b_%1.png").arg(k))));
        QVERIFY(before.open(QIODevice::ReadOnly) && after.open(QIODevice::ReadOnly));
        QVERIFY(before.size() > 100);
        QCOMPARE(after.readAll(), before.readAll());
    }
}

/// The film of a picture is as long as the motion, without options that the format does not support; its
/// frames are the sequence's.
void TestExportDialog::filmIsOneFile() {
    open(writeCutOut(*m_folder));
    bend(-10, 25);
    const auto asked = dialog(ExportKind::Film);
    QVERIFY(asked->form().isFilm());
    QCOMPARE(asked->form().extension(), QStringLiteral(".mp4"));
    choose(*asked, ".webp");
    const ExportForm& form = asked->form();
    for (const char* flag :
         {"--fps", "--loop", "--webp", "--canvas", "--scale", "--width", "--outside", "--filter"})
        QVERIFY2(form.field(flag)->isVisible(), flag);
    for (const char* flag : {"--depth", "--count"}) QVERIFY(!form.field(flag)->isVisible());
    form.field("--fps")->setNumber(8 / session().playback().end());
    emit form.field("--fps")->changed();
    QVERIFY(written(ExportKind::Film, file("film.webp"), form.values()));
    QVERIFY(written(ExportKind::Frames, file("f_#.png"), with("--count", "9")));
    const WebpFrames film = webpFrames(file("film.webp"));
    QCOMPARE(film.pictures.size(), std::size_t(9));
    for (std::size_t k = 0; k < 9; ++k)
        QCOMPARE(seenDifference(film.pictures[k], QImage(file(qPrintable(QString("f_%1.png").arg(k))))), 0);
    const double seconds = session().playback().end() * Playback::kSecondsPerUnit;
    QVERIFY(std::abs(film.ends[7] - 1000 * seconds) <= 1);  // then the last one is seen
}

/// The button looks like the main one: filled, as the step's own.
void TestExportDialog::exportIsTheMainButton() {
    open(writeCutOut(*m_folder));
    const auto asked = dialog(ExportKind::Picture);
    PictureDialog view({320, 200}, false, m_window.get());
    view.show();
    for (QDialog* one : {static_cast<QDialog*>(asked.get()), static_cast<QDialog*>(&view)})
        for (QAbstractButton* button : one->findChild<QDialogButtonBox*>()->buttons()) {
            const QColor inside =
                button->grab().toImage().pixelColor(button->width() / 8, button->height() / 2);
            const bool isFilled = inside.blue() > inside.red() + 60;
            QCOMPARE(isFilled, button->text().contains(QStringLiteral("xport")));
        }
}

void TestExportDialog::depthsAreWritten_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QString>("depth");
    QTest::addColumn<int>("type");
    QTest::newRow("png 8") << ".png"
                           << "8" << int(PixelType::UInt8);
    QTest::newRow("png 16") << ".png"
                            << "16" << int(PixelType::UInt16);
    QTest::newRow("tif float") << ".tif"
                               << "float" << int(PixelType::Float);
    QTest::newRow("exr half") << ".exr"
                              << "half" << int(PixelType::Half);
    QTest::newRow("exr float") << ".exr"
                               << "float" << int(PixelType::Float);
}

/// The same picture in another depth has each value to the half step of eight bits.
void TestExportDialog::depthsAreWritten() {
    QFETCH(QString, extension);
    QFETCH(QString, depth);
    QFETCH(int, type);
    open(writeCutOut(*m_folder));
    bend(-10, 25);
    const QString path = file("deep") + extension;
    QVERIFY(written(ExportKind::Picture, path, with("--depth", depth.toStdString())));
    QVERIFY(written(ExportKind::Picture, file("plain.png"), {}));
    const Image deep = readImage(path.toStdString());
    QCOMPARE(int(deep.type), type);
    const QImage plain = QImage(file("plain.png")).convertToFormat(QImage::Format_RGBA8888);
    QCOMPARE(QSize(deep.width, deep.height), plain.size());
    if (depth == "16") {
        const QImage sixteen(path);  // Qt's own reader
        QCOMPARE(sixteen.format(), QImage::Format_RGBA64);
        QVERIFY(sixteen.convertToFormat(QImage::Format_RGBA8888) == plain);
    }
}

void TestExportDialog::backgroundsAreWritten() {
    open(writeCutOut(*m_folder));
    bend(-10, 25);
    const std::pair<const char*, QRgb> kinds[] = {{"transparent", qRgba(0, 0, 0, 0)},
                                                  {"white", qRgb(255, 255, 255)},
                                                  {"black", qRgb(0, 0, 0)},
                                                  {"#d9E4f2", qRgb(0xd9, 0xe4, 0xf2)}};
    for (const auto& [name, colour] : kinds) {
        QVERIFY(written(ExportKind::Picture, file("ground.png"), with("--outside", name)));
        const QImage image = QImage(file("ground.png")).convertToFormat(QImage::Format_ARGB32);
        QCOMPARE(image.pixel(2, 2), colour);
    }
}

/// Two soft discs are close to each other: the outline leaves a gap between them and cuts their edges off.
/// Where nothing has moved, the written pixels are those of the source all the same.
void TestExportDialog::softEdgesAtRestAreTheSourcesOwn() {
    QImage image(164, 90, QImage::Format_ARGB32);
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 164; ++x) {
            const double left = std::hypot(x - 47.5, y - 44.5), right = std::hypot(x - 115.5, y - 44.5);
            const double edge = 33 - std::min(left, right);  // soft over 24 pixels
            image.setPixel(x, y, qRgba(200, 90, 40, std::clamp(int(255 * edge / 24), 0, 255)));
        }
    image.save(file("soft.png"));
    open(file("soft.png"));
    QCOMPARE(session().document().domain().outline, OutlineKind::Alpha);
    QVERIFY(written(ExportKind::Picture, file("rest.png"), {}));
    const QImage rest = QImage(file("rest.png")).convertToFormat(QImage::Format_ARGB32);
    int off = 0;
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 164; ++x) off += qAlpha(rest.pixel(x, y)) != qAlpha(image.pixel(x, y));
    QCOMPARE(off, 0);
}

/// The film lasts as long as the motion.
void TestExportDialog::framesFollowTheirRate() {
    open(writeCutOut(*m_folder));
    bend(-10, 25);
    const auto asked = dialog(ExportKind::Frames);
    OptionField *count = asked->form().field("--count"), *rate = asked->form().field("--fps");
    const double seconds = session().playback().end() * Playback::kSecondsPerUnit;
    QCOMPARE(rate->number(), defaultOf("--fps"));
    QCOMPARE(count->number(), std::lround(24 * seconds) + 1.0);
    count->setNumber(11);
    emit count->changed();
    QCOMPARE(rate->number(), 10 / seconds);
    rate->setNumber(30);
    emit rate->changed();
    QCOMPARE(count->number(), std::lround(30 * seconds) + 1.0);
    if (waitForPreview(*asked)) keepPicture(*asked, "export-frames.png");
}

QTEST_MAIN(TestExportDialog)
#include "test_export_dialog.moc"
