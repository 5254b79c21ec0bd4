#pragma once

#include <QDialog>

#include "app/window/export/export_form.h"

namespace wend {

/// Asks how something is written, before its name is asked.
class ExportDialog : public QDialog {
    Q_OBJECT

  public:
    ExportDialog(const ExportSubject& subject, QWidget* parent);

    static QString title(ExportKind kind);
    ExportForm& form() const { return *m_form; }

  private:
    ExportForm* m_form;
};

}  // namespace wend
