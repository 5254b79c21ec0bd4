#pragma once

#include <QWidget>

#include "core/mesh/cut_plane.h"

class QComboBox;
class QSlider;
class QToolButton;

namespace wend {

class ExactBox;

/// The plane that cuts a solid open, in numbers.
class CutPanel : public QWidget {
    Q_OBJECT

  public:
    explicit CutPanel(QWidget* parent = nullptr);

    /// `kind` 0: none, 1: whole cells, 2: exact; the solid's bounding box gives the range.
    void show(int kind, const CutPlane& plane, const Vec3& low, const Vec3& high);
    /// Shows that there is no solid yet.
    void showNothing();

  signals:
    void kindChosen(int kind);
    void planeChosen(wend::CutPlane plane);

  private:
    void makeControls();
    void arrange();
    void chooseNormal(const Vec3& normal);
    void chooseNumbers();
    double minimum() const;
    double maximum() const;

    QComboBox* m_kind;
    std::array<QToolButton*, 4> m_ways;
    QSlider* m_slider;
    std::array<ExactBox*, 3> m_normal;
    ExactBox* m_place;
    QWidget* m_numbers;
    CutPlane m_plane;
    Vec3 m_low = Vec3::Zero(), m_high = Vec3::Ones();
};

}  // namespace wend
