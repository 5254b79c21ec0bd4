#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QHelpEvent>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPainter>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSlider>
#include <QStatusBar>
#include <QStatusTipEvent>
#include <QTextDocument>
#include <QToolButton>
#include <QToolTip>
#include <QTreeWidget>
#include <QUndoStack>
#include <QWheelEvent>
#include <QWindow>

#include "app/panels/cut_panel.h"
#include "app/panels/fields/number_boxes.h"
#include "app/panels/fields/option_field.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/picture_tip.h"
#include "app/panels/handle_panel.h"
#include "app/panels/pin_list.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/setting_edits.h"
#include "app/project/options/settings.h"
#include "app/style/theme.h"
#include "app/window/actions/toolbox.h"
#include "app/window/files/file_workflow.h"
#include "app/window/film/time_strip.h"
#include "app/window/properties.h"
#include "tests/support/dialogs.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// Fields of the panels, used by keys and the wheel, in a window with a picture or a solid.
class TestPanelFields : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void numbersCanBeTyped_data();
    void numbersCanBeTyped();
    void eitherPointCanBeTyped_data();
    void eitherPointCanBeTyped();
    void framesLeaveTheCutsNumbers();
    void longNumbersWidenNoPanel();
    void amountsOfSmallSolidsAreFine();
    void enterGivesTheKeyboardBack_data();
    void enterGivesTheKeyboardBack();
    void escapeGivesTheKeyboardBack_data();
    void escapeGivesTheKeyboardBack();
    void stepsKeepTheKeyboard_data();
    void stepsKeepTheKeyboard();
    void nothingStaysSelected_data();
    void nothingStaysSelected();
    void wheelScrollsThePanels_data();
    void wheelScrollsThePanels();
    void clicksOnTheStripGoToTheirTime_data();
    void clicksOnTheStripGoToTheirTime();
    void clicksOnSlidersAreStepsOfTheirOwn();
    void hintsFitBesideTheNumbers();
    void fieldsShowAnyValueOfTheirSetting();
    void spaceTappedPlays_data();
    void spaceTappedPlays();
    void spaceHeldMovesTheView_data();
    void spaceHeldMovesTheView();
    void reachIsNearToFar_data();
    void reachIsNearToFar();
    void tipsShowPictures_data();
    void tipsShowPictures();
    void numbersAreTakenBeforeTheWindowCloses_data();
    void numbersAreTakenBeforeTheWindowCloses();
    void namesAreTakenBeforeSaving_data();
    void namesAreTakenBeforeSaving();

  private:
    bool open(bool solid);
    bool bend(bool solid);
    QWidget& view();
    QWidget& side();
    void inEveryStep(const std::function<void()>& check);
    static void pictureAndSolid();
    static QString valueOf(const QWidget& field);
    void turnWheel(const QWidget& over, int notches);
    QAbstractSpinBox* box(const QString& name);
    void type(QAbstractSpinBox& box, const QString& text);
    bool tapSpace(QWidget& on);
    static bool showsTip(QWidget& widget, int pictures);

    std::unique_ptr<SolidFixture> m_f;
};

void TestPanelFields::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

/// Opens the file and expands the folded sections with numbers as well.
bool TestPanelFields::open(bool solid) {
    m_f->window().findChild<FoldingSection*>(QStringLiteral("advanced"))->setOpen(true);
    return solid ? m_f->open() : m_f->openPicture();
}

/// Holds one end and moves the other.
bool TestPanelFields::bend(bool solid) {
    ShapeSession& session = m_f->session();
    if (solid) {
        if (!m_f->holdEnds()) return false;
        m_f->drag(m_f->at(m_f->pin(1)), m_f->at(m_f->pin(1)) + QPoint(0, 60));
    } else {
        ShapeCanvas& canvas = m_f->window().canvas();
        const auto at = [&](double x, double y) { return canvas.toWidget({x, y}).toPoint(); };
        for (const double x : {40, 200}) QTest::mouseClick(&canvas, Qt::LeftButton, {}, at(x, 80));
        if (!settle(session)) return false;
        QTest::mousePress(&canvas, Qt::LeftButton, {}, at(200, 80));
        for (int i = 1; i <= 5; ++i) QTest::mouseMove(&canvas, at(200, 80 + 5 * i));
        QTest::mouseRelease(&canvas, Qt::LeftButton, {}, at(200, 105));
    }
    return settle(session) && session.playback().end() > 0;
}

QWidget& TestPanelFields::view() {
    return m_f->session().document().dimension() == 3 ? static_cast<QWidget&>(m_f->canvas())
                                                      : m_f->window().canvas();
}

QWidget& TestPanelFields::side() {
    return *m_f->window().findChild<QScrollArea*>(QStringLiteral("sideScroll"));
}

