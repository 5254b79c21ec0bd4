#include <QColorDialog>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QToolButton>

#include "app/panels/fields/option_field.h"
#include "app/panels/material_panel.h"
#include "app/project/edits/handle_edits.h"
#include "app/window/export/export_panel.h"
#include "app/window/export/export_preview.h"
#include "app/window/export/exporter.h"
#include "tests/support/dialogs.h"
#include "tests/support/projects.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// The step Export: options, preview and files of its panel, in a window with a picture or a solid.
class TestExportPanel : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void kindsAreThoseOfTheShape_data();
    void kindsAreThoseOfTheShape();
    void nothingIsAskedWithoutAShape();
    void previewFollowsThePose();
    void whatIsPreviewedIsWritten();
    void choicesAreKept();
    void fitIsOneClick();
    void anyColourIsBehindThePicture();
    void framesLastAsLongAsTheMotion();
    void nothingIsWrittenWithoutAShape();
    void solidIsPreviewedAsFilesGetIt();
    void solidIsPreviewedAsItIsTurned();
    void cropIsDrawn();
    void cropIsOfAMeshsPictureToo();
    void cropIsChangedByItsParts();
    void cropIsWrittenAsItIsSeen();
    void panMovesTheView_data();
    void panMovesTheView();
    void allIsInViewOnASmallScreen_data();
    void allIsInViewOnASmallScreen();

  private:
    static void pictureAndSolid();
    bool open(bool solid) { return solid ? m_f->open() : m_f->openPicture(); }
    bool bend(double dx, double dy);
    void toExport() { m_f->window().tools().setMode(Mode::Export); }
    ExportPanel& panel() { return *m_f->window().properties().findChild<ExportPanel*>(); }
    QPushButton* button(const QString& text);
    QToolButton* kind(const QString& name);
    bool isCurrent();
    bool openToCrop();
    void drag(const Vec2& from, const Vec2& to, Qt::KeyboardModifiers modifiers = {});
    QPointF seenAt(const Vec3& p);
    void moveWithLeft(const QPoint& to);
    Crop& crop() { return m_f->window().exporter().crop(); }
    QImage seen() {
        return panel().form().preview().image().convertToFormat(QImage::Format_ARGB32_Premultiplied);
    }
    QString facts() { return panel().findChild<QLabel*>(QStringLiteral("facts"))->text(); }
    QString file(const char* name) const { return m_folder->filePath(QString::fromLatin1(name)); }

    std::unique_ptr<SolidFixture> m_f;
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestExportPanel::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

void TestExportPanel::pictureAndSolid() {
    QTest::addColumn<bool>("solid");
    QTest::newRow("picture") << false;
    QTest::newRow("solid") << true;
}

/// Holds the left end of the picture and drags the right one.
bool TestExportPanel::bend(double dx, double dy) {
    ShapeSession& session = m_f->session();
    if (session.gestures().pins().empty()) {
        session.addPin({40, 80, 0});
        session.addPin({200, 80, 0});
        if (!settle(session)) return false;
    }
    session.gestures().begin();
    session.gestures().moveBy({dx, dy, 0});
    session.gestures().end(0.5);
    return settle(session);
}

/// The last background asks for a colour; cancelling the dialog changes nothing.
void TestExportPanel::anyColourIsBehindThePicture() {
    QVERIFY(m_f->openPicture());
    toExport();
    auto* choice = panel().form().field("--outside")->findChild<QComboBox*>();
    choice->setFocus();
    const auto chosen = [&](const QColor& colour) {
        bool asked = false;
        withNext<QColorDialog>(this, [&](QColorDialog& dialog) {
            asked = true;
            if (!colour.isValid()) return dialog.reject();
            dialog.setCurrentColor(colour);
            dialog.accept();
        });
        QTest::keyClick(choice, Qt::Key_End);
        return asked ? panel().form().values().text("--outside") : std::string("not asked");
    };
    QCOMPARE(chosen({}), std::string("transparent"));
    QCOMPARE(chosen(QColor(0xd9, 0xe4, 0xf2)), std::string("#d9e4f2"));
    QVERIFY(isCurrent());
    QCOMPARE(seen().pixel(1, 1), qRgb(0xd9, 0xe4, 0xf2));
    choice->setCurrentIndex(3);
    QCOMPARE(chosen({}), std::string("white"));
}

QPushButton* TestExportPanel::button(const QString& text) {
    for (auto* one : panel().findChildren<QPushButton*>())
        if (one->text().remove('&') == text) return one;
    return nullptr;
}

