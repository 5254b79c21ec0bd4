#pragma once

#include <QWidget>
#include <array>

#include "core/mesh/region.h"

class QComboBox;
class QLabel;

namespace wend {

class ExactBox;

/// Returns the number of decimals that shows at least a ten-thousandth of the diagonal.
int digitsFor(double diagonal);

/// A ball, a box or a half-space in numbers.
class RegionNumbers : public QWidget {
    Q_OBJECT

  public:
    /// Elsewhere: another field shows the radius, including that of points.
    enum class Radius { Here, Elsewhere };
    explicit RegionNumbers(Radius radius, QWidget* parent = nullptr);
    /// `diagonal` of the shape: so fine are the numbers.
    void showRegion(const Region<3>& region, double diagonal);
    /// Returns whether this kind of region has numbers here.
    static bool canShow(const Region<3>& region) { return !std::holds_alternative<Blend<3>>(region); }

  signals:
    void changed(const wend::Region<3>& region);

  private:
    using ThreeBoxes = std::array<ExactBox*, 3>;
    void makeControls();
    void arrange();
    void chooseKind(int kind);
    Region<3> numbers() const;
    void showDigits(bool direction);

    Region<3> m_region;
    double m_diagonal = 1;
    QComboBox* m_kind;
    QLabel *m_firstName, *m_secondName;
    ThreeBoxes m_first, m_second;
    QWidget* m_radiusRow;
    ExactBox* m_radius;
    bool m_hasRadius;
};

}  // namespace wend