/// Runs the check in every step, since each has its own panels.
void TestPanelFields::inEveryStep(const std::function<void()>& check) {
    for (const Mode mode : kModes) {
        m_f->window().tools().setMode(mode);
        settleLayout(m_f->window().properties());
        // The facts about a file may follow later and take another line.
        const auto* facts = m_f->window().properties().findChild<QLabel*>(QStringLiteral("facts"));
        QVERIFY(!facts->isVisible() || QTest::qWaitFor([&] { return !facts->text().isEmpty(); }, 20000));
        settleLayout(m_f->window().properties());
        check();
    }
    m_f->window().tools().setMode(Mode::Pins);
}

void TestPanelFields::pictureAndSolid() {
    QTest::addColumn<bool>("solid");
    QTest::newRow("picture") << false;
    QTest::newRow("solid") << true;
}

/// Returns a null string if the widget is not a field.
QString TestPanelFields::valueOf(const QWidget& field) {
    if (const auto* box = qobject_cast<const QAbstractSpinBox*>(&field)) return box->text();
    if (const auto* slider = qobject_cast<const QSlider*>(&field)) return QString::number(slider->value());
    if (const auto* list = qobject_cast<const QComboBox*>(&field)) return list->currentText();
    return {};
}

/// Sends the event as the screen does: the window decides which widget is under the pointer and which gets
/// the keyboard.
void TestPanelFields::turnWheel(const QWidget& over, int notches) {
    MainWindow& window = m_f->window();
    const QPoint global = over.mapToGlobal(over.rect().center());
    QWheelEvent event(window.mapFromGlobal(global), global, {}, {0, 120 * notches}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event);
    qApp->notify(window.windowHandle(), &event);
}

QAbstractSpinBox* TestPanelFields::box(const QString& name) {
    for (auto* one : m_f->window().findChildren<QAbstractSpinBox*>())
        if (one->isVisible() && one->accessibleName() == name) return one;
    return nullptr;
}

void TestPanelFields::type(QAbstractSpinBox& box, const QString& text) {
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Return);
}

void TestPanelFields::numbersCanBeTyped_data() {
    pictureAndSolid();
}

/// A partly typed number is not reformatted; once complete, it is one step.
void TestPanelFields::numbersCanBeTyped() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    m_f->window().tools().setMode(Mode::Mesh);
    const QUndoStack& undo = *m_f->session().document().undoStack();
    const auto check = [&](const char* name, const char* typed, const char* shown) {
        QAbstractSpinBox* field = box(QString::fromUtf8(name));
        QVERIFY2(field, name);
        const QString before = field->text();
        const int steps = undo.count();
        type(*field, QString::fromUtf8(typed));
        QCOMPARE(field->text(), QString::fromUtf8(shown));
        QVERIFY2(before != field->text() && undo.count() <= steps + 1, name);
    };
    check("Exact balance", "1.257", "1.257 rad");
    check("Smoothing length", "0.03", "0.0300");
    check("Smoothing length", "0", "none");
    check("Smoothing length", "0.04", "0.0400");
    check("Vertices", "450", "450");
    if (!solid) check("Opaque from", "25", "25 %");
    if (!solid) check("Margin", "0.5", "0.5 px");
    if (solid) check("Radius–edge ratio", "2.25", "2.25");
    QVERIFY(settle(m_f->session()));
    const MaterialSpec& material = m_f->session().document().design().material;
    QCOMPARE(material.phi, 1.257);
    QCOMPARE(material.smoothing.length, 0.04);
    QCOMPARE(m_f->domain().vertices, 450);
}

/// Frames arrive continuously while a motion plays or is being computed.
void TestPanelFields::eitherPointCanBeTyped_data() {
    QTest::addColumn<QLocale>("locale");
    QTest::addColumn<QString>("text");
    for (const char* name : {"en_US", "de_DE"})
        for (const char* text : {"1234.5", "1234,5"})
            QTest::addRow("%s %s", name, text) << QLocale(QLatin1String(name)) << text;
}

/// Numbers in documents have points, those of the language may have commas; the text that the box then shows
/// can be typed again.
void TestPanelFields::eitherPointCanBeTyped() {
    QFETCH(QLocale, locale);
    QFETCH(QString, text);
    const QLocale before;
    QLocale::setDefault(locale);
    NumberBox plain;
    MagnitudeBox magnitude;
    QLocale::setDefault(before);
    plain.setRange(0, 1e6);
    for (QDoubleSpinBox* box :
         {static_cast<QDoubleSpinBox*>(&plain), static_cast<QDoubleSpinBox*>(&magnitude)}) {
        type(*box, text);
        QCOMPARE(box->value(), 1234.5);
        const QString shown = box->cleanText();
        box->setValue(2);
        type(*box, shown);
        QCOMPARE(box->value(), 1234.5);
    }
}

