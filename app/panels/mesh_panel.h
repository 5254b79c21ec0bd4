#pragma once

#include <QWidget>

#include "app/session/shape_session.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;
class QSpinBox;

namespace wend {

/// Where the shape's outline comes from and how fine the mesh is.
class MeshPanel : public QWidget {
    Q_OBJECT

  public:
    explicit MeshPanel(ShapeSession& session, QWidget* parent = nullptr);

  private:
    void makeControls();
    void arrange();
    void connectControls();
    void showProject();
    void showSolid(const Domain& domain);
    void showCounts();
    /// One undo step of the domain; steps of the same key merge.
    template <class Edit>
    void edit(const QString& name, const QString& key, Edit change);

    ShapeSession& m_session;
    QComboBox* m_outline;
    QDoubleSpinBox* m_threshold;
    QDoubleSpinBox* m_margin;
    QSpinBox* m_vertices;
    QSlider* m_density;
    QDoubleSpinBox* m_quality;
    QCheckBox* m_refine;
    std::vector<QWidget*> m_pictureRows, m_surfaceRows, m_solidRows;
    QLabel* m_counts;
    int m_gesture = 0;
};

}  // namespace wend
