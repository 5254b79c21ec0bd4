#pragma once

#include <QOpenGLFramebufferObject>
#include <QOpenGLWidget>
#include <QPoint>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>

#include "app/views/volume/camera.h"
#include "app/views/volume/line_renderer.h"
#include "app/views/volume/ray_casting.h"
#include "app/views/volume/surface_renderer.h"
#include "app/views/volume/volume_picture.h"
#include "core/mesh/cut_plane.h"

namespace wend {

enum class CutKind { None, WholeCells, Exact };

/// A view of a solid, which can be rotated, panned, zoomed and cut by a plane.
class VolumeView : public QOpenGLWidget {
    Q_OBJECT

  public:
    explicit VolumeView(QWidget* parent = nullptr);
    ~VolumeView() override;

    /// Returns false without OpenGL; do not make a VolumeView then (Qt 6.4 crashes on the offscreen
    /// platform).
    static bool available();

    void setPicture(VolumePicture picture, bool fitView);
    void setStyle(const SurfaceStyle& style);
    void setCut(CutKind kind, const CutPlane& plane);
    CutKind cut() const { return m_cut; }
    const CutPlane& plane() const { return m_plane; }
    void setPreset(NavigationPreset preset) { m_navigation.setPreset(preset); }
    Camera& camera() { return m_camera; }
    const Camera& camera() const { return m_camera; }
    /// Sets additional triangles; the veiled ones are faintly visible where they are covered.
    void setGlyphs(std::vector<DrawVertex> triangles, std::vector<DrawVertex> veiled = {});
    /// Returns the drawn surface, with its cut.
    const CutSurface& surface() const { return m_surface; }
    /// The view as a picture of any size, drawn in tiles where it is larger than the renderer can; the
    /// background may be left transparent. Null if the memory does not suffice.
    QImage picture(const QSize& size, bool transparent) {
        return pictureRows(size, 0, size.height(), transparent);
    }
    /// Returns some rows of a picture.
    QImage pictureRows(const QSize& size, int top, int rows, bool transparent);
    /// Why there can be no picture; empty if there can.
    QString obstacle() const;
    /// Tiles of a picture are at most so large, also where the renderer could do more.
    void setLargestTile(int pixels) { m_largestTile = pixels; }
    /// Something moves and will be drawn again soon: where the processor draws, edges are not smoothed until
    /// it is over.
    void hurry();
    /// Boxes and triangles that the last pick() looked at.
    int visitedByPick() const { return m_rays.visited() + m_skinRays.visited(); }
    /// Triangles that are drawn.
    int drawnTriangles() const { return m_drawnTriangles; }
    /// Times of a frame in milliseconds: preparation of a pose, and drawing.
    struct FrameTimes {
        double prepare = 0, draw = 0;
    };
    const FrameTimes& lastFrame() const { return m_times; }
    /// Returns whether the last drawing is current and of full quality.
    bool isSettled() const;
    void fit();
    void look(Camera::Axis axis);
    void setOrthographic(bool on);

    /// Returns the nearest triangle under a pixel, or cell −1.
    SolidHit pick(const QPointF& pixel) const;
    /// Returns all vertices inside the rectangle on screen, only visible ones if `visibleOnly`.
    std::vector<int> verticesIn(const QRectF& rectangle, bool visibleOnly) const;

  signals:
    void cameraChanged();
    /// Emits unreadable pictures of materials, once per surface.
    void picturesMissing(const QStringList& files);

  protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

    Navigation& navigation() { return m_navigation; }
    const Navigation& navigation() const { return m_navigation; }
    const VolumePicture& shown() const { return m_picture; }
    void setBackground(const QColor& colour) { m_background = colour; }

    /// Returns whether an embedded surface is drawn instead of the solid's border.
    bool showsSkin() const { return m_picture.skin && m_cut != CutKind::WholeCells; }
    /// Returns whether that surface has points of its own, which the pointer then touches.
    bool ridesInside() const { return showsSkin() && m_picture.embedding->isFree(); }
    /// Returns the points of that surface.
    const Points<3>& skinPose() const;
    /// Returns the points that fit() shows: all drawn ones. The view rotates around the middle of the solid.
    virtual Points<3> fitted() const;
    /// Returns the nearest drawn point that the ray hits.
    SolidHit hitOf(const Ray& ray) const;
    bool drawsInSoftware() const { return m_renderer.isSoftware(); }
    /// Returns whether the content will change again soon.
    virtual bool isMoving() const { return m_rest.isActive(); }
    /// Drops the vertices that the solid hides.
    void keepVisible(std::vector<int>& vertices) const;

  private:
    void remakeSurface();
    void upload();
    void uploadMeshes();
    void uploadTextures();
    void releaseGl();
    void uploadPose();
    void uploadColours();
    void uploadPlaces(SurfaceRenderer::Layer layer, const DrawMesh& mesh, bool skin);
    void uploadGlyphs();
    void uploadRim(const Sight& sight);
    std::vector<QRgb> coloursOf(const DrawMesh& mesh, bool skin) const;
    /// The inputs of a painting besides the uploaded data.
    struct Scene {
        Sight sight;
        SurfaceStyle style;
        QColor background;
        bool coarse = false, materials = false;

        bool operator==(const Scene&) const = default;
        /// A fine drawing serves as a coarse one.
        bool isServedBy(const Scene& painted) const {
            Scene wanted = *this;
            wanted.coarse = coarse && painted.coarse;
            return wanted == painted;
        }
    };
    Scene scene() const;
    bool isStale() const;
    SurfaceStyle style() const;
    static bool bind(std::unique_ptr<QOpenGLFramebufferObject>& buffer, const QSize& pixels, int samples);
    void drawScene(const Sight& sight, const QColor& background);
    void drawFinely(const Scene& scene);
    void drawCoarsely(const Scene& scene);
    QImage tile(const QRect& part, const QSize& whole, const QColor& background);
    QColor background() const;
    Eigen::Vector2d pixelOf(const QPointF& p) const { return {p.x(), p.y()}; }

    Camera m_camera;
    SurfaceRenderer m_renderer;
    SurfaceStyle m_style;
    VolumePicture m_picture;
    std::shared_ptr<const Skin> m_textured;  // the skin whose pictures were uploaded
    CutSurface m_surface;
    DrawMesh m_outer, m_section;
    std::vector<std::array<int, 2>> m_outline;  // of the section: its points
    Points<3> m_sectionEnds{3, 0};              // of the lines of the outline
    Contour m_contour;                          // of m_outer, if it is asked for
    mutable std::optional<Points<3>> m_ridden;  // until the pose changes
    mutable RayCasting m_rays;
    mutable SkinCasting m_skinRays;
    CutPlane m_plane;
    CutKind m_cut = CutKind::None;
    Navigation m_navigation;
    QColor m_background;
    std::vector<DrawVertex> m_glyphs, m_veiled;
    std::unique_ptr<QOpenGLFramebufferObject> m_fine, m_coarse;
    QTimer m_rest;  // runs while something moves
    FrameTimes m_times;
    std::optional<Scene> m_painted;  // the content of the view's buffer
    int m_largestTile = 2048, m_drawnTriangles = 0;
    bool m_meshStale = true, m_poseStale = true, m_coloursStale = true, m_texturesStale = true;
    bool m_glyphsStale = false, m_ready = false, m_hasNormals = false, m_hasContour = false;
    bool m_isSlow = false;  // what moves is drawn with fewer pixels
};

}  // namespace wend