void TestPanelFields::longNumbersWidenNoPanel() {
    QVERIFY(m_f->open() && m_f->holdEnds());
    m_f->session().gestures().moveAtOnce(Grip{}, {-1.00098825e-5, -0.15596123, 3e-9});
    QVERIFY(settle(m_f->session()));
    auto* panel = m_f->window().findChild<HandlePanel*>();
    auto* place = panel->findChild<QLabel*>(QStringLiteral("pinPlace"));
    const QLocale locale;
    const auto number = [&](double value) { return locale.toString(value, 'g', 5); };
    QCOMPARE(place->text(), QStringLiteral("at %1, %2, %3").arg(number(2), number(-0.15596), number(0)));
    const int width = panel->minimumSizeHint().width();
    place->setText(QString(80, QLatin1Char('0')));
    settleLayout(m_f->window());
    QCOMPARE(panel->minimumSizeHint().width(), width);
}

/// A solid in metres may be a centimetre large: a typed amount keeps its digits.
void TestPanelFields::amountsOfSmallSolidsAreFine() {
    const QString path = m_f->folder().filePath(QStringLiteral("small.obj"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("v 0 0 0\nv 0.01 0 0\nv 0 0.01 0\nv 0 0 0.01\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    file.close();
    QVERIFY(m_f->openFile(path));
    m_f->session().addHandle(std::vector<int>{1}, "Pin");
    m_f->session().selection().set({0});
    QVERIFY(settle(m_f->session()));
    auto* panel = m_f->window().findChild<HandlePanel*>();
    auto* amount = box(QStringLiteral("Amount"));
    QVERIFY(amount && panel->isAncestorOf(amount));
    type(*amount, QStringLiteral("0.00012"));
    QTest::mouseClick(panel->findChild<QToolButton*>(QStringLiteral("applyStep")), Qt::LeftButton);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->handles()[0].motions.size(), std::size_t(1));
    QVERIFY((m_f->pin(0) - Vec3(0.01012, 0, 0)).norm() < 1e-9);
}

void TestPanelFields::framesLeaveTheCutsNumbers() {
    QVERIFY(open(true));
    m_f->actions().cut->trigger();
    QAbstractSpinBox* place = box(QStringLiteral("Distance of the cut"));
    QVERIFY(place);
    place->setFocus();
    place->selectAll();
    QTest::keyClicks(place, QStringLiteral("0.25"));
    m_f->window().findChild<CutPanel*>()->show(2, m_f->canvas().solid().plane(), Vec3(-3, -3, -3),
                                               Vec3(3, 3, 3));
    QTest::keyClick(place, Qt::Key_Return);
    QCOMPARE(place->text(), QStringLiteral("0.2500"));
    const CutPlane& plane = m_f->canvas().solid().plane();
    QCOMPARE(plane.normal.dot(plane.point), 0.25);
}

void TestPanelFields::enterGivesTheKeyboardBack_data() {
    pictureAndSolid();
}

/// Enter leaves each field, whether it is shown at the moment or not; the next key is for the view.
void TestPanelFields::enterGivesTheKeyboardBack() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    if (solid) m_f->session().addHandle(Ball<3>{{2, 0, 0}, 0.6}, "Region");
    QVERIFY(settle(m_f->session()));
    QSet<QWidget*> seen;
    inEveryStep([&] {
        for (QWidget* field : side().findChildren<QWidget*>()) {
            if (!field->inherits("QAbstractSpinBox") && !field->inherits("QLineEdit")) continue;
            view().clearFocus();
            field->setFocus();
            QTest::keyClick(field, Qt::Key_Return);
            QVERIFY2(view().hasFocus(), qPrintable(field->accessibleName()));
            if (field->isVisible()) seen << field;
        }
    });
    QVERIFY(seen.size() >= (solid ? 10 : 5));
    m_f->window().tools().setMode(Mode::Pins);
    QAbstractSpinBox* phi = box(QStringLiteral("Exact balance"));
    type(*phi, QStringLiteral("1.257"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_1);
    QCOMPARE(phi->text(), QStringLiteral("1.257 rad"));
    const int steps = m_f->session().document().undoStack()->index();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(m_f->session().document().undoStack()->index(), steps - 1);
}

void TestPanelFields::escapeGivesTheKeyboardBack_data() {
    pictureAndSolid();
}

/// Escape works wherever Tab leads, not only in fields; a number that was being typed is restored.
void TestPanelFields::escapeGivesTheKeyboardBack() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    int seen = 0;
    inEveryStep([&] {
        for (auto* widget : m_f->window().findChildren<QWidget*>()) {
            const bool reached = widget->isVisible() && widget->isEnabled() && !widget->focusProxy() &&
                                 (widget->focusPolicy() & Qt::TabFocus) && widget->window() == &m_f->window();
            if (!reached) continue;
            widget->setFocus();
            QTest::keyClick(widget, Qt::Key_Escape);
            QVERIFY2(view().hasFocus(), qPrintable(QStringLiteral("%1 %2").arg(
                                            widget->metaObject()->className(), widget->accessibleName())));
            ++seen;
        }
    });
    QVERIFY2(seen > 50, qPrintable(QString::number(seen)));
    m_f->window().tools().setMode(Mode::Mesh);
    const auto before = m_f->session().document().project();
    for (const char* name : {"Exact balance", "Vertices"}) {
        QAbstractSpinBox* field = box(QString::fromUtf8(name));
        const QString shown = field->text();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("1"));
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(view().hasFocus());
        QCOMPARE(field->text(), shown);
    }
    QVERIFY(m_f->session().document().project() == before);
}

