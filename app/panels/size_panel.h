#pragma once

#include <QWidget>

#include "app/session/brush.h"
#include "app/session/shape_session.h"

class QLabel;
class QListWidget;
class QToolButton;

namespace wend {

class MagnitudeBox;
class RegionNumbers;
struct SizeGroup;

/// Cell sizes of a solid: the factor of the next stroke, and the existing strokes and regions with editable
/// numbers.
class SizePanel : public QWidget {
    Q_OBJECT

  public:
    /// Shares the regions of the chosen entry with the brush; there are none while the next stroke is chosen.
    SizePanel(ShapeSession& session, Brush& brush, QWidget* parent = nullptr);

  private:
    void makeControls();
    void makeAddMenu();
    void arrange();
    void connectControls();
    void showSizes();
    void showGroup();
    void changeFactor(double factor);
    void changeShape(const Region<3>& shape, double feather);
    void add(const Region<3>& shape);
    void addSelected();
    void allowSelected(bool allowed);
    int group() const;
    QString textOf(const SizeGroup& group) const;
    Vec<3> middle() const;

    ShapeSession& m_session;
    Brush& m_brush;
    MagnitudeBox* m_factor;
    QListWidget* m_list;
    QToolButton *m_add, *m_remove;
    QWidget* m_shape;
    RegionNumbers* m_numbers;
    MagnitudeBox* m_feather;
    QLabel* m_note;
    QAction* m_selected = nullptr;
};

}  // namespace wend
