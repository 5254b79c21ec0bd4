#pragma once

#include "app/panels/fields/exact_box.h"

namespace wend {

/// A positive number of any magnitude, with six significant digits by default; a step changes it by a tenth.
class MagnitudeBox : public ExactBox {
    Q_OBJECT

  public:
    explicit MagnitudeBox(QWidget* parent = nullptr);
    /// Sets the shown significant digits; the number keeps all.
    void setDigits(int digits) { m_digits = digits; }
    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& at) const override;
    void stepBy(int steps) override;

  private:
    int m_digits = 6;
};

}  // namespace wend
