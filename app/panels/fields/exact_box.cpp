#include "app/panels/fields/exact_box.h"

#include <QSignalBlocker>

namespace wend {

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

}  // namespace wend
