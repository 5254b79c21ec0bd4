#include "app/panels/paint_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QListWidget>
#include <QToolButton>
#include <cmath>

#include "app/panels/energy_slider.h"
#include "app/panels/exact_box.h"
#include "app/panels/panel_parts.h"

namespace wend {

namespace {

constexpr int kNumbers = 3;  // of the direction: behind the axes, before what a stroke brings along

}  // namespace

PaintPanel::PaintPanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_hasPhi(new QCheckBox(tr("&Keep here"), this)),
      m_phi(new EnergySlider(this)),
      m_stiffness(new ExactBox(this)),
      m_axis(new QComboBox(this)),
      m_list(new QListWidget(this)),
      m_remove(new QToolButton(this)) {
    makeControls();
    arrange();
    connect(m_hasPhi, &QCheckBox::toggled, m_phi, &QWidget::setEnabled);
    connect(m_hasPhi, &QCheckBox::clicked, this, &PaintPanel::changeGroup);
    connect(m_phi, &EnergySlider::phiChosen, this, &PaintPanel::changeGroup);
    connect(m_stiffness, &QDoubleSpinBox::valueChanged, this, &PaintPanel::changeGroup);
    connect(m_axis, &QComboBox::activated, this, &PaintPanel::chooseAxis);
    for (ExactBox* box : m_numbers)
        connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
            showAxis({m_numbers[0]->exact(), m_numbers[1]->exact(), m_numbers[2]->exact()});
            m_ownAxes = false;
            emit alongChanged(along());
            changeGroup();
        });
    connect(m_list, &QListWidget::currentRowChanged, this, &PaintPanel::showGroup);
    connect(m_remove, &QToolButton::clicked, this, [this] {
        if (selectedGroup().isEmpty()) return;
        Document& document = m_session.document();
        document.change(tr("Remove region"),
                        withoutGroup(*document.project(), selectedGroup().toStdString()));
    });
    connect(&m_session.document(), &Document::projectChanged, this, &PaintPanel::showRegions);
    showRegions();
}

void PaintPanel::makeControls() {
    m_hasPhi->setChecked(true);
    describe(m_hasPhi, tr("Keep here"), tr("Whether the brush changes what is kept, and to what."));
    m_phi->setDimension(3);
    m_phi->setPhi(phi::kAkvf);
    m_stiffness->setRange(1, 1000);
    m_stiffness->setDecimals(1);
    m_stiffness->put(1);
    m_stiffness->setPrefix(QStringLiteral("×"));
    m_stiffness->setFixedWidth(116);
    describe(m_stiffness, tr("Stiffness"),
             tr("How many times stiffer the painted part is along the axis; ×1 is as everywhere."));
    m_axis->addItems({tr("along X"), tr("along Y"), tr("along Z"), tr("as numbers"), tr("along the view"),
                      tr("along the stroke"), tr("along the pin's way")});
    m_axis->setFixedWidth(150);
    describe(m_axis, tr("Stiff direction"),
             tr("The direction at rest, which turns with the material: an axis, numbers, the direction of "
                "view, the stroke's own, or the way of the selected pin where it is nearest."));
    for (ExactBox*& box : m_numbers) {
        box = new ExactBox(this);
        box->setRange(-1e6, 1e6);
        box->setDecimals(3);
        box->setSingleStep(0.1);
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setMinimumWidth(56);
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        describe(box, tr("Direction in numbers"), tr("As x, y and z at rest; its length does not matter."));
    }
    m_numbers[0]->put(1);
    m_list->setFixedHeight(84);
    describe(m_list, tr("Regions"),
             tr("Where the material is another; a click shows its values for changing."));
    m_remove->setText(tr("Remove"));
    m_remove->setProperty("role", "chip");
    describe(m_remove, tr("Remove region"), tr("Takes the chosen region away."));
}

