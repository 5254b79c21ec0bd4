#include <QComboBox>
#include <QLabel>
#include <QMimeData>
#include <QToolButton>

#include "app/panels/distortion_panel.h"
#include "app/panels/material_panel.h"
#include "app/project/design.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/material_edits.h"
#include "app/project/edits/setting_edits.h"
#include "app/project/options/settings.h"
#include "app/window/actions/look_choices.h"
#include "app/window/compare_view.h"
#include "core/energy/distortion.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

namespace {

/// The same bar as a cut-out and as a solid.
template <int Dim>
struct Bar;

template <>
struct Bar<2> {
    static bool open(SolidFixture& f) { return f.openPicture(); }
    static ShapeCanvas& canvas(SolidFixture& f) { return f.window().canvas(); }
    static ShapeCanvas& other(SolidFixture& f) { return f.window().compared().picture(); }
    static bool hold(SolidFixture& f) {
        f.session().addPin({40, 80, 0});
        f.session().addPin({200, 80, 0});
        f.window().actions().selectTool->trigger();
        return settle(f.session());
    }
    static Vec2 end() { return {200, 80}; }
    static Vec2 way() { return {-60, 30}; }
};

template <>
struct Bar<3> {
    static bool open(SolidFixture& f) { return f.open(300); }
    static SolidCanvas& canvas(SolidFixture& f) { return f.canvas(); }
    static SolidCanvas& other(SolidFixture& f) { return *f.window().compared().solid(); }
    static bool hold(SolidFixture& f) { return f.holdEnds(); }
    static Vec3 end() { return {2, 0, 0}; }
    static Vec3 way() { return {-1, 0, 0.7}; }
};

}  // namespace

/// Another energy is shown beside the shape, with the same handles.
class TestComparison : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void halvesGoTogether_data() { dimensions(); }
    void halvesGoTogether();
    void lateMovesDoNotLead_data() { dimensions(); }
    void lateMovesDoNotLead();
    void pinsAreDraggedInTheOtherHalf_data() { dimensions(); }
    void pinsAreDraggedInTheOtherHalf();
    void influenceIsThatOfTheSamePin_data() { dimensions(); }
    void influenceIsThatOfTheSamePin();
    void halvesShowTheSamePart();
    void tilesAreDropped();
    void tilesArePreviewed();
    void tilesShowTheShape_data() { dimensions(); }
    void tilesShowTheShape();
    void backdropLiesBehindBoth_data() { dimensions(); }
    void backdropLiesBehindBoth();
    void keysReturnToTheShape_data() { dimensions(); }
    void keysReturnToTheShape();
    void paintIsTakenAway_data() { dimensions(); }
    void paintIsTakenAway();
    void anotherFileEndsIt();

  private:
    static void dimensions();
    template <int Dim>
    void goTogether();
    template <int Dim>
    void dragInTheOther();
    template <int Dim>
    void showInfluence();
    template <int Dim>
    void moveLate();
    template <int Dim>
    void returnKeys();
    template <int Dim>
    void chooseBackdrop();
    template <int Dim>
    void takePaintAway();
    template <int Dim>
    bool begin();
    CompareView& view() { return m_f->window().compared(); }
    ShapeSession& other() { return view().comparison().other(); }
    EnergySlider& tiles() { return *m_f->window().properties().material().energySlider(); }
    QToolButton* tile(int i) {
        QToolButton* found = nullptr;
        for (auto* button : tiles().findChildren<QToolButton*>())
            if (button->text() == tiles().scale().stops().at(i).name) found = button;
        return found;
    }
    std::unique_ptr<SolidFixture> m_f;
};

#define BOTH(body)          \
    QFETCH(int, dimension); \
    if (dimension == 2)     \
        body<2>();          \
    else                    \
        body<3>()

void TestComparison::dimensions() {
    QTest::addColumn<int>("dimension");
    QTest::newRow("picture") << 2;
    QTest::newRow("solid") << 3;
}

void TestComparison::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

template <int Dim>
bool TestComparison::begin() {
    if (!Bar<Dim>::open(*m_f) || !Bar<Dim>::hold(*m_f)) return false;
    QTest::keyClick(&Bar<Dim>::canvas(*m_f), Qt::Key_Y);
    settleLayout(m_f->window());
    return view().isSplit() && settle(other());
}

void TestComparison::halvesGoTogether() {
    BOTH(goTogether);
}

