#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace wend {

class CurvePanel;

/// The selected handle of a solid in numbers: its name and place, exact steps, and the curve that it follows.
class HandlePanel : public QWidget {
    Q_OBJECT

  public:
    explicit HandlePanel(ShapeSession& session, QWidget* parent = nullptr);

  private:
    void makeControls();
    void arrange();
    void showHandle();
    void showStep();
    void apply();
    Vec<3> middle() const;
    int single() const;

    ShapeSession& m_session;
    QLabel* m_none;
    QWidget* m_body;
    QLineEdit* m_name;
    QLabel* m_place;
    QComboBox* m_kind;
    std::array<QDoubleSpinBox*, 3> m_numbers;
    QComboBox* m_axis;
    QPushButton* m_apply;
    CurvePanel* m_curve;
};

}  // namespace wend
