#include <QComboBox>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QSlider>
#include <QStatusTipEvent>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <cmath>
#include <numbers>

#include "app/panels/distortion_panel.h"
#include "app/panels/fields/energy_slider.h"
#include "app/panels/handle_panel.h"
#include "app/panels/material_panel.h"
#include "app/panels/paint_panel.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/setting_edits.h"
#include "app/session/opening.h"
#include "app/style/colours.h"
#include "app/views/canvas/canvas.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/pin_actions.h"
#include "app/window/actions/toolbox.h"
#include "app/window/export/export_panel.h"
#include "app/window/files/file_workflow.h"
#include "app/window/main_window.h"
#include "app/window/notices/info_banner.h"
#include "app/window/notices/offers.h"
#include "app/window/properties.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/support/dialogs.h"
#include "tests/support/window_test.h"
#include "warp/warp.h"

using namespace wend;
using namespace wend::test;

/// The whole window, with real mouse and key events.
class TestWindow : public WindowTest {
    Q_OBJECT
  private slots:
    void init() { begin(); }
    void cleanup() { end(); }
    void startsWithAStartPage();
    void everyActionSaysWhatItDoes();
    void dropOpens();
    void dropsOfOtherThingsAreRefused();
    void energySliderIsOneStep();
    void stopLabelsChooseTheNamedEnergies();
    void stopLabelsStayApart_data();
    void stopLabelsStayApart();
    void brushAndWholeShapeReadDifferently();
    void noticesOutlastTheHintOfTheirButton();
    void moreToolsAreToBeSeen();
    void saveAndLoadGiveTheSameShape();
    void closingAsks();
    void bordersOfPhotographsAreOffered();
    void springingBackIsOffered();
    void dragsPoseAtTheShownTime();
    void lineArtIsFilled();
    void softEdgesAreTakenAlong();
    void openingIsReportedUntilThePictureIsSeen();
    void lightAndDarkHaveOneLayout();
    void ringOfAPointIsSeenOnDark();
    void unreadableFilesLeaveALine();
    void holdingHHidesPins();
    void playRuns();
    void exportedPictureIsWhatIsShown();
    void fitsASmallScreen();
    void viewIsZoomed();
    void numbersBelowThePicture();
    void recentFilesAreTheLastOnesFirst();
    void worstPlaceFollowsTheMap();
    void samplesAreExportedElsewhere();
    void exportedMeshIsThatOfTheWindow();
    void exportsFollowEachOther();
    void outdatedPosesAreNotExported();

  private:
    /// Drags and waits for the shape.
    void lead(double x, double y, double dx, double dy) {
        dragPin(x, y, dx, dy);
        QTest::mouseRelease(&m_window->canvas(), Qt::LeftButton, {}, at(x + dx, y + dy));
        QVERIFY(settle(m_window->session()));
    }
    /// Accepts the name that the next dialog proposes, in that file's folder.
    void exportNextTo(const QString& path) {
        withNext<ExportDialog>(m_window.get(), [](ExportDialog& dialog) { dialog.accept(); });
        nameNextFile(m_window.get(), path);
    }
};

void TestWindow::startsWithAStartPage() {
    auto* button = m_window->findChild<QPushButton*>(QStringLiteral("startOpen"));
    QVERIFY(button && button->isVisible());
    QVERIFY(!m_window->canvas().isVisible());
    QVERIFY(!m_window->actions().save->isEnabled());
    QVERIFY(m_window->actions().save->toolTip().contains(QStringLiteral("first")));
    const QString path = writeCutOut(*m_folder);
    nameNextFile(m_window.get(), path);
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return m_window->canvas().isVisible(); }, 20000));
    QVERIFY(settle(m_window->session()));
    QVERIFY(m_window->windowTitle().startsWith(QStringLiteral("bar.png")));
    QVERIFY(!m_window->isWindowModified());
}

void TestWindow::everyActionSaysWhatItDoes() {
    int seen = 0;
    for (const QAction* action : m_window->actions().findChildren<QAction*>()) {
        if (action->menu() || action->isSeparator()) continue;
        ++seen;
        QVERIFY2(!action->statusTip().isEmpty(), qPrintable(action->text()));
        QVERIFY2(!action->toolTip().isEmpty(), qPrintable(action->text()));
    }
    QVERIFY(seen > 25);
    for (const QToolButton* button : m_window->findChildren<QToolButton*>())
        QVERIFY2(!button->toolTip().isEmpty() || button->parent()->inherits("QAbstractSpinBox") ||
                     !button->defaultAction() || !button->isVisible(),
                 qPrintable(button->text()));
}

