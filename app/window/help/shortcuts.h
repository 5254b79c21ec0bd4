#pragma once

#include <QDialog>
#include <QKeySequence>

class QAction;
class QKeySequenceEdit;
class QLabel;
class QMenuBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace wend {

class Toolbox;

/// All shortcuts, collected from the current menus, and the mouse gestures.
class CheatSheet : public QDialog {
    Q_OBJECT

  public:
    CheatSheet(const QMenuBar& menus, int dimension, QWidget* parent);

    /// Returns rich text.
    static QString text(const QMenuBar& menus, int dimension);
};

/// All actions under the menus that they are in, of which each may get other keys. Keys are remembered at
/// once.
class ShortcutDialog : public QDialog {
    Q_OBJECT

  public:
    ShortcutDialog(const QMenuBar& menus, Toolbox& tools, QWidget* parent);

  private:
    QWidget* makeRow();
    void fill(const QMenuBar& menus);
    void search(const QString& text);
    QAction* chosen() const;
    void showChosen();
    void showKeys();
    void take(QKeySequence typed);
    /// Gives an action keys, or its standard ones; actions that had one of them lose it, and are named.
    void assign(QAction& action, const QList<QKeySequence>& keys);
    void restoreAll();

    Toolbox& m_tools;
    QTreeWidget* m_list;
    QKeySequenceEdit* m_edit;
    QPushButton *m_none, *m_standard;
    QLabel* m_note;
};

}  // namespace wend