/// The mouse drags both halves: live, after the release, in time, and undone; the other half equals the
/// document with that energy.
template <int Dim>
void TestComparison::goTogether() {
    QVERIFY(begin<Dim>());
    auto& session = m_f->session();
    QVERIFY(session.motion().template frame<Dim>()->rest->cells ==
            other().motion().template frame<Dim>()->rest->cells);
    auto& canvas = Bar<Dim>::canvas(*m_f);
    if constexpr (Dim == 3) canvas.look(Camera::Axis::Front);
    const QPoint from = canvas.toWidget(Bar<Dim>::end()).toPoint();
    const QPoint to = canvas.toWidget(Bar<Dim>::end() + Bar<Dim>::way()).toPoint();
    session.selection().set({1});
    QTest::mouseMove(&canvas, from);
    QTest::mousePress(&canvas, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 8; ++i) QTest::mouseMove(&canvas, from + (to - from) * i / 8);
    QVERIFY(session.motion().isDragging() && other().motion().isDragging());
    const auto hasCome = [&](ShapeSession& one) {
        const auto frame = one.motion().template frame<Dim>();
        return frame->live && (frame->pose - frame->rest->points).norm() > 0.1 * Bar<Dim>::way().norm();
    };
    QTRY_VERIFY_WITH_TIMEOUT(hasCome(session) && hasCome(other()), 60000);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, to);
    QVERIFY(!other().motion().isDragging());
    QVERIFY(settle(session) && settle(other()));
    QVERIFY(session.playback().end() > 0);
    QCOMPARE(other().motion().frame()->time, session.motion().frame()->time);
    const Points<Dim> own = session.motion().template frame<Dim>()->pose,
                      its = other().motion().template frame<Dim>()->pose;
    QVERIFY((own - its).cwiseAbs().maxCoeff() > 1e-3 * Bar<Dim>::way().norm());
    QVERIFY(std::abs(own.col(0).norm()) > 0);
    const QString totals = view().template findChild<QLabel*>("otherTotals")->text();
    QVERIFY(totals.contains(QLocale().toString(other().motion().frame()->distortion->totalAngle, 'f', 3)));
    QVERIFY(totals != view().template findChild<QLabel*>("ownTotals")->text());
    session.playback().setTime(session.playback().end() / 2);
    QVERIFY(settle(session) && settle(other()));
    QCOMPARE(other().playback().time(), session.playback().time());
    QVERIFY(other().motion().frame()->time < session.playback().end());
    session.playback().setTime(session.playback().end());
    // The other energy as that of the document, computed alone.
    const double phi = view().comparison().phi().value();
    view().join();
    QVERIFY(!view().comparison().isOn());
    const auto changed = copyOf(m_f->project());
    designOf(*changed).material.phi = phi;
    session.document().change("Energy", changed);
    QVERIFY(settle(session));
    QVERIFY((session.motion().template frame<Dim>()->pose - its).cwiseAbs().maxCoeff() <
            1e-9 * Bar<Dim>::way().norm());
}

void TestComparison::lateMovesDoNotLead() {
    BOTH(moveLate);
}

/// X refers to the pointer's place before the press, when the drag has begun long ago: no button is down
/// there.
template <int Dim>
void TestComparison::moveLate() {
    QVERIFY(Bar<Dim>::open(*m_f) && Bar<Dim>::hold(*m_f));
    auto& session = m_f->session();
    auto& canvas = Bar<Dim>::canvas(*m_f);
    if constexpr (Dim == 3) canvas.look(Camera::Axis::Front);
    const QPointF from = canvas.toWidget(Bar<Dim>::end()).toPoint();
    const QPoint to = from.toPoint() + QPoint(-30, 20);
    QTest::mousePress(&canvas, Qt::LeftButton, {}, from.toPoint());
    for (int i = 1; i <= 4; ++i) QTest::mouseMove(&canvas, from.toPoint() + (to - from.toPoint()) * i / 4);
    QVERIFY(session.motion().isDragging());
    const Amount amount = session.gestures().drag()->newest();
    const int samples = session.gestures().drag()->sampleCount();
    QVERIFY(amount.norm() > 0);
    QMouseEvent late(QEvent::MouseMove, from, canvas.mapToGlobal(from), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(&canvas, &late);
    QCOMPARE(session.gestures().drag()->newest(), amount);
    QCOMPARE(session.gestures().drag()->sampleCount(), samples);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, to);
    QVERIFY(settle(session));
}