/// Supported files are known by their names, or pictures by their first bytes.
void TestWindow::dropsOfOtherThingsAreRefused() {
    const auto accepted = [this](const QString& path) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter({400, 300}, Qt::CopyAction, &data, Qt::LeftButton, {});
        enter.ignore();
        QCoreApplication::sendEvent(m_window.get(), &enter);
        return enter.isAccepted();
    };
    const auto written = [this](const char* name, const QByteArray& text) {
        QFile file(m_folder->filePath(QLatin1String(name)));
        if (file.open(QIODevice::WriteOnly)) file.write(text);
        return file.fileName();
    };
    const QString picture = writeCutOut(*m_folder), bare = m_folder->filePath("bare");
    QVERIFY(accepted(picture));
    QVERIFY(m_window->statusBar()->currentMessage().contains("bar.png"));
    QVERIFY(QFile::copy(picture, bare));
    QVERIFY(accepted(bare));
    QVERIFY(accepted(written("shape.obj", "")));  // opening it says what is wrong
    QVERIFY(!accepted(written("letter.odt", "PK")));
    QVERIFY(!accepted(m_folder->path()));
    QVERIFY(!accepted(m_folder->filePath("missing.png")));
}

void TestWindow::dropOpens() {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(writeCutOut(*m_folder))});
    QDragEnterEvent enter({400, 300}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(m_window.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({400, 300}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(m_window.get(), &drop);
    QVERIFY(QTest::qWaitFor([&] { return m_window->canvas().isVisible(); }, 20000));
    QVERIFY(settle(m_window->session()));
}

void TestWindow::energySliderIsOneStep() {
    open();
    QUndoStack& undo = *m_window->session().document().undoStack();
    const int steps = undo.count();
    QSlider* slider = m_window->materialPanel().energySlider()->slider();
    slider->setSliderDown(true);
    for (int value = 1200; value <= 2600; value += 100) slider->setSliderPosition(value);
    slider->setSliderDown(false);
    QCOMPARE(undo.count(), steps + 1);
    const double phi = m_window->session().document().design().material.phi;
    QVERIFY(phi > phi::kAkvf && phi < phi::conformal(2));
    undo.undo();
    QCOMPARE(m_window->session().document().design().material.phi, phi::kMetr);
    QCOMPARE(slider->value(), 1000);
    slider->setSliderDown(true);
    slider->setSliderPosition(2020);  // near a stop
    slider->setSliderDown(false);
    QCOMPARE(m_window->session().document().design().material.phi, phi::kAkvf);
}

void TestWindow::stopLabelsChooseTheNamedEnergies() {
    open();
    const EnergyScale scale;
    int found = 0;
    for (QToolButton* label : m_window->materialPanel().energySlider()->findChildren<QToolButton*>()) {
        for (const auto& stop : scale.stops()) {
            if (label->text() != stop.name) continue;
            ++found;
            QTest::mouseClick(label, Qt::LeftButton);
            QCOMPARE(m_window->session().document().design().material.phi, stop.phi);
            QVERIFY(label->isChecked());
        }
    }
    QCOMPARE(found, 4);
    for (double x = 0; x <= 3; x += 0.125) QVERIFY(std::abs(scale.positionOf(scale.phiAt(x)) - x) < 1e-12);
}

void TestWindow::stopLabelsStayApart_data() {
    QTest::addColumn<QStringList>("names");  // none: those that it has
    QTest::newRow("English") << QStringList();
    QTest::newRow("German") << QStringList{"Volumen", QStringLiteral("Länge"), "Starr", "Winkel"};
}
void TestWindow::stopLabelsStayApart() {
    QFETCH(QStringList, names);
    EnergySlider& slider = *m_window->materialPanel().energySlider();
    slider.setDimension(3);
    QList<QToolButton*> labels = slider.findChildren<QToolButton*>();
    QCOMPARE(labels.size(), 4);
    for (int i = 0; i < names.size(); ++i) labels[i]->setText(names[i]);
    constexpr int kWidthInTheWindow = 249;
    slider.resize(300, slider.height());
    slider.resize(kWidthInTheWindow, slider.height());
    QResizeEvent resized(slider.size(), slider.size());
    QCoreApplication::sendEvent(&slider, &resized);  // hidden widgets hear of it later
    QVERIFY(labels.front()->x() >= 0 && labels.back()->geometry().right() < kWidthInTheWindow);
    for (int i = 0; i < 4; ++i) {
        QVERIFY(labels[i]->width() >= labels[i]->fontMetrics().horizontalAdvance(labels[i]->text()) + 4);
        if (i > 0) QVERIFY(labels[i]->x() > labels[i - 1]->geometry().right() + 2);
    }
}

/// In the step Paint both have the four stops: the titles say whose they are, and the brush's have its
/// colours.
void TestWindow::brushAndWholeShapeReadDifferently() {
    m_window->openPath(writeCutOut(*m_folder));
    QVERIFY(QTest::qWaitFor([&] { return !m_window->session().document().isEmpty(); }, 20000));
    QVERIFY(settle(m_window->session()));
    const auto titles = [this] {
        QStringList all;
        for (const auto* label : m_window->properties().findChildren<QLabel*>())
            if (label->isVisible() && label->property("role") == "title") all << label->text();
        return all;
    };
    QVERIFY(titles().contains("Keep") && !titles().contains("The brush paints"));
    m_window->tools().setMode(Mode::Paint);
    QVERIFY(!titles().contains("Keep"));
    QVERIFY(titles().contains("Keep: whole shape") && titles().contains("The brush paints"));
    auto* brush = m_window->properties().findChild<PaintPanel*>()->findChild<EnergySlider*>();
    QVERIFY(brush->slider()->accessibleName().contains("brush"));
    brush->setPhi(brush->scale().phiAt(1.5));  // the handle stands beside all of them
    QTRY_VERIFY(brush->height() >= brush->sizeHint().height());
    const QImage seen = brush->grab().toImage();
    const auto isNear = [](QColor a, QColor b) {
        return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) <
               24;
    };
    const auto labels = brush->findChildren<QToolButton*>();
    QCOMPARE(labels.size(), 4);
    const QSlider* slider = brush->slider();
    for (int stop = 0; stop < 4; ++stop) {
        const QColor colour(energyColour(stop));
        QVERIFY(isNear(labels[stop]->icon().pixmap(26, 8).toImage().pixelColor(13, 4), colour));
        const int x = slider->x() + 8 + (slider->width() - 16) * stop / 3;
        QVERIFY2(isNear(seen.pixelColor(x, slider->geometry().center().y()), colour),
                 qPrintable(QStringLiteral("%1 at %2: %3")
                                .arg(stop)
                                .arg(x)
                                .arg(seen.pixelColor(x, slider->geometry().center().y()).name())));
    }
    QVERIFY(m_window->materialPanel().energySlider()->slider()->accessibleName() != slider->accessibleName());
    m_window->tools().setMode(Mode::Pins);
    QVERIFY(titles().contains("Keep"));
}

void TestWindow::noticesOutlastTheHintOfTheirButton() {
    open();
    const auto hint = [this](const QString& text) {
        QStatusTipEvent tip(text);
        QCoreApplication::sendEvent(m_window.get(), &tip);
        return m_window->statusBar()->currentMessage();
    };
    QCOMPARE(hint("Write"), QString("Write"));
    hint({});
    m_window->session().document().notify("Written");
    QCOMPARE(hint("Write"), QString("Written"));  // the pointer is on the button still
    QCOMPARE(hint("Open"), QString("Open"));
    QCOMPARE(hint("Write"), QString("Write"));
    QCOMPARE(hint({}), QString("Written"));
    // The notice disappears with its subject.
    changeSetting(m_window->session().document(), "domain.vertices", 400);
    m_window->session().document().notify("Replaced; Undo brings it back");
    m_window->session().document().undoStack()->undo();
    QCOMPARE(m_window->statusBar()->currentMessage(), QString());
}

/// A low window leaves tools out: the button for them has an arrow of more than a few pixels.
void TestWindow::moreToolsAreToBeSeen() {
    open();
    auto* bar = m_window->findChild<QToolBar*>(QStringLiteral("toolBar"));
    auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
    QVERIFY(more);
    for (int i = 0; i < 12; ++i) bar->addAction(m_window->actions().open->icon(), QStringLiteral("Tool"));
    m_window->resize(m_window->minimumSizeHint());
    QVERIFY(QTest::qWaitFor([&] { return more->isVisible(); }, 20000));
    const QImage drawn = more->grab().toImage();
    int arrow = 0;
    for (int y = 0; y < drawn.height(); ++y)
        for (int x = 0; x < drawn.width(); ++x) arrow += drawn.pixelColor(x, y).alpha() > 128;
    QVERIFY2(arrow > 20 && arrow < 100, qPrintable(QString::number(arrow)));
}

void TestWindow::saveAndLoadGiveTheSameShape() {
    open();
    click(40, 80);
    click(200, 80);
    QVERIFY(settle(m_window->session()));
    dragPin(200, 80, -5, 20);
    QTest::mouseRelease(&m_window->canvas(), Qt::LeftButton, {}, at(195, 100));
    QVERIFY(settle(m_window->session()));
    const Points2 shape = m_window->session().motion().frame<2>()->pose;
    const QString path = m_folder->filePath(QStringLiteral("bar.wend"));
    m_window->session().document().save(path);
    QVERIFY(!m_window->isWindowModified());
    MainWindow other;
    other.openPath(path);
    QVERIFY(QTest::qWaitFor([&] { return !other.session().document().isEmpty(); }, 20000));
    QVERIFY(settle(other.session()));
    other.session().playback().setTime(other.session().playback().end());
    QVERIFY(settle(other.session()));
    QVERIFY(other.session().motion().frame<2>()->pose == shape);
    QVERIFY(m_window->files().recent().isEmpty() || m_window->files().recent().first() == path);
}

void TestWindow::closingAsks() {
    open();
    click(40, 80);
    QVERIFY(m_window->isWindowModified());
    bool asked = false;
    withNext<QMessageBox>(m_window.get(), [&asked](QMessageBox& box) {
        asked = true;
        box.button(QMessageBox::Cancel)->click();
    });
    QVERIFY(!m_window->close());
    QVERIFY(asked);
    withNext<QMessageBox>(m_window.get(),
                          [](QMessageBox& box) { box.button(QMessageBox::Discard)->click(); });
    QVERIFY(m_window->close());
}

/// One click makes the shape spring back if it would not although a pin has returned or the film loops.
void TestWindow::springingBackIsOffered() {
    open();
    QVERIFY(bend());
    ShapeSession& session = m_window->session();
    Document& document = session.document();
    InfoBanner& banner = m_window->banner();
    constexpr double kFully = std::numeric_limits<double>::infinity();
    QCOMPARE(settingOf(document, "material.memory"), kFully);
    m_window->actions().loop->trigger();
    QVERIFY(!banner.isVisible());  // it springs back
    m_window->actions().loop->trigger();
    changeSetting(document, "material.memory", 0);
    QVERIFY(settle(session) && !banner.isVisible());
    QVERIFY(!comesBack(document.design().handles.back()));
    lead(200, 100, 0, -20);
    QVERIFY(comesBack(document.design().handles.back()));
    QVERIFY(banner.isVisible() && banner.property("offers").toBool());
    QTest::mouseClick(banner.findChild<QPushButton*>(), Qt::LeftButton);
    QVERIFY(settle(session) && !banner.isVisible());
    QCOMPARE(settingOf(document, "material.memory"), kFully);
    const auto frame = session.motion().frame<2>();
    QVERIFY((frame->pose - frame->rest->points).colwise().norm().maxCoeff() < 1e-6);
    document.undoStack()->undo();
    QVERIFY(!banner.isVisible());  // it is offered once
}

/// In the step Animate a drag at a time sets the pose there; the ends and the shown time stay.
void TestWindow::dragsPoseAtTheShownTime() {
    open();
    QVERIFY(bend());
    ShapeSession& session = m_window->session();
    const auto motions = [&]() -> const auto& {
        return session.document().design().handles.back().motions;
    };
    const double end = session.playback().end();
    const Points2 last = session.motion().frame<2>()->pose;
    m_window->tools().setMode(Mode::Animate);
    session.playback().setTime(0.5 * end);
    QVERIFY(settle(session));
    lead(200, 90, 15, 0);
    QCOMPARE(session.playback().time(), 0.5 * end);
    QCOMPARE(session.playback().end(), end);
    QCOMPARE(motions().size(), 2U);
    QCOMPARE(motions()[0].end, 0.5 * end);
    session.playback().setTime(end);
    QVERIFY(settle(session));
    QVERIFY((session.motion().frame<2>()->pose - last).colwise().norm().maxCoeff() < 1e-3);
    lead(200, 100, 0, -20);  // at the end the film becomes longer
    QCOMPARE(session.playback().end(), end + 1);
    QCOMPARE(session.playback().time(), end + 1);
    QCOMPARE(motions().size(), 3U);
    QCOMPARE(motions()[1].end, end);
    const int steps = session.document().undoStack()->index();
    for (int i = 0; i < 3; ++i) QTest::keyClick(&m_window->canvas(), Qt::Key_Up);  // moves the last pose
    QCOMPARE(session.document().undoStack()->index(), steps + 1);
    QCOMPARE(motions().size(), 3U);
    QCOMPARE(session.playback().end(), end + 1);
    m_window->actions().poseHere->trigger();
    session.playback().setTime(0.25 * end);
    QVERIFY(settle(session));
    lead(207.5, 85, -5, 0);  // on to the end of the film, as ever
    QCOMPARE(motions().size(), 2U);
    QCOMPARE(motions()[1].end, end + 1);
}

/// A click holds the border of a photograph, in one step; a cut-out gets no such offer. The offer disappears
/// when it is accepted or declined, and does not return with a project.
void TestWindow::bordersOfPhotographsAreOffered() {
    const QString path = m_folder->filePath(QStringLiteral("photograph.png"));
    QImage photograph(120, 80, QImage::Format_RGB888);
    photograph.fill(QColor(40, 90, 60));
    QVERIFY(photograph.save(path));
    InfoBanner& banner = m_window->banner();
    const Document& document = m_window->session().document();
    const auto opened = [&](const QString& file) {
        const int before = document.generation();
        m_window->openPath(file);
        return QTest::qWaitFor([&] { return document.generation() > before; }, 20000) &&
               settle(m_window->session());
    };
    QVERIFY(opened(path));
    QVERIFY(banner.isVisible() && banner.property("offers").toBool());
    const auto* sign = banner.findChild<QLabel*>(QStringLiteral("bannerSign"));
    QVERIFY(sign->text().isEmpty() && !sign->pixmap().isNull());  // a letter would need a font that has it
    auto* hold = banner.findChild<QPushButton*>();
    QCOMPARE(hold->text(), QStringLiteral("Hold the Border"));
    QTest::mouseClick(hold, Qt::LeftButton);
    QVERIFY(document.domain().border == Border::Fixed && !banner.isVisible());
    m_window->session().document().undoStack()->undo();
    QVERIFY(document.domain().border == Border::Free && !banner.isVisible());
    const QString project = m_folder->filePath(QStringLiteral("photograph.wend"));
    m_window->session().document().save(project);
    QVERIFY(opened(project) && !banner.isVisible());
    QVERIFY(opened(path) && banner.isVisible());
    QTest::mouseClick(banner.findChild<QToolButton*>(), Qt::LeftButton);
    QVERIFY(!banner.isVisible());
    QVERIFY(opened(path) && banner.isVisible());
    Domain other = document.domain();
    other.border = Border::Slide;
    m_window->session().document().changeDomain(QStringLiteral("Slide"), other);
    QVERIFY(!banner.isVisible());
    m_window->session().document().undoStack()->setClean();
    QVERIFY(opened(writeCutOut(*m_folder)) && !banner.isVisible());
}

/// Colours change with the appearance; nothing moves.
void TestWindow::lightAndDarkHaveOneLayout() {
    open();
    const auto places = [this] {
        QCoreApplication::sendPostedEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        QList<QRect> all;
        for (const QToolBar* bar : m_window->findChildren<QToolBar*>())
            for (const QWidget* one : bar->findChildren<QWidget*>())
                if (one->isVisible()) all << QRect(one->mapTo(m_window.get(), QPoint()), one->size());
        return all;
    };
    const QList<QRect> before = places();
    QVERIFY(before.size() > 10);
    for (QAction* look : {m_window->actions().darkLook, m_window->actions().lightLook}) {
        look->trigger();
        QCOMPARE(places(), before);
    }
}

/// There is a light dot under each of its dots.
void TestWindow::ringOfAPointIsSeenOnDark() {
    open();
    ShapeCanvas& canvas = m_window->canvas();
    const auto frame = m_window->session().motion().frame<2>();
    const Vec2 edge(120, frame->pose.row(1).minCoeff() + 4);
    click(edge.x(), edge.y());
    QVERIFY(settle(m_window->session()));
    canvas.viewport().set(&Looks::backdrop, QColor(Qt::black));
    QVERIFY(QTest::qWaitFor([&] { return canvas.isSettled(); }, 20000));
    const QImage seen = canvas.grab().toImage();
    const QPointF pin = canvas.toWidget(edge);
    const QPointF knob = pin + 44 * std::numbers::sqrt2 / 2 * QPointF(1, -1);  // has a light rim of its own
    int light = 0;
    for (int y = 0; y < seen.height(); ++y)
        for (int x = 0; x < seen.width(); ++x) {
            const bool isRing = std::abs(std::hypot(x - pin.x(), y - pin.y()) - 44) < 3 &&
                                std::hypot(x - knob.x(), y - knob.y()) > 10;
            light += isRing && !canvas.touch({double(x), double(y)}) && qGray(seen.pixel(x, y)) > 140;
        }
    QVERIFY2(light > 20, qPrintable(QString::number(light)));
}

/// A large picture takes a while from its file to the screen: the note stays until then.
void TestWindow::openingIsReportedUntilThePictureIsSeen() {
    const QString path = m_folder->filePath(QStringLiteral("large.png"));
    QImage large(2000, 1500, QImage::Format_RGB888);
    large.fill(QColor(40, 90, 60));
    QVERIFY(large.save(path));
    const auto* note = m_window->findChild<QLabel*>(QStringLiteral("busyNote"));
    const ShapeCanvas& canvas = m_window->canvas();
    bool isBlank = false;
    const auto look = [&] { isBlank |= canvas.shape().isPreparing() && !note->text().contains("large.png"); };
    connect(&m_window->session().document(), &Document::opened, this, look);
    m_window->openPath(path);
    QVERIFY(QTest::qWaitFor([&] { return look(), canvas.shape().screenPicture() != nullptr; }, 20000));
    QVERIFY(!isBlank);
    QTRY_COMPARE(note->text(), QString());
}

/// A ring drawn as a line is filled by one click, which is one step.
void TestWindow::lineArtIsFilled() {
    const auto ring = [this](const QString& name, double width) {
        QImage image(200, 200, QImage::Format_ARGB32);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(Qt::black, width));
        painter.drawEllipse(QPointF(100, 100), 70, 70);
        painter.end();
        const QString path = m_folder->filePath(name);
        return image.save(path) ? path : QString();
    };
    const QString line = ring(QStringLiteral("line.png"), 4), thick = ring(QStringLiteral("thick.png"), 60);
    QVERIFY(isLineArt(readImage(line.toStdString()), {}));
    QVERIFY(!isLineArt(readImage(thick.toStdString()), {}));
    const Document& document = m_window->session().document();
    InfoBanner& banner = m_window->banner();
    m_window->openPath(line);
    QVERIFY(QTest::qWaitFor([&] { return banner.isVisible(); }, 20000));
    auto* fill = banner.findChild<QPushButton*>();
    QCOMPARE(fill->text(), QStringLiteral("Fill the Holes"));
    QTest::mouseClick(fill, Qt::LeftButton);
    QVERIFY(settle(m_window->session()) && !banner.isVisible());
    const auto frame = m_window->session().motion().frame<2>();
    double area = 0;
    for (const Cell<2>& cell : frame->rest->cells)
        area += std::abs(cellMeasure<2>(frame->rest->points, cell));
    QVERIFY(area > 3.14 * 70 * 70);
    m_window->session().document().undoStack()->undo();
    QCOMPARE(document.domain().alpha.holes, OutlineHoles::Kept);
}