void TestPanelFields::stepsKeepTheKeyboard_data() {
    pictureAndSolid();
}

/// Widgets that a change updates are not hidden in between.
void TestPanelFields::stepsKeepTheKeyboard() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    inEveryStep([this] {
        for (auto* field : side().findChildren<QAbstractSpinBox*>()) {
            if (!field->isVisible() || !field->isEnabled()) continue;
            field->setFocus();
            const QString before = field->text();
            for (const Qt::Key key : {Qt::Key_Up, Qt::Key_Down})  // down from what is at its largest
                for (int i = 0; i < 2 && (i > 0 || field->text() == before); ++i)
                    QTest::keyClick(QApplication::focusWidget(), key);
            QVERIFY2(field->hasFocus() && field->text() != before, qPrintable(field->accessibleName()));
        }
    });
}

void TestPanelFields::nothingStaysSelected_data() {
    pictureAndSolid();
}

void TestPanelFields::nothingStaysSelected() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    const auto selected = [&] {
        QStringList names;
        for (auto* text : side().findChildren<QLineEdit*>())
            if (text->hasSelectedText()) names << text->parentWidget()->accessibleName();
        return names.join(QStringLiteral(", "));
    };
    inEveryStep([&] {
        for (auto* field : side().findChildren<QAbstractSpinBox*>()) {
            if (!field->isVisible() || !field->isEnabled()) continue;
            field->setFocus(Qt::TabFocusReason);
            QTest::keyClick(field, Qt::Key_Up);
            QVERIFY(!selected().isEmpty());  // for typing over it
            QTest::keyClick(field, Qt::Key_Return);
            QCOMPARE(selected(), QString());
            field->selectAll();
            QCOMPARE(selected(), QString());
        }
    });
    QVERIFY(settle(m_f->session()));
    QCOMPARE(selected(), QString());
}

void TestPanelFields::wheelScrollsThePanels_data() {
    pictureAndSolid();
}

/// A field takes the wheel only after it was clicked.
void TestPanelFields::wheelScrollsThePanels() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    if (solid) m_f->session().addHandle(Ball<3>{{2, 0, 0}, 0.6}, "Region");
    QVERIFY(settle(m_f->session()));
    if (solid) m_f->actions().cut->trigger();
    m_f->window().tools().setMode(Mode::Mesh);
    m_f->window().resize(1100, 520);  // with the panels beside the view
    auto& scroll = static_cast<QScrollArea&>(side());
    QScrollBar& bar = *scroll.verticalScrollBar();
    QVERIFY(QTest::qWaitFor([&] { return bar.maximum() > 0; }, 20000));
    settleLayout(scroll);
    QSet<QWidget*> seen;
    inEveryStep([&] {
        for (QWidget* field : side().findChildren<QWidget*>()) {
            if (!field->isVisible() || valueOf(*field).isNull()) continue;
            scroll.ensureWidgetVisible(field);
            QCoreApplication::processEvents();
            const QByteArray name = field->accessibleName().toUtf8();
            view().setFocus();
            for (const int way : {-1, 1}) {
                const QString before = valueOf(*field);
                const bool room = way > 0 ? bar.value() > 0 : bar.value() < bar.maximum();
                const int at = bar.value();
                turnWheel(*field, way);
                QVERIFY2(valueOf(*field) == before && view().hasFocus(), name);
                QVERIFY2(!room || bar.value() != at, name);
                bar.setValue(at);
            }
            seen << field;
            // A direction keeps its length, and so restricts one of its numbers.
            if (!field->isEnabled() || qobject_cast<QComboBox*>(field) || name.startsWith("Normal")) continue;
            field->setFocus();
            const QString before = valueOf(*field);
            turnWheel(*field, 1);
            if (valueOf(*field) == before) turnWheel(*field, -1);  // it was at its end
            QVERIFY2(valueOf(*field) != before, name);
        }
    });
    QVERIFY(seen.size() >= (solid ? 15 : 8));
}

