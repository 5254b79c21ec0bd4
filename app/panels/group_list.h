#pragma once

#include <QColor>
#include <QString>
#include <QWidget>
#include <memory>
#include <string>
#include <vector>

#include "app/base/latest.h"
#include "app/project/edits/document.h"
#include "app/session/selection.h"

class QListWidget;
class QPushButton;

namespace wend {

/// A group of a mesh's or surface's file, with the vertices that a handle on it holds.
struct HeldGroup {
    std::string name;   // as a project names it: a number if the file has no name
    int dimension = 0;  // of its cells; 0: of vertices
    int count = 0;      // of its cells or vertices
    std::vector<int> vertices;
};

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
    GroupList(Document& document, Selection& selection, QWidget* parent = nullptr);
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

    Document& m_document;
    Selection& m_selection;
    std::vector<HeldGroup> m_groups;
    QListWidget* m_list;
    QPushButton* m_hold;
    QWidget* m_content;  // hidden where there are no groups
    Latest m_reading{this};
};

}  // namespace wend
