#pragma once

#include <QWidget>

#include "app/panels/fields/setting_rows.h"
#include "app/project/project_fwd.h"
#include "app/session/shape_motion.h"

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace wend {

/// The source of the outline and the fineness of the mesh.
class MeshPanel : public QWidget {
    Q_OBJECT

  public:
    MeshPanel(Document& document, ShapeMotion& motion, QWidget* parent = nullptr);
    /// Shows the outline and detail of one part of the picture; −1: of all.
    void setPart(int part);

  signals:
    void partChosen(int part);
    /// Request that a detailed surface for the solid be chosen, or removed.
    void detailWanted();
    void detailRemoved();
    /// Cell sizes are to be painted.
    void sizesWanted();

  private:
    void makeControls();
    void arrange();
    void makeSkin();
    void showSkin(const std::string& file);
    void setAim(bool volume);
    void showProject();
    void showParts();
    bool hasAlpha() const;
    int partVertices() const;
    void showDetail();
    void showRows();
    void showShells();
    void showCounts();

    Document& m_document;
    ShapeMotion& m_motion;
    SettingRows m_settings;
    QSlider* m_density;
    QComboBox* m_aim = nullptr;
    QComboBox* m_whose = nullptr;  // the part that the outline is of
    QToolButton *m_asAll = nullptr, *m_sizes = nullptr;
    QLabel* m_skin;  // the name of the file of the detailed surface
    QToolButton* m_removeSkin = nullptr;
    QWidget *m_skinRows = nullptr, *m_shells = nullptr, *m_border = nullptr, *m_whoseRow = nullptr;
    // of pictures; of all that is meshed; of surfaces; of surfaces by their aim
    std::vector<QWidget*> m_pictureRows, m_surfaceRows, m_solidRows, m_volumeRows;
    QLabel* m_counts;
    int m_gesture = 0, m_part = -1;
    std::string m_partName;
};

}  // namespace wend
