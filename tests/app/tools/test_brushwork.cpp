#include <QAction>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolBar>
#include <QUndoStack>

#include "app/panels/distortion_panel.h"
#include "app/panels/layer_panel.h"
#include "app/project/design.h"
#include "app/project/edits/material_edits.h"
#include "tests/support/paint_test.h"

using namespace wend;
using namespace wend::test;

/// The layers that strokes make or join; the brush used by keys alone and in the row of options.
class TestBrushwork : public PaintTest {
    Q_OBJECT
  private slots:
    void init() { begin(); }
    void cleanup() { m_f.reset(); }
    void strokesJoinTheirLayer_data() { dimensions(); }
    void strokesJoinTheirLayer();
    void stepsNameThePlace_data() { dimensions(); }
    void stepsNameThePlace();
    void noStiffnessIsNoLayer_data() { dimensions(); }
    void noStiffnessIsNoLayer();
    void keysAlonePaint_data() { dimensions(); }
    void keysAlonePaint();
    void keysAloneBlend_data() { dimensions(); }
    void keysAloneBlend();
    void optionsHoldTheBrush_data() { dimensions(); }
    void optionsHoldTheBrush();
    void valuesOfLayersAreLabelled_data() { dimensions(); }
    void valuesOfLayersAreLabelled();
    void layersAreMerged_data() { dimensions(); }
    void layersAreMerged();
    void mapComesBack();

  private:
    template <int Dim>
    void joinLayers();
    template <int Dim>
    void namePlaces();
    template <int Dim>
    void paintNothing();
    template <int Dim>
    void paintByKeys();
    template <int Dim>
    void blendByKeys();
    template <int Dim>
    void showOptions();
    template <int Dim>
    void labelValues();
    template <int Dim>
    void merge();
};

void TestBrushwork::strokesJoinTheirLayer() {
    BOTH(joinLayers);
}

/// A stroke joins the chosen layer if that has the painted value, wherever it is; another value makes another
/// layer, which is then chosen. Each stroke is a step.
template <int Dim>
void TestBrushwork::joinLayers() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    m_f->tool("paint")->trigger();
    const int first = steps();
    set([](BrushSettings& b) { b.phi = phi::kAkvf, b.radius = 20, b.amount = 0.5; });
    stroke<Dim>({-1.5, 0}, {-1, 0});
    stroke<Dim>({-0.5, 0}, {0, 0});
    QVERIFY(settle(session));
    QVERIFY(layers() == std::vector<std::string>{"Rigid 1"});
    QVERIFY(list()->currentRow() == 0 && steps() == first + 2);
    set([](BrushSettings& b) { b.target = BrushTarget::Stiffness, b.ratio = 8, b.amount = 1; });
    stroke<Dim>({0.5, 0}, {1, 0});
    stroke<Dim>({0.5, 0.2}, {1, 0.2});
    set([](BrushSettings& b) { b.target = BrushTarget::Direction; });
    stroke<Dim>({1.5, 0}, {1.2, 0});
    QVERIFY(settle(session));
    const std::vector<std::string> three{"Rigid 1", "Stiff 1", "Combed 1"};
    QVERIFY(layers() == three && list()->currentRow() == 0);
    // The stroke joins a layer further down, beneath the others.
    set([](BrushSettings& b) { b.target = BrushTarget::Keep, b.phi = phi::kEquia; });
    stroke<Dim>({0, 0}, {0, 0});
    set([](BrushSettings& b) { b.phi = phi::kMetr; });
    stroke<Dim>({0, 0.2}, {0, 0.2});
    QVERIFY(settle(session));
    const std::size_t count = regions<Dim>().size();
    list()->setCurrentRow(1);
    QCOMPARE(list()->currentItem()->text(), Dim == 3 ? QStringLiteral("Volume 1") : QStringLiteral("Area 1"));
    set([](BrushSettings& b) { b.phi = phi::kEquia; });
    stroke<Dim>({0, 0.2}, {0, 0.2});
    QVERIFY(settle(session));
    QVERIFY(regions<Dim>().size() == count + 1 && layers().size() == 5);
    QCOMPARE(regions<Dim>()[count - 1].phi, std::optional(phi::kEquia));
    QCOMPARE(regions<Dim>()[count].phi, std::optional(phi::kMetr));  // still on top
    QVERIFY(phis<Dim>()[cellAt<Dim>(0)] != phi::kMetr || Dim == 3);
    QVERIFY(undo() && regions<Dim>().size() == count);
    // With another value chosen the stroke makes a new layer; with none, it joins the topmost if that has the
    // painted value.
    set([](BrushSettings& b) { b.phi = phi::conformal(Dim); });
    stroke<Dim>({-1, 0.2}, {-1, 0.2});
    list()->setCurrentRow(-1);
    stroke<Dim>({-1, -0.2}, {-1, -0.2});
    QVERIFY(settle(session));
    QVERIFY(layers().size() == 6 && layers().back() == "Angle 1");
    QCOMPARE(list()->currentRow(), 0);
    list()->item(0)->setCheckState(Qt::Unchecked);  // nobody would see it
    stroke<Dim>({-1, -0.2}, {-1, -0.2});
    QVERIFY(settle(session) && layers().back() == "Angle 2");
}

