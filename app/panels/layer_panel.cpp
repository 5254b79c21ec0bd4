#include "app/panels/layer_panel.h"

#include <QCheckBox>
#include <QListWidget>
#include <QToolButton>
#include <cmath>

#include "app/panels/energy_slider.h"
#include "app/panels/exact_box.h"
#include "app/panels/magnitude_box.h"
#include "app/panels/panel_parts.h"
#include "app/panels/stiffness_fields.h"
#include "app/session/accent.h"

namespace wend {

namespace {

/// A square in the colour of what the layer keeps; of stiffness for one that is only stiff.
template <int Dim>
QIcon swatch(const MaterialPaint<Dim>& paint) {
    QPixmap pixmap(12, 12);
    pixmap.fill(paint.phi ? energyColour(stopOfPhi(*paint.phi, Dim)) : kStiffColour);
    return pixmap;
}

}  // namespace

LayerPanel::LayerPanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_list(new QListWidget(this)),
      m_up(new QToolButton(this)),
      m_down(new QToolButton(this)),
      m_remove(new QToolButton(this)),
      m_none(secondLabel(tr("It is the same everywhere: brush over the shape to change a part."), this)),
      m_values(new QWidget(this)),
      m_hasPhi(new QCheckBox(tr("Keep here"), m_values)),
      m_phi(new EnergySlider(m_values)),
      m_ratio(stiffnessField(
          tr("How many times stiffer the layer is along its direction; ×1 is as everywhere."), m_values)),
      m_axisNote(secondLabel(tr("Each along a direction of its own."), m_values)),
      m_feather(new MagnitudeBox(m_values)) {
    makeList();
    makeControls();
    arrange();
    connectControls();
    showLayers();
}

void LayerPanel::makeList() {
    m_list->setObjectName(QStringLiteral("layers"));
    m_list->setFixedHeight(96);
    m_none->setObjectName(QStringLiteral("noLayers"));
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    describe(m_list, tr("Layers"),
             tr("Where the material is another. The topmost wins. A click shows its values, a double click "
                "changes its name."));
    const auto make = [](QToolButton* button, const char* id, const QString& text, const QString& help) {
        button->setObjectName(QLatin1String(id));
        button->setText(text);
        button->setProperty("role", "chip");
        describe(button, text, help);
    };
    make(m_up, "layerUp", tr("Up"), tr("Lets the chosen layer win over the one above it."));
    make(m_down, "layerDown", tr("Down"), tr("Lets the layer below win over the chosen one."));
    make(m_remove, "layerRemove", tr("Remove"), tr("Takes the chosen layer away."));
}

void LayerPanel::makeControls() {
    describe(m_hasPhi, tr("Keep here"), tr("Whether the layer changes what is kept, and to what."));
    m_ratio->setObjectName(QStringLiteral("layerRatio"));
    m_axis = directionFields(
        tr("Stiff direction"),
        tr("At rest; it turns with the shape. Another one is for all regions of the layer."), m_values);
    m_feather->setObjectName(QStringLiteral("layerFeather"));
    m_feather->setRange(0, 1e9);
    m_feather->setFixedWidth(116);
    describe(m_feather, tr("Soft edge"), tr("How wide the edge fades, in the shape's own units."));
}

void LayerPanel::arrange() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 14, 16, 14);
    layout->setSpacing(10);
    layout->addWidget(panelTitle(tr("Layers"), this));
    layout->addWidget(m_none);
    layout->addWidget(m_list);
    auto* buttons = new QHBoxLayout;
    for (QToolButton* button : {m_up, m_down}) buttons->addWidget(button);
    buttons->addStretch(1);
    buttons->addWidget(m_remove);
    layout->addLayout(buttons);
    auto* values = new QVBoxLayout(m_values);
    values->setContentsMargins(0, 0, 0, 0);
    values->setSpacing(8);
    values->addWidget(m_hasPhi);
    values->addWidget(m_phi);
    values->addLayout(panelRow(tr("Stiffness"), m_ratio, m_values));
    auto* axis = new QHBoxLayout;
    for (ExactBox* box : m_axis) axis->addWidget(box);
    values->addLayout(axis);
    values->addWidget(m_axisNote);
    values->addLayout(panelRow(tr("Soft ed&ge"), m_feather, m_values));
    layout->addWidget(m_values);
}

void LayerPanel::connectControls() {
    connect(&m_session.document(), &Document::projectChanged, this, &LayerPanel::showLayers);
    connect(m_list, &QListWidget::currentRowChanged, this, &LayerPanel::showValues);
    connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        const Project& project = *m_session.document().project();
        const std::string before = item->data(Qt::UserRole).toString().toStdString();
        const std::string wish = item->text().trimmed().toStdString();
        if (wish.empty() || wish == before) return showLayers();
        const std::string name = freeGroupName(project, before, wish);
        const QSignalBlocker quiet(m_list);
        item->setData(Qt::UserRole, QString::fromStdString(name));  // it stays the chosen one
        changeBy(tr("Rename layer"), withGroupName(project, before, name));
    });
    const auto move = [this](int by) {
        changeBy(tr("Move layer"), withGroupMoved(*m_session.document().project(), selected(), by));
    };
    connect(m_up, &QToolButton::clicked, this, [move] { move(1); });
    connect(m_down, &QToolButton::clicked, this, [move] { move(-1); });
    connect(m_remove, &QToolButton::clicked, this, [this] {
        changeBy(tr("Remove layer"), withoutGroup(*m_session.document().project(), selected()));
    });
    const auto changeMaterial = [this] {
        m_session.document().dimension() == 2 ? changePaint<2>() : changePaint<3>();
    };
    connect(m_hasPhi, &QCheckBox::clicked, this, changeMaterial);
    connect(m_phi, &EnergySlider::phiChosen, this, changeMaterial);
    connect(m_ratio, &QDoubleSpinBox::valueChanged, this, changeMaterial);
    for (ExactBox* box : m_axis)
        connect(box, &QDoubleSpinBox::valueChanged, this, [this, changeMaterial] {
            m_ownAxes = false;
            changeMaterial();
        });
    connect(m_feather, &QDoubleSpinBox::valueChanged, this, [this](double feather) {
        changeBy(tr("Change soft edge"),
                 withGroupFeather(*m_session.document().project(), selected(), feather),
                 QStringLiteral("feather ") + QString::fromStdString(selected()));
    });
}