void TestPanelFields::clicksOnTheStripGoToTheirTime_data() {
    pictureAndSolid();
}

void TestPanelFields::clicksOnTheStripGoToTheirTime() {
    QFETCH(bool, solid);
    QVERIFY(open(solid) && bend(solid));
    Playback& playback = m_f->session().playback();
    auto* slider = m_f->window().findChild<TimeStrip*>()->slider();
    const int handle = 16;  // pixels; its middle goes from one half of it to the other
    const auto at = [&](double part) {
        return QPoint(handle / 2 + qRound(part * (slider->width() - handle)), slider->height() / 2);
    };
    const auto shows = [&](double part) {
        return std::abs(playback.time() / playback.end() - part) < 2.0 / slider->width();
    };
    QVERIFY(playback.isAtEnd());
    QTest::mouseClick(slider, Qt::LeftButton, {}, at(0.3));
    QVERIFY2(shows(0.3), qPrintable(QString::number(playback.time())));
    playback.setPlaying(true);
    QTest::mousePress(slider, Qt::LeftButton, {}, at(0.8));
    QVERIFY(shows(0.8) && !playback.isPlaying());
    for (const double part : {0.7, 0.6, 0.5}) QTest::mouseMove(slider, at(part));
    QVERIFY(shows(0.5));
    QTest::mouseRelease(slider, Qt::LeftButton, {}, at(0.5));
    QVERIFY(shows(0.5));
    QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() - 1, 1));  // beyond, and above it
    QVERIFY(playback.isAtEnd());
    QVERIFY(settle(m_f->session()));
}

void TestPanelFields::clicksOnSlidersAreStepsOfTheirOwn() {
    QVERIFY(open(false));
    m_f->window().tools().setMode(Mode::Mesh);
    QSlider* density = nullptr;
    for (auto* one : side().findChildren<QSlider*>())
        if (one->accessibleName() == QString::fromUtf8("Detail: coarse – fine")) density = one;
    QVERIFY(density);
    const int steps = m_f->session().document().undoStack()->count();
    for (const int sixth : {2, 3}) {
        QTest::mouseClick(density, Qt::LeftButton, {}, QPoint(density->width() * sixth / 6, 4));
        QVERIFY(std::abs(density->value() - 1000 * sixth / 6) < 50);
    }
    QCOMPARE(m_f->session().document().undoStack()->count(), steps + 2);
    QVERIFY(settle(m_f->session()));
}

/// Hints are shortened before the numbers are, and never in the middle of a sentence where a whole one fits;
/// the tooltip has the full text.
void TestPanelFields::hintsFitBesideTheNumbers() {
    QVERIFY(open(true));
    const QStatusBar& bar = *m_f->window().statusBar();
    const auto room = [&bar] {
        settleLayout(bar);
        int left = bar.width();
        for (const auto* label : bar.findChildren<QLabel*>())
            if (label->isVisible() && !label->accessibleName().isEmpty()) left = std::min(left, label->x());
        return left;
    };
    int cut = 0;
    for (const int width : {1200, m_f->window().minimumSizeHint().width()}) {
        m_f->window().resize(width, 800);
        settleLayout(m_f->window());
        QVERIFY(room() < bar.width());
        for (const auto* widget : side().findChildren<QWidget*>()) {
            const QString hint = widget->statusTip();
            if (hint.isEmpty()) continue;
            QStatusTipEvent tip(hint);
            QCoreApplication::sendEvent(&m_f->window(), &tip);
            const QString shown = bar.currentMessage();
            QVERIFY(hint.startsWith(shown.chopped(1)) && shown.size() > 10);
            QVERIFY2(bar.fontMetrics().horizontalAdvance(shown) < room(), qPrintable(shown));
            cut += shown != hint;
        }
    }
    QVERIFY(cut > 0);
    QStatusTipEvent sizes(m_f->window().findChild<QWidget*>(QStringLiteral("detailRegions"))->statusTip());
    QCoreApplication::sendEvent(&m_f->window(), &sizes);
    QVERIFY2(bar.currentMessage().endsWith('.'), qPrintable(bar.currentMessage()));
    QStatusTipEvent none{QString()};
    QCoreApplication::sendEvent(&m_f->window(), &none);
    m_f->window().resize(m_f->window().minimumSizeHint());
    const auto labels = bar.findChildren<QLabel*>();
    const auto* tool =
        *std::min_element(labels.begin(), labels.end(), [](auto* a, auto* b) { return a->x() < b->x(); });
    QVERIFY(QTest::qWaitFor([&] { return tool->isVisible() && !tool->text().isEmpty(); }, 20000));
    QVERIFY(tool->fontMetrics().horizontalAdvance(tool->text()) <= tool->contentsRect().width());
    QVERIFY(tool->toolTip().startsWith(tool->text().chopped(1)));
    QCOMPARE(bar.currentMessage(), QString());
}

