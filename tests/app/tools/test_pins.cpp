// Pins in the list, the menus and by keys, with pictures and solids in one test body: locked, hidden,
// grouped, linked, mirrored, coloured; and which pin a click picks.
#include <QComboBox>
#include <QInputDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QMenu>
#include <QStatusBar>
#include <QToolBar>
#include <QTreeWidget>

#include "app/engine/shape/material_raster.h"
#include "app/panels/pin_list.h"
#include "app/project/design.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/file/project_writer.h"
#include "app/session/opening.h"
#include "app/style/marks.h"
#include "app/tools/drag_label.h"
#include "app/tools/paint/paint_tool.h"
#include "app/tools/picture_marks.h"
#include "app/views/volume/glyphs.h"
#include "app/window/actions/pin_actions.h"
#include "tests/support/bar.h"
#include "tests/support/dialogs.h"

using namespace wend;
using namespace wend::test;

class TestPins : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void lockedPinsStay_data() { dimensions(); }
    void lockedPinsStay();
    void hiddenPinsHoldOn_data() { dimensions(); }
    void hiddenPinsHoldOn();
    void groupsHaveAHeading_data() { dimensions(); }
    void groupsHaveAHeading();
    void linkedPinsMoveTogether_data() { dimensions(); }
    void linkedPinsMoveTogether();
    void mirrorImagesMoveAsInAMirror_data() { dimensions(); }
    void mirrorImagesMoveAsInAMirror();
    void allIsUndoneSavedAndReopened_data() { dimensions(); }
    void allIsUndoneSavedAndReopened();
    void waysArePickedAndSnapIsAChoice_data() { dimensions(); }
    void waysArePickedAndSnapIsAChoice();
    void keysSetPins_data() { dimensions(); }
    void keysSetPins();
    void marksAreAsLargeAsChosen_data() { dimensions(); }
    void marksAreAsLargeAsChosen();
    void fieldsAndLabelsAreAsLargeAsChosen();
    void glyphsAreAsLargeAsChosen();
    void brushesKeepTheirRadius();

  private:
    ShapeSession& session() { return m_f->session(); }
    PinActions& pins() { return *m_f->window().findChild<PinActions*>(); }
    PinList& list() { return m_f->window().properties().pins(); }
    const PinTraits& traits(int handle) {
        return m_f->session().document().design().handles.at(handle).traits;
    }
    QString said() { return m_f->window().statusBar()->currentMessage(); }
    template <int Dim>
    bool open();
    template <int Dim>
    Vec<Dim> pin(int handle);
    template <int Dim>
    QPoint at(const Vec<Dim>& p) {
        return Bar<Dim>::canvas(*m_f).toWidget(p).toPoint();
    }
    template <int Dim>
    void click(const QPoint& where, Qt::KeyboardModifiers modifiers = {});
    template <int Dim>
    bool drag(int handle, const QPoint& by);
    void clickSign(const QTreeWidgetItem& item, PinList::Column column);
    template <int Dim>
    void lock();
    template <int Dim>
    void hide();
    template <int Dim>
    void group();
    template <int Dim>
    void link();
    template <int Dim>
    void mirror();
    template <int Dim>
    void keep();
    template <int Dim>
    void pick();
    template <int Dim>
    void setByKeys();
    template <int Dim>
    void enlarge();

    std::unique_ptr<SolidFixture> m_f;
};

void TestPins::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

/// Pins left, in the middle and right, none selected; the tool selects.
template <int Dim>
bool TestPins::open() {
    if (!Bar<Dim>::open(*m_f)) return false;
    m_f->tool("pin")->trigger();
    for (const double u : {-1.5, 0.0, 1.5}) {
        click<Dim>(at<Dim>(Bar<Dim>::place(u, 0)));
        if (!settle(session())) return false;
    }
    m_f->tool("select")->trigger();
    session().selection().clear();
    m_f->picture(QStringLiteral("pins-%1").arg(Dim));
    return session().pins().count() == 3;
}

template <int Dim>
Vec<Dim> TestPins::pin(int handle) {
    for (const auto& view : session().gestures().pins(true))
        if (view.handle == handle) return view.centre.head<Dim>();
    return Vec<Dim>::Zero();
}

