#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "app/session/shape_session.h"

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace wend {

class ExactBox;
class RegionNumbers;

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
    QPushButton* m_make = nullptr;
    QWidget* m_curve;
    QComboBox *m_ease = nullptr, *m_frame = nullptr;
    ExactBox *m_twist = nullptr, *m_scale = nullptr;
    QWidget* m_twistRow = nullptr;
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
    void showDigits();
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
    QToolButton* m_apply = nullptr;
    QHBoxLayout *m_step = nullptr, *m_space = nullptr;
};

/// The region of the single selected handle in numbers of the rest shape, with the number of its vertices; in
/// a picture only the radius of a disc, and whether the pin holds its angle. A point has radius 0: another
/// number makes it a disc or a ball, and back. Hidden for other handles.
class RegionPanel : public QWidget {
    Q_OBJECT

  public:
    explicit RegionPanel(ShapeSession& session, QWidget* parent = nullptr);

  private:
    void showHandle();
    void takeFrame();
    void apply(const Region<3>& region);
    bool isSolid() const { return m_session.document().dimension() == 3; }
    std::optional<Region<3>> region() const;
    std::optional<double> radius() const;
    void applyRadius();
    void showRadius(double radius, double diagonal);

    ShapeSession& m_session;
    RegionNumbers* m_numbers;
    QWidget* m_radiusRow = nullptr;
    ExactBox* m_radius;
    QCheckBox* m_holdsAngle;
    QLabel* m_count;
    std::shared_ptr<const void> m_mesh;  // mesh of the counted vertices
};

}  // namespace wend
