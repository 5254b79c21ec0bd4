#pragma once

#include <QWidget>
#include <array>

#include "app/document/material_edits.h"
#include "app/session/shape_session.h"

class QCheckBox;
class QComboBox;
class QListWidget;
class QToolButton;

namespace wend {

class EnergySlider;
class ExactBox;

/// What the brush paints into a solid, and the regions that are there: a click on one shows its values, which
/// then can be changed, or removes it.
class PaintPanel : public QWidget {
    Q_OBJECT

  public:
    explicit PaintPanel(ShapeSession& session, QWidget* parent = nullptr);
    MaterialPaint paint() const;
    StiffAlong along() const;

  signals:
    void paintChanged(const wend::MaterialPaint& paint);
    void alongChanged(wend::StiffAlong along);

  private:
    void makeControls();
    void arrange();
    void showRegions();
    void showGroup();
    void changeGroup();
    void chooseAxis(int index);
    void showAxis(const Vec<3>& axis);
    Vec<3> axis() const;
    QString selectedGroup() const;

    ShapeSession& m_session;
    QCheckBox* m_hasPhi;
    EnergySlider* m_phi;
    ExactBox* m_stiffness;
    QComboBox* m_axis;
    std::array<ExactBox*, 3> m_numbers;
    bool m_ownAxes = false;  // the chosen group's regions are stiff along directions of their own
    QListWidget* m_list;
    QToolButton* m_remove;
};

}  // namespace wend
