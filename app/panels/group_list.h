#pragma once

#include <QColor>
#include <QWidget>
#include <memory>

#include "app/session/mesh_groups.h"
#include "app/session/shape_session.h"

class QListWidget;
class QPushButton;

namespace wend {

/// The vertices of a group, as they are marked on the shape.
struct GroupMark {
    QColor colour;
    std::vector<int> vertices;
    bool chosen = false;
};
using GroupMarks = std::shared_ptr<const std::vector<GroupMark>>;

/// The groups of the mesh's or surface's file, each in its colour: a click marks one on the shape, and the
/// button or a double click makes a handle that holds it. Hidden for files without groups.
class GroupList : public QWidget {
    Q_OBJECT

  public:
    explicit GroupList(ShapeSession& session, QWidget* parent = nullptr);
    QListWidget* list() const { return m_list; }
    QPushButton* holdButton() const { return m_hold; }

  signals:
    /// Emits what is to be marked; null while the list is hidden.
    void marked(const wend::GroupMarks& marks);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void read();
    void take(const std::vector<HeldGroup>& groups);
    void tell();
    void hold();

    ShapeSession& m_session;
    std::vector<HeldGroup> m_groups;
    QListWidget* m_list;
    QPushButton* m_hold;
    QWidget* m_content;  // hidden where there are no groups
    int m_ticket = 0;    // of the newest reading
};

}  // namespace wend
