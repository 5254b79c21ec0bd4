#include "app/panels/fields/stiffness_fields.h"

#include <QCoreApplication>

#include "app/panels/fields/number_boxes.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/picture_tip.h"
#include "app/project/options/options.h"

namespace wend {

ExactBox* stiffnessField(const QString& help, QWidget* parent) {
    auto* box = new ExactBox(parent);
    const Range ratios = option("material.regions[].stiffness.ratio").range;
    box->setRange(ratios.min, ratios.max);
    box->setDecimals(1);
    box->setPrefix(QStringLiteral("×"));
    describe(box, QCoreApplication::translate("StiffnessFields", "Stiffness"), help);
    showInTip(box, stiffnessPictures);
    return box;
}

std::array<ExactBox*, 3> directionFields(const QString& name, const QString& help, QWidget* parent) {
    const auto boxes = coordinateBoxes(1e6, 3, name, help, parent);
    for (ExactBox* box : boxes) box->setSingleStep(0.1);
    return boxes;
}

}  // namespace wend
