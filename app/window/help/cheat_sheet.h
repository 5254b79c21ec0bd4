#pragma once

#include <QDialog>

class QMenuBar;

namespace wend {

/// All shortcuts, collected from the current menus, and the mouse gestures.
class CheatSheet : public QDialog {
    Q_OBJECT

  public:
    CheatSheet(const QMenuBar& menus, int dimension, QWidget* parent);

    /// Returns rich text.
    static QString text(const QMenuBar& menus, int dimension);
};

}  // namespace wend