template <int Dim>
void TestPins::click(const QPoint& where, Qt::KeyboardModifiers modifiers) {
    auto& canvas = Bar<Dim>::canvas(*m_f);
    QTest::mouseMove(&canvas, where);
    QTest::mouseClick(&canvas, Qt::LeftButton, modifiers, where);
}

/// A single one of them suffices.
template <int Dim>
bool TestPins::drag(int handle, const QPoint& by) {
    auto& canvas = Bar<Dim>::canvas(*m_f);
    session().selection().clear();
    const QPoint from = at<Dim>(pin<Dim>(handle));
    QTest::mouseMove(&canvas, from);
    QTest::mousePress(&canvas, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 6; ++i) QTest::mouseMove(&canvas, from + by * i / 6);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, from + by);
    return settle(session());
}

void TestPins::clickSign(const QTreeWidgetItem& item, PinList::Column column) {
    QTreeWidget& tree = *list().list();
    const QRect row = tree.visualItemRect(&item);
    QTest::mouseClick(
        tree.viewport(), Qt::LeftButton, {},
        QPoint(tree.columnViewportPosition(column) + tree.columnWidth(column) / 2, row.center().y()));
}

void TestPins::lockedPinsStay() {
    BOTH(lock);
}

/// A click on its padlock locks a pin: it is neither dragged, nor nudged, nor removed, until another click.
template <int Dim>
void TestPins::lock() {
    QVERIFY(open<Dim>());
    const std::vector<int> before = session().selection().handles();
    clickSign(*list().rowOf(2), PinList::Lock);
    QVERIFY(settle(session()));
    QVERIFY(traits(2).locked && !traits(0).locked);
    QCOMPARE(session().selection().handles(), before);  // a sign selects nothing
    const int steps = session().document().undoStack()->count();
    const Vec<Dim> place = pin<Dim>(2);
    QVERIFY(drag<Dim>(2, {0, -40}));
    QCOMPARE(session().selection().handles(), std::vector<int>{2});
    QVERIFY2(said().contains(QStringLiteral("is locked")), qPrintable(said()));
    auto& canvas = Bar<Dim>::canvas(*m_f);
    canvas.setFocus();
    QTest::keyClick(&canvas, Qt::Key_Up, Qt::ShiftModifier);
    m_f->window().actions().remove->trigger();
    QVERIFY(settle(session()));
    QCOMPARE(session().pins().count(), 3);
    QCOMPARE(session().document().undoStack()->count(), steps);
    QCOMPARE((pin<Dim>(2) - place).norm(), 0.0);
    QVERIFY(pins().lock->isChecked());
    pins().lock->trigger();
    QVERIFY(settle(session()) && !traits(2).locked);
    QVERIFY(drag<Dim>(2, {0, -40}));
    QVERIFY((pin<Dim>(2) - place).norm() > 20 * canvas.pixelSize(inSpace(place)));
    session().selection().set({0, 1});  // of several the others go
    clickSign(*list().rowOf(0), PinList::Lock);
    QVERIFY(traits(0).locked && traits(1).locked);
    clickSign(*list().rowOf(1), PinList::Lock);
    QVERIFY(!traits(0).locked && !traits(1).locked);
}

void TestPins::hiddenPinsHoldOn() {
    BOTH(hide);
}

/// A hidden pin is neither drawn nor picked, and the shape is held there to the last digit while another one
/// moves.
template <int Dim>
void TestPins::hide() {
    QVERIFY(open<Dim>());
    auto& canvas = Bar<Dim>::canvas(*m_f);
    const Vec<Dim> place = pin<Dim>(1);
    const auto mark = [&] {
        const QPointF away = at<Dim>(place) + QPoint(0, -150);
        QMouseEvent move(QEvent::MouseMove, away, canvas.mapToGlobal(away), Qt::NoButton, Qt::NoButton, {});
        QCoreApplication::sendEvent(&canvas, &move);
        const QRect around(at<Dim>(place) - QPoint(5, 5), QSize(11, 11));
        return canvas.grab().toImage().copy(around);
    };
    if (Dim == 2) QVERIFY(QTest::qWaitFor([&] { return m_f->window().canvas().isSettled(); }, 60000));
    const QImage drawn = mark();
    clickSign(*list().rowOf(1), PinList::Seen);
    QVERIFY(settle(session()) && traits(1).hidden);
    if (Dim == 2) {
        QVERIFY(QTest::qWaitFor([&] { return m_f->window().canvas().isSettled(); }, 60000));
        QVERIFY(mark() != drawn);
    }
    click<Dim>(at<Dim>(place));
    QVERIFY(session().selection().isEmpty());
    m_f->window().actions().selectAll->trigger();
    QCOMPARE(session().selection().handles(), (std::vector<int>{0, 2}));
    QVERIFY(drag<Dim>(2, {0, -60}));
    QVERIFY((pin<Dim>(1) - place).norm() < 1e-9 * session().motion().frame()->diagonal);
    pins().showAll->trigger();
    QVERIFY(settle(session()) && !traits(1).hidden && !pins().showAll->isEnabled());
    click<Dim>(at<Dim>(pin<Dim>(1)));
    QCOMPARE(session().selection().handles(), std::vector<int>{1});
}

