#include "app/project/edits/setting_edits.h"

#include <QCoreApplication>
#include <algorithm>

#include "app/project/domain.h"
#include "app/project/edits/document.h"
#include "app/project/edits/part_edits.h"
#include "app/project/options/settings.h"

namespace wend {

double settingOf(const Document& document, std::string_view key) {
    return settingOf(*document.project(), key);
}

namespace {

QString stepKey(const Option& setting, int gesture) {
    const bool merges = setting.kind != OptionKind::Flag && setting.kind != OptionKind::Choice;
    const QString name = QString::fromUtf8(setting.key.data(), static_cast<qsizetype>(setting.key.size()));
    return merges ? QStringLiteral("%1 %2").arg(name).arg(gesture) : QString();
}

}  // namespace

void changeSetting(Document& document, std::string_view key, double value, int gesture) {
    const Option& setting = option(key);
    if (document.isEmpty() || value == setting.field.at.get(*document.project())) return;
    const auto next = copyOf(*document.project());
    if (setting.kind == OptionKind::Phi) value = std::min(value, rangeOf(setting, document.dimension()).max);
    setting.field.at.set(*next, value);
    document.change(QCoreApplication::translate("Options", setting.row.undo), next,
                    stepKey(setting, gesture));
}

void changePartSetting(Document& document, int part, std::string_view key, double value, int gesture) {
    const Option& setting = option(key);
    const Project& before = *document.project();
    const auto whole = asWhole(before, part);
    if (value == setting.field.at.get(*whole)) return;
    setting.field.at.set(*whole, value);
    const Domain& domain = domainOf(*whole);
    const QString name = QCoreApplication::translate("Options", setting.row.undo);
    const QString step = stepKey(setting, gesture);
    document.change(name,
                    key == "domain.vertices"
                        ? withPartVertices(before, part, domain.vertices)
                        : withPartOutline(before, part, {domain.outline, domain.alpha, domain.polygons}),
                    step.isEmpty() ? step : QStringLiteral("%1 %2").arg(step).arg(part));
}

}  // namespace wend
