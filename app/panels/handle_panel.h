#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "app/session/shape_session.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

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
    int single() const { return m_session.selection().single(); }
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

/// Numbers of the selection: its place, exact steps, and the path of a single handle.
class HandlePanel : public QWidget {
    Q_OBJECT

  public:
    explicit HandlePanel(ShapeSession& session, QWidget* parent = nullptr);

  private:
    void makeControls();
    void arrange();
    void showHandle();
    void showStep();
    void placeNumbers();
    void changeEvent(QEvent* event) override;
    void apply();
    std::optional<Vec3> middle() const;
    bool isSolid() const { return m_session.document().dimension() == 3; }

    ShapeSession& m_session;
    QLabel* m_none;
    QWidget* m_body;
    QLabel* m_place;
    QComboBox* m_kind;
    std::array<ExactBox*, 3> m_numbers;
    QComboBox* m_axis;
    QToolButton* m_apply;
    QHBoxLayout *m_step = nullptr, *m_space = nullptr;
};

}  // namespace wend
