#include "app/panels/fields/ease_names.h"

#include <QCoreApplication>

namespace wend {

QString easeName(Ease ease) {
    const auto named = [](const char* name) { return QCoreApplication::translate("EaseNames", name); };
    switch (ease) {
        case Ease::In:
            return named(QT_TRANSLATE_NOOP("EaseNames", "Begins &Softly"));
        case Ease::Out:
            return named(QT_TRANSLATE_NOOP("EaseNames", "&Ends Softly"));
        case Ease::InOut:
            return named(QT_TRANSLATE_NOOP("EaseNames", "&Both Softly"));
        case Ease::Linear:
            break;
    }
    return named(QT_TRANSLATE_NOOP("EaseNames", "&Even"));
}

}  // namespace wend
