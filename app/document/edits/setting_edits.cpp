#include "app/document/edits/setting_edits.h"

#include <QCoreApplication>
#include <algorithm>

#include "app/document/edits/document.h"
#include "app/document/options/settings.h"

namespace wend {

double settingOf(const Document& document, std::string_view key) {
    return settingOf(*document.project(), key);
}

void changeSetting(Document& document, std::string_view key, double value, int gesture) {
    const Option& setting = option(key);
    if (document.isEmpty() || value == setting.field.at.get(*document.project())) return;
    const auto next = copyOf(*document.project());
    if (setting.kind == OptionKind::Phi) value = std::min(value, rangeOf(setting, document.dimension()).max);
    setting.field.at.set(*next, value);
    const bool merges = setting.kind != OptionKind::Flag && setting.kind != OptionKind::Choice;
    const QString name = QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()));
    document.change(QCoreApplication::translate("Options", setting.row.undo), next,
                    merges ? QStringLiteral("%1 %2").arg(name).arg(gesture) : QString());
}

}  // namespace wend