void TestBrushwork::stepsNameThePlace() {
    BOTH(namePlaces);
}

/// A layer is named after a pin nearby or by the user, not after the file.
template <int Dim>
void TestBrushwork::namePlaces() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    const auto next = copyOf(m_f->project());
    Pin neck;
    neck.name = "Neck";
    neck.at = std::vector<Vec3>{inSpace(Bar<Dim>::place(-1.5, 0))};
    designOf(*next).handles.push_back(neck);
    session.document().change(QStringLiteral("Pin"), next);
    QVERIFY(settle(session));
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.phi = phi::kAkvf, b.radius = Dim == 3 ? 60 : 20; });
    const auto step = [&](double u, Qt::KeyboardModifiers modifiers = {}) {
        stroke<Dim>({u, 0}, {u, 0}, modifiers);
        return undoText().mid(undoText().indexOf(' ') + 1).remove('&');
    };
    QVERIFY(step(-1.2).endsWith(QStringLiteral("Paint Rigid on Neck")));
    QVERIFY(step(1.2).endsWith(QStringLiteral("Paint Rigid")));
    QVERIFY(step(-1.2, Qt::ControlModifier).endsWith(QStringLiteral("Erase paint from Neck")));
    list()->item(0)->setText(QStringLiteral("Wing"));
    QVERIFY(settle(session));
    QVERIFY(step(1).endsWith(QStringLiteral("Paint Rigid on Wing")));
    QVERIFY(layers() == std::vector<std::string>{"Wing"});
}

void TestBrushwork::noStiffnessIsNoLayer() {
    BOTH(paintNothing);
}

/// The effect is shown before and after; over a stiff part the stroke does reduce the stiffness.
template <int Dim>
void TestBrushwork::paintNothing() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.target = BrushTarget::Stiffness, b.ratio = 1; });
    QVERIFY(Bar<Dim>::canvas(*m_f).viewport().tool()->hint().contains(QStringLiteral("×1")));
    QSignalSpy told(&session.document(), &Document::notice);
    const int before = steps();
    for (const char* tool : {"paint", "fill", "gradient"}) {
        m_f->tool(tool)->trigger();
        stroke<Dim>({-1, 0}, {1, 0});
    }
    QVERIFY(steps() == before && layers().empty());
    QCOMPARE(told.count(), 3);
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.ratio = 9; });
    stroke<Dim>({-1, 0}, {1, 0});
    QVERIFY(settle(session));
    set([](BrushSettings& b) { b.ratio = 1, b.radius = 120, b.hardness = 1; });
    stroke<Dim>({-1, 0}, {1, 0});
    QVERIFY(settle(session) && layers().size() == 2);
    QVERIFY(session.motion().frame<Dim>()->material->anisotropy[cellAt<Dim>(0)].isIdentity(1e-9));
}

