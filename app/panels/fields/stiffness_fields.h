#pragma once

#include <QString>
#include <array>

class QWidget;

namespace wend {

class ExactBox;

/// Fields for relative stiffness and its direction, shared by the paint and layer panels.
ExactBox* stiffnessField(const QString& help, QWidget* parent);
std::array<ExactBox*, 3> directionFields(const QString& name, const QString& help, QWidget* parent);

}  // namespace wend
