#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QDoubleSpinBox;

namespace wend {

/// What the whole shape keeps and how far a pull reaches, in numbers.
class BalancePanel : public QWidget {
    Q_OBJECT

  public:
    explicit BalancePanel(ShapeSession& session, QWidget* parent = nullptr);

  private:
    static QString phiHelp(int dimension);
    void makeControls();
    void showProject();
    void chooseSmoothing(double length);

    ShapeSession& m_session;
    QDoubleSpinBox* m_phi;
    QDoubleSpinBox* m_smoothing;
};

}  // namespace wend
