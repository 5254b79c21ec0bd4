#pragma once

#include <QDoubleSpinBox>

namespace wend {

/// A number with a decimal point or comma, whichever of them the language has: both may be typed, and none
/// groups digits.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT

  public:
    explicit NumberBox(QWidget* parent = nullptr);
    QValidator::State validate(QString& text, int& at) const override;

  protected:
    void takeEitherPoint(QString& text) const;
};

}  // namespace wend