/// A click includes a glow that the cut-out leaves out, in one step; a narrow soft edge is included anyway.
void TestWindow::softEdgesAreTakenAlong() {
    const auto disc = [this](const QString& name, double edge) {
        QImage image(200, 200, QImage::Format_ARGB32);
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const double beyond = (std::hypot(x - 99.5, y - 99.5) - 40) / edge;
                image.setPixelColor(x, y,
                                    QColor(200, 60, 40, qRound(255 * std::exp(-std::max(0.0, beyond)))));
            }
        const QString path = m_folder->filePath(name);
        return image.save(path) ? path : QString();
    };
    const QString sharp = disc(QStringLiteral("sharp.png"), 0.4), glow = disc(QStringLiteral("glow.png"), 12);
    QVERIFY(!cutsSoftEdges(readImage(sharp.toStdString()), {}));
    QVERIFY(cutsSoftEdges(readImage(glow.toStdString()), {}));
    const Document& document = m_window->session().document();
    InfoBanner& banner = m_window->banner();
    m_window->openPath(glow);
    QVERIFY(QTest::qWaitFor([&] { return banner.isVisible(); }, 20000));
    auto* take = banner.findChild<QPushButton*>();
    QCOMPARE(take->text(), QStringLiteral("Include Them"));
    const auto width = [&] {
        const auto frame = m_window->session().motion().frame<2>();
        return frame->pose.row(0).maxCoeff() - frame->pose.row(0).minCoeff();
    };
    QVERIFY(settle(m_window->session()));
    const double before = width();
    QTest::mouseClick(take, Qt::LeftButton);
    QVERIFY(settle(m_window->session()) && !banner.isVisible());
    QVERIFY(width() > before + 30);
    m_window->session().document().undoStack()->undo();
    QCOMPARE(document.domain().alpha.threshold, AlphaOutlineOptions().threshold);
}

