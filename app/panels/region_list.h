#pragma once

#include <QWidget>

#include "app/project/layer.h"
#include "app/session/brush.h"
#include "app/session/selection.h"
#include "app/session/shape_motion.h"

class QLabel;
class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace wend {

class ExactBox;
class MagnitudeBox;
class RegionNumbers;

/// The kinds of listed layers: cell size, and in pictures depth.
enum class RegionsOf { Detail, Depth };

/// The layers of one kind, topmost first: a click shows where a layer is and its value, which can be edited;
/// a double click renames it. In a solid, regions can be added and edited in numbers.
class RegionList : public QWidget {
    Q_OBJECT

  public:
    RegionList(Document& document, Selection& selection, ShapeMotion& motion, Brush& brush, RegionsOf of,
               QWidget* parent = nullptr);
    QListWidget* list() const { return m_list; }

  signals:
    /// Emits the regions of the chosen layer; none if there is none or the list is hidden.
    void chosen(const std::vector<wend::SoftRegion>& regions);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    bool isDetail() const { return m_of == RegionsOf::Detail; }
    bool isSolid() const { return m_document.dimension() == 3; }
    void makeControls();
    void makeAddMenu();
    void arrange();
    void makeList();
    void showLayers();
    void showNotes();
    void showChosen();
    void tellChosen();
    void rename(QListWidgetItem* item);
    void changeShape(const Region<3>& shape, double feather);
    void addRegion(const Region<3>& shape);
    void change(const QString& step, ValueLayers layers, const QString& key = {});
    const ValueLayers& layers() const;
    const ValueLayer* layer() const;
    Id chosenId() const;
    QString nameOf(const ValueLayer& layer) const;
    QString valueText(double value) const;
    const Region<3>* selectedRegion() const;
    void allowSelected();
    Vec3 middle() const;

    Document& m_document;
    Selection& m_selection;
    ShapeMotion& m_motion;
    Brush& m_brush;
    const RegionsOf m_of;
    QLabel* m_none;
    QListWidget* m_list;
    QWidget* m_row = nullptr;  // of the value
    ExactBox* m_value = nullptr;
    QToolButton *m_add = nullptr, *m_remove = nullptr;
    QAction* m_addSelected = nullptr;
    QWidget* m_shape;  // of a layer that is one region of a solid
    RegionNumbers* m_numbers = nullptr;
    MagnitudeBox* m_feather = nullptr;
    QLabel* m_note;
};

}  // namespace wend
