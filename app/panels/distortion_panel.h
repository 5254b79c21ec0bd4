#pragma once

#include <QTimer>
#include <QWidget>

#include "app/base/in_background.h"
#include "app/engine/motion/playback.h"
#include "app/engine/shape/pose_faults.h"
#include "app/panels/legend.h"
#include "app/session/shape_motion.h"

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace wend {

class ExactBox;

/// Checks the shown pose for faults in a background thread, once it is at rest.
class PoseWatch : public QObject {
    Q_OBJECT

  public:
    PoseWatch(ShapeMotion& motion, Playback& playback, QObject* parent = nullptr);

    /// Returns null while the result is unknown, or if the dimension differs.
    template <int Dim>
    std::shared_ptr<const PoseFaults<Dim>> faults() const {
        if constexpr (Dim == 2)
            return m_flat;
        else
            return m_solid;
    }
    /// Returns whether a check is due or running.
    bool isBusy() const { return m_due.isActive() || m_work.isRunning(); }

  signals:
    void changed();

  private:
    void takeFrame();
    void look();
    template <int Dim>
    void lookAt(const PosedPtr<Dim>& frame);

    ShapeMotion& m_motion;
    Playback& m_playback;
    QTimer m_due;
    BackgroundWork m_work;
    FramePtr m_seen;  // that the faults are of
    std::shared_ptr<const PoseFaults<2>> m_flat;
    std::shared_ptr<const PoseFaults<3>> m_solid;
};

/// The distortion of the shape: the map with its legend, three totals, the worst place, self-crossings and
/// blown-up cells.
class DistortionPanel : public QWidget {
    Q_OBJECT

  public:
    DistortionPanel(ShapeMotion& motion, Playback& playback, QWidget* parent = nullptr);

    Measure measure() const;
    void setMeasure(Measure measure);
    const MeasureRange& range() const { return m_range; }
    /// Returns the switch that freezes the range.
    QAction& keepRange() const { return *m_keep; }
    /// Opacity of maps over a picture, stored in the settings.
    double opacity() const;
    /// Returns whether maps blend colours between cells; it is stored in the settings.
    bool isSmooth() const;
    /// Returns the widget with the map's options and the totals, which is placed under *Advanced*.
    QWidget* details() const { return m_details; }
    /// Returns the faults of the shown pose.
    const PoseWatch& watch() const { return m_watch; }

  signals:
    /// Emitted when the measure or its range changes.
    void mapChanged();
    void showWorst();
    /// Requests a view of a place; z is 0 in pictures.
    void placeWanted(const wend::Vec3& at);
    void faultsChanged();
    void opacityChanged(double opacity);
    void smoothChanged(bool smooth);
    /// Emitted when the user chooses a measure.
    void mapChosen();

  private:
    void makeControls();
    void makeDetails();
    void setDimension(int dimension);
    static bool hasPicture(const ShapeFrame& frame);
    void arrange();
    QLayout* totals();
    void takeFrame();
    QLayout* rangeRow();
    void chooseRange();
    void fitLogarithm(const std::vector<double>& values);
    void showRange();
    void showTotals(const ShapeFrame& frame);
    void describeFaults();
    void showFaults();
    template <int Dim>
    void showFaults();
    void goOn(std::size_t& next, const std::vector<Vec3>& places);

    ShapeMotion& m_motion;
    QComboBox* m_measure;
    Legend* m_legend;
    QWidget* m_opacityRow = nullptr;
    QSlider* m_opacity;
    QAction* m_keep;
    QToolButton* m_lock;
    QWidget* m_details;
    QCheckBox* m_smooth = nullptr;
    ExactBox *m_low = nullptr, *m_high = nullptr;  // the ends of the range
    QCheckBox* m_logarithmic = nullptr;
    QLabel* m_angle;
    QLabel* m_area;
    QLabel* m_length;
    QLabel* m_worst;
    QLabel *m_pinError, *m_time;
    QToolButton* m_find;
    QLabel* m_areaName = nullptr;
    PoseWatch m_watch;
    QToolButton *m_crossings = nullptr, *m_blown = nullptr;  // counts; each click shows the next place
    QLabel* m_crossingsName = nullptr;
    std::vector<Vec3> m_crossed, m_grown;            // their places …
    std::size_t m_nextCrossed = 0, m_nextGrown = 0;  // … and the index of the next one
    MeasureRange m_range;
    int m_dimension = 0;
};

}  // namespace wend
