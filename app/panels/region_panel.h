#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QLabel;

namespace wend {

class ExactBox;
class RegionNumbers;

/// The region that the one selected handle holds, in numbers of the rest shape, and how many vertices that
/// are; of a picture only how large a circle is. A point has a radius of 0: another number makes a circle or
/// a ball of it, and 0 a point of those. Only there for such a handle.
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
    template <int Dim>
    std::optional<double> radius() const;
    void applyRadius();
    void showRadius(double radius, double diagonal);
    template <int Dim>
    void showCount();

    ShapeSession& m_session;
    RegionNumbers* m_numbers;
    QWidget* m_radiusRow = nullptr;
    ExactBox* m_radius;
    QLabel* m_count;
    std::shared_ptr<const void> m_mesh;  // whose vertices were counted
};

}  // namespace wend
