#pragma once

#include <QWidget>

#include "app/document/material_edits.h"
#include "app/session/shape_session.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QListWidget;
class QToolButton;

namespace wend {

class EnergySlider;

/// What the brush paints into a solid, and the regions that are there: a click on one shows its values, which
/// then can be changed, or removes it.
class PaintPanel : public QWidget {
    Q_OBJECT

  public:
    explicit PaintPanel(ShapeSession& session, QWidget* parent = nullptr);
    MaterialPaint paint() const;

  signals:
    void paintChanged(const wend::MaterialPaint& paint);

  private:
    void makeControls();
    void arrange();
    void showRegions();
    void showGroup();
    void changeGroup();
    QString selectedGroup() const;

    ShapeSession& m_session;
    QCheckBox* m_hasPhi;
    EnergySlider* m_phi;
    QDoubleSpinBox* m_stiffness;
    QComboBox* m_axis;
    QListWidget* m_list;
    QToolButton* m_remove;
};

}  // namespace wend
