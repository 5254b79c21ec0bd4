#pragma once

#include <QOpenGLFramebufferObject>
#include <QOpenGLWidget>
#include <QPoint>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "app/views/volume/camera.h"
#include "app/views/volume/drawn_solid.h"

namespace wend {

/// A view of a solid, which can be rotated, panned, zoomed and cut by a plane.
class VolumeView : public QOpenGLWidget {
    Q_OBJECT

  public:
    explicit VolumeView(QWidget* parent = nullptr);
    ~VolumeView() override;

    /// Returns false without OpenGL; do not make a VolumeView then (Qt 6.4 crashes on the offscreen
    /// platform).
    static bool available();

    /// Returns what is drawn.
    const DrawnSolid& solid() const { return m_solid; }
    void setPicture(VolumePicture picture, bool fitView);
    void setStyle(const SurfaceStyle& style) { m_solid.setStyle(style), update(); }
    void setCut(CutKind kind, const CutPlane& plane) { m_solid.setCut(kind, plane), update(); }
    Camera& camera() { return m_camera; }
    const Camera& camera() const { return m_camera; }
    void setCamera(const Camera& camera) { m_camera = camera, emit cameraChanged(); }
    Navigation& navigation() { return m_navigation; }
    const Navigation& navigation() const { return m_navigation; }
    void setGlyphs(std::vector<DrawVertex> triangles, std::vector<DrawVertex> veiled = {});
    /// Returns the view as a picture of any size, drawn in tiles if it is larger than the renderer allows;
    /// the background may be left transparent. Returns a null image if the memory does not suffice.
    QImage picture(const QSize& size, bool transparent) {
        return pictureRows(size, 0, size.height(), transparent);
    }
    /// Returns some rows of a picture.
    QImage pictureRows(const QSize& size, int top, int rows, bool transparent);
    /// Returns why there can be no picture; empty if there can.
    QString obstacle() const;
    /// Tiles of a picture are at most so large, also where the renderer could do more.
    void setLargestTile(int pixels) { m_largestTile = pixels; }
    /// Something moves and will be drawn again soon: where the processor draws, edges are not smoothed until
    /// it is over.
    void hurry() { m_rest.start(); }
    /// Times of a frame in milliseconds: preparation of a pose, and drawing.
    struct FrameTimes {
        double prepare = 0, draw = 0;
    };
    const FrameTimes& lastFrame() const { return m_times; }
    /// Returns whether the last drawing is current and of full quality.
    bool isSettled() const;
    /// Shows fitted(), and rotates around the middle of the solid from then on.
    void fit();
    /// Returns the points that fit() shows: all drawn ones.
    virtual Points3 fitted() const { return m_solid.points(); }
    void look(Camera::Axis axis);
    void setOrthographic(bool on);

    /// Returns the nearest triangle under a pixel, or cell −1.
    SolidHit pick(const QPointF& pixel) const;
    /// Returns all vertices in front of the cut that are inside on the screen, only visible ones if
    /// `visibleOnly`.
    std::vector<int> verticesWhere(const std::function<bool(const QPointF&)>& inside, bool visibleOnly) const;

  signals:
    void cameraChanged();
    /// Emits unreadable pictures of materials, once per surface.
    void picturesMissing(const QStringList& files);

  protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override { m_navigation.press(*event); }
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void setBackground(const QColor& colour) { m_background = colour; }
    /// Returns whether the content will change again soon.
    virtual bool isMoving() const { return m_rest.isActive(); }

  private:
    void releaseGl();
    /// The inputs of a painting besides the uploaded data.
    struct Scene {
        Sight sight;
        SurfaceStyle style;
        QColor background;
        bool coarse = false, materials = false;

        bool operator==(const Scene&) const = default;
        /// Returns whether the painted scene will do: a fine drawing serves as a coarse one.
        bool isServedBy(const Scene& painted) const {
            Scene wanted = *this;
            wanted.coarse = coarse && painted.coarse;
            return wanted == painted;
        }
    };
    Scene scene() const;
    void drawScene(const Sight& sight, const QColor& background);
    void drawFinely(const Scene& scene);
    void drawCoarsely(const Scene& scene);
    QImage tile(const QRect& part, const QSize& whole, const QColor& background);
    QColor background() const;

    Camera m_camera;
    DrawnSolid m_solid;
    Navigation m_navigation;
    QColor m_background;
    std::unique_ptr<QOpenGLFramebufferObject> m_fine, m_coarse;
    QTimer m_rest;  // runs while something moves
    FrameTimes m_times;
    std::optional<Scene> m_painted;  // the content of the view's buffer
    int m_largestTile = 2048;
    bool m_ready = false, m_isSlow = false;  // slow: what moves is drawn with fewer pixels
};

}  // namespace wend
