#pragma once

#include "app/panels/exact_box.h"

namespace wend {

/// A positive number of any size, with six digits that count; a step changes it by a tenth.
class MagnitudeBox : public ExactBox {
    Q_OBJECT

  public:
    explicit MagnitudeBox(QWidget* parent = nullptr);
    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& at) const override;
    void stepBy(int steps) override;
};

}  // namespace wend
