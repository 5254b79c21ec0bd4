#include "app/panels/fields/number_box.h"

namespace wend {

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

}  // namespace wend
