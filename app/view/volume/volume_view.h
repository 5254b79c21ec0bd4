#pragma once

#include <QOpenGLFramebufferObject>
#include <QOpenGLWidget>
#include <QPoint>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>

#include "app/view/volume/camera.h"
#include "app/view/volume/contour.h"
#include "app/view/volume/navigation.h"
#include "app/view/volume/ray_casting.h"
#include "app/view/volume/skin_casting.h"
#include "app/view/volume/surface_renderer.h"
#include "app/view/volume/volume_picture.h"
#include "core/mesh/cut_plane.h"

namespace wend {

enum class CutKind { None, WholeCells, Exact };

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
    void setPreset(NavigationPreset preset) { m_navigation.setPreset(preset); }
    Camera& camera() { return m_camera; }
    const Camera& camera() const { return m_camera; }
    /// Triangles that are drawn beside the surface; the veiled ones are seen, faintly, where it hides them.
    void setGlyphs(std::vector<DrawVertex> triangles, std::vector<DrawVertex> veiled = {});
    /// What is drawn: the surface, cut as it is.
    const CutSurface& surface() const { return m_surface; }
    /// The view as a picture of any size, drawn in tiles where it is larger than the renderer can; the
    /// background may be left transparent. Null if the memory does not suffice.
    QImage picture(const QSize& size, bool transparent) {
        return pictureRows(size, 0, size.height(), transparent);
    }
    /// Some rows of it.
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
    /// What a frame cost, in milliseconds: the preparation of a new pose, and the drawing.
    struct FrameTimes {
        double prepare = 0, draw = 0;
    };
    const FrameTimes& lastFrame() const { return m_times; }
    /// True if what was drawn last is what there is to show, at full quality.
    bool isSettled() const;
    void fit();
    void look(Camera::Axis axis);
    void setOrthographic(bool on);

    /// The nearest triangle under a pixel, or cell −1.
    SolidHit pick(const QPointF& pixel) const;
    /// All vertices on screen inside the rectangle; only those that nothing hides if `visibleOnly`.
    std::vector<int> verticesIn(const QRectF& rectangle, bool visibleOnly) const;

  signals:
    void cameraChanged();
    /// Pictures of the surface's materials that cannot be read; told while it is drawn, once for each
    /// surface.
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

    /// True if a surface is embedded in the solid and is drawn in place of its border.
    bool showsSkin() const { return m_picture.skin && m_cut != CutKind::WholeCells; }
    /// True if it is drawn and has points of its own: then it is what the pointer touches.
    bool ridesInside() const { return showsSkin() && m_picture.embedding->isFree(); }
    /// Where the points of that surface are.
    const Points<3>& skinPose() const;
    /// What fit() brings into the view: all that is drawn. The view turns around the middle of the solid all
    /// the same.
    virtual Points<3> fitted() const;
    /// The nearest point of what is drawn that the ray meets.
    SolidHit hitOf(const Ray& ray) const;
    bool drawsInSoftware() const { return m_renderer.isSoftware(); }
    /// True while what is shown will change again soon.
    virtual bool isMoving() const { return m_rest.isActive(); }
    /// Drops the vertices that the solid hides.
    void keepVisible(std::vector<int>& vertices) const;

  private:
    void remakeSurface();
    void upload();
    void uploadMeshes();
    void uploadTextures();
    void releaseGl();
    bool bindFine();
    void uploadPose();
    void uploadColours();
    void uploadPlaces(SurfaceRenderer::Layer layer, const DrawMesh& mesh, bool skin);
    void uploadGlyphs();
    void uploadRim(const Sight& sight);
    std::vector<QRgb> coloursOf(const DrawMesh& mesh, bool skin) const;
    /// What a painting of the view depends on beside what is uploaded.
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
    void drawScene(const Sight& sight, const QColor& background);
    QImage tile(const QRect& part, const QSize& whole, const QColor& background);
    QColor background() const;
    Eigen::Vector2d pixelOf(const QPointF& p) const { return {p.x(), p.y()}; }

    Camera m_camera;
    SurfaceRenderer m_renderer;
    SurfaceStyle m_style;
    VolumePicture m_picture;
    std::shared_ptr<const Skin> m_textured;  // whose pictures the renderer has
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
    std::unique_ptr<QOpenGLFramebufferObject> m_fine;
    QTimer m_rest;  // runs while something moves
    FrameTimes m_times;
    std::optional<Scene> m_painted;  // what is in the view's buffer
    int m_largestTile = 2048, m_drawnTriangles = 0;
    bool m_meshStale = true, m_poseStale = true, m_coloursStale = true, m_texturesStale = true;
    bool m_glyphsStale = false, m_ready = false, m_hasNormals = false, m_hasContour = false;
};

}  // namespace wend
