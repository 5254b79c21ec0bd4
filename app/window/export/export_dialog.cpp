#include "app/window/export/export_dialog.h"

#include <QDialogButtonBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/window/export/export_button.h"

namespace wend {

QString ExportDialog::title(ExportKind kind) {
    switch (kind) {
        case ExportKind::Picture:
            return tr("Export Picture");
        case ExportKind::Film:
            return tr("Export Film");
        case ExportKind::Frames:
            return tr("Export Sequence");
        case ExportKind::StMap:
            return tr("Export ST Map");
        case ExportKind::Mesh:
            break;
    }
    return tr("Export Mesh");
}

ExportDialog::ExportDialog(const ExportSubject& subject, QWidget* parent)
    : QDialog(parent), m_form(new ExportForm(ExportForm::Fields::Beside, this)) {
    setWindowTitle(title(subject.kind));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    QPushButton* write = addExportButton(*buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_form, &ExportForm::readyChanged, write, &QWidget::setEnabled);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    column->addWidget(m_form, 1);
    column->addWidget(buttons);
    m_form->setSubject(subject);
}

}  // namespace wend
