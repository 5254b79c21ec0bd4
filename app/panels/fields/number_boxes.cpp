#include "app/panels/fields/number_boxes.h"

#include <QSignalBlocker>
#include <cmath>

namespace wend {

namespace {

constexpr int kPlaces = 40;  // behind the point, so that nothing small is rounded away

}  // namespace

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
    QLocale ungrouped = locale();
    ungrouped.setNumberOptions(QLocale::OmitGroupSeparator);
    setLocale(ungrouped);
}

QValidator::State NumberBox::validate(QString& text, int& at) const {
    takeEitherPoint(text);
    return QDoubleSpinBox::validate(text, at);
}

void NumberBox::takeEitherPoint(QString& text) const {
    const QString point = locale().decimalPoint();
    text.replace(QLatin1Char('.'), point).replace(QLatin1Char(','), point);
}

void ExactBox::put(double number) {
    if (number == m_exact && value() == m_shown) return;
    const QSignalBlocker quiet(this);
    setValue(number);
    m_exact = number;
    m_shown = value();
}

void ExactBox::showDigits(int digits) {
    if (digits == decimals()) return;
    const QSignalBlocker quiet(this);
    const double number = exact();
    setDecimals(digits);
    setValue(number);
    m_exact = number;
    m_shown = value();
}

MagnitudeBox::MagnitudeBox(QWidget* parent) : ExactBox(parent) {
    setDecimals(kPlaces);
    setRange(1e-30, 1e30);
}

QString MagnitudeBox::textFromValue(double value) const {
    const bool isWhole = value >= std::pow(10, m_digits) && value < 1e6;  // rather than with an exponent
    return isWhole ? locale().toString(value, 'f', 0) : locale().toString(value, 'g', m_digits);
}

double MagnitudeBox::valueFromText(const QString& text) const {
    QString number = text;
    number.remove(prefix()).remove(suffix());
    return locale().toDouble(number.trimmed());
}

QValidator::State MagnitudeBox::validate(QString& text, int&) const {
    takeEitherPoint(text);
    const double number = valueFromText(text);
    return number >= minimum() && number <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
}

/// Steps to a number of two digits.
void MagnitudeBox::stepBy(int steps) {
    const double exact = value() * std::pow(1.1, steps);
    const double unit = std::pow(10, std::floor(std::log10(exact)) - 1);
    const double rounded = std::round(exact / unit) * unit;
    setValue(rounded == value() ? value() + std::copysign(unit, steps) : rounded);
}

}  // namespace wend