void TestComparison::pinsAreDraggedInTheOtherHalf() {
    BOTH(dragInTheOther);
}

/// A drag in the other half is one drag of the document; beside the pins nothing is pressed.
template <int Dim>
void TestComparison::dragInTheOther() {
    QVERIFY(begin<Dim>());
    auto& session = m_f->session();
    auto &own = Bar<Dim>::canvas(*m_f), &canvas = Bar<Dim>::other(*m_f);
    if constexpr (Dim == 3) own.look(Camera::Axis::Front);
    QTRY_COMPARE(canvas.size(), own.size());
    const QPoint from = canvas.toWidget(Bar<Dim>::end()).toPoint();
    const QPoint to = canvas.toWidget(Bar<Dim>::end() + 0.5 * Bar<Dim>::way()).toPoint();
    const auto drag = [&](const QPoint& a, const QPoint& b) {
        QTest::mouseMove(&canvas, a);
        QTest::mousePress(&canvas, Qt::LeftButton, {}, a);
        for (int i = 1; i <= 4; ++i) QTest::mouseMove(&canvas, a + (b - a) * i / 4);
        const bool drags = session.motion().isDragging();
        QTest::mouseRelease(&canvas, Qt::LeftButton, {}, b);
        return drags;
    };
    session.selection().set({0});
    QVERIFY(!drag({12, 12}, {40, 40}));
    const int steps = session.document().undoStack()->count();
    QVERIFY(drag(from, to));
    QVERIFY(settle(session) && settle(other()));
    QCOMPARE(session.document().undoStack()->count(), steps + 1);
    QCOMPARE(session.selection().handles(), std::vector<int>{1});
    const auto pins = session.gestures().pins();
    const Vec<Dim> reached = pins[1].centre.template head<Dim>();
    QVERIFY((reached - Bar<Dim>::end() - 0.5 * Bar<Dim>::way()).norm() < 0.1 * Bar<Dim>::way().norm());
}

/// The drag also works in the other half, with nothing selected.
template <int Dim>
void TestComparison::showInfluence() {
    QVERIFY(begin<Dim>());
    m_f->session().selection().set({1});
    for (ShapeSession* session : {&m_f->session(), &other()}) {
        session->motion().setFieldWanted(ShapeMotion::FieldKind::Influence);
        QTRY_VERIFY(session->motion().influence().cols() > 0);
        const double least = session->motion().influence().row(0).minCoeff(),
                     most = session->motion().influence().row(0).maxCoeff();
        QVERIFY2(least < 0.1 && most > 0.9, qPrintable(QString("%1 %2").arg(least).arg(most)));
    }
    m_f->session().selection().clear();
    QCOMPARE(other().motion().influence().cols(), 0);
}

void TestComparison::influenceIsThatOfTheSamePin() {
    BOTH(showInfluence);
}

void TestComparison::halvesShowTheSamePart() {
    QVERIFY(begin<2>());
    auto &own = m_f->window().canvas(), &its = view().picture();
    QTRY_COMPARE(its.size(), own.size());
    QVERIFY(own.view() == its.view());
    QTest::keyClick(&own, Qt::Key_1);
    m_f->window().actions().zoomIn->trigger();
    QVERIFY(own.view() == its.view());
    // A view fitted to the bent shape stays fitted when the window is resized.
    m_f->session().selection().set({1});
    m_f->session().gestures().begin();
    m_f->session().gestures().moveBy({150, -200, 0}, 0);
    m_f->session().gestures().end(1);
    QVERIFY(settle(m_f->session()));
    m_f->window().actions().fit->trigger();
    const auto shows = [&](const ShapeCanvas& canvas) {
        const Points2& pose = m_f->session().motion().frame<2>()->pose;
        for (Eigen::Index v = 0; v < pose.cols(); ++v)
            if (!canvas.rect().contains(canvas.toWidget(pose.col(v)).toPoint())) return false;
        return true;
    };
    QVERIFY(shows(own));
    m_f->window().resize(m_f->window().width() - 160, m_f->window().height() - 60);
    settleLayout(m_f->window());
    QTRY_COMPARE(its.size(), own.size());
    QVERIFY(shows(own) && shows(its) && own.view() == its.view());
    // Maps have the same colours in both halves.
    m_f->window().actions().showMap->setChecked(true);
    const auto mapOf = [](const ShapeCanvas& canvas) {
        return canvas.shape().drawn() ? canvas.shape().drawn()->request : RenderRequest();
    };
    QTRY_VERIFY_WITH_TIMEOUT(mapOf(own).map && mapOf(its).map, 20000);
    QCOMPARE(mapOf(its).colours.range.high, mapOf(own).colours.range.high);
    QTest::keyClick(&own, Qt::Key_Y);
    QVERIFY(!view().isSplit() && !its.isVisible());
}