void TestBrushwork::keysAlonePaint() {
    BOTH(paintByKeys);
}

/// A stroke by keys starts in the middle of the shape; with Shift it is a line from the last place; a fill
/// works likewise.
template <int Dim>
void TestBrushwork::paintByKeys() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    auto& canvas = Bar<Dim>::canvas(*m_f);
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.phi = phi::kAkvf, b.radius = 20; });
    canvas.setFocus();
    QTest::keyClick(&canvas, Qt::Key_Return);  // nothing shows where yet
    QVERIFY(regions<Dim>().empty());
    QTest::keyClick(&canvas, Qt::Key_Left);
    QTest::keyClick(&canvas, Qt::Key_Return);
    QCOMPARE(regions<Dim>().size(), std::size_t(1));
    const Vec<Dim> start = std::get<Ball<Dim>>(regionIn<Dim>(regions<Dim>()[0].shape)).centre;
    const double pixel = canvas.pixelSize(inSpace(start));
    QVERIFY((start - Bar<Dim>::place(0, 0)).norm() < 3 * pixel);
    const int before = steps();
    QTest::keyClick(&canvas, Qt::Key_Right, Qt::ShiftModifier);
    QTest::keyClick(&canvas, Qt::Key_Right, Qt::ShiftModifier);
    QTest::keyClick(&canvas, Qt::Key_Return, Qt::ShiftModifier);
    QVERIFY(settle(session));
    QVERIFY(steps() == before + 1 && layers().size() == 1 && regions<Dim>().size() > 10);
    const Vec<Dim> end = std::get<Ball<Dim>>(regionIn<Dim>(regions<Dim>().back().shape)).centre;
    QVERIFY(std::abs((end - start).x() - 100 * pixel) < 7 * pixel && (end - start).norm() < 107 * pixel);
    m_f->tool("fill")->trigger();
    set([](BrushSettings& b) { b.phi = phi::kEquia; });
    QTest::keyClick(&canvas, Qt::Key_Up);
    QTest::keyClick(&canvas, Qt::Key_Enter, Qt::KeypadModifier);
    QVERIFY(settle(session));
    QVERIFY(std::ranges::all_of(phis<Dim>(), [](double one) { return std::abs(one - phi::kEquia) < 1e-12; }));
}

void TestBrushwork::keysAloneBlend() {
    BOTH(blendByKeys);
}

/// Enter takes hold of an end, arrows move it, Enter releases it, for a new gradient and for an existing one.
/// Escape and the mouse cancel it.
template <int Dim>
void TestBrushwork::blendByKeys() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& canvas = Bar<Dim>::canvas(*m_f);
    m_f->tool("gradient")->trigger();
    set([](BrushSettings& b) { b.phi = phi::kAkvf; });
    canvas.setFocus();
    const auto keys = [&canvas](const QList<int>& all) {
        for (const int key : all)
            QTest::keyClick(&canvas, static_cast<Qt::Key>(key),
                            key >= Qt::Key_Left && key <= Qt::Key_Down ? Qt::ShiftModifier : Qt::NoModifier);
    };
    const auto blend = [&] { return std::get<Blend<Dim>>(regionIn<Dim>(regions<Dim>().back().shape)); };
    keys({Qt::Key_Right, Qt::Key_Return, Qt::Key_Right, Qt::Key_Escape, Qt::Key_Return});
    QVERIFY(regions<Dim>().empty());  // the last one has begun another
    QTest::mouseMove(&canvas, canvas.toWidget(Bar<Dim>::place(0.5, 0)).toPoint());
    QVERIFY(regions<Dim>().empty());
    const int before = steps();
    keys({Qt::Key_Right, Qt::Key_Return, Qt::Key_Right, Qt::Key_Right, Qt::Key_Up});
    QVERIFY(regions<Dim>().empty());
    keys({Qt::Key_Return});
    QVERIFY(settle(m_f->session()));
    QCOMPARE(steps(), before + 1);
    const Vec<Dim> from = blend().from, way = blend().to - from;
    const double step = 50 * canvas.pixelSize(inSpace(from));
    QVERIFY((from - Bar<Dim>::place(0, 0)).norm() < 0.1 * step);
    QVERIFY2(
        std::abs(way.x() - 2 * step) < 0.1 * step && std::abs(way.norm() - std::sqrt(5) * step) < 0.2 * step,
        qPrintable(QString("%1 %2").arg(way.x() / step).arg(way.norm() / step)));
    keys({Qt::Key_Return, Qt::Key_Down, Qt::Key_Return});  // where the cross is: its end
    QVERIFY(settle(m_f->session()));
    QCOMPARE(regions<Dim>().size(), std::size_t(1));
    const Vec<Dim> after = blend().to - blend().from;
    QVERIFY(blend().from == from && std::abs(after.norm() - 2 * step) < 0.2 * step);
}

