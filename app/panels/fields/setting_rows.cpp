#include "app/panels/fields/setting_rows.h"

#include <QComboBox>

#include "app/panels/fields/option_field.h"
#include "app/panels/fields/panel_parts.h"
#include "app/project/edits/document.h"
#include "app/project/edits/part_edits.h"
#include "app/project/edits/setting_edits.h"
#include "app/project/options/settings.h"

namespace wend {

namespace {

constexpr int kNarrowNumber = 96, kWords = 150;  // pixels

}  // namespace

SettingRows::SettingRows(Document& document, QWidget* panel, QString whyNot)
    : QObject(panel), m_document(document), m_panel(panel), m_whyNot(std::move(whyNot)) {}

QWidget* SettingRows::row(std::string_view key) {
    auto* field = new OptionField(key, m_panel);
    m_fields.emplace(field->option().key, field);
    connect(field, &OptionField::changed, this, [this, field] {
        const bool isPart = m_part >= 0 && m_part < partCount(*m_document.project());
        if (!isPart) return changeSetting(m_document, field->option().key, field->number());
        changePartSetting(m_document, m_part, field->option().key, field->number());
    });
    if (field->option().kind == OptionKind::Flag && !field->option().row.words[0]) {
        field->sayLabel();
        return field;
    }
    if (auto* choice = field->findChild<QComboBox*>())
        fitToEntries(choice, kWords);
    else
        field->setWidth(kControlWidth, kNarrowNumber);
    return panelRowIn(field->label(), field, m_panel);
}

void SettingRows::show() {
    if (m_document.isEmpty()) return;
    const bool isPart = m_part >= 0 && m_part < partCount(*m_document.project());
    const auto shown = isPart ? std::shared_ptr<const Project>(asWhole(*m_document.project(), m_part))
                              : m_document.project();
    const Project& project = *shown;
    for (const auto& [key, field] : m_fields) {
        field->allow(isFor(field->option(), project), m_whyNot);
        field->setRange(rangeOf(field->option(), m_document.dimension()));
        field->setNumber(field->option().field.at.get(project));
    }
}

}  // namespace wend
