#pragma once

#include <QWidget>

#include "app/panels/fields/setting_rows.h"
#include "app/session/shape_session.h"

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace wend {

class DetailRow;

/// The source of the outline and the fineness of the mesh.
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
    void arrange();
    void connectControls();
    void setAim(bool volume);
    void showProject();
    void showRows();
    void showShells();
    void showCounts();

    ShapeSession& m_session;
    SettingRows m_settings;
    QSlider* m_density;
    QComboBox* m_aim;
    QToolButton* m_sizes;
    DetailRow* m_detail;
    QWidget* m_shells = nullptr;  // what is inside of shells in others
    // of pictures; of all that is meshed; of surfaces; of surfaces by their aim
    std::vector<QWidget*> m_pictureRows, m_surfaceRows, m_solidRows, m_volumeRows;
    QLabel* m_counts;
    int m_gesture = 0;
};

}  // namespace wend