/// The event is that of Qt when a tile is dragged to the shape; beside the shape nothing happens.
void TestComparison::tilesAreDropped() {
    QVERIFY(m_f->openPicture());
    QMimeData data;
    const double phi = tiles().scale().stops()[2].phi;
    data.setData("application/x-wend-energy", QByteArray::number(phi, 'g', 17));
    QCOMPARE(EnergySlider::phiIn(&data), std::optional<double>(phi));
    const auto drop = [&](const QPoint& at) {
        QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&m_f->window(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&m_f->window(), &event);
    };
    drop(tiles().mapTo(&m_f->window(), tiles().rect().center()));
    QVERIFY(!view().isSplit());
    drop(m_f->window().canvas().mapTo(&m_f->window(), m_f->window().canvas().rect().center()));
    QVERIFY(view().isSplit());
    QCOMPARE(view().comparison().phi(), std::optional(phi));
    auto* energy = view().findChild<QComboBox*>("comparedEnergy");
    QCOMPARE(energy->currentText(), tiles().scale().stops()[2].name);
    QVERIFY(settle(other()));
    energy->setFocus();
    QTest::keyClick(energy, Qt::Key_Down);
    QCOMPARE(view().comparison().phi(), std::optional(tiles().scale().stops()[3].phi));
    QTest::mouseClick(view().findChild<QToolButton*>("endComparison"), Qt::LeftButton);
    QVERIFY(!view().isSplit() && !m_f->window().actions().compare->isChecked());
}

void TestComparison::tilesArePreviewed() {
    QVERIFY(m_f->openPicture() && Bar<2>::hold(*m_f));
    m_f->session().gestures().nudge({-60, 30, 0});
    QVERIFY(settle(m_f->session()));
    const auto& canvas = m_f->window().canvas();
    const auto before = m_f->session().document().project();
    const auto isOwn = [&] {
        return canvas.shape().drawn() &&
               canvas.shape().drawn()->request.frame == m_f->session().motion().frame<2>();
    };
    QTRY_VERIFY_WITH_TIMEOUT(isOwn(), 20000);
    QTest::mouseMove(tile(3), tile(3)->rect().center());
    QEnterEvent enter(QPointF(5, 5), QPointF(5, 5), QPointF(5, 5));
    QApplication::sendEvent(tile(3), &enter);
    QTRY_VERIFY_WITH_TIMEOUT(!isOwn() && canvas.shape().drawn()->request.frame == other().motion().frame<2>(),
                             60000);
    QVERIFY((other().motion().frame<2>()->pose - m_f->session().motion().frame<2>()->pose).norm() > 1);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(tile(3), &leave);
    QTRY_VERIFY_WITH_TIMEOUT(isOwn(), 20000);
    QVERIFY(m_f->session().document().project() == before && !view().isSplit());
}

/// The tiles show samples while nothing moves, then the effect of each energy on this picture.
void TestComparison::tilesShowTheShape() {
    QFETCH(int, dimension);
    const bool solid = dimension == 3;
    QVERIFY(solid ? Bar<3>::open(*m_f) : m_f->openPicture());
    const auto picture = [&](int i) { return tile(i)->icon().pixmap(EnergySlider::pictureSize()).toImage(); };
    const QImage sample = picture(1);
    QVERIFY(solid ? Bar<3>::hold(*m_f) : Bar<2>::hold(*m_f));
    solid ? m_f->session().gestures().nudge({-1, 0, 0.7}) : m_f->session().gestures().nudge({-100, 40, 0});
    QVERIFY(settle(m_f->session()));
    auto* made = tiles().findChild<TilePictures*>();
    QTRY_VERIFY_WITH_TIMEOUT(made->isDone(), 60000);
    QVERIFY(picture(1) != sample);
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < i; ++k) QVERIFY(picture(i) != picture(k));
    const QImage bent = picture(1);
    m_f->session().playback().setTime(0.5 * m_f->session().playback().end());
    QVERIFY(!made->isDone() && picture(1) != bent);  // faint until it is there
    QTRY_VERIFY_WITH_TIMEOUT(made->isDone(), 60000);
    while (m_f->window().actions().undo->isEnabled()) m_f->window().actions().undo->trigger();
    QVERIFY(settle(m_f->session()));
    QCOMPARE(picture(1), sample);
}

