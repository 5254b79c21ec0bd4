#include "app/panels/fields/controls.h"

#include "app/panels/fields/panel_parts.h"

namespace wend {

void setWords(QAbstractButton* button, const char* id, const QString& text, const QString& help,
              const QString& name) {
    button->setText(text);
    describe(button, id, name.isEmpty() ? withoutKey(text) : name, help);
}

void describe(QWidget* field, const char* id, const QString& name, const QString& help) {
    if (*id) field->setObjectName(QLatin1String(id));
    describe(field, name, help);
}

void limit(QDoubleSpinBox* box, const Numbers& numbers) {
    if (numbers.decimals >= 0) box->setDecimals(numbers.decimals);
    box->setRange(numbers.min, numbers.max);
    box->setSingleStep(numbers.step);
    box->setSuffix(numbers.unit);
}

}  // namespace wend
