#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;
class QSpinBox;
class QToolButton;

namespace wend {

class DetailRow;
class MagnitudeBox;

/// Where the shape's outline comes from and how fine the mesh is.
class MeshPanel : public QWidget {
    Q_OBJECT

  public:
    explicit MeshPanel(ShapeSession& session, QWidget* parent = nullptr);

  signals:
    /// A detailed surface for the solid is to be chosen, or taken away.
    void detailWanted();
    void detailRemoved();
    /// Cell sizes are to be painted.
    void sizesWanted();

  private:
    void makeControls();
    void makeSolidControls();
    void arrange();
    void connectControls();
    void connectSolidControls();
    void setAim(bool volume);
    void showProject();
    void showRows();
    void showSolid(const Domain& domain);
    void showCounts();
    /// One undo step of the domain; steps of the same key merge.
    template <class Edit>
    void edit(const QString& name, const QString& key, Edit change);

    ShapeSession& m_session;
    QComboBox* m_outline;
    QDoubleSpinBox* m_threshold;
    QDoubleSpinBox* m_margin;
    QComboBox* m_border;
    QSpinBox* m_vertices;
    QSlider* m_density;
    QDoubleSpinBox* m_quality;
    QCheckBox* m_refine;
    QComboBox *m_fit, *m_aim;
    MagnitudeBox* m_volume;
    QToolButton* m_sizes;
    DetailRow* m_detail;
    // of pictures; of all that is meshed; of surfaces; of surfaces by their aim
    std::vector<QWidget*> m_pictureRows, m_surfaceRows, m_solidRows, m_volumeRows;
    QLabel* m_counts;
    int m_gesture = 0;
};

}  // namespace wend
