#pragma once

#include <QWidget>

#include "app/project/edits/region_edits.h"
#include "app/session/shape_session.h"

class QLabel;
class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace wend {

class ExactBox;

/// The kinds of listed regions of a picture: cell size and depth.
enum class RegionsOf { Detail, Depth };

/// The regions of one kind in a picture, topmost first like layers: a click shows a region's place and its
/// number, which can be edited; a double click renames it.
class RegionList : public QWidget {
    Q_OBJECT

  public:
    RegionList(ShapeSession& session, RegionsOf of, QWidget* parent = nullptr);
    QListWidget* list() const { return m_list; }

  signals:
    /// Emits the shapes of the chosen regions; empty if none is chosen or the list is hidden.
    void chosen(const std::vector<wend::MaterialRegion>& regions);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    bool isDetail() const { return m_of == RegionsOf::Detail; }
    void makeControls();
    void arrange();
    void connectControls();
    void showRegions();
    void showChosen();
    void tellChosen();
    void rename(QListWidgetItem* item);
    template <class Edit>
    void change(const QString& step, const Edit& edit, const QString& key = {});
    std::vector<NamedRegions> groups() const;
    QString nameOf(const NamedRegions& group) const;
    QString valueText(double value) const;
    int group() const;

    ShapeSession& m_session;
    const RegionsOf m_of;
    QLabel* m_none;
    QListWidget* m_list;
    QWidget* m_row = nullptr;  // of the value
    ExactBox* m_value;
    QToolButton* m_remove;
};

}  // namespace wend
