#pragma once

#include <QWidget>

class QAction;

namespace wend {

class Actions;

/// What can be written of what is shown: a button for each kind, with what it is for, or what it waits for.
class ExportPanel : public QWidget {
    Q_OBJECT

  public:
    explicit ExportPanel(const Actions& actions, QWidget* parent = nullptr);

  private:
    QWidget* row(QAction* action);
};

}  // namespace wend
