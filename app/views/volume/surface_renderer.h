#pragma once

#include <Eigen/Core>
#include <QColor>
#include <QImage>
#include <QOpenGLBuffer>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLTexture>
#include <QOpenGLVertexArrayObject>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/views/volume/draw_mesh.h"
#include "app/views/volume/line_renderer.h"

namespace wend {

/// A corner of an additional triangle.
struct DrawVertex {
    std::array<float, 3> position, normal;
    std::array<unsigned char, 4> colour;
};

/// Options for drawing a surface.
struct SurfaceStyle {
    bool flat = false;
    bool edges = true;
    double dimming = 0;  // 0 … 1: towards grey
    QColor edgeColour = QColor(20, 24, 32);
    QColor lightEdgeColour = QColor(236, 238, 244);  // over dark colours
    QColor backColour = QColor(150, 92, 86);
    double ownFromBehind = 0;  // 0 … 1: how much of its own colour a face seen from behind keeps
    double mapOpacity = 0;     // 0 … 1: how much the colours of a map cover a surface that has its own
    QColor rim;                // around all of it; none if it is no colour

    bool operator==(const SurfaceStyle&) const = default;
};

/// The view and projection matrices.
struct Sight {
    Eigen::Matrix4d view, projection;
    bool orthographic = false;
    QSize pixels;          // of the picture
    double pixelsPer = 1;  // device pixels per logical pixel, for line widths

    bool operator==(const Sight& other) const {
        return view == other.view && projection == other.projection && orthographic == other.orthographic &&
               pixels == other.pixels && pixelsPer == other.pixelsPer;
    }
};

/// Draws triangle meshes on the GPU (OpenGL 3.3). Only data that a pose changes is uploaded again: positions
/// and normals of shared vertices. All calls need the current context.
class SurfaceRenderer {
  public:
    /// The outer surface, and the section where it is cut open.
    enum Layer { Outer, Section };
    static constexpr int kLayers = 2;
    static constexpr int kMostKinds = 4;  // kinds of marked triangles

    /// Returns false, with the reason in error(), if the context cannot run the shaders.
    bool initialize();
    void release();
    const QString& error() const { return m_error; }
    /// Returns whether the CPU draws.
    bool isSoftware() const { return m_isSoftware; }

    /// Sets triangles, creases and texture points, once for each surface. Its pose must be set afterwards.
    void setMesh(Layer layer, const DrawMesh& mesh);
    /// Positions of the mesh's points; also normals, unless all faces are flat.
    void setPose(Layer layer, const DrawMesh& mesh, const Points3& points, bool withNormals);
    /// Sets one colour per triangle.
    void setColours(Layer layer, const std::vector<QRgb>& colours) { fill(m_layers[layer].colours, colours); }
    /// Sets map colours over the layer, one per triangle, drawn with the opacity in `style`.
    void setMap(Layer layer, const std::vector<QRgb>& colours) { fill(m_layers[layer].map, colours); }
    /// Sets the opacity of paint over the colours; 0 for none. Its own opacity is that of the places or, if
    /// it is not 0, of the triangle in the map.
    void setPaint(double opacity) { m_paint = opacity; }
    /// Sets the pictures of the skin's materials; null for none.
    void setTextures(const std::vector<QImage>& pictures);
    /// Sets smooth colours per vertex: a position in the colour ramp (first number), or paint. None: per
    /// triangle.
    using Place = std::array<float, 4>;
    void setPlaces(Layer layer, const std::vector<Place>& places);
    /// Sets the colours of the positions from 0 to 1; empty if there is no ramp.
    void setRamp(const std::vector<QRgb>& colours);
    /// Sets lines around the section, by both ends of each.
    void setOutline(const Points3& ends) { m_outline.set(placesOf(ends)); }
    /// Sets the edges of the rim, by both ends of each.
    void setRim(const Points3& ends) { m_rim.set(placesOf(ends)); }
    /// Sets additional triangles: arrows, ellipsoids.
    void setGlyphs(const std::vector<DrawVertex>& triangles) { fillGlyphs(m_glyphs, triangles); }
    /// Sets triangles that are visible through the surface, faintly, only where they are covered.
    void setVeiled(const std::vector<DrawVertex>& triangles) { fillGlyphs(m_veiled, triangles); }
    /// Sets marked triangles of the surface, which are visible through it, in several kinds. Overlapping
    /// kinds are drawn in stripes, so that colours do not mix.
    void setMarked(const std::vector<std::vector<DrawVertex>>& kinds);
    /// Draws without textures unless `materials`. The plane removes the part of the outer surface above it.
    void draw(const Sight& sight, const SurfaceStyle& style, bool materials,
              const std::optional<CutPlane>& clip);

  private:
    struct Triangles {
        QOpenGLVertexArrayObject array;
        QOpenGLBuffer vertices{QOpenGLBuffer::VertexBuffer}, uv{QOpenGLBuffer::VertexBuffer},
            tints{QOpenGLBuffer::VertexBuffer}, places{QOpenGLBuffer::VertexBuffer},
            indices{QOpenGLBuffer::IndexBuffer};
        std::unique_ptr<QOpenGLTexture> colours, map;
        std::vector<DrawMesh::Part> parts;
        int count = 0;
        bool isSmooth = false, isTinted = false;

        std::array<QOpenGLBuffer*, 5> buffers() { return {&vertices, &uv, &tints, &places, &indices}; }
    };
    struct Corner {
        std::array<float, 3> position, normal;
    };
    bool link(QOpenGLShaderProgram& program, bool edges);
    void create(Triangles& triangles);
    static void fill(std::unique_ptr<QOpenGLTexture>& texture, const std::vector<QRgb>& colours);
    /// Sets values of vertices in the bound array. Returns false if there are none.
    template <class T>
    bool setOptional(GLuint location, QOpenGLBuffer& buffer, const std::vector<T>& values);
    void createGlyphs(Triangles& glyphs);
    void fillGlyphs(Triangles& glyphs, const std::vector<DrawVertex>& triangles);
    std::vector<std::array<float, 3>> placesOf(const Points3& points) const;
    /// Returns the matrices in units of m_scale, relative to m_centre.
    std::pair<Eigen::Matrix4d, Eigen::Matrix4d> matricesOf(const Sight& sight) const;
    void setUniforms(QOpenGLShaderProgram& program, const Sight& sight, const SurfaceStyle& style,
                     const std::optional<CutPlane>& clip);
    void drawLayer(QOpenGLShaderProgram& program, Triangles& triangles, bool materials, double mapOpacity);
    void drawGlyphs(Triangles& glyphs, QOpenGLShaderProgram& program);
    void drawVeiled();
    void drawMarked(QOpenGLShaderProgram& seen, const Sight& sight);
    LineRenderer::Look lineLook(const Sight& sight, double width, const QColor& colour) const;
    Eigen::Vector3f normalized(const Vec3& p) const { return ((p - m_centre) / m_scale).cast<float>(); }

    QOpenGLFunctions_3_3_Core* m_gl = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> m_plain, m_edged;
    std::array<Triangles, kLayers> m_layers;
    Triangles m_glyphs, m_veiled;
    std::array<Triangles, kMostKinds> m_marked;
    LineRenderer m_outline, m_rim;
    std::vector<std::unique_ptr<QOpenGLTexture>> m_textures;
    std::unique_ptr<QOpenGLTexture> m_noTexture, m_ramp;
    Vec3 m_centre = Vec3::Zero();  // origin and scale of coordinates on the GPU
    double m_scale = 1, m_paint = 0;
    bool m_isSoftware = false;
    QString m_error;
};

}  // namespace wend
