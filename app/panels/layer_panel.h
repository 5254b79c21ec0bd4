#pragma once

#include <QWidget>
#include <array>

#include "app/project/edits/document.h"
#include "app/project/edits/material_edits.h"
#include "app/session/brush.h"

class QCheckBox;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QMenu;
class QToolButton;

namespace wend {

class EnergySlider;
class ExactBox;
class MagnitudeBox;

/// The regions of the material as layers, topmost first. A click selects a layer and shows its values; double
/// click renames, dragging or arrows reorder, the eye hides. Values per cell are at the bottom.
class LayerPanel : public QWidget {
    Q_OBJECT

  public:
    LayerPanel(Document& document, LayerChoice& chosen, QWidget* parent = nullptr);
    QListWidget* list() const { return m_list; }
    /// Sets the menu that imports and exports pictures.
    void setPictureMenu(QMenu* menu);

  signals:
    /// Emitted when the user chooses a layer; Id::None for none, or while the panel is hidden.
    void chosen(wend::Id layer);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void makeControls();
    void makeList();
    void makeMenu();
    void makeChips();
    void arrange();
    void showLayers();
    void select(Id layer, bool cells);
    void choose();
    void showValues();
    void allowOrder(bool has);
    void showPictures(const MaterialPictures& pictures);
    void showCells();
    void showUnit();
    void allowDirection(bool isStiff);
    void takeItem(QListWidgetItem* item);
    void takeOrder(int from, int to);
    void remove();
    bool isCells() const;
    QListWidgetItem* itemAt(int row);
    void fill();
    void showLayer(const MaterialLayer& layer);
    void changePaint();
    void change(const QString& step, std::vector<MaterialLayer> next, const QString& key = {});
    template <class Change>
    void changeChosen(const QString& step, const Change& change, const QString& key = {});
    const std::vector<MaterialLayer>& layers() const;
    Id selected() const;
    void tellChosen();

    Document& m_document;
    LayerChoice& m_chosen;
    Id m_pointed = Id::None;  // the clicked layer, whose border is shown
    QListWidget* m_list;
    QToolButton *m_up = nullptr, *m_down = nullptr, *m_remove = nullptr, *m_pictureMenu = nullptr;
    QAction *m_rename = nullptr, *m_merge = nullptr, *m_takeAway = nullptr;
    QLabel* m_none;
    QWidget* m_values;
    QWidget* m_paint;     // of a layer with values of its own,
    QWidget* m_pictures;  // and of one that has them from pictures
    QLabel* m_files;
    QToolButton* m_readAgain = nullptr;
    QWidget* m_featherRow = nullptr;
    QCheckBox* m_hasPhi = nullptr;
    EnergySlider* m_phi = nullptr;
    ExactBox* m_ratio = nullptr;
    std::array<ExactBox*, 3> m_axis = {};
    QLabel* m_axisNote;
    MagnitudeBox* m_feather = nullptr;
    bool m_ownAxes = false;  // the chosen regions are stiff along directions of their own
};

}  // namespace wend