void TestWindow::unreadableFilesLeaveALine() {
    QFile file(m_folder->filePath(QStringLiteral("broken.png")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("not a picture");
    file.close();
    m_window->openPath(file.fileName());
    QVERIFY(QTest::qWaitFor([&] { return !m_window->banner().text().isEmpty(); }, 20000));
    QVERIFY(m_window->banner().text().contains(QStringLiteral("broken.png")));
    QVERIFY(m_window->session().document().isEmpty());
}

void TestWindow::holdingHHidesPins() {
    open();
    click(120, 80);
    QVERIFY(settle(m_window->session()));
    QVERIFY(QTest::qWaitFor([&] { return m_window->canvas().isSettled(); }, 20000));
    const QPoint pin = at(120, 80) + QPoint(7, 0);  // the pin's dark ring
    const QRgb shown = m_window->canvas().grab().toImage().pixel(pin);
    QTest::keyPress(&m_window->canvas(), Qt::Key_H);
    QVERIFY(m_window->canvas().grab().toImage().pixel(pin) != shown);
    QTest::keyRelease(&m_window->canvas(), Qt::Key_H);
    QCOMPARE(m_window->canvas().grab().toImage().pixel(pin), shown);
}

void TestWindow::playRuns() {
    open();
    QVERIFY(!m_window->actions().play->isEnabled());
    QVERIFY(bend());
    QVERIFY(m_window->actions().play->isEnabled());
    Playback& playback = m_window->session().playback();
    std::vector<double> heights;
    connect(&playback, &Playback::timeChanged, this,
            [&] { heights.push_back(m_window->session().gestures().pins()[1].centre.y()); });
    m_window->actions().play->trigger();
    QVERIFY(playback.isPlaying());
    QVERIFY(QTest::qWaitFor([&] { return !playback.isPlaying(); }, 20000));
    QVERIFY(playback.isAtEnd());
    QVERIFY(heights.size() > 3);
    QVERIFY(std::is_sorted(heights.begin() + 1, heights.end()));
}

/// At 100 % a pixel of the picture is one of the screen, at any number of device pixels.
void TestWindow::viewIsZoomed() {
    open();
    const ShapeCanvas& canvas = m_window->canvas();
    m_window->actions().actualSize->trigger();
    const double one = QLineF(canvas.toWidget({0, 0}), canvas.toWidget({1, 0})).length();
    QVERIFY(std::abs(one * canvas.devicePixelRatioF() - 1) < 1e-9);
    m_window->actions().zoomIn->trigger();
    const double larger = QLineF(canvas.toWidget({0, 0}), canvas.toWidget({1, 0})).length();
    QVERIFY(larger > 1.1 * one);
    m_window->actions().zoomOut->trigger();
    const double back = QLineF(canvas.toWidget({0, 0}), canvas.toWidget({1, 0})).length();
    QVERIFY(std::abs(back - one) < 1e-9);
    m_window->actions().zoomOut->trigger();
    QVERIFY(QLineF(canvas.toWidget({0, 0}), canvas.toWidget({1, 0})).length() < 0.9 * one);
    auto* zoom = m_window->findChild<QToolButton*>(QStringLiteral("zoom"));
    QCOMPARE(zoom->text(), QStringLiteral("80 %"));
    QTest::mouseClick(zoom, Qt::LeftButton);
    QCOMPARE(zoom->text(), QStringLiteral("100 %"));
    QVERIFY(std::abs(QLineF(canvas.toWidget({0, 0}), canvas.toWidget({1, 0})).length() - one) < 1e-9);
}

/// The numbers give the pointer's place and the growth of the shape, by the areas of its cells.
void TestWindow::numbersBelowThePicture() {
    open();
    click(40, 80);
    click(200, 80);
    QVERIFY(settle(m_window->session()));
    const auto shown = [this](const QString& name) {
        for (const auto* label : m_window->statusBar()->findChildren<QLabel*>())
            if (label->accessibleName() == name) return label->text();
        return QString();
    };
    const auto placeText = [this](const QPoint& there) {
        const Vec2 p = m_window->canvas().toShape(there);
        return QLocale().toString(p.x(), 'f', 1) + QStringLiteral(", ") + QLocale().toString(p.y(), 'f', 1);
    };
    dragPin(200, 80, 25, 10);
    QTRY_COMPARE(shown(QStringLiteral("Position")), placeText(at(225, 90)));  // of the last of many moves
    QTest::mouseRelease(&m_window->canvas(), Qt::LeftButton, {}, at(225, 90));
    QVERIFY(settle(m_window->session()));
    const auto frame = m_window->session().motion().frame<2>();
    double pose = 0, rest = 0;
    for (const auto& cell : frame->rest->cells) {
        pose += cellMeasure<2>(frame->pose, cell);
        rest += cellMeasure<2>(frame->rest->points, cell);
    }
    const double grown = 100 * (pose / rest - 1);
    QVERIFY(grown > 1);
    QCOMPARE(shown(QStringLiteral("Area change")),
             QStringLiteral("area +%1 %").arg(QLocale().toString(grown, 'f', 1)));
    const QPoint there = at(70, 30);
    QTest::mouseMove(&m_window->canvas(), there);
    // A real X server reports it with a delay.
    QTRY_COMPARE(shown(QStringLiteral("Position")), placeText(there));
}

void TestWindow::recentFilesAreTheLastOnesFirst() {
    const QString bar = writeCutOut(*m_folder), other = writeCutOut(*m_folder, QStringLiteral("other.png"));
    int opened = 0;
    for (const QString& path : {bar, other, bar}) {
        const int generation = m_window->session().document().generation();
        m_window->openPath(path);
        QVERIFY(
            QTest::qWaitFor([&] { return m_window->session().document().generation() > generation; }, 20000));
        ++opened;
        const QStringList expected = opened == 1   ? QStringList{bar}
                                     : opened == 2 ? QStringList{other, bar}
                                                   : QStringList{bar, other};
        QCOMPARE(m_window->files().recent(), expected);
    }
}

void TestWindow::exportedPictureIsWhatIsShown() {
    open();
    QVERIFY(bend());
    const QString path = m_folder->filePath(QStringLiteral("out.png"));
    exportNextTo(path);
    m_window->actions().exportPicture->trigger();
    QVERIFY(QTest::qWaitFor([&] { return QFile::exists(path); }, 20000));
    const auto& frame = *m_window->session().motion().frame<2>();
    View view;
    view.width = 240;
    view.height = 160;
    const Image expected =
        warpImage(*m_window->session().document().picture(), *frame.rest, frame.pose, view);
    const Image written = readImage(path.toStdString());
    QCOMPARE(written.width, 240);
    QVERIFY(written.data == expected.data);
}

/// The window fits 1600 × 1000 at two device pixels per pixel, with room for the frame and a task bar.
void TestWindow::fitsASmallScreen() {
    const QSize minimum(790, 450);
    const auto fits = [&] {
        const QSize need = m_window->minimumSizeHint();
        return need.width() <= minimum.width() && need.height() <= minimum.height();
    };
    QVERIFY(fits());
    open();
    QVERIFY(fits());
    m_window->resize(minimum);
    settleLayout(*m_window);
    QCOMPARE(m_window->size(), minimum);
    QVERIFY(MainWindow().height() <= m_window->screen()->availableSize().height());
}

/// The worst place is that of the chosen map.
void TestWindow::worstPlaceFollowsTheMap() {
    open();
    QVERIFY(bend());
    const auto* panel = m_window->findChild<QLabel*>(QStringLiteral("worstPlace"));
    auto* map = m_window->findChild<DistortionPanel*>()->findChild<QComboBox*>();
    QStringList seen;
    for (int i = 0; i < 3; ++i) {
        map->setCurrentIndex(i);
        seen << panel->text();
    }
    QCOMPARE(seen.removeDuplicates(), 0);
}

void TestWindow::samplesAreExportedElsewhere() {
    const QString sample = samplePaths().first();
    m_window->openPath(sample);
    Document& document = m_window->session().document();
    QVERIFY(QTest::qWaitFor([&] { return !document.isEmpty(); }, 20000));
    QVERIFY(proposedFolder(document) != QFileInfo(sample).absolutePath());
    document.save(m_folder->filePath(QStringLiteral("own.wend")));
    QCOMPARE(proposedFolder(document), QFileInfo(document.path()).absolutePath());
}

/// The file is not read again, since it may have changed by then.
void TestWindow::exportedMeshIsThatOfTheWindow() {
    const QString source = m_folder->filePath(QStringLiteral("quad.obj"));
    const auto write = [&source](const char* text) {
        QFile mesh(source);
        QVERIFY(mesh.open(QIODevice::WriteOnly));
        mesh.write(text);
    };
    write("v 0 0 0\nv 3 0 0\nv 3 2 0\nv 0 2 0\nf 1 2 3\nf 1 3 4\n");
    m_window->openPath(source);
    QVERIFY(QTest::qWaitFor([&] { return !m_window->session().document().isEmpty(); }, 20000));
    QVERIFY(settle(m_window->session()));
    write("v 0 0 0\nv 3 0 0\nv 3 2 0\nf 1 2 3\n");
    const QString path = m_folder->filePath(QStringLiteral("out.obj"));
    exportNextTo(path);
    m_window->actions().exportMesh->trigger();
    QVERIFY(QTest::qWaitFor([&] { return QFile::exists(path); }, 20000));
    QCOMPARE(readMesh<2>(path.toStdString()).points.cols(), 4);
}

void TestWindow::outdatedPosesAreNotExported() {
    open();
    click(40, 80);
    QVERIFY(settle(m_window->session()));
    Document& document = m_window->session().document();
    const auto next = copyOf(*document.project());
    Pin& pin = designOf(*next).handles[0];
    pin.motions.push_back({Translate<3>{Vec3(0, 20, 0)}, 0, 1, Ease::Linear, {}});
    document.change(QStringLiteral("Move"), next);  // what is shown has not moved yet
    bool asked = false;
    QTimer::singleShot(0, this, [&asked] {
        if (QWidget* dialog = QApplication::activeModalWidget()) asked = dialog->close();
    });
    m_window->actions().exportPicture->trigger();
    QVERIFY(!asked);
    QVERIFY2(m_window->banner().text().contains(QStringLiteral("still being computed")),
             qPrintable(m_window->banner().text()));
    QVERIFY(settle(m_window->session()));
}

void TestWindow::exportsFollowEachOther() {
    open();
    QVERIFY(bend());
    const QString path = m_folder->filePath(QStringLiteral("f_####.png"));
    exportNextTo(path);
    m_window->actions().exportFrames->trigger();
    m_window->actions().exportMesh->trigger();  // without a dialog
    QVERIFY(m_window->banner().text().contains(QStringLiteral("Another export")));
    QVERIFY(QTest::qWaitFor([&] { return QFile::exists(m_folder->filePath(QStringLiteral("f_0024.png"))); },
                            60000));
}

QTEST_MAIN(TestWindow)
#include "test_window.moc"