void TestBrushwork::optionsHoldTheBrush() {
    BOTH(showOptions);
}

/// The row shows the value, the size and the hardness, as far as a tool has them.
template <int Dim>
void TestBrushwork::showOptions() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& canvas = Bar<Dim>::canvas(*m_f);
    const auto* row = m_f->window().template findChild<QToolBar*>(QStringLiteral("optionRow"));
    const auto field = [&](const QString& name) -> QSpinBox* {
        for (auto* box : row->findChildren<QSpinBox*>())
            if (box->accessibleName() == name && box->isVisible()) return box;
        return nullptr;
    };
    std::vector<const char*> tools{"paint", "comb", "eraser", "sizes"};
    if (Dim == 2) tools.push_back("depth");
    for (const char* tool : tools) {
        m_f->tool(tool)->trigger();
        QCoreApplication::processEvents();
        QVERIFY2(field("Size"), tool);
        const bool paints = tool != std::string("sizes") && tool != std::string("depth");
        QCOMPARE(field("Hardness") && field("Amount"), paints);
        field("Size")->setValue(100);
        QCOMPARE(brush().now().radius, 50.0);
        canvas.setFocus();
        QTest::keyClick(&canvas, Qt::Key_BracketLeft);
        QCOMPARE(field("Size")->value(), 80);
    }
    m_f->tool("paint")->trigger();
    QTRY_VERIFY(field("Hardness") && field("Amount"));
    field("Hardness")->setValue(30);
    field("Amount")->setValue(40);
    QVERIFY(brush().now().hardness == 0.3 && brush().now().amount == 0.4);
    for (QAction* action : row->actions())
        if (action->text().remove('&') == QStringLiteral("Direction")) action->trigger();
    QVERIFY(brush().now().target == BrushTarget::Direction && m_f->tool("comb")->isChecked());
}

void TestBrushwork::valuesOfLayersAreLabelled() {
    BOTH(labelValues);
}

template <int Dim>
void TestBrushwork::labelValues() {
    QVERIFY(Bar<Dim>::open(*m_f));
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.phi = phi::kAkvf, b.radius = 37, b.hardness = 0.57; });
    stroke<Dim>({-1, 0}, {0, 0});
    QVERIFY(settle(m_f->session()));
    auto& panel = m_f->window().properties().layers();
    const auto* feather = panel.findChild<QDoubleSpinBox*>(QStringLiteral("layerFeather"));
    QVERIFY(feather->isVisible());
    QCOMPARE(feather->suffix(), Dim == 2 ? QStringLiteral(" px") : QString());
    QVERIFY2(feather->cleanText().remove('.').remove(QRegularExpression("^0*")).size() <= 4,
             qPrintable(feather->cleanText()));
    QCOMPARE(feather->value(), regions<Dim>().back().feather);
    std::vector<QDoubleSpinBox*> axis;
    for (auto* box : panel.findChildren<QDoubleSpinBox*>())
        if (box->accessibleName() == QStringLiteral("Stiff direction") && box->isVisible())
            axis.push_back(box);
    QCOMPARE(axis.size(), std::size_t(Dim));
    const auto labels = panel.findChildren<QLabel*>();
    QVERIFY(std::ranges::any_of(labels,
                                [](const QLabel* l) { return l->isVisible() && l->text() == "Direction"; }));
    for (const auto* box : axis) QCOMPARE(box->visibleRegion().boundingRect().width(), box->width());
    for (const auto* box : axis) QVERIFY(!box->isEnabled() && box->toolTip().contains(QStringLiteral("×1")));
    panel.findChild<QDoubleSpinBox*>(QStringLiteral("layerRatio"))->setValue(5);
    for (const auto* box : axis) QVERIFY(box->isEnabled() && !box->toolTip().contains(QStringLiteral("×1")));
    QCOMPARE(regions<Dim>().back().feather, feather->value());
}

