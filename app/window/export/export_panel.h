#pragma once

#include <QDialog>
#include <QMap>
#include <QTimer>
#include <QWidget>

#include "app/window/export/export_form.h"

class QButtonGroup;
class QPushButton;

namespace wend {

class Actions;
class Exporter;
class ShapeMotion;

/// Asks how something is written, before its name is asked.
class ExportDialog : public QDialog {
    Q_OBJECT

  public:
    ExportDialog(const ExportSubject& subject, ExportChoices& choices, QWidget* parent);

    static QString title(ExportKind kind);
    ExportForm& form() const { return *m_form; }

  private:
    ExportForm* m_form;
};

/// The panel of the step Export, which previews the shown shape and follows it.
class ExportPanel : public QWidget {
    Q_OBJECT

  public:
    ExportPanel(const ShapeMotion& motion, Exporter& exporter, const Actions& actions,
                QWidget* parent = nullptr);

    ExportForm& form() const { return *m_form; }
    ExportKind kind() const;

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void addKind(ExportKind kind, const QString& name, QAction* action);
    QPushButton* viewButton(QAction* action);
    void ask();
    void showShape();

    const ShapeMotion& m_motion;
    Exporter& m_exporter;
    QButtonGroup* m_kinds;
    QMap<int, QAction*> m_actions;  // of the kinds
    ExportForm* m_form;
    QPushButton *m_write, *m_view, *m_film;
    QTimer m_soon;
};

}  // namespace wend