/// Every field can show the extreme values of its setting: none is cut off, and showing it does not change
/// it.
void TestPanelFields::fieldsShowAnyValueOfTheirSetting() {
    int seen = 0;
    for (const Option& one : options()) {
        if (!*one.row.label || !one.field.at.get) continue;
        OptionField field(one.key);
        const QByteArray key(one.key.data(), static_cast<qsizetype>(one.key.size()));
        QVERIFY2(!field.focusProxy()->accessibleName().isEmpty() && !field.focusProxy()->toolTip().isEmpty(),
                 key);
        std::vector<double> values{defaultOf(one)};
        const Range range = rangeOf(one, 2);
        const bool open = range.openMin || std::isinf(range.min);
        if (one.kind == OptionKind::Flag || one.kind == OptionKind::Choice)
            values = {0, 1};
        else
            values.insert(values.end(), {open ? 1e-3 * std::min(1.0, range.max) : range.min,
                                         std::isinf(range.max) ? 1e5
                                         : range.openMax       ? 0.99 * range.max
                                                               : range.max});
        for (const double value : values) {
            if (one.kind == OptionKind::Number && !range.contains(value)) continue;  // there is none
            QSignalSpy changed(&field, &OptionField::changed);
            field.setNumber(value);
            QVERIFY2(std::abs(field.number() - value) <= 1e-12 * std::abs(value), key);
            QCOMPARE(changed.count(), 0);
            if (const auto* box = qobject_cast<QDoubleSpinBox*>(field.focusProxy()))
                QVERIFY2(std::abs(box->value() / one.row.factor - value) <= 0.05 * std::abs(value) + 1e-12,
                         key + ' ' + box->text().toUtf8());
        }
        ++seen;
    }
    QVERIFY(seen >= 10);
}

void TestPanelFields::spaceTappedPlays_data() {
    pictureAndSolid();
}

/// Taps the space bar and returns whether that toggled playback.
bool TestPanelFields::tapSpace(QWidget& on) {
    const Playback& playback = m_f->session().playback();
    const bool before = playback.isPlaying();
    on.setFocus();
    QTest::keyClick(&on, Qt::Key_Space);
    return playback.isPlaying() != before;
}

/// A tap plays on the view and wherever no other widget uses the space bar; fields, buttons and lists keep
/// it. Held until it repeats, or combined with the mouse, it is not a tap.
void TestPanelFields::spaceTappedPlays() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    QVERIFY(!tapSpace(view()));  // nothing moves yet
    QVERIFY(bend(solid));
    Playback& playback = m_f->session().playback();
    QVERIFY(tapSpace(view()) && playback.isPlaying());
    QVERIFY(tapSpace(view()) && !playback.isPlaying());
    QVERIFY(tapSpace(*m_f->window().findChild<TimeStrip*>()->slider()));
    QVERIFY(tapSpace(*m_f->window().findChild<QSlider*>(QStringLiteral("energySlider"))));
    QVERIFY(!playback.isPlaying());
    m_f->window().tools().setMode(Mode::Mesh);
    settleLayout(m_f->window().properties());
    QAbstractButton* tile = nullptr;
    for (auto* one : m_f->window().findChildren<QToolButton*>())
        if (one->property("role") == QStringLiteral("tile")) tile = one;
    const auto* choices = solid ? "domain.cage" : "domain.outline.from";
    QWidget* list = m_f->window().findChild<OptionField*>(QLatin1String(choices))->focusProxy();
    for (QWidget* field : std::initializer_list<QWidget*>{tile, list, box(QStringLiteral("Vertices"))}) {
        QVERIFY(field && field->isVisible());
        QVERIFY2(!tapSpace(*field), qPrintable(field->accessibleName()));
        if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
    }
    QLineEdit text(&m_f->window());
    text.show();
    QVERIFY(!tapSpace(text));
    QCOMPARE(text.text(), QStringLiteral(" "));
    view().setFocus();
    QTest::keyPress(&view(), Qt::Key_Space);
    QKeyEvent again(QEvent::KeyPress, Qt::Key_Space, {}, QStringLiteral(" "), true);
    QCoreApplication::sendEvent(&view(), &again);
    QTest::keyRelease(&view(), Qt::Key_Space);
    QVERIFY(!playback.isPlaying());
}

void TestPanelFields::spaceHeldMovesTheView_data() {
    pictureAndSolid();
}

