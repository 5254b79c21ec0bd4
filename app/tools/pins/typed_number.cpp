#include "app/tools/pins/typed_number.h"

namespace wend {

bool TypedNumber::take(const QKeyEvent& key) {
    const QString text = key.text();
    if (key.key() == Qt::Key_Backspace)
        m_text.chop(1);
    else if (text == QStringLiteral(",") || text == QStringLiteral("."))
        m_text += '.';
    else if (text.size() == 1 && (text[0].isDigit() || (text[0] == '-' && m_text.isEmpty())))
        m_text += text;
    else
        return false;
    return true;
}

}  // namespace wend