void TestPins::groupsHaveAHeading() {
    BOTH(group);
}

/// A heading of the list selects, locks and hides all of its group, folds, and is renamed.
template <int Dim>
void TestPins::group() {
    QVERIFY(open<Dim>());
    QTreeWidget& tree = *list().list();
    QCOMPARE(tree.topLevelItemCount(), 3);
    session().selection().set({0, 2});
    // A name is offered; typing replaces it, and the typed name is kept.
    QStringList offered;
    const auto typed = [&](const QString& keys) {
        withNext<QInputDialog>(this, [&offered, keys](QInputDialog& dialog) {
            offered << dialog.textValue();
            QTest::keyClicks(dialog.findChild<QComboBox*>()->lineEdit(), keys);
            dialog.accept();
        });
        pins().group->trigger();
    };
    typed(QString());
    QVERIFY(list().headingOf(QStringLiteral("Group 1")));
    session().document().undoStack()->undo();
    typed(QStringLiteral("Ends"));
    QVERIFY(settle(session()));
    QCOMPARE(offered, (QStringList{QStringLiteral("Group 1"), QStringLiteral("Group 1")}));
    QCOMPARE(tree.topLevelItemCount(), 2);
    QTreeWidgetItem* heading = list().headingOf(QStringLiteral("Ends"));
    QVERIFY(heading && heading->childCount() == 2 && list().rowOf(2)->parent() == heading);
    session().selection().clear();
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {},
                      tree.visualItemRect(heading).center() - QPoint(20, 0));
    QCOMPARE(session().selection().handles(), (std::vector<int>{0, 2}));
    QVERIFY(list().rowOf(0)->isSelected() && list().rowOf(2)->isSelected() && !list().rowOf(1)->isSelected());
    clickSign(*heading, PinList::Lock);
    clickSign(*heading, PinList::Seen);
    QVERIFY(traits(0).locked && traits(2).locked && !traits(1).locked);
    QVERIFY(traits(0).hidden && traits(2).hidden && !traits(1).hidden);
    tree.setFocus();
    tree.setCurrentItem(list().rowOf(1));
    QCOMPARE(session().selection().handles(), std::vector<int>{1});
    QTest::keyClick(&tree, Qt::Key_Up);
    QTest::keyClick(&tree, Qt::Key_Up);
    QTest::keyClick(&tree, Qt::Key_Up);
    QCOMPARE(tree.currentItem(), heading);
    QCOMPARE(session().selection().handles(), (std::vector<int>{0, 2}));
    QTest::keyClick(&tree, Qt::Key_Left);
    QVERIFY(!heading->isExpanded() && heading->font(PinList::Name).bold());
    QTest::keyClick(&tree, Qt::Key_F2);
    auto* editor = tree.findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->setText(QStringLiteral("Tips"));
    QTest::keyClick(editor, Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return traits(0).group == "Tips"; }, 5000));
    QCOMPARE(traits(2).group, std::string("Tips"));
    heading = list().headingOf(QStringLiteral("Tips"));
    QVERIFY(heading);
    session().selection().set({0, 2});
    pins().ungroup->trigger();
    QCOMPARE(tree.topLevelItemCount(), 3);
    QVERIFY(!pins().ungroup->isEnabled());
}

void TestPins::linkedPinsMoveTogether() {
    BOTH(link);
}

