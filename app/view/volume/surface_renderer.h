#pragma once

#include <Eigen/Core>
#include <QColor>
#include <QOpenGLBuffer>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <array>
#include <vector>

#include "core/mesh/cut_plane.h"

namespace wend {

/// A corner of a triangle on the GPU.
struct DrawVertex {
    std::array<float, 3> position, normal;
    std::array<unsigned char, 4> colour;
};

/// How a surface is drawn.
struct SurfaceStyle {
    bool flat = false;
    bool edges = true;
    QColor edgeColour = QColor(20, 24, 32);
    QColor backColour = QColor(150, 92, 86);
};

/// The triangles of a CutSurface on the GPU (OpenGL 3.3). All calls with the context current.
class SurfaceRenderer {
  public:
    /// False, with the reason in error(), if the context cannot run the shaders.
    bool initialize();
    void release();
    const QString& error() const { return m_error; }

    /// The triangles at a pose; colours are one per vertex of the mesh, or one per cell.
    void upload(const CutSurface& surface, const Points<3>& pose, const std::vector<QRgb>& vertexColours,
                const std::vector<QRgb>& cellColours);
    /// Things beside the surface: arrows, ellipsoids.
    void uploadGlyphs(const std::vector<DrawVertex>& triangles);
    void draw(const Eigen::Matrix4d& view, const Eigen::Matrix4d& projection, bool orthographic,
              const SurfaceStyle& style);

  private:
    QOpenGLFunctions_3_3_Core* m_gl = nullptr;
    QOpenGLShaderProgram m_program;
    struct Triangles {
        QOpenGLVertexArrayObject array;
        QOpenGLBuffer buffer{QOpenGLBuffer::VertexBuffer};
        int vertices = 0;
    };
    void create(Triangles& triangles);
    void fill(Triangles& triangles, const std::vector<DrawVertex>& vertices);
    void draw(Triangles& triangles);

    Triangles m_surface, m_glyphs;
    QString m_error;
};

}  // namespace wend
