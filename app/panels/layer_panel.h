#pragma once

#include <QWidget>
#include <array>

#include "app/document/material_edits.h"
#include "app/session/shape_session.h"

class QCheckBox;
class QLabel;
class QListWidget;
class QToolButton;

namespace wend {

class EnergySlider;
class ExactBox;
class MagnitudeBox;

/// The regions of the material, of pictures and of solids, as layers: the topmost wins. A click on one shows
/// its values, which then can be changed; its name by a double click, its place by the arrows.
class LayerPanel : public QWidget {
    Q_OBJECT

  public:
    explicit LayerPanel(ShapeSession& session, QWidget* parent = nullptr);
    QListWidget* list() const { return m_list; }

  signals:
    /// Another layer, by its name; null if there is none, or nobody sees the panel.
    void chosen(QString name);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void makeControls();
    void makeList();
    void arrange();
    void connectControls();
    void showLayers();
    void showValues();
    template <int Dim>
    void fill();
    template <int Dim>
    void showGroup();
    template <int Dim>
    void changePaint();
    void changeBy(const QString& step, Project next, const QString& key = {});
    std::string selected() const;
    void tellChosen();

    ShapeSession& m_session;
    QListWidget* m_list;
    QToolButton *m_up, *m_down, *m_remove;
    QLabel* m_none;
    QWidget* m_values;
    QCheckBox* m_hasPhi;
    EnergySlider* m_phi;
    ExactBox* m_ratio;
    std::array<ExactBox*, 3> m_axis;
    QLabel* m_axisNote;
    MagnitudeBox* m_feather;
    bool m_ownAxes = false;  // the chosen regions are stiff along directions of their own
};

}  // namespace wend