/// One pin is dragged, and the linked one moves as far, in one undo step; the third stays.
template <int Dim>
void TestPins::link() {
    QVERIFY(open<Dim>());
    session().selection().set({0});
    QVERIFY(!pins().link->isEnabled());
    session().selection().set({0, 2});
    pins().link->trigger();
    QVERIFY(settle(session()) && traits(0).link == traits(2).link && traits(0).link > 0);
    std::vector<Vec<Dim>> before;
    for (int h = 0; h < 3; ++h) before.push_back(pin<Dim>(h));
    const std::string text = toJson(m_f->project());
    const int steps = session().document().undoStack()->count();
    QVERIFY(drag<Dim>(0, {12, -40}));
    QCOMPARE(session().document().undoStack()->count(), steps + 1);
    const Vec<Dim> by = pin<Dim>(0) - before[0];
    QVERIFY(by.norm() > 30 * Bar<Dim>::canvas(*m_f).pixelSize(inSpace(before[0])));
    QVERIFY((pin<Dim>(2) - before[2] - by).norm() < 1e-9 * session().motion().frame()->diagonal);
    QVERIFY((pin<Dim>(1) - before[1]).norm() < 1e-9 * session().motion().frame()->diagonal);
    m_f->window().actions().undo->trigger();
    QCOMPARE(toJson(m_f->project()), text);
    session().selection().set({0});
    QVERIFY(pins().link->isChecked());
    pins().link->trigger();
    QVERIFY(traits(0).link == 0 && traits(2).link == 0);  // one alone is no link
    QVERIFY(settle(session()) && drag<Dim>(0, {12, -40}));
    QVERIFY((pin<Dim>(2) - before[2]).norm() < 1e-9 * session().motion().frame()->diagonal);
}

void TestPins::mirrorImagesMoveAsInAMirror() {
    BOTH(mirror);
}

/// The bar is its own mirror image: a dragged pin left of the middle gets one at the right, which moves in
/// the opposite direction along the bar and in the same across it, and so does the shape.
template <int Dim>
void TestPins::mirror() {
    QVERIFY(open<Dim>());
    session().selection().set({2});
    m_f->window().actions().remove->trigger();
    QVERIFY(settle(session()) && session().pins().count() == 2);
    const Vec<Dim> rest = pin<Dim>(0);
    QVERIFY(drag<Dim>(0, {-10, -30}));
    const Vec<Dim> way = pin<Dim>(0) - rest;
    session().selection().set({0});
    pins().mirror->trigger();
    QVERIFY(settle(session()));
    QCOMPARE(session().pins().count(), 3);
    QCOMPARE(session().selection().handles(), std::vector<int>{2});
    const double middle = Bar<Dim>::place(0, 0).x(), pixel = Bar<Dim>::canvas(*m_f).pixelSize(inSpace(rest));
    Vec<Dim> expected = rest + way;
    expected.x() = 2 * middle - expected.x();
    QVERIFY2((pin<Dim>(2) - expected).norm() <
                 (Dim == 2 ? 0.01 * pixel : 0.02 * session().motion().frame()->diagonal),
             qPrintable(QString::number((pin<Dim>(2) - expected).norm() / pixel)));
    session().selection().set({0});
    const int steps = session().document().undoStack()->count();
    pins().mirror->trigger();  // there is one already
    QCOMPARE(session().document().undoStack()->count(), steps);
    pins().mirrorMotion->trigger();
    QVERIFY(settle(session()));
    Vec<Dim> other = way;
    other.x() = -other.x();
    QVERIFY((pin<Dim>(0) - rest - other).norm() < 0.01 * pixel);
    m_f->window().actions().undo->trigger();
    QVERIFY(settle(session()));
    QVERIFY((pin<Dim>(0) - rest - way).norm() < 0.01 * pixel);
}

void TestPins::allIsUndoneSavedAndReopened() {
    BOTH(keep);
}

