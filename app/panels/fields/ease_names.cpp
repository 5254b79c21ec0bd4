#include "app/panels/fields/ease_names.h"

#include <QCoreApplication>

namespace wend {

QString easeName(Ease ease) {
    const auto named = [](const char* name) { return QCoreApplication::translate("EaseNames", name); };
    switch (ease) {
        case Ease::In:
            return named(QT_TRANSLATE_NOOP("EaseNames", "Ease &In"));
        case Ease::Out:
            return named(QT_TRANSLATE_NOOP("EaseNames", "Ease &Out"));
        case Ease::InOut:
            return named(QT_TRANSLATE_NOOP("EaseNames", "Ease In and O&ut"));
        case Ease::Linear:
            break;
    }
    return named(QT_TRANSLATE_NOOP("EaseNames", "&Linear"));
}

}  // namespace wend