void PaintPanel::arrange() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 14, 16, 14);
    layout->setSpacing(10);
    layout->addWidget(panelTitle(tr("Paint material"), this));
    layout->addWidget(m_hasPhi);
    layout->addWidget(m_phi);
    layout->addLayout(panelRow(tr("St&iffness"), m_stiffness, this));
    layout->addLayout(panelRow(tr("&Direction"), m_axis, this));
    auto* numbers = new QHBoxLayout;
    for (ExactBox* box : m_numbers) numbers->addWidget(box);
    layout->addLayout(numbers);
    layout->addWidget(m_list);
    layout->addWidget(m_remove, 0, Qt::AlignLeft);
}

MaterialPaint PaintPanel::paint() const {
    MaterialPaint paint;
    if (m_hasPhi->isChecked()) paint.phi = m_phi->phi();
    if (m_stiffness->exact() != 1) paint.stiffness = Stiffness<3>{axis(), m_stiffness->exact()};
    return paint;
}

/// Of length 1; what has that already keeps its bits.
Vec<3> PaintPanel::axis() const {
    const Vec<3> axis(m_numbers[0]->exact(), m_numbers[1]->exact(), m_numbers[2]->exact());
    if (axis.isZero(0)) return Vec<3>::UnitX();
    return std::abs(axis.norm() - 1) < 1e-12 ? axis : axis.normalized();
}

StiffAlong PaintPanel::along() const {
    const int beyond = m_axis->currentIndex() - kNumbers;
    return beyond <= 0 ? StiffAlong::Axis : static_cast<StiffAlong>(beyond);
}

/// An axis sets the numbers; what a stroke brings along is for the next one.
void PaintPanel::chooseAxis(int index) {
    if (index < kNumbers) showAxis(Vec<3>::Unit(index));
    if (index < kNumbers) m_ownAxes = false;
    emit alongChanged(along());
    if (index <= kNumbers) changeGroup();
}

void PaintPanel::showAxis(const Vec<3>& axis) {
    int index = kNumbers;
    for (int k = 0; k < 3; ++k) {
        m_numbers[k]->put(axis[k]);
        if (axis == Vec<3>::Unit(k)) index = k;
    }
    m_axis->setCurrentIndex(index);
}

QString PaintPanel::selectedGroup() const {
    const QListWidgetItem* item = m_list->currentItem();
    return item ? item->data(Qt::UserRole).toString() : QString();
}

void PaintPanel::changeGroup() {
    emit paintChanged(paint());
    const MaterialPaint now = paint();
    Document& document = m_session.document();
    if (document.dimension() != 3 || selectedGroup().isEmpty() || (!now.phi && !now.stiffness)) return;
    document.change(tr("Change region"),
                    withGroupPaint(*document.project(), selectedGroup().toStdString(), now, m_ownAxes),
                    QStringLiteral("region ") + selectedGroup());
}

void PaintPanel::showGroup() {
    m_remove->setEnabled(!selectedGroup().isEmpty());
    if (selectedGroup().isEmpty() || m_session.document().dimension() != 3) return;
    for (const RegionGroup& group : regionGroups(*m_session.document().project())) {
        if (group.name != selectedGroup().toStdString()) continue;
        m_hasPhi->setChecked(group.paint.phi.has_value());
        if (group.paint.phi) m_phi->setPhi(*group.paint.phi);
        m_stiffness->put(group.paint.stiffness ? group.paint.stiffness->ratio : 1);
        m_ownAxes = !group.oneAxis;
        if (group.axis) showAxis(*group.axis);
    }
    emit alongChanged(along());
    emit paintChanged(paint());
}

void PaintPanel::showRegions() {
    if (m_session.document().dimension() != 3) return;
    const QString chosen = selectedGroup();
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (const RegionGroup& group : regionGroups(*m_session.document().project())) {
        const QString name = QString::fromStdString(group.name);
        auto* item = new QListWidgetItem(name.isEmpty() ? tr("Unnamed") : name, m_list);
        item->setData(Qt::UserRole, name);
        if (name == chosen) m_list->setCurrentItem(item);
    }
    m_list->setVisible(m_list->count() > 0);
    m_remove->setVisible(m_list->count() > 0);
    m_remove->setEnabled(!selectedGroup().isEmpty());
}

}  // namespace wend