template <int Dim>
void TestPins::keep() {
    QVERIFY(open<Dim>());
    const std::string plain = toJson(m_f->project());
    QUndoStack& undo = *session().document().undoStack();
    const int first = undo.index();
    const auto rest = session().motion().frame<Dim>()->rest;
    session().selection().set({0});
    pins().lock->trigger();
    session().selection().set({1});
    pins().hide->trigger();
    session().selection().set({0, 1});
    pins().link->trigger();
    withNext<QInputDialog>(this, [](QInputDialog& dialog) {
        dialog.setTextValue(QStringLiteral("Left"));
        dialog.accept();
    });
    pins().group->trigger();
    for (QAction* action : pins().menu()->actions())
        if (action->menu()) action->menu()->actions().at(1)->trigger();
    QVERIFY(settle(session()));
    QVERIFY(session().motion().frame<Dim>()->rest == rest);  // the shape does not depend on any of it
    QCOMPARE(undo.index(), first + 5);
    const std::string changed = toJson(m_f->project());
    undo.setIndex(first);
    QCOMPARE(toJson(m_f->project()), plain);
    undo.setIndex(first + 5);
    QCOMPARE(toJson(m_f->project()), changed);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("pins.wend"));
    session().document().save(path);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonArray handles = QJsonDocument::fromJson(file.readAll()).object()["handles"].toArray();
    QCOMPARE(handles[0].toObject()["locked"].toBool(), true);
    QCOMPARE(handles[1].toObject()["hidden"].toBool(), true);
    QCOMPARE(handles[0].toObject()["link"].toInt(), handles[1].toObject()["link"].toInt());
    QCOMPARE(handles[1].toObject()["group"].toString(), QStringLiteral("Left"));
    QCOMPARE(handles[0].toObject()["colour"].toString(), pinColours()[1].name());
    for (const char* key : {"locked", "hidden", "link", "group", "colour"})
        QVERIFY(!handles[2].toObject().contains(QLatin1String(key)));
    m_f->window().openPath(path);
    QVERIFY(QTest::qWaitFor([&] { return session().document().source() == path; }, 20000));
    QVERIFY(settle(session()));
    QVERIFY(traits(0).locked && traits(1).hidden && traits(1).link == traits(0).link &&
            traits(2) == PinTraits());
    QVERIFY(list().headingOf(QStringLiteral("Left")));
}

void TestPins::waysArePickedAndSnapIsAChoice() {
    BOTH(pick);
}

/// A click on a path selects its pin; new pins are placed at the click, or on a corner of the mesh.
template <int Dim>
void TestPins::pick() {
    QVERIFY(open<Dim>());
    const Vec<Dim> from = pin<Dim>(2);
    QVERIFY(drag<Dim>(2, {0, -80}));
    session().selection().clear();
    click<Dim>(at<Dim>((from + pin<Dim>(2)) / 2));
    QCOMPARE(session().selection().handles(), std::vector<int>{2});
    m_f->tool("pin")->trigger();
    QAction* snap = nullptr;
    for (QAction* action : m_f->window().findChild<QToolBar*>(QStringLiteral("optionRow"))->actions())
        if (action->text() == QStringLiteral("S&nap")) snap = action;
    QVERIFY(snap);
    QVERIFY(!snap->isChecked());
    for (const bool snaps : {true, false}) {
        snap->setChecked(snaps);
        const auto frame = session().motion().frame<Dim>();
        const Points<Dim> corners = frame->rest->points;
        const Vec<Dim> place = Bar<Dim>::place(snaps ? -1.1 : -0.7, 0.13);
        click<Dim>(at<Dim>(place));
        const auto& own = session().document().design().handles.back();
        const auto* points = std::get_if<std::vector<Vec3>>(&own.at);
        QVERIFY(points && points->size() == 1);
        const double nearest =
            (corners.colwise() - Vec<Dim>(points->front().template head<Dim>())).colwise().norm().minCoeff();
        QVERIFY2((nearest < 1e-9 * frame->diagonal) == snaps, qPrintable(QString::number(nearest)));
        QVERIFY(settle(session()));
    }
}

void TestPins::keysSetPins() {
    BOTH(setByKeys);
}

