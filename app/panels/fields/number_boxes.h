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

/// A number box that keeps more digits than it shows: until the user enters another number, exact() returns
/// the number that was set. Text that is being typed survives updates with the same number.
class ExactBox : public NumberBox {
  public:
    using NumberBox::NumberBox;

    /// Sets the number without a signal.
    void put(double number);
    /// Sets the number of decimals and shows the number with them.
    void showDigits(int decimals);
    double exact() const { return value() == m_shown ? m_exact : value(); }

  private:
    double m_exact = 0, m_shown = 0;  // m_shown: m_exact as the box rounds it
};

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
