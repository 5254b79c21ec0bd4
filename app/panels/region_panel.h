#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QLabel;

namespace wend {

class ExactBox;
class RegionNumbers;

/// The region that the one selected handle holds, in numbers of the rest shape, and how many vertices that
/// are; of a picture how large a circle is. A point has a radius of 0, and any other widens it. Only there
/// for such a handle.
class RegionPanel : public QWidget {
    Q_OBJECT

  public:
    explicit RegionPanel(ShapeSession& session, QWidget* parent = nullptr);

  private:
    void showHandle();
    void takeFrame();
    void apply(const Region<3>& region);
    template <int Dim>
    const Placement<Dim>* place() const;
    template <int Dim>
    const Region<Dim>* region() const;
    template <int Dim>
    bool isPoint() const;
    template <int Dim>
    void widen();
    const Ball<2>* circle() const;
    void applyRadius();
    void showSolid();
    void showPicture();
    void showPoint();
    void showCount(std::size_t vertices);

    ShapeSession& m_session;
    RegionNumbers* m_numbers;
    QWidget* m_radiusRow = nullptr;
    ExactBox* m_radius;  // of a circle, or a point
    QLabel* m_count;
    std::shared_ptr<const void> m_mesh;  // whose vertices were counted
};

}  // namespace wend
