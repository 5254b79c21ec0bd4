#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QToolButton;

namespace wend {

class MagnitudeBox;
class RegionNumbers;
struct SizeGroup;

/// Where the tetrahedra of a solid are finer or coarser: what the next stroke of the brush does, and the
/// strokes and regions that are there, whose numbers can be changed.
class SizePanel : public QWidget {
    Q_OBJECT

  public:
    explicit SizePanel(ShapeSession& session, QWidget* parent = nullptr);
    /// Of the next stroke.
    double brushFactor() const { return m_brush; }

  signals:
    void brushChanged(double factor);
    /// The regions of the chosen entry; none for the next stroke.
    void chosen(const std::vector<wend::Region<3>>& regions);

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
    int group() const;
    QString textOf(const SizeGroup& group) const;
    Vec<3> middle() const;

    ShapeSession& m_session;
    double m_brush = 0.5;
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
