// The widgets of the form and their layout.
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "app/panels/fields/option_field.h"
#include "app/panels/fields/panel_parts.h"
#include "app/window/export/export_form.h"

namespace wend {

namespace {

constexpr int kNumberWidth = 140;  // common width, since they are in one column

}  // namespace

void ExportForm::makeFields() {
    for (const char* flag :
         {"--count", "--fps", "--loop", "--webp", "--depth", "--canvas", "--scale", "--width", "--outside",
          "--filter", "--fields", "--encoding", "--msh", "--border"}) {
        auto* field = new OptionField(flag, this);
        m_fields << field;
        connect(field, &OptionField::changed, this, [this, field] {
            tie(*field);
            adapt();
        });
    }
}

void ExportForm::makeCropNote(Fields place) {
    m_crop->setObjectName(QStringLiteral("cropNote"));
    const QString label = tr("Fit the Can&vas");
    auto* fit = new QPushButton(place == Fields::Beside ? label : withoutKey(label), m_crop);
    fit->setAutoDefault(false);
    describe(fit, tr("Fit the canvas"),
             tr("Make the canvas as large as the shape needs, so that nothing is cut off."));
    connect(fit, &QPushButton::clicked, this, [this] { field("--canvas")->setValue("fit"); });
    m_cropText->setWordWrap(true);
    m_cropText->setProperty("role", "warning");
    auto* line =
        new QBoxLayout(place == Fields::Beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom, m_crop);
    line->setContentsMargins(12, 8, 8, 8);
    line->addWidget(m_cropText, 1);
    line->addWidget(fit);
    m_crop->setAttribute(Qt::WA_StyledBackground);
    m_crop->hide();
}

/// A check box shows its own label.
void ExportForm::addRow(OptionField& field, bool hasKey) {
    if (field.option().kind == OptionKind::Flag) {
        field.sayLabel(hasKey);
        return m_form->addRow(&field);
    }
    m_form->addRow(hasKey ? field.label() : withoutKey(field.label()), &field);
}

/// Lays out the fields. Below the preview, long fields get a line of their own, and mnemonics are left to the
/// menus.
void ExportForm::lay(Fields place) {
    const bool beside = place == Fields::Beside;
    if (!beside) m_form->setHorizontalSpacing(4);
    m_form->setVerticalSpacing(beside ? 10 : 6);
    m_form->setRowWrapPolicy(beside ? QFormLayout::DontWrapRows : QFormLayout::WrapLongRows);
    m_form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    const QString format = tr("F&ormat");
    m_form->addRow(beside ? format : withoutKey(format), m_format);
    for (OptionField* field : m_fields) addRow(*field, beside);
    m_facts->setObjectName(QStringLiteral("facts"));
    m_facts->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_facts->setWordWrap(!beside);
    m_problem->setObjectName(QStringLiteral("problem"));
    m_problem->setProperty("role", "warning");
    m_problem->setWordWrap(true);
    m_problem->hide();
    auto* fields = new QVBoxLayout;
    fields->addLayout(m_form);
    fields->addStretch(1);
    auto* top = new QBoxLayout(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    top->setSpacing(beside ? 20 : 8);
    top->addWidget(m_preview, 1);
    if (!beside) top->addWidget(m_facts);
    top->addLayout(fields);
    auto* all = bareColumn(this, beside ? 12 : 8);
    all->addLayout(top, 1);
    if (beside) all->addWidget(m_facts);
    all->addWidget(m_crop);
    all->addWidget(m_problem);
    for (auto* number : findChildren<QAbstractSpinBox*>()) number->setMinimumWidth(kNumberWidth);
    for (QComboBox* box : findChildren<QComboBox*>()) {
        box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        if (beside) {
            box->setMinimumWidth(220);
        } else {
            box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        }
    }
}

}  // namespace wend