QToolButton* TestExportPanel::kind(const QString& name) {
    for (auto* one : panel().findChildren<QToolButton*>())
        if (one->text() == name) return one;
    return nullptr;
}

bool TestExportPanel::isCurrent() {
    return QTest::qWaitFor([&] { return panel().form().preview().isCurrent(); }, 30000);
}

void TestExportPanel::kindsAreThoseOfTheShape_data() {
    pictureAndSolid();
}

void TestExportPanel::kindsAreThoseOfTheShape() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    toExport();
    QTRY_VERIFY(panel().isVisible());
    for (const char* name : {"Picture", "Film", "ST Map"}) QCOMPARE(kind(name)->isVisible(), !solid);
    for (const char* name : {"View…", "Film…"}) QCOMPARE(button(name)->isVisible(), solid);
    QVERIFY(kind("Mesh")->isEnabled());
    QVERIFY(!kind("Sequence")->isEnabled() && kind("Sequence")->toolTip().contains("drag a pin"));
    QVERIFY(kind(solid ? "Mesh" : "Picture")->isChecked());
    QCOMPARE(panel().form().kind(), solid ? ExportKind::Mesh : ExportKind::Picture);
    QTRY_VERIFY(button("Export…")->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(facts().contains(solid ? "vertices" : "240 × 160 pixels"), 20000);
    QVERIFY(isCurrent() && !seen().isNull());
    const auto& preview = *panel().findChild<ExportPreview*>();
    QVERIFY(QRectF(preview.rect()).contains(preview.place()));  // nothing is cut off
    QVERIFY(!m_f->window().materialPanel().isVisible());        // its room is the preview's
}

/// While a shape is being computed, no option can be chosen.
void TestExportPanel::nothingIsAskedWithoutAShape() {
    ExportChoices choices;
    ExportForm form(ExportForm::Fields::Below, choices);
    form.setNothing(QStringLiteral("Not yet."));
    form.show();
    QVERIFY(QTest::qWaitForWindowExposed(&form));
    for (const QComboBox* box : form.findChildren<QComboBox*>()) QVERIFY(!box->isVisible());
    for (const OptionField* field : form.findChildren<OptionField*>()) QVERIFY(!field->isVisible());
    QVERIFY(!form.isReady());
}

/// A pose that changes in this step is previewed without a click, and only the newest one.
void TestExportPanel::previewFollowsThePose() {
    QVERIFY(open(false));
    toExport();
    QVERIFY(isCurrent());
    const QImage rest = seen();
    QVERIFY(bend(-10, 30));
    QTRY_VERIFY_WITH_TIMEOUT(isCurrent() && seen() != rest, 20000);
    const QImage bent = seen();
    QCOMPARE(bent.size(), rest.size());
    // Another moment needs no computing.
    m_f->session().playback().setTime(0);
    QTRY_VERIFY_WITH_TIMEOUT(isCurrent() && seen() == rest, 20000);
    m_f->session().playback().setTime(m_f->session().playback().end());
    QTRY_VERIFY_WITH_TIMEOUT(isCurrent() && seen() == bent, 20000);
    m_f->session().document().undoStack()->undo();
    QVERIFY(settle(m_f->session()));
    QTRY_VERIFY_WITH_TIMEOUT(isCurrent() && seen() == rest, 20000);
    m_f->window().tools().setMode(Mode::Pins);
    m_f->session().document().undoStack()->redo();
    QVERIFY(settle(m_f->session()));
    toExport();
    QTRY_VERIFY_WITH_TIMEOUT(isCurrent() && seen() == bent, 20000);
}

