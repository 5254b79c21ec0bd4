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

#include "app/view/volume/draw_mesh.h"
#include "app/view/volume/line_renderer.h"

namespace wend {

/// A corner of a triangle that is drawn beside the surface.
struct DrawVertex {
    std::array<float, 3> position, normal;
    std::array<unsigned char, 4> colour;
};

/// How a surface is drawn.
struct SurfaceStyle {
    bool flat = false;
    bool edges = true;
    double dimming = 0;  // 0 … 1: towards grey
    QColor edgeColour = QColor(20, 24, 32);
    QColor lightEdgeColour = QColor(236, 238, 244);  // on what is dark
    QColor backColour = QColor(150, 92, 86);
    double ownFromBehind = 0;  // 0 … 1: how much of its own colour a face seen from behind keeps
    double mapOpacity = 0;     // 0 … 1: how much the colours of a map cover a surface that has its own
    QColor rim;                // around all of it; none if it is no colour

    bool operator==(const SurfaceStyle&) const = default;
};

/// From where a scene is seen.
struct Sight {
    Eigen::Matrix4d view, projection;
    bool orthographic = false;
    QSize pixels;          // of the picture
    double pixelsPer = 1;  // pixel of the view, by which the width of lines goes

    bool operator==(const Sight& other) const {
        return view == other.view && projection == other.projection && orthographic == other.orthographic &&
               pixels == other.pixels && pixelsPer == other.pixelsPer;
    }
};

/// Triangle meshes on the GPU (OpenGL 3.3). What a pose changes is uploaded alone: positions and normals of
/// shared vertices. All calls with the context current.
class SurfaceRenderer {
  public:
    /// The outer surface, and the section where it is cut open.
    enum Layer { Outer, Section };
    static constexpr int kLayers = 2;
    static constexpr int kMostKinds = 4;  // of what is marked

    /// False, with the reason in error(), if the context cannot run the shaders.
    bool initialize();
    void release();
    const QString& error() const { return m_error; }
    /// True if the processor draws.
    bool isSoftware() const { return m_isSoftware; }

    /// Triangles, creases and texture points: once for each surface. Then its pose is needed.
    void setMesh(Layer layer, const DrawMesh& mesh);
    void clear(Layer layer);
    /// Positions of the mesh's points; also normals, unless all faces are flat.
    void setPose(Layer layer, const DrawMesh& mesh, const Points<3>& points, bool withNormals);
    /// One per triangle.
    void setColours(Layer layer, const std::vector<QRgb>& colours);
    /// Those of a map over the layer, one per triangle: drawn where `style` has an opacity for it.
    void setMap(Layer layer, const std::vector<QRgb>& colours);
    /// More than 0: what is painted lies over the colours, so opaque. Its own are the places, times their
    /// opacity, or, where it is not 0, that of the triangle in the map.
    void setPaint(double opacity) { m_paint = opacity; }
    /// Pictures of the skin's materials, null ones where there are none.
    void setTextures(const std::vector<QImage>& pictures);
    /// For colours that change smoothly, per vertex of the mesh: its place in the ramp of colours (the first
    /// number), or what is painted there. None: each triangle has its own.
    using Place = std::array<float, 4>;
    void setPlaces(Layer layer, const std::vector<Place>& places);
    /// The colours of the places from 0 to 1; none: there is no ramp.
    void setRamp(const std::vector<QRgb>& colours);
    /// Lines around the section: both ends of each.
    void setOutline(const Points<3>& ends);
    /// What the rim runs along, likewise.
    void setRim(const Points<3>& ends);
    /// Things beside the surface: arrows, ellipsoids.
    void setGlyphs(const std::vector<DrawVertex>& triangles);
    /// What is seen through the surface, faintly, and not where nothing lies in front of it.
    void setVeiled(const std::vector<DrawVertex>& triangles);
    /// Triangles of the surface that are seen through it likewise, of several kinds. Where one lies before
    /// another, that one is seen in stripes: their colours do not mix.
    void setMarked(const std::vector<std::vector<DrawVertex>>& kinds);
    /// Without `materials` no texture is drawn. The plane takes away the part of the outer surface that lies
    /// above it.
    void draw(const Sight& sight, const SurfaceStyle& style, bool materials,
              const std::optional<CutPlane>& clip);

  private:
    struct Triangles {
        QOpenGLVertexArrayObject array;
        QOpenGLBuffer vertices{QOpenGLBuffer::VertexBuffer}, uv{QOpenGLBuffer::VertexBuffer},
            places{QOpenGLBuffer::VertexBuffer}, indices{QOpenGLBuffer::IndexBuffer};
        std::unique_ptr<QOpenGLTexture> colours, map;
        std::vector<DrawMesh::Part> parts;
        int count = 0;
        bool isSmooth = false;
    };
    struct Corner {
        std::array<float, 3> position, normal;
    };
    bool link(QOpenGLShaderProgram& program, bool edges);
    void create(Triangles& triangles);
    static void fill(std::unique_ptr<QOpenGLTexture>& texture, const std::vector<QRgb>& colours);
    void createGlyphs(Triangles& glyphs);
    void fillGlyphs(Triangles& glyphs, const std::vector<DrawVertex>& triangles);
    std::vector<std::array<float, 3>> placesOf(const Points<3>& points) const;
    /// The matrices in units of m_scale from m_centre on.
    std::pair<Eigen::Matrix4d, Eigen::Matrix4d> matricesOf(const Sight& sight) const;
    void setUniforms(QOpenGLShaderProgram& program, const Sight& sight, const SurfaceStyle& style,
                     const std::optional<CutPlane>& clip);
    void drawLayer(QOpenGLShaderProgram& program, Triangles& triangles, bool materials, double mapOpacity);
    void drawGlyphs(Triangles& glyphs, QOpenGLShaderProgram& program);
    void drawVeiled();
    void drawMarked(QOpenGLShaderProgram& seen, const Sight& sight);
    LineRenderer::Look lineLook(const Sight& sight, double width, const QColor& colour) const;
    Eigen::Vector3f normalized(const Vec<3>& p) const { return ((p - m_centre) / m_scale).cast<float>(); }

    QOpenGLFunctions_3_3_Core* m_gl = nullptr;
    std::unique_ptr<QOpenGLShaderProgram> m_plain, m_edged;
    std::array<Triangles, kLayers> m_layers;
    Triangles m_glyphs, m_veiled;
    std::array<Triangles, kMostKinds> m_marked;
    LineRenderer m_outline, m_rim;
    std::vector<std::unique_ptr<QOpenGLTexture>> m_textures;
    std::unique_ptr<QOpenGLTexture> m_noTexture, m_ramp;
    Vec<3> m_centre = Vec<3>::Zero();  // of what is drawn: the GPU's floats count from there, in m_scale
    double m_scale = 1, m_paint = 0;
    bool m_isSoftware = false;
    QString m_error;
};

}  // namespace wend
