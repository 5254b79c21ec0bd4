#include "app/panels/paint_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QListWidget>
#include <QToolButton>

#include "app/panels/energy_slider.h"
#include "app/panels/panel_parts.h"

namespace wend {

PaintPanel::PaintPanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_hasPhi(new QCheckBox(tr("&Keep here"), this)),
      m_phi(new EnergySlider(this)),
      m_stiffness(new QDoubleSpinBox(this)),
      m_axis(new QComboBox(this)),
      m_list(new QListWidget(this)),
      m_remove(new QToolButton(this)) {
    makeControls();
    arrange();
    connect(m_hasPhi, &QCheckBox::toggled, m_phi, &QWidget::setEnabled);
    connect(m_hasPhi, &QCheckBox::clicked, this, &PaintPanel::changeGroup);
    connect(m_phi, &EnergySlider::phiChosen, this, &PaintPanel::changeGroup);
    connect(m_stiffness, &QDoubleSpinBox::valueChanged, this, &PaintPanel::changeGroup);
    connect(m_axis, &QComboBox::activated, this, &PaintPanel::changeGroup);
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
    m_stiffness->setValue(1);
    m_stiffness->setPrefix(QStringLiteral("×"));
    m_stiffness->setFixedWidth(116);
    m_stiffness->setKeyboardTracking(false);
    describe(m_stiffness, tr("Stiffness"),
             tr("How many times stiffer the painted part is along the axis; ×1 is as everywhere."));
    m_axis->addItems({tr("along X"), tr("along Y"), tr("along Z")});
    m_axis->setFixedWidth(116);
    describe(m_axis, tr("Stiff direction"), tr("The direction at rest; it turns with the material."));
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
    layout->addLayout(panelRow(tr("Direc&tion"), m_axis, this));
    layout->addWidget(m_list);
    layout->addWidget(m_remove, 0, Qt::AlignLeft);
}

MaterialPaint PaintPanel::paint() const {
    MaterialPaint paint;
    if (m_hasPhi->isChecked()) paint.phi = m_phi->phi();
    if (m_stiffness->value() > 1)
        paint.stiffness = Stiffness<3>{Vec<3>::Unit(m_axis->currentIndex()), m_stiffness->value()};
    return paint;
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
                    withGroupPaint(*document.project(), selectedGroup().toStdString(), now),
                    QStringLiteral("region ") + selectedGroup());
}

void PaintPanel::showGroup() {
    m_remove->setEnabled(!selectedGroup().isEmpty());
    if (selectedGroup().isEmpty() || m_session.document().dimension() != 3) return;
    for (const RegionGroup& group : regionGroups(*m_session.document().project())) {
        if (group.name != selectedGroup().toStdString()) continue;
        const QSignalBlocker a(m_stiffness);
        m_hasPhi->setChecked(group.paint.phi.has_value());
        if (group.paint.phi) m_phi->setPhi(*group.paint.phi);
        m_stiffness->setValue(group.paint.stiffness ? group.paint.stiffness->ratio : 1);
        int axis = 0;
        if (group.paint.stiffness) group.paint.stiffness->axis.cwiseAbs().maxCoeff(&axis);
        m_axis->setCurrentIndex(axis);
    }
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
