#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QCheckBox;
class QLabel;

namespace wend {

class ExactBox;
class RegionNumbers;

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