std::string LayerPanel::selected() const {
    const QListWidgetItem* item = m_list->currentItem();
    return item ? item->data(Qt::UserRole).toString().toStdString() : std::string();
}

void LayerPanel::changeBy(const QString& step, Project next, const QString& key) {
    if (m_session.document().isEmpty() || !m_list->currentItem()) return;
    m_session.document().change(step, std::move(next), key);
}

/// A layer that would be nothing stays as it is.
template <int Dim>
void LayerPanel::changePaint() {
    MaterialPaint<Dim> paint;
    if (m_hasPhi->isChecked()) paint.phi = m_phi->phi();
    Vec<Dim> axis;
    for (int k = 0; k < Dim; ++k) axis[k] = m_axis[k]->exact();
    if (axis.isZero(0)) axis = Vec<Dim>::UnitX();
    if (std::abs(axis.norm() - 1) >= 1e-12) axis.normalize();  // what has that already keeps its bits
    if (m_ratio->exact() != 1) paint.stiffness = Stiffness<Dim>{axis, m_ratio->exact()};
    if (!paint.phi && !paint.stiffness) return showValues();
    m_phi->setEnabled(paint.phi.has_value());
    changeBy(tr("Change layer"),
             withGroupPaint<Dim>(*m_session.document().project(), selected(), paint, m_ownAxes),
             QStringLiteral("layer ") + QString::fromStdString(selected()));
}

template <int Dim>
void LayerPanel::showGroup() {
    for (const RegionGroup<Dim>& group : regionGroups<Dim>(*m_session.document().project())) {
        if (group.name != selected()) continue;
        m_phi->setDimension(Dim);
        m_hasPhi->setChecked(group.paint.phi.has_value());
        m_phi->setEnabled(group.paint.phi.has_value());
        if (group.paint.phi) m_phi->setPhi(*group.paint.phi);
        m_ratio->put(group.paint.stiffness ? group.paint.stiffness->ratio : 1);
        m_ownAxes = !group.oneAxis;
        m_axisNote->setVisible(m_ownAxes);
        const Vec<Dim> axis = group.axis.value_or(Vec<Dim>::UnitX());
        for (int k = 0; k < 3; ++k) m_axis[k]->setVisible(k < Dim);
        for (int k = 0; k < Dim; ++k) m_axis[k]->put(axis[k]);
        const QSignalBlocker quiet(m_feather);
        if (m_feather->value() != group.feather) m_feather->setValue(group.feather);
    }
}

void LayerPanel::showValues() {
    const bool has = m_list->currentItem() && !m_session.document().isEmpty();
    m_values->setVisible(has);
    m_none->setVisible(m_list->count() == 0);
    m_list->setVisible(m_list->count() > 0);
    for (QToolButton* button : {m_up, m_down, m_remove}) {
        button->setVisible(m_list->count() > 0);
        button->setEnabled(has);
    }
    if (has && m_session.document().dimension() == 2) showGroup<2>();
    if (has && m_session.document().dimension() == 3) showGroup<3>();
    if (has) {
        m_up->setEnabled(m_list->currentRow() > 0);
        m_down->setEnabled(m_list->currentRow() + 1 < m_list->count());
    }
    tellChosen();
}

void LayerPanel::tellChosen() {
    const bool has = m_list->currentItem() && isVisible();
    emit chosen(has ? m_list->currentItem()->data(Qt::UserRole).toString() : QString());
}

void LayerPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    tellChosen();
}

void LayerPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    tellChosen();
}

template <int Dim>
void LayerPanel::fill() {
    const auto groups = regionGroups<Dim>(*m_session.document().project());
    for (auto group = groups.rbegin(); group != groups.rend(); ++group) {
        const QString name = QString::fromStdString(group->name);
        auto* item = new QListWidgetItem(swatch<Dim>(group->paint), name.isEmpty() ? tr("Unnamed") : name);
        item->setData(Qt::UserRole, name);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        m_list->addItem(item);
    }
}

void LayerPanel::showLayers() {
    const QString before = QString::fromStdString(selected());
    const bool had = m_list->currentItem();
    {
        const QSignalBlocker quiet(m_list);
        m_list->clear();
        if (m_session.document().dimension() == 2) fill<2>();
        if (m_session.document().dimension() == 3) fill<3>();
        for (int i = 0; had && i < m_list->count(); ++i)
            if (m_list->item(i)->data(Qt::UserRole).toString() == before) m_list->setCurrentRow(i);
    }
    showValues();
}

}  // namespace wend
