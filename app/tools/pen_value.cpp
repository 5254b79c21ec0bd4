#include "app/tools/pen_value.h"

namespace wend {

void PenValue::set(double value) {
    if (value == m_value) return;
    m_value = value;
    emit changed();
}

}  // namespace wend
