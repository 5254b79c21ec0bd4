#pragma once

#include <QOpenGLWidget>
#include <QPoint>
#include <memory>

#include "app/view/volume/camera.h"
#include "app/view/volume/surface_renderer.h"
#include "core/mesh/cut_plane.h"

namespace wend {

/// What the view shows: a solid at rest, its pose, and colours.
struct VolumePicture {
    std::shared_ptr<const SimplicialMesh<3>> rest;
    std::shared_ptr<const std::vector<Facet<3>>> facets;
    Points<3> pose;
    std::vector<QRgb> vertexColours;  // one per vertex, or
    std::vector<QRgb> cellColours;    // one per cell; both empty: one plain colour
};

enum class CutKind { None, WholeCells, Exact };
enum class NavigationPreset { Wend, VtkLike, BlenderLike };

/// What lies under a pixel of the view.
struct VolumeHit {
    int cell = -1;
    int vertex = -1;  // the nearest corner
    Vec<3> point = Vec<3>::Zero();
};

/// A solid in space: turned, moved and zoomed with the mouse whatever is under it, cut open by a plane.
class VolumeView : public QOpenGLWidget {
    Q_OBJECT

  public:
    explicit VolumeView(QWidget* parent = nullptr);
    ~VolumeView() override;

    /// False where OpenGL cannot be had: then no VolumeView must be made (Qt 6.4 crashes on the offscreen
    /// platform).
    static bool available();

    void setPicture(VolumePicture picture, bool fitView);
    void setStyle(const SurfaceStyle& style);
    void setCut(CutKind kind, const CutPlane& plane);
    void setPreset(NavigationPreset preset) { m_preset = preset; }
    Camera& camera() { return m_camera; }
    void fit();
    void look(Camera::Axis axis);
    void setOrthographic(bool on);

    /// The nearest triangle under a pixel, or cell −1.
    VolumeHit pick(const QPointF& pixel) const;
    /// All vertices on screen inside the rectangle; only those that nothing hides if `visibleOnly`.
    std::vector<int> verticesIn(const QRectF& rectangle, bool visibleOnly) const;

  signals:
    void hovered(const VolumeHit& hit);
    void picked(const VolumeHit& hit, Qt::KeyboardModifiers modifiers);

  protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    enum class Drag { None, Orbit, Pan, Zoom };
    Drag dragFor(const QMouseEvent& event) const;
    void remakeSurface();
    void uploadIfStale();
    Eigen::Vector2d pixelOf(const QPointF& p) const { return {p.x(), p.y()}; }

    Camera m_camera;
    SurfaceRenderer m_renderer;
    SurfaceStyle m_style;
    VolumePicture m_picture;
    CutSurface m_surface;
    CutPlane m_plane;
    CutKind m_cut = CutKind::None;
    NavigationPreset m_preset = NavigationPreset::Wend;
    Drag m_drag = Drag::None;
    QPointF m_last, m_pressed;
    bool m_stale = true, m_ready = false;
};

}  // namespace wend
