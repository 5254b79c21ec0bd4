#pragma once

#include <QWidget>

#include "app/panels/legend.h"
#include "app/session/pose_watch.h"

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace wend {

/// What the deformation costs: the map that is shown, its legend, the three totals, the worst place, and
/// where the pose passes through itself or has blown up.
class DistortionPanel : public QWidget {
    Q_OBJECT

  public:
    explicit DistortionPanel(ShapeSession& session, QWidget* parent = nullptr);

    Measure measure() const;
    void setMeasure(Measure measure);
    const MeasureRange& range() const { return m_range; }
    /// While it is checked, the range stays as it is.
    QAction& keepRange() const { return *m_keep; }
    /// Of the map over a picture; remembered for other documents and other days.
    double opacity() const;
    /// Whether maps are drawn without the borders of their cells; remembered likewise.
    bool isSmooth() const;
    /// How maps are drawn, the sums over the shape and the worst place in numbers, to be shown elsewhere.
    QWidget* details() const { return m_details; }
    /// What is wrong with the pose that is shown.
    const PoseWatch& watch() const { return m_watch; }

  signals:
    /// The measure or its range changed.
    void mapChanged();
    void showWorst();
    /// A place is to be seen; of a picture z is 0.
    void placeWanted(const wend::Vec<3>& at);
    void faultsChanged();
    void opacityChanged(double opacity);
    void smoothChanged(bool smooth);
    /// The user has chosen one.
    void mapChosen();

  private:
    void makeControls();
    void setDimension(int dimension);
    static bool hasPicture(const ShapeFrame& frame);
    void arrange();
    QLayout* totals();
    void takeFrame();
    void showTotals(const ShapeFrame& frame);
    void describeFaults();
    void showFaults();
    template <int Dim>
    void showFaults();
    void goOn(std::size_t& next, const std::vector<Vec<3>>& places);

    ShapeSession& m_session;
    QComboBox* m_measure;
    Legend* m_legend;
    QWidget* m_opacityRow = nullptr;
    QSlider* m_opacity;
    QAction* m_keep;
    QToolButton* m_lock;
    QWidget* m_details;
    QCheckBox* m_smooth;
    QLabel* m_angle;
    QLabel* m_area;
    QLabel* m_length;
    QLabel* m_worst;
    QLabel *m_pinError, *m_time;
    QToolButton* m_find;
    QLabel* m_areaName = nullptr;
    PoseWatch m_watch;
    QToolButton *m_crossings, *m_blown;  // how many; each click goes to the next
    QLabel* m_crossingsName = nullptr;
    std::vector<Vec<3>> m_crossed, m_grown;          // their places …
    std::size_t m_nextCrossed = 0, m_nextGrown = 0;  // … and which comes next
    MeasureRange m_range;
    int m_dimension = 0;
};

}  // namespace wend