void TestBrushwork::layersAreMerged() {
    BOTH(merge);
}

/// Layers are merged only where that leaves the shape as it was.
template <int Dim>
void TestBrushwork::merge() {
    QVERIFY(Bar<Dim>::open(*m_f));
    m_f->tool("paint")->trigger();
    auto* merge =
        m_f->window().properties().layers().template findChild<QAction*>(QStringLiteral("layerMerge"));
    set([](BrushSettings& b) { b.phi = phi::kAkvf, b.radius = 40; });
    stroke<Dim>({-1, 0}, {0, 0});
    QVERIFY(settle(m_f->session()) && !merge->isEnabled());
    QCOMPARE(merge->statusTip(), QStringLiteral("There is no layer below it."));
    set([](BrushSettings& b) { b.phi = phi::kEquia; });
    stroke<Dim>({-0.5, 0}, {1, 0});
    QVERIFY(settle(m_f->session()) && merge->isEnabled());
    const auto before = phis<Dim>();
    merge->trigger();
    QVERIFY(settle(m_f->session()) && layers() == std::vector<std::string>{"Rigid 1"});
    QVERIFY(phis<Dim>() == before);
    QVERIFY(undo() && layers().size() == 2 && phis<Dim>() == before);
    m_f->tool("eraser")->trigger();
    stroke<Dim>({0, 0}, {0, 0});
    list()->setCurrentRow(0);
    QVERIFY(settle(m_f->session()) && layers().size() == 2 && !merge->isEnabled());
    QVERIFY2(merge->statusTip().contains(QStringLiteral("erases")), qPrintable(merge->statusTip()));
    // The menu of a layer has the remaining commands.
    const auto entry = [this](const char* name) {
        return list()->template findChild<QAction*>(QLatin1String(name));
    };
    entry("layerRename")->trigger();
    QVERIFY(list()->findChild<QLineEdit*>());
    QTest::keyClick(list()->findChild<QLineEdit*>(), Qt::Key_Escape);
    entry("layerTakeAway")->trigger();
    QVERIFY(settle(m_f->session()) && layers().size() == 1);
}

/// Leaving the step restores the previous map, also if the map was switched off or another file was opened.
void TestBrushwork::mapComesBack() {
    QVERIFY(m_f->openPicture());
    auto& map = m_f->window().properties().distortion();
    QAction* shown = m_f->window().actions().showMap;
    map.setMeasure(Measure::Length);
    for (const bool switchesOff : {false, true}) {
        m_f->tool("paint")->trigger();
        QVERIFY(map.measure() == Measure::Phi && shown->isChecked());
        if (switchesOff) shown->trigger();
        m_f->tool("pin")->trigger();
        QVERIFY(map.measure() == Measure::Length && !shown->isChecked());
    }
    m_f->tool("paint")->trigger();
    shown->trigger();
    m_f->session().document().undoStack()->setClean();  // nothing is asked
    QVERIFY(m_f->openProject(3, 300));
    QVERIFY(map.measure() == Measure::Length && !shown->isChecked());
}

QTEST_MAIN(TestBrushwork)
#include "test_brushwork.moc"
