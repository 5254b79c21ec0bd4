#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QComboBox;
class QLabel;

namespace wend {

class ExactBox;

/// The region that the one selected handle of a solid holds, in numbers of the rest shape, and how many
/// vertices that are. Only there for such a handle.
class RegionPanel : public QWidget {
    Q_OBJECT

  public:
    explicit RegionPanel(ShapeSession& session, QWidget* parent = nullptr);

  private:
    using Numbers = std::array<ExactBox*, 3>;
    void makeControls();
    Numbers makeNumbers();
    void arrange();
    void showHandle();
    void takeFrame();
    void showDigits(bool direction);
    void showNumbers(const Region<3>& region);
    void chooseKind(int kind);
    void apply(const Region<3>& region);
    Region<3> numbers() const;
    const Region<3>* region() const;

    ShapeSession& m_session;
    QComboBox* m_kind;
    QLabel *m_firstName, *m_secondName, *m_count;
    Numbers m_first, m_second;
    std::shared_ptr<const void> m_mesh;  // whose vertices were counted
    QWidget* m_radiusRow;
    ExactBox* m_radius;
};

}  // namespace wend
