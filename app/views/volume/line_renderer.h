#pragma once

#include <QColor>
#include <QMatrix4x4>
#include <QOpenGLBuffer>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/views/volume/camera.h"
#include "core/mesh/cut_plane.h"

namespace wend {

/// The silhouette edges of a triangle surface.
class Contour {
  public:
    /// Takes triangles of point indices.
    void takeTriangles(const std::vector<std::array<int, 3>>& triangles);
    void takePoints(Points3 points) { m_points = std::move(points); }
    /// Returns both ends of each silhouette edge in a view, without parts above the plane.
    Points3 ends(const Eigen::Matrix4d& view, bool orthographic, const std::optional<CutPlane>& clip) const;

  private:
    struct Edge {
        int from, to;
        int one, other;  // triangles; −1 for none
    };
    std::vector<std::array<int, 3>> m_triangles;
    std::vector<Edge> m_edges;
    Points3 m_points;
};

/// Lines in space, as wide on the screen as one likes (OpenGL 3.3). All calls with the context current.
class LineRenderer {
  public:
    /// Returns false, with the reason in error(), if the context cannot run the shaders.
    bool initialize(QOpenGLFunctions_3_3_Core* gl);
    void release();
    const QString& error() const { return m_error; }

    /// Sets both ends of each line.
    void set(const std::vector<std::array<float, 3>>& ends);
    /// How lines are drawn.
    struct Look {
        QMatrix4x4 view, projection;
        bool orthographic = false;
        QSize pixels;  // of the picture
        float width = 1;
        QColor colour;
        bool behindAll = false;  // only where nothing else is drawn, and each pixel once
    };
    void draw(const Look& look);

  private:
    QOpenGLFunctions_3_3_Core* m_gl = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    QOpenGLVertexArrayObject m_array;
    QOpenGLBuffer m_vertices{QOpenGLBuffer::VertexBuffer};
    int m_count = 0;  // ends
    QString m_error;
};

}  // namespace wend
