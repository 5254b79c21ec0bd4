#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QComboBox;
class QPushButton;

namespace wend {

class ExactBox;

/// The way of the one selected handle: how its motion of the time that is shown begins and ends; of the curve
/// that it follows last the frame that turns along it, its twist (in space) and its scale, or the button that
/// makes a curve of the last way. Only there when there is one of them.
class CurvePanel : public QWidget {
    Q_OBJECT

  public:
    explicit CurvePanel(ShapeSession& session, QWidget* parent = nullptr);

  private:
    void makeControls();
    void arrange();
    void showCurve();
    void change();
    template <int Dim>
    void show();
    template <int Dim>
    void changeOf();
    int dimension() const { return m_session.document().dimension(); }
    int single() const { return m_session.singleHandle(); }
    bool holdsPart() const;
    void allowTurning(bool allow);
    void changeEase();
    template <int Dim>
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
