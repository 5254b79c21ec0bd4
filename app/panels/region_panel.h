#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QLabel;

namespace wend {

class RegionNumbers;

/// The region that the one selected handle of a solid holds, in numbers of the rest shape, and how many
/// vertices that are. Only there for such a handle.
class RegionPanel : public QWidget {
    Q_OBJECT

  public:
    explicit RegionPanel(ShapeSession& session, QWidget* parent = nullptr);

  private:
    void showHandle();
    void takeFrame();
    void apply(const Region<3>& region);
    const Region<3>* region() const;

    ShapeSession& m_session;
    RegionNumbers* m_numbers;
    QLabel* m_count;
    std::shared_ptr<const void> m_mesh;  // whose vertices were counted
};

}  // namespace wend