/// The view moves as far as the pointer, without a rotation; afterwards the tool has the button again, and
/// nothing plays.
void TestPanelFields::spaceHeldMovesTheView() {
    QFETCH(bool, solid);
    QVERIFY(open(solid) && bend(solid));
    const auto places = [&] {
        if (solid) return std::pair{m_f->at({-1, -0.5, 0}), m_f->at({1, -0.5, 0.3})};
        ShapeCanvas& canvas = m_f->window().canvas();
        return std::pair{canvas.toWidget({60, 80}).toPoint(), canvas.toWidget({160, 90}).toPoint()};
    };
    const auto before = places();
    const int steps = m_f->session().document().undoStack()->count();
    const QPoint at = before.first, by(40, 25);
    view().setFocus();
    QTest::keyPress(&view(), Qt::Key_Space);
    QTest::mousePress(&view(), Qt::LeftButton, {}, at);
    for (int i = 1; i <= 5; ++i) QTest::mouseMove(&view(), at + by * i / 5);
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, at + by);
    QTest::keyRelease(&view(), Qt::Key_Space);
    const auto after = places();
    for (const QPoint& off : {after.first - before.first - by, after.second - before.second - by})
        QVERIFY2(off.manhattanLength() <= (solid ? 6 : 2),  // nearer than what is turned about: a little more
                 qPrintable(QStringLiteral("%1 %2").arg(off.x()).arg(off.y())));
    QVERIFY(!m_f->session().playback().isPlaying());
    QCOMPARE(m_f->session().document().undoStack()->count(), steps);
    QTest::mouseMove(&view(), at + by);
    QTest::mousePress(&view(), Qt::LeftButton, {}, at + by);
    QTest::mouseMove(&view(), at + 2 * by);
    QCOMPARE(places(), after);
    QTest::keyClick(&view(), Qt::Key_Escape);
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, at + 2 * by);
}

void TestPanelFields::reachIsNearToFar_data() {
    pictureAndSolid();
}

/// The slider and the number are one setting and follow each other: farther is more, and values beyond the
/// slider's ends stay as they are.
void TestPanelFields::reachIsNearToFar() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    m_f->window().tools().setMode(Mode::Pins);
    auto* slider = m_f->window().findChild<QSlider*>(QStringLiteral("reachSlider"));
    auto* number = m_f->window().findChild<OptionField*>(QStringLiteral("material.smoothing.length"));
    QVERIFY(slider && slider->isVisible() && number);
    QUndoStack& undo = *m_f->session().document().undoStack();
    const auto length = [&] {
        return settingOf(*m_f->session().document().project(), "material.smoothing.length");
    };
    QCOMPARE(length(), 1.0 / 75);  // of a new project: only shown
    double before = 0;
    for (int value = 0; value <= 100; ++value) {
        if (slider->value() != value) slider->setValue(value);
        if (value == 0) slider->setValue(1), slider->setValue(0);
        QVERIFY(length() > before);
        before = length();
        QCOMPARE(number->number(), length());
        changeSetting(m_f->session().document(), "material.smoothing.length", 1);
        QCOMPARE(slider->value(), 100);
        changeSetting(m_f->session().document(), "material.smoothing.length", before);
        QCOMPARE(slider->value(), value);
    }
    const int steps = undo.count();
    QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() / 2, slider->height() / 2));
    QCOMPARE(undo.count(), steps + 1);
    QVERIFY(length() > 0.01 && length() < 0.1);
    type(*box(QStringLiteral("Smoothing length")), QStringLiteral("0"));
    QCOMPARE(slider->value(), 0);
    QCOMPARE(length(), 0.0);
    QTest::keyClick(slider, Qt::Key_Right);
    QVERIFY(length() > 0);
    QVERIFY(settle(m_f->session()));
}

void TestPanelFields::tipsShowPictures_data() {
    pictureAndSolid();
}

/// Returns whether the tooltip appears under a resting pointer, as rich text with this number of drawings.
bool TestPanelFields::showsTip(QWidget& widget, int pictures) {
    const QPoint at = widget.rect().center();
    QHelpEvent event(QEvent::ToolTip, at, widget.mapToGlobal(at));
    QCoreApplication::sendEvent(&widget, &event);
    const QString text = QToolTip::text();
    QToolTip::hideText();
    QTextDocument words, all;
    words.setHtml(widget.toolTip());
    all.setHtml(text);
    return text.startsWith(widget.toolTip()) && text.count(QStringLiteral("<img")) == pictures &&
           all.size().height() > words.size().height() + 60;
}

