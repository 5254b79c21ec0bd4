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
/// Which buttons turn, move and zoom. Wend: right or middle turns, with Shift moves, with Ctrl zooms.
/// VTK-like: left turns, middle moves, right zooms. Blender-like: middle turns, with Shift moves, with Ctrl
/// zooms.
enum class NavigationPreset { Wend, VtkLike, BlenderLike };

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
    CutKind cut() const { return m_cut; }
    const CutPlane& plane() const { return m_plane; }
    void setPreset(NavigationPreset preset) { m_preset = preset; }
    Camera& camera() { return m_camera; }
    const Camera& camera() const { return m_camera; }
    /// Triangles that are drawn beside the surface.
    void setGlyphs(std::vector<DrawVertex> triangles);
    /// What is drawn: the surface, cut as it is.
    const CutSurface& surface() const { return m_surface; }
    /// The view as a picture of any size; the background may be left transparent.
    QImage picture(const QSize& size, bool transparent);
    void fit();
    void look(Camera::Axis axis);
    void setOrthographic(bool on);

    /// The nearest triangle under a pixel, or cell −1.
    SolidHit pick(const QPointF& pixel) const;
    /// All vertices on screen inside the rectangle; only those that nothing hides if `visibleOnly`.
    std::vector<int> verticesIn(const QRectF& rectangle, bool visibleOnly) const;

  signals:
    void hovered(const SolidHit& hit);
    void picked(const SolidHit& hit, Qt::KeyboardModifiers modifiers);
    void cameraChanged();

  protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

    enum class Drag { None, Orbit, Pan, Zoom };
    Drag dragFor(const QMouseEvent& event) const;
    bool isNavigating() const { return m_drag != Drag::None; }
    void endNavigation() { m_drag = Drag::None; }
    const QPointF& pressedAt() const { return m_pressed; }
    const VolumePicture& shown() const { return m_picture; }
    void setBackground(const QColor& colour) { m_background = colour; }

  private:
    void remakeSurface();
    void uploadIfStale();
    void drawScene(const QSize& size, const QColor& background);
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
    QColor m_background;
    std::vector<DrawVertex> m_glyphs;
    bool m_stale = true, m_glyphsStale = false, m_ready = false;
};

}  // namespace wend