/// The cursor begins in the middle of the shape if nothing is selected, and moves five pixels with each
/// press.
template <int Dim>
void TestPins::setByKeys() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& canvas = Bar<Dim>::canvas(*m_f);
    m_f->tool("pin")->trigger();
    canvas.setFocus();
    QTest::keyClick(&canvas, Qt::Key_Right);
    for (int i = 0; i < 4; ++i) QTest::keyClick(&canvas, Qt::Key_Right, Qt::ShiftModifier);
    const QPointF middle = canvas.toWidget(Bar<Dim>::place(0, 0));
    QTest::keyClick(&canvas, Qt::Key_Return);
    QVERIFY(settle(session()));
    QCOMPARE(session().pins().count(), 1);
    const QPointF set = canvas.toWidget(pin<Dim>(0));
    QVERIFY2(QLineF(set, middle + QPointF(200, 0)).length() < (Dim == 2 ? 1.5 : 40),
             qPrintable(QString::number(QLineF(set, middle + QPointF(200, 0)).length())));
    QTest::keyClick(&canvas, Qt::Key_Escape);
    QVERIFY(session().selection().isEmpty());
    QTest::keyClick(&canvas, Qt::Key_Left);
    QTest::keyClick(&canvas, Qt::Key_Return);
    QVERIFY(settle(session()));
    if (Dim == 2) QCOMPARE(session().pins().count(), 1);  // within reach of the pin: it is selected
    QVERIFY(!session().selection().isEmpty());
    for (int i = 0; i < 8; ++i) {  // more than the list has room for: the new one is seen in it
        session().addPin(session().motion().frame()->vertex(7 * i));
        const QTreeWidget& rows = *list().list();
        QVERIFY(rows.viewport()->rect().contains(
            rows.visualItemRect(list().rowOf(session().pins().count() - 1))));
    }
}

void TestPins::marksAreAsLargeAsChosen() {
    BOTH(enlarge);
}

/// The size changes both the drawing and the hit area, at once and in the next window.
template <int Dim>
void TestPins::enlarge() {
    QVERIFY(open<Dim>());
    auto& canvas = Bar<Dim>::canvas(*m_f);
    const QPoint middle = at<Dim>(pin<Dim>(1));
    const auto lit = [&](int right) {  // the white rim of a pin that holds
        const QImage seen = m_f->window().grab().toImage();
        return seen.pixelColor(canvas.mapTo(&m_f->window(), middle + QPoint(right, 0))).lightness() > 235;
    };
    const auto picked = [&](int right) {
        session().selection().clear();
        click<Dim>(middle + QPoint(right, 0));
        const bool is = session().selection().contains(1);
        session().selection().clear();
        QTest::mouseMove(&canvas, QPoint(3, 3));
        QCoreApplication::processEvents();
        return is;
    };
    const auto choose = [&](double factor) {
        for (QAction* one : m_f->window().actions().markSizes->actions())
            if (one->data().toDouble() == factor) one->trigger();
    };
    QVERIFY(picked(5) && !picked(20));
    QVERIFY(!lit(19) && !lit(20));
    choose(3);
    QTRY_VERIFY(lit(19) || lit(20));
    QVERIFY(picked(20) && !picked(40));
    {
        MainWindow next;
        for (const QAction* one : next.actions().markSizes->actions())
            QCOMPARE(one->isChecked(), one->data().toDouble() == 3);
    }
    QVERIFY(picked(20));
    m_f->picture(QStringLiteral("large-marks-%1").arg(Dim));
    choose(1);
    QTRY_VERIFY(!lit(19) && !lit(20));
    QVERIFY(picked(5) && !picked(20));
}

namespace {

/// Returns the longest row of painted pixels.
int widest(const std::function<void(QPainter&)>& paint) {
    QImage image(900, 400, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    paint(painter);
    painter.end();
    int longest = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0, run = 0; x < image.width(); ++x) {
            run = qAlpha(image.pixel(x, y)) > 50 ? run + 1 : 0;
            longest = std::max(longest, run);
        }
    return longest;
}

}  // namespace