/// The backdrop is behind both halves, and is the same on another day.
void TestComparison::backdropLiesBehindBoth() {
    BOTH(chooseBackdrop);
}

template <int Dim>
void TestComparison::chooseBackdrop() {
    QVERIFY(begin<Dim>());
    const auto behind = [](QWidget& view) {
        QPoint place(6, 6);  // beside the solid; of a picture in a corner that is transparent
        if constexpr (Dim == 2) place = static_cast<ShapeCanvas&>(view).toWidget({4, 4}).toPoint();
        return view.grab().toImage().pixelColor(place);
    };
    auto &own = Bar<Dim>::canvas(*m_f), &its = Bar<Dim>::other(*m_f);
    BackdropChoice& choice = *m_f->window().actions().backdrop;
    const auto choices = choice.menu()->actions();
    QVERIFY(choices[0]->isChecked() && !choice.colour().isValid());
    const QColor usual = behind(own);
    for (const auto& [index, colour] : {std::pair{1, QColor(Qt::white)}, {3, QColor(Qt::black)}}) {
        choices[index]->trigger();
        QCOMPARE(behind(own), colour);
        QCOMPARE(behind(its), colour);
        QCOMPARE(BackdropChoice(nullptr).colour(), colour);
    }
    choices[0]->trigger();
    QCOMPARE(behind(own), usual);
}

/// The keyboard returns to the half that is in use.
void TestComparison::keysReturnToTheShape() {
    BOTH(returnKeys);
}

template <int Dim>
void TestComparison::returnKeys() {
    QVERIFY(begin<Dim>());
    auto &own = Bar<Dim>::canvas(*m_f), &its = Bar<Dim>::other(*m_f);
    its.setFocus();
    QVERIFY(its.hasFocus());
    QTest::keyClick(&its, Qt::Key_Y);
    QVERIFY(!view().isSplit());
    QVERIFY(own.hasFocus());
}

void TestComparison::paintIsTakenAway() {
    BOTH(takePaintAway);
}

/// The other half shows the shape as it was before painting, with the same energy, even if that changes.
template <int Dim>
void TestComparison::takePaintAway() {
    QVERIFY(begin<Dim>());
    auto* choice = view().findChild<QComboBox*>("comparedEnergy");
    const QString unpainted = CompareView::tr("Nothing painted");
    QCOMPARE(choice->findText(unpainted), -1);
    ShapeSession& session = m_f->session();
    session.selection().set({1});
    session.gestures().nudge(inSpace(Bar<Dim>::way()));
    QVERIFY(settle(session));
    const Points<Dim> before = session.motion().template frame<Dim>()->pose;
    MaterialRegion stiff;
    stiff.shape = HalfSpace<3>{Vec3::Zero(), Vec3::Unit(1)};
    stiff.stiffness = Stiffness{Vec3::Unit(0), 300};
    const auto project = copyOf(*session.document().project());
    Design design = session.document().design();
    design.material.layers.push_back({"Stiff", {stiff}});
    designOf(*project) = design;
    session.document().change(QStringLiteral("paint"), project);
    QCOMPARE(choice->itemText(choice->count() - 1), unpainted);
    choice->setFocus();
    while (choice->currentIndex() + 1 < choice->count()) QTest::keyClick(choice, Qt::Key_Down);
    QVERIFY(settle(session) && settle(other()));
    QVERIFY(!view().comparison().phi());
    QVERIFY(other().motion().template frame<Dim>()->pose == before);
    QVERIFY((session.motion().template frame<Dim>()->pose - before).norm() > 1e-3 * before.norm());
    const double angle = tiles().scale().stops()[3].phi;
    changeSetting(session.document(), "material.phi", angle);
    QVERIFY(settle(session) && settle(other()));
    QCOMPARE(settingOf(*other().document().project(), "material.phi"), angle);
    QCOMPARE(choice->currentText(), unpainted);
}

void TestComparison::anotherFileEndsIt() {
    QVERIFY(begin<2>());
    m_f->session().document().close();
    QVERIFY(!view().isSplit() && !view().picture().isVisible());
    QVERIFY(other().document().isEmpty());
}

QTEST_MAIN(TestComparison)
#include "test_comparison.moc"
