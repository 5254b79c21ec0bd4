#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QComboBox;
class QPushButton;

namespace wend {

class ExactBox;

/// The curve that the one selected handle follows last: the frame that turns along it, its twist (in space)
/// and its scale; or the button that makes a curve of the last way. Only there when there is one of them.
class CurvePanel : public QWidget {
    Q_OBJECT

  public:
    /// For shapes of that dimension alone; `titled`: stands by itself.
    CurvePanel(ShapeSession& session, int dimension, bool titled, QWidget* parent = nullptr);

  private:
    void makeControls();
    void arrange(bool titled);
    void showCurve();
    void change();
    template <int Dim>
    void show();
    template <int Dim>
    void changeOf();
    int single() const;
    bool holdsPart() const;
    void allowTurning(bool allow);

    ShapeSession& m_session;
    int m_dimension;
    QPushButton* m_make;
    QWidget* m_curve;
    QComboBox* m_frame;
    ExactBox* m_twist;
    ExactBox* m_scale;
};

}  // namespace wend