void TestPanelFields::tipsShowPictures() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    const auto field = [&](const char* name) {
        auto* found = m_f->window().findChild<QWidget*>(QString::fromLatin1(name));
        return found && found->focusProxy() ? found->focusProxy() : found;
    };
    QVERIFY(showsTip(*field("energySlider"), 4));
    QVERIFY(showsTip(*field("material.phi"), 4));
    QVERIFY(showsTip(*field("reachSlider"), 2));
    QVERIFY(showsTip(*field("material.smoothing.length"), 2));
    QVERIFY(showsTip(*field("brushRatio"), 2));
    QVERIFY(showsTip(*field("layerRatio"), 2));
    QVERIFY(showsTip(*field("memorySlider"), 2));
    QVERIFY(showsTip(*field("settle"), 2));
    int tiles = 0;
    for (auto* tile : m_f->window().findChildren<QToolButton*>())
        if (tile->property("role") == QStringLiteral("tile")) tiles += showsTip(*tile, 1);
    QCOMPARE(tiles, 4);
    // Drawn in the palette's colours: light lines on dark, dark ones on light.
    const auto lightness = [](Appearance appearance) {
        const QPalette palette = wendPalette(appearance, {});
        QTextDocument text;
        text.setHtml(tipWithPictures({}, stiffnessPictures(), palette));
        QImage image(text.size().toSize(), QImage::Format_RGB32);
        const QColor ground = palette.color(QPalette::ToolTipBase);
        image.fill(ground);
        QPainter painter(&image);
        painter.setClipRect(0, 0, image.width(), 70);  // above the words
        text.drawContents(&painter);
        int lighter = 0, darker = 0;
        for (int y = 0; y < 70; ++y)
            for (int x = 0; x < image.width(); ++x) {
                const int off = qGray(image.pixel(x, y)) - qGray(ground.rgb());
                lighter += off > 60, darker += off < -60;
            }
        return std::pair{lighter, darker};
    };
    const auto light = lightness(Appearance::Light), dark = lightness(Appearance::Dark);
    QVERIFY(light.first == 0 && light.second > 200);
    QVERIFY(dark.first > 200 && dark.second == 0);
}

void TestPanelFields::numbersAreTakenBeforeTheWindowCloses_data() {
    pictureAndSolid();
}

/// Closing the window while a number is being typed asks whether to save; the window also closes with one
/// half typed.
void TestPanelFields::numbersAreTakenBeforeTheWindowCloses() {
    QFETCH(bool, solid);
    QVERIFY(open(solid) && bend(solid));
    QUndoStack& undo = *m_f->session().document().undoStack();
    undo.setClean();
    const auto type = [this](const QString& text) {
        m_f->window().activateWindow();  // a dialog had the keyboard
        QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
        auto* length = m_f->window().findChild<TimeStrip*>()->length();
        length->setFocus();
        length->selectAll();
        QTest::keyClicks(length, text);
    };
    type(QStringLiteral("2"));
    QVERIFY(undo.isClean());
    bool asked = false;
    withNext<QMessageBox>(this, [&asked](QMessageBox& box) {
        asked = true;
        box.button(QMessageBox::Cancel)->click();
    });
    m_f->window().close();
    QVERIFY(asked && m_f->window().isVisible());
    QCOMPARE(m_f->session().document().end(), 2.0);
    type(QStringLiteral("3"));
    QTemporaryDir folder;
    nameNextFile(this, folder.filePath(QStringLiteral("typed.wend")));
    m_f->window().files().saveAs();
    QVERIFY(undo.isClean());
    QCOMPARE(m_f->session().document().end(), 3.0);
    type(QStringLiteral("4"));
    m_f.reset();
}

void TestPanelFields::namesAreTakenBeforeSaving_data() {
    pictureAndSolid();
}

/// A name that is still being typed is saved, too.
void TestPanelFields::namesAreTakenBeforeSaving() {
    QFETCH(bool, solid);
    QVERIFY(open(solid) && bend(solid));
    m_f->window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
    auto* pins = m_f->window().findChild<PinList*>();
    QTreeWidget& tree = *pins->list();
    QVERIFY(tree.isVisible());
    tree.setFocus();
    tree.setCurrentItem(pins->rowOf(0));
    QTest::keyClick(&tree, Qt::Key_F2);
    auto* editor = tree.findChild<QLineEdit*>();
    QVERIFY(editor && editor->hasFocus());
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("Paw"));
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("named.wend"));
    nameNextFile(this, path);
    QVERIFY(m_f->window().files().saveAs());
    QVERIFY(!m_f->session().document().isModified());
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonArray handles = QJsonDocument::fromJson(file.readAll())["handles"].toArray();
    QCOMPARE(handles[0]["name"].toString(), QStringLiteral("Paw"));
}

QTEST_MAIN(TestPanelFields)
#include "test_panel_fields.moc"
