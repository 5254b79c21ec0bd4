#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QComboBox;
class QPushButton;

namespace wend {

class ExactBox;

/// The path of the single selected handle: easing of its motion at the shown time; of its last curve the
/// rotating frame, the twist (in space) and the scale, or a button that converts the last path to a curve.
/// Hidden without a single handle.
class CurvePanel : public QWidget {
    Q_OBJECT

  public:
    explicit CurvePanel(ShapeSession& session, QWidget* parent = nullptr);

  private:
    void makeControls();
    void arrange();
    void showCurve();
    void change();
    int dimension() const { return m_session.document().dimension(); }
    int single() const { return m_session.singleHandle(); }
    bool holdsPart() const;
    void allowTurning(bool allow);
    void changeEase();
    int shownMotion() const;

    ShapeSession& m_session;
    QPushButton* m_make;
    QWidget* m_curve;
    QComboBox* m_ease;
    QComboBox* m_frame;
    ExactBox* m_twist;
    QWidget* m_twistRow = nullptr;
    ExactBox* m_scale;
};

}  // namespace wend