/// The field along x has an arrow of 15 pixels with round ends and a light rim of 3.5, and an ellipse of the
/// ratio 4, whose tips are narrower than a pixel.
void TestPins::fieldsAndLabelsAreAsLargeAsChosen() {
    QVERIFY(open<2>());
    ShapeCanvas& canvas = m_f->window().canvas();
    const auto frame = session().motion().frame<2>();
    Points2 velocity = Points2::Zero(2, frame->pose.cols());
    velocity.row(0).setConstant(0.5);
    velocity(0, 0) = 1;  // the fastest one's arrow is 30 long
    auto material = std::make_shared<Material<2>>(*frame->material);
    material->anisotropy.assign(frame->rest->cells.size(), anisotropyOf<2>({Vec3::UnitX(), 4}));
    auto painted = std::make_shared<PosedFrame<2>>(*frame);
    painted->material = material;
    canvas.showMaterial(painted, true);
    const double ellipse = 2 * (6 + 12 * std::log(4) / std::log(100));
    for (const double factor : {1.0, 2.0}) {
        setMarkSize(factor);
        const int arrow =
            widest([&](QPainter& p) { paintVelocityArrows(p, canvas, velocity, canvas.size()); });
        const int mark = widest([&](QPainter& p) { paintStiffnessMarks(p, canvas, canvas.size()); });
        const int label = widest([](QPainter& p) { paintLabel(p, {10, 10}, QStringLiteral("12 px")); });
        setMarkSize(1);
        const int once = widest([](QPainter& p) { paintLabel(p, {10, 10}, QStringLiteral("12 px")); });
        QVERIFY2(std::abs(arrow - factor * 18.5) <= 2, qPrintable(QString::number(arrow)));
        QVERIFY2(std::abs(mark - factor * (ellipse + 3.5)) <= 2, qPrintable(QString::number(mark)));
        QVERIFY2(std::abs(label - factor * once) <= 2, qPrintable(QString::number(label)));
    }
}

/// The arrows of a solid are a tenth of its diagonal long; of larger ones, and of larger ellipsoids, there
/// are no more.
void TestPins::glyphsAreAsLargeAsChosen() {
    QVERIFY(open<3>());
    const auto frame = session().motion().frame<3>();
    PosedFrame<3> stiff = *frame;
    auto material = std::make_shared<Material<3>>(*frame->material);
    material->anisotropy.assign(frame->rest->cells.size(), anisotropyOf<3>({Vec3::UnitX(), 4}));
    stiff.material = material;
    const CutSurface& surface = m_f->canvas().solid().surface();
    Points3 velocity = Points3::Zero(3, frame->pose.cols());
    velocity.row(2).setOnes();
    const auto height = [](const std::vector<DrawVertex>& drawn, std::size_t count) {
        float low = 1e9F, high = -1e9F;
        for (std::size_t i = 0; i < count; ++i)
            low = std::min(low, drawn[i].position[2]), high = std::max(high, drawn[i].position[2]);
        return double(high - low);
    };
    constexpr std::size_t kArrow = 3 * 8 * 6, kEllipsoid = 6 * 8 * 6;  // vertices
    std::size_t arrows = 0, ellipsoids = 0;
    double once = 0;
    for (const double factor : {1.0, 3.0}) {
        setMarkSize(factor);
        const auto arrow = velocityArrows(*frame, velocity, surface, 0);
        const auto ellipsoid = stiffnessEllipsoids(stiff, surface, 0);
        setMarkSize(1);
        QVERIFY(std::abs(height(arrow, kArrow) - factor * 0.1 * frame->diagonal) < 1e-3 * frame->diagonal);
        if (factor == 1) once = height(ellipsoid, kEllipsoid);
        QVERIFY(std::abs(height(ellipsoid, kEllipsoid) - factor * once) < 1e-3 * once);
        QVERIFY(factor == 1 || (arrow.size() <= arrows && ellipsoid.size() <= ellipsoids));
        arrows = arrow.size(), ellipsoids = ellipsoid.size();
    }
}

/// Their rim has the chosen width, half of it on either side.
void TestPins::brushesKeepTheirRadius() {
    QVERIFY(open<2>());
    Brush tip;
    PaintTool brush(m_f->window().canvas(), tip, PaintTool::Deed::Paint);
    const QPointF at(200, 200);
    QMouseEvent move(QEvent::MouseMove, at, at, Qt::NoButton, Qt::NoButton, {});
    brush.move(move);
    const auto across = [&](double x, double width) {  // the rim where it is upright
        return widest([&](QPainter& p) {
            p.setClipRect(QRectF(x - width, 195, 2 * width, 10));
            brush.paint(p);
        });
    };
    const double radius = tip.now().radius;
    for (const double factor : {1.0, 3.0}) {
        setMarkSize(factor);
        const int left = across(200 - radius, 10), inner = across(200 - radius + 5, 5);
        setMarkSize(1);
        QVERIFY2(std::abs(left - factor * 3.5) <= 1.5, qPrintable(QString::number(left)));
        QVERIFY2(std::abs(inner - factor * 1.75) <= 1.5, qPrintable(QString::number(inner)));
    }
}

QTEST_MAIN(TestPins)
#include "test_pins.moc"
