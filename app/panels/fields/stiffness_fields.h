#pragma once

#include <QString>
#include <array>

class QWidget;

namespace wend {

class ExactBox;

/// How many times stiffer something is along its direction, and that direction, as the panels of paint and
/// of layers have them.
ExactBox* stiffnessField(const QString& help, QWidget* parent);
std::array<ExactBox*, 3> directionFields(const QString& name, const QString& help, QWidget* parent);

}  // namespace wend
