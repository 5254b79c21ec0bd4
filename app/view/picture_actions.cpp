#include "app/view/picture_actions.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>
#include <QWidgetAction>
#include <cmath>

#include "app/panels/panel_parts.h"

namespace wend {

PictureActions::PictureActions(Brush& brush, QObject* parent) : ActionMaker(parent) {
    adds =
        addToggle({tr("&Add"), tr("What is drawn shall bend, too; with Ctrl it is taken away")}, {}, "add");
    takesAway = addToggle({tr("&Take Away"), tr("What is drawn shall not bend; with Ctrl it is added")}, {},
                          "take-away");
    auto* group = new QActionGroup(this);
    group->addAction(adds);
    group->addAction(takesAway);
    size = number(tr("Size"), tr("How wide the brush is, on the screen; also [ and ]"), m_size, tr(" px"));
    m_size->setRange(static_cast<int>(2 * OutlinePen::kSmallest), static_cast<int>(2 * OutlinePen::kLargest));
    tolerance = number(tr("Tolerance"),
                       tr("How far colours may be apart, of what was clicked last too; also [ and ]"),
                       m_tolerance, tr(" %"));
    m_tolerance->setRange(1, 100);
    makeBrushes();
    makeSwitches(brush);
    const auto set = [this](auto change) {
        OutlineSettings next = m_pen.now();
        change(next);
        m_pen.set(next);
    };
    connect(takesAway, &QAction::toggled, this, [set](bool on) { set([on](auto& s) { s.takesAway = on; }); });
    connect(m_size, &QSpinBox::valueChanged, this,
            [set](int px) { set([px](auto& s) { s.radius = px / 2.0; }); });
    connect(m_tolerance, &QSpinBox::valueChanged, this,
            [set](int percent) { set([percent](auto& s) { s.tolerance = percent / 100.0; }); });
    connect(&m_pen, &OutlinePen::changed, this, &PictureActions::showPen);
    showPen();
}

void PictureActions::makeSwitches(Brush& brush) {
    snap =
        addToggle({tr("S&nap"), tr("New pins sit on corners of the mesh, instead of where one clicks")}, {});
    pressure = addToggle(
        {tr("&Pressure"), tr("The harder a pen is pressed, the more of the amount is painted")}, {});
    pressure->setObjectName(QStringLiteral("pressure"));
    pressure->setChecked(brush.now().pressure);
    connect(pressure, &QAction::toggled, &brush, [&brush](bool on) {
        BrushSettings next = brush.now();
        next.pressure = on;
        brush.set(next);
    });
    connect(&brush, &Brush::changed, this, [this, &brush] { pressure->setChecked(brush.now().pressure); });
}

void PictureActions::makeBrushes() {
    QSpinBox *orders = nullptr, *lengths = nullptr;
    order = number(tr("Order"),
                   tr("What is brushed lies in front where it is greater than 0, behind where it is less"),
                   orders, {});
    orders->setRange(-99, 99);
    orders->setValue(static_cast<int>(m_depth.now()));
    edges =
        number(tr("Edges"), tr("How long the edges of the mesh are where it is brushed, of those elsewhere"),
               lengths, tr(" %"));
    lengths->setRange(10, 400);
    lengths->setSingleStep(10);
    lengths->setValue(static_cast<int>(100 * m_fineness.now()));
    connect(orders, &QSpinBox::valueChanged, this, [this](int value) { m_depth.set(value); });
    connect(lengths, &QSpinBox::valueChanged, this, [this](int percent) { m_fineness.set(percent / 100.0); });
}

QWidgetAction* PictureActions::number(const QString& name, const QString& help, QSpinBox*& box,
                                      const QString& unit) {
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(8, 0, 8, 0);
    box = new QSpinBox;
    box->setSuffix(unit);
    box->setKeyboardTracking(false);
    wend::describe(box, name, help);
    auto* label = new QLabel(name);
    label->setBuddy(box);
    row->addWidget(label);
    row->addWidget(box);
    auto* action = new QWidgetAction(this);
    action->setText(name);
    action->setDefaultWidget(holder);
    return action;
}

void PictureActions::showPen() {
    const OutlineSettings& now = m_pen.now();
    (now.takesAway ? takesAway : adds)->setChecked(true);
    const QSignalBlocker a(m_size), b(m_tolerance);
    m_size->setValue(static_cast<int>(std::lround(2 * now.radius)));
    m_tolerance->setValue(static_cast<int>(std::lround(100 * now.tolerance)));
}

}  // namespace wend