/// The button and the file dialog write a file that, decoded by Qt, has the announced size and, scaled down,
/// the pixels of the preview.
void TestExportPanel::whatIsPreviewedIsWritten() {
    QVERIFY(open(false) && bend(-10, 30));
    toExport();
    QVERIFY(isCurrent());
    QSignalSpy done(&m_f->window().exporter(), &Exporter::done);
    nameNextFile(&m_f->window(), file("bent.png"));
    QTRY_VERIFY(button("Export…")->isEnabled());
    QTest::mouseClick(button("Export…"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(done.count(), 1, 60000);
    const QImage written(file("bent.png"));
    QCOMPARE(written.size(), QSize(240, 160));
    const QImage small = written.convertToFormat(QImage::Format_ARGB32_Premultiplied)
                             .scaled(seen().size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    double off = 0, ink = 0;
    for (int y = 0; y < small.height(); ++y)
        for (int x = 0; x < small.width(); ++x) {
            off += std::abs(qAlpha(small.pixel(x, y)) - qAlpha(seen().pixel(x, y)));
            ink += qAlpha(small.pixel(x, y));
        }
    QVERIFY2(off < 0.03 * ink, qPrintable(QString::number(off / ink)));  // two filters at soft edges
}

void TestExportPanel::choicesAreKept() {
    QVERIFY(open(false) && bend(-10, 30));
    toExport();
    auto* format = panel().findChild<QComboBox*>(QStringLiteral("format"));
    format->setCurrentIndex(format->findData(QStringLiteral(".tif")));
    panel().form().field("--depth")->setValue("16");
    QTest::mouseClick(kind("Mesh"), Qt::LeftButton);
    QCOMPARE(panel().form().kind(), ExportKind::Mesh);
    QVERIFY(!panel().form().field("--depth")->isVisible());
    format->setCurrentIndex(format->findData(QStringLiteral(".ply")));
    QTest::mouseClick(kind("Picture"), Qt::LeftButton);
    QCOMPARE(panel().form().extension(), QStringLiteral(".tif"));
    QCOMPARE(panel().form().values().text("--depth"), std::string("16"));
    QVERIFY(isCurrent());
    const QImage before = seen();
    QVERIFY(bend(0, -20));
    QTRY_VERIFY_WITH_TIMEOUT(isCurrent() && seen() != before, 20000);
    QCOMPARE(panel().form().extension(), QStringLiteral(".tif"));
    QCOMPARE(panel().form().values().text("--depth"), std::string("16"));
    QTest::mouseClick(kind("Mesh"), Qt::LeftButton);
    QCOMPARE(panel().form().extension(), QStringLiteral(".ply"));
}

/// The panel says at once which parts would be cut off, and one click avoids it.
void TestExportPanel::fitIsOneClick() {
    QVERIFY(open(false));
    toExport();
    auto* note = panel().findChild<QWidget*>(QStringLiteral("cropNote"));
    QVERIFY(isCurrent() && !note->isVisible());
    QVERIFY(bend(60, 30));  // beyond the right border at 240
    QTRY_VERIFY(note->isVisible());
    QVERIFY(note->findChild<QLabel*>()->text().contains(QStringLiteral("right")));
    QTest::mouseClick(note->findChild<QPushButton*>(), Qt::LeftButton);
    QVERIFY(!note->isVisible());
    QCOMPARE(panel().form().values().text("--canvas"), std::string("fit"));
    const auto frame = m_f->session().motion().frame<2>();
    const Vec2 low = frame->pose.rowwise().minCoeff().array().floor(),
               high = frame->pose.rowwise().maxCoeff().array().ceil();
    QVERIFY2(
        facts().startsWith(QStringLiteral("%1 × %2 pixels").arg(high.x() - low.x()).arg(high.y() - low.y())),
        qPrintable(facts()));
}

void TestExportPanel::framesLastAsLongAsTheMotion() {
    QVERIFY(open(false) && bend(-10, 30));
    toExport();
    QTRY_VERIFY(kind("Sequence")->isEnabled());
    QTest::mouseClick(kind("Sequence"), Qt::LeftButton);
    const auto seconds = [&] { return m_f->session().playback().end() * Playback::kSecondsPerUnit; };
    const OptionField* count = panel().form().field("--count");
    QCOMPARE(count->number(), std::lround(24 * seconds()) + 1.0);
    const double before = seconds();
    setLength(m_f->session().document(), 3 * m_f->session().document().end());
    QVERIFY(settle(m_f->session()));
    QCOMPARE(seconds(), 3 * before);
    QTRY_COMPARE(count->number(), std::lround(24 * seconds()) + 1.0);
}

/// A project that cannot be computed is reported, and the button is disabled.
void TestExportPanel::nothingIsWrittenWithoutAShape() {
    QVERIFY(open(false));
    toExport();
    QTRY_VERIFY(button("Export…")->isEnabled());
    Document& document = m_f->session().document();
    addPin(document, {5, 5}, "stray");
    QTRY_VERIFY_WITH_TIMEOUT(!button("Export…")->isEnabled(), 20000);
    QTRY_VERIFY(panel().findChild<QLabel*>(QStringLiteral("problem"))->isVisible());
    document.undoStack()->undo();
    QTRY_VERIFY_WITH_TIMEOUT(button("Export…")->isEnabled(), 20000);
    QVERIFY(!panel().findChild<QLabel*>(QStringLiteral("problem"))->isVisible());
}

/// Opens the view at three screen pixels for one of the picture, so that the pointer reaches every pixel.
bool TestExportPanel::openToCrop() {
    if (!open(false)) return false;
    toExport();
    QTest::keyClick(&m_f->window().canvas(), Qt::Key_C);
    m_f->window().canvas().zoomTo(3);
    return m_f->window().tools().isChosen("crop") && isCurrent();
}

void TestExportPanel::drag(const Vec2& from, const Vec2& to, Qt::KeyboardModifiers modifiers) {
    ShapeCanvas& canvas = m_f->window().canvas();
    const auto at = [&](const Vec2& pixel) { return canvas.toWidget(pixel).toPoint(); };
    QTest::mouseMove(&canvas, at(from));
    QTest::mousePress(&canvas, Qt::LeftButton, modifiers, at(from));
    for (const double part : {0.3, 0.7, 1.0}) {
        QMouseEvent move(QEvent::MouseMove, at(from + part * (to - from)),
                         canvas.mapToGlobal(at(from + part * (to - from))), Qt::NoButton, Qt::LeftButton,
                         modifiers);
        QCoreApplication::sendEvent(&canvas, &move);
    }
    QTest::mouseRelease(&canvas, Qt::LeftButton, modifiers, at(to));
}

/// The written mesh has neither map nor cut nor marks of the view.
void TestExportPanel::solidIsPreviewedAsFilesGetIt() {
    QVERIFY(open(true));
    toExport();
    QTRY_VERIFY(panel().isVisible());
    QTRY_VERIFY(!seen().isNull());
    SolidCanvas& canvas = m_f->canvas();
    const QImage plain = seen(), view = canvas.picture({300, 200}, true);
    int opaque = 0;
    for (int y = 0; y < plain.height(); ++y)
        for (int x = 0; x < plain.width(); ++x) opaque += qAlpha(plain.pixel(x, y)) == 255;
    QVERIFY2(opaque > 5000, qPrintable(QString::number(opaque)));
    m_f->window().actions().showMap->trigger();
    m_f->window().actions().showMarks->trigger();
    m_f->actions().cut->trigger();
    QTRY_VERIFY(canvas.solid().cut() != CutKind::None && canvas.isSettled());
    QVERIFY(canvas.picture({300, 200}, true) != view);
    kind(QStringLiteral("Mesh"))->click();
    QCOMPARE(seen(), plain);
}

/// The mouse rotates the view as anywhere: the preview shows the view as it is rotated now.
void TestExportPanel::solidIsPreviewedAsItIsTurned() {
    QVERIFY(open(true));
    toExport();
    QTRY_VERIFY(panel().isVisible() && !seen().isNull());
    const QImage before = seen();
    SolidCanvas& canvas = m_f->canvas();
    const QPoint corner(30, 30);
    QTest::mousePress(&canvas, Qt::MiddleButton, {}, corner);
    for (int i = 1; i <= 8; ++i) {
        const QPointF to = corner + QPointF(20 * i, 6 * i);
        QMouseEvent move(QEvent::MouseMove, to, canvas.mapToGlobal(to), Qt::NoButton, Qt::MiddleButton, {});
        QCoreApplication::sendEvent(&canvas, &move);
    }
    QTest::mouseRelease(&canvas, Qt::MiddleButton, {}, corner + QPoint(160, 48));
    QTRY_VERIFY(seen() != before);
}

void TestExportPanel::cropIsDrawn() {
    QVERIFY(openToCrop());
    QVERIFY(!crop().now());
    drag({60, 50}, {180, 110});
    QCOMPARE(crop().now(), std::optional(PixelRect{60, 50, 120, 60}));
    QTRY_COMPARE(panel().form().values().text("--canvas"), std::string("60,50,120,60"));
    QTRY_VERIFY_WITH_TIMEOUT(isCurrent() && seen().size() == QSize(120, 60), 20000);
    QTRY_VERIFY(facts().startsWith(QStringLiteral("120 × 60 pixels")));
    QVERIFY(!panel().findChild<QWidget*>(QStringLiteral("cropNote"))->isVisible());
    // Another canvas can still be chosen, until another rectangle is drawn.
    panel().form().field("--canvas")->setValue("picture");
    QCOMPARE(panel().form().values().text("--canvas"), std::string("picture"));
    QVERIFY(isCurrent());
    const QImage before = seen();
    QVERIFY(bend(-10, 20));
    QTRY_VERIFY_WITH_TIMEOUT(isCurrent() && seen() != before, 20000);
    QCOMPARE(panel().form().values().text("--canvas"), std::string("picture"));
    drag({180, 110}, {170, 100});
    QTRY_COMPARE(panel().form().values().text("--canvas"), std::string("60,50,110,50"));
    QTest::mouseDClick(&m_f->window().canvas(), Qt::LeftButton, {},
                       m_f->window().canvas().toWidget({100, 80}).toPoint());
    QVERIFY(!crop().now());
    QTRY_COMPARE(panel().form().values().text("--canvas"), std::string("picture"));
    QCOMPARE(panel().form().field("--canvas")->choices(), QStringList({"picture", "fit"}));
}

/// The crop is in pixels of the picture, whatever the coordinates of its mesh: here ten to one, and upwards.
void TestExportPanel::cropIsOfAMeshsPictureToo() {
    writeCutOut(*m_folder);
    const auto put = [&](const char* name, const QByteArray& text) {
        QFile out(file(name));
        return out.open(QIODevice::WriteOnly) && out.write(text) == text.size();
    };
    QVERIFY(put("quad.obj",
                "v 0 0 0\nv 24 0 0\nv 24 16 0\nv 0 16 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"));
    QVERIFY(put("quad.wend",
                R"({"format": "wend", "version": 1, "domain": {"mesh": "quad.obj", "image": "bar.png"}})"));
    m_f->window().openPath(file("quad.wend"));
    QVERIFY(QTest::qWaitFor([&] { return !m_f->session().document().isEmpty(); }, 20000));
    QVERIFY(settle(m_f->session()));
    toExport();
    QTest::keyClick(&m_f->window().canvas(), Qt::Key_C);
    QVERIFY(isCurrent());
    m_f->window().canvas().zoomTo(30);
    drag({6, 11}, {18, 5});
    QCOMPARE(crop().now(), std::optional(PixelRect{60, 50, 120, 60}));
}

void TestExportPanel::cropIsChangedByItsParts() {
    QVERIFY(openToCrop());
    drag({60, 50}, {180, 110});
    const auto is = [&](const PixelRect& part) { return crop().now() == part; };
    drag({120, 80}, {110, 85});  // by its inside
    QVERIFY(is({50, 55, 120, 60}));
    drag({50, 80}, {40, 100});  // a side follows in its own direction only
    QVERIFY(is({40, 55, 130, 60}));
    drag({100, 115}, {90, 130});
    QVERIFY(is({40, 55, 130, 75}));
    drag({170, 55}, {150, 40});  // a corner in both
    QVERIFY(is({40, 40, 110, 90}));
    drag({40, 40}, {160, 140});  // beyond the opposite corner
    QVERIFY(is({150, 130, 10, 10}));
    drag({20, 20}, {110, 30}, Qt::ShiftModifier);  // of 240 × 160
    QVERIFY(is({20, 20, 90, 60}));
    ShapeCanvas& canvas = m_f->window().canvas();
    QTest::keyClick(&canvas, Qt::Key_Right);
    QTest::keyClick(&canvas, Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(is({21, 10, 90, 60}));
    QTest::mousePress(&canvas, Qt::LeftButton, {}, canvas.toWidget({60, 40}).toPoint());
    QTest::mouseMove(&canvas, canvas.toWidget({90, 70}).toPoint());
    QVERIFY(!is({21, 10, 90, 60}));
    QTest::keyClick(&canvas, Qt::Key_Escape);
    QVERIFY(is({21, 10, 90, 60}));
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, canvas.toWidget({90, 70}).toPoint());
    QVERIFY(is({21, 10, 90, 60}));
    QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.toWidget({200, 140}).toPoint());
    QVERIFY(is({21, 10, 90, 60}));  // a click is no rectangle
    QTest::keyClick(&canvas, Qt::Key_Delete);
    QVERIFY(!crop().now());
    QCOMPARE(m_f->session().document().undoStack()->index(), 1);  // only the test's own change
    drag({60, 50}, {180, 110});
    m_f->session().document().undoStack()->setClean();
    m_f->window().actions().closeFile->trigger();
    QVERIFY(m_f->openPicture());
    QVERIFY(!crop().now());  // it was of another document
}

/// The crop has the same pixels as the whole picture.
void TestExportPanel::cropIsWrittenAsItIsSeen() {
    QVERIFY(openToCrop() && bend(-10, 20));
    drag({90, 30}, {230, 130});
    QTRY_COMPARE(panel().form().values().text("--canvas"), std::string("90,30,140,100"));
    QTRY_VERIFY(button("Export…")->isEnabled());
    QSignalSpy done(&m_f->window().exporter(), &Exporter::done);
    nameNextFile(&m_f->window(), file("part.png"));
    QTest::mouseClick(button("Export…"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(done.count(), 1, 60000);
    m_f->window().exporter().write(ExportKind::Picture, file("whole.png"));
    QTRY_COMPARE_WITH_TIMEOUT(done.count(), 2, 60000);
    const QImage whole(file("whole.png")), part(file("part.png"));
    QCOMPARE(part.size(), QSize(140, 100));
    QVERIFY(part == whole.copy(90, 30, 140, 100));
    QVERIFY(part != whole.copy(90, 31, 140, 100));
}

/// Returns the place of a point of the shape in the view.
QPointF TestExportPanel::seenAt(const Vec3& p) {
    const bool solid = m_f->session().document().dimension() == 3;
    return solid ? m_f->canvas().toWidget(p) : m_f->window().canvas().toWidget(p.head<2>());
}

void TestExportPanel::moveWithLeft(const QPoint& to) {
    QMouseEvent move(QEvent::MouseMove, to, m_f->view().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&m_f->view(), &move);
}

void TestExportPanel::panMovesTheView_data() {
    pictureAndSolid();
}

/// The second press of a double click pans as well, as far as with the space bar. The shape stays as it is.
void TestExportPanel::panMovesTheView() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    toExport();
    QWidget& view = m_f->view();
    QTest::keyClick(&view, Qt::Key_Q);
    QVERIFY(m_f->window().tools().isChosen("pan"));
    QCOMPARE(view.cursor().shape(), Qt::OpenHandCursor);
    const int steps = m_f->session().document().undoStack()->index();
    const Vec3 middle = solid ? Vec3(0, 0, 0) : Vec3(120, 80, 0);
    const QPoint from = seenAt(middle).toPoint(), by(60, -35);
    for (const bool space : {false, false, true}) {
        if (space) m_f->window().tools().setMode(Mode::Pins), QTest::keyPress(&view, Qt::Key_Space);
        const QPointF before = seenAt(middle);
        QTest::mousePress(&view, Qt::LeftButton, {}, from);
        QCOMPARE(view.cursor().shape(), Qt::ClosedHandCursor);
        moveWithLeft(from + by);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, from + by);
        QCOMPARE(view.cursor().shape(), Qt::OpenHandCursor);
        const QPointF moved = seenAt(middle) - before;
        QVERIFY2(QLineF(moved, by).length() < 0.5,
                 qPrintable(QStringLiteral("%1 %2").arg(moved.x()).arg(moved.y())));
    }
    QTest::keyRelease(&view, Qt::Key_Space);
    QCOMPARE(m_f->session().document().undoStack()->index(), steps);
    QCOMPARE(m_f->session().pins().count(), 0);
}

void TestExportPanel::allIsInViewOnASmallScreen_data() {
    pictureAndSolid();
}

/// Warnings are in view as well.
void TestExportPanel::allIsInViewOnASmallScreen() {
    QFETCH(bool, solid);
    m_f->window().resize(1366, 768);
    QVERIFY(open(solid));
    if (!solid) QVERIFY(bend(60, 30));
    toExport();
    if (!solid) QTRY_VERIFY(panel().findChild<QWidget*>(QStringLiteral("cropNote"))->isVisible());
    settleLayout(panel());
    auto* scroll = m_f->window().findChild<QScrollArea*>(QStringLiteral("sideScroll"));
    const QRect room = scroll->viewport()->rect();
    for (QWidget* one : {static_cast<QWidget*>(button("Export…")),
                         static_cast<QWidget*>(panel().findChild<ExportPreview*>())}) {
        const QRect place(one->mapTo(scroll->viewport(), QPoint()), one->size());
        QVERIFY2(room.contains(place),
                 qPrintable(QStringLiteral("%1 of %2").arg(place.bottom()).arg(room.bottom())));
    }
    QVERIFY(!scroll->verticalScrollBar()->isVisible());
}

QTEST_MAIN(TestExportPanel)
#include "test_export_panel.moc"
