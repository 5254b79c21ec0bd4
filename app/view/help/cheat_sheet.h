#pragma once

#include <QDialog>

class QMenuBar;

namespace wend {

/// All keys, made from the menus as they are now, and what the pointer does.
class CheatSheet : public QDialog {
    Q_OBJECT

  public:
    CheatSheet(const QMenuBar& menus, int dimension, QWidget* parent);

    /// As rich text.
    static QString text(const QMenuBar& menus, int dimension);
};

}  // namespace wend
