#pragma once

#include <QSet>
#include <QWidget>
#include <functional>
#include <string>
#include <vector>

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace wend {

class ShapeSession;

/// All pins by name under the headings of their groups, to select, rename, remove, lock and hide them, also
/// by keyboard. Enter moves the focus to the view, where arrow keys move the selection.
class PinList : public QWidget {
    Q_OBJECT

  public:
    explicit PinList(ShapeSession& session, QWidget* parent = nullptr);
    QTreeWidget* list() const { return m_list; }
    /// Fills the available height instead of a few rows.
    void setFills(bool fills);
    /// Returns the row of a pin, or the heading of a group; null if there is none.
    QTreeWidgetItem* rowOf(int handle) const;
    QTreeWidgetItem* headingOf(const QString& group) const;

    enum Column { Name, Link, Seen, Lock };

  signals:
    /// Emitted to return the keyboard to the view.
    void done();
    /// Emitted to request the menu of the selection.
    void menuWanted(QPoint global);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void makeList();
    void makeIcons();
    void showPins();
    void arrangeRows(const std::vector<int>& groups, std::size_t groupCount);
    QTreeWidgetItem* newRow(QTreeWidgetItem* heading);
    void showRow(int handle);
    void showHeading(QTreeWidgetItem& item, const QString& group);
    void showSigns(QTreeWidgetItem& item, bool linked, bool hidden, bool locked);
    void takeSelection();
    void rename(QTreeWidgetItem* item, int column);
    void later(const std::function<void()>& change);
    void renamePin(int handle, const std::string& name);
    bool takeKey(QKeyEvent& key, bool overrides);
    bool takePress(const QMouseEvent& press);
    std::vector<int> handlesOf(const QTreeWidgetItem& item) const;

    ShapeSession& m_session;
    QTreeWidget* m_list;
    QLabel* m_empty;                                   // in place of rows
    std::vector<QTreeWidgetItem*> m_rows, m_headings;  // of the handles, of the groups
    std::vector<int> m_groups;                         // per handle the number of its heading, or −1
    QSet<QString> m_folded;                            // groups that show their heading alone
    QIcon m_link, m_seen, m_hidden, m_locked, m_unlocked;
    bool m_showing = false;
};

}  // namespace wend
