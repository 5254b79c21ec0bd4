// Values of the chosen layer and their changes.

#include <QCheckBox>
#include <QFileInfo>
#include <QLabel>
#include <QToolButton>
#include <cmath>

#include "app/engine/shape/told_units.h"
#include "app/panels/fields/energy_slider.h"
#include "app/panels/fields/number_boxes.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/layer_panel.h"
#include "app/project/domain.h"
#include "app/project/file/named_files.h"

namespace wend {

/// A change that would empty the layer is ignored.
void LayerPanel::changePaint() {
    MaterialPaint paint;
    if (m_hasPhi->isChecked()) paint.phi = m_phi->phi();
    Vec3 axis = Vec3::Zero();
    for (int k = 0; k < m_session.document().dimension(); ++k) axis[k] = m_axis[k]->exact();
    if (axis.isZero(0)) axis = Vec3::UnitX();
    if (std::abs(axis.norm() - 1) >= 1e-12) axis.normalize();  // unit vectors keep their bits
    if (m_ratio->exact() != 1) paint.stiffness = Stiffness{axis, m_ratio->exact()};
    if (!paint.phi && !paint.stiffness) return showValues();
    m_phi->setEnabled(paint.phi.has_value());
    changeBy(tr("Change layer"), withGroupPaint(m_session.document().design(), selected(), paint, m_ownAxes),
             QStringLiteral("layer ") + QString::fromStdString(selected()));
}

void LayerPanel::showGroup() {
    const int dimension = m_session.document().dimension();
    for (const RegionGroup& group : regionGroups(m_session.document().design())) {
        if (group.name != selected()) continue;
        m_phi->setDimension(dimension);
        m_hasPhi->setChecked(group.paint.phi.has_value());
        m_phi->setEnabled(group.paint.phi.has_value());
        if (group.paint.phi) m_phi->setPhi(*group.paint.phi);
        m_ratio->put(group.paint.stiffness ? group.paint.stiffness->ratio : 1);
        allowDirection(group.paint.stiffness && group.paint.stiffness->ratio != 1);
        m_ownAxes = !group.oneAxis;
        m_axisNote->setVisible(m_ownAxes);
        const Vec3 axis = group.axis.value_or(Vec3::UnitX());
        for (int k = 0; k < 3; ++k) m_axis[k]->setVisible(k < dimension);
        for (int k = 0; k < dimension; ++k) m_axis[k]->put(axis[k]);
        m_feather->put(group.feather);
        showPictures(group.pictures);
    }
}

void LayerPanel::allowDirection(bool isStiff) {
    for (ExactBox* box : m_axis) {
        box->setEnabled(isStiff);
        describe(box, tr("Stiff direction"),
                 isStiff ? tr("At rest; it turns with the shape. A change is for all regions of the layer.")
                         : tr("Stiffness ×1 has no direction: first choose how many times stiffer it is."));
    }
}

/// Shows the unit of a picture, or of a mesh file.
void LayerPanel::showUnit() {
    const Document& document = m_session.document();
    if (document.isEmpty()) return;
    const Domain& domain = document.domain();
    const QString unit = QString::fromStdString(
        domain.kind == DomainKind::Image ? "px"
                                         : toldUnits(pathIn(document.folder().toStdString(), domain.path)));
    m_feather->setSuffix(unit.isEmpty() ? unit : ' ' + unit);
}

void LayerPanel::showPictures(const MaterialPictures& pictures) {
    QStringList lines;
    for (const auto& [text, file] : {std::pair{tr("Keep: %1"), pictures.phi},
                                     {tr("Stiffness: %1"), pictures.stiffness},
                                     {tr("Direction: %1"), pictures.direction}})
        if (!file.empty()) lines << text.arg(QFileInfo(QString::fromStdString(file)).fileName());
    m_files->setText(lines.join('\n'));
    m_paint->setVisible(lines.isEmpty());
    m_pictures->setVisible(!lines.isEmpty());
    m_readAgain->show();
    m_featherRow->show();
}

void LayerPanel::showCells() {
    const std::string& file = m_session.document().design().material.cellsFile;
    m_files->setText(file.empty()
                         ? tr("As the project's file says, cell by cell.")
                         : tr("Cell by cell: %1").arg(QFileInfo(QString::fromStdString(file)).fileName()));
    m_paint->hide();
    m_pictures->show();
    m_readAgain->hide();
    m_featherRow->hide();
}

}  // namespace wend
