#include "app/view/volume/surface_renderer.h"

#include <Eigen/Geometry>
#include <QMatrix4x4>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

namespace wend {
namespace {

std::array<float, 3> floats(const Vec<3>& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

std::array<unsigned char, 4> bytes(QRgb c) {
    return {static_cast<unsigned char>(qRed(c)), static_cast<unsigned char>(qGreen(c)),
            static_cast<unsigned char>(qBlue(c)), static_cast<unsigned char>(qAlpha(c))};
}

QMatrix4x4 toQt(const Eigen::Matrix4d& matrix) {
    QMatrix4x4 result;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) result(i, j) = static_cast<float>(matrix(i, j));
    return result;
}

Vec<3> place(const CutSurface::Corner& c, const Points<3>& pose) {
    return (1 - c.weight) * pose.col(c.from) + c.weight * pose.col(c.to);
}

/// Faces that meet at a sharper angle than this keep their edge.
const double kCrease = std::cos(40 * std::numbers::pi / 180);

Vec<3> areaVector(const std::array<CutSurface::Corner, 3>& corners, const Points<3>& pose) {
    const Vec<3> a = place(corners[0], pose);
    return (place(corners[1], pose) - a).cross(place(corners[2], pose) - a) / 2;
}

int nearerVertex(const CutSurface::Corner& corner) {
    return corner.weight < 0.5 ? corner.from : corner.to;
}

/// Normals of the outer surface: per corner the mean of the faces at its vertex that its own face meets
/// smoothly, by area.
class CornerNormals {
  public:
    CornerNormals(const CutSurface& surface, const Points<3>& pose)
        : m_start(static_cast<std::size_t>(pose.cols()) + 1, 0) {
        for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
            m_areas.push_back(areaVector(surface.triangles[t], pose));
            if (surface.onCut[t]) continue;
            for (const auto& corner : surface.triangles[t]) ++m_start[nearerVertex(corner) + 1];
        }
        std::partial_sum(m_start.begin(), m_start.end(), m_start.begin());
        std::vector<int> at(m_start.begin(), m_start.end() - 1);
        m_faces.resize(static_cast<std::size_t>(m_start.back()));
        for (std::size_t t = 0; t < surface.triangles.size(); ++t)
            if (!surface.onCut[t])
                for (const auto& corner : surface.triangles[t])
                    m_faces[at[nearerVertex(corner)]++] = static_cast<int>(t);
    }

    Vec<3> face(std::size_t t) const { return m_areas[t].normalized(); }

    Vec<3> corner(std::size_t t, const CutSurface::Corner& corner) const {
        const Vec<3> own = face(t);
        Vec<3> sum = Vec<3>::Zero();
        const int vertex = nearerVertex(corner);
        for (int k = m_start[vertex]; k < m_start[vertex + 1]; ++k) {
            const Vec<3>& other = m_areas[m_faces[k]];
            if (own.dot(other) >= kCrease * other.norm()) sum += other;
        }
        return sum.isZero() ? own : sum.normalized();
    }

  private:
    std::vector<Vec<3>> m_areas;
    std::vector<int> m_start, m_faces;
};

QRgb mixed(QRgb a, QRgb b, double t) {
    const auto mix = [t](int x, int y) { return static_cast<int>(x + t * (y - x) + 0.5); };
    return qRgba(mix(qRed(a), qRed(b)), mix(qGreen(a), qGreen(b)), mix(qBlue(a), qBlue(b)),
                 mix(qAlpha(a), qAlpha(b)));
}

std::vector<DrawVertex> assemble(const CutSurface& surface, const Points<3>& pose,
                                 const std::vector<QRgb>& vertexColours,
                                 const std::vector<QRgb>& cellColours) {
    const CornerNormals normals(surface, pose);
    std::vector<DrawVertex> vertices;
    vertices.reserve(3 * surface.triangles.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto& corners = surface.triangles[t];
        for (const auto& corner : corners) {
            const Vec<3> normal = surface.onCut[t] ? normals.face(t) : normals.corner(t, corner);
            const QRgb colour = !cellColours.empty() ? cellColours[surface.cells[t]]
                                                     : mixed(vertexColours[corner.from],
                                                             vertexColours[corner.to], corner.weight);
            vertices.push_back({floats(place(corner, pose)), floats(normal), bytes(colour)});
        }
    }
    return vertices;
}

QVector3D toVector(const QColor& c) {
    return {c.redF(), c.greenF(), c.blueF()};
}

}  // namespace

bool SurfaceRenderer::initialize() {
    m_gl = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(QOpenGLContext::currentContext());
    if (m_gl == nullptr) {
        m_error = QStringLiteral("OpenGL 3.3 is not available");
        return false;
    }
    const bool linked =
        m_program.addShaderFromSourceFile(QOpenGLShader::Vertex, QStringLiteral(":/shaders/surface.vert")) &&
        m_program.addShaderFromSourceFile(QOpenGLShader::Fragment,
                                          QStringLiteral(":/shaders/surface.frag")) &&
        m_program.link();
    if (!linked) {
        m_error = m_program.log();
        return false;
    }
    create(m_surface);
    create(m_glyphs);
    return true;
}

void SurfaceRenderer::create(Triangles& triangles) {
    triangles.array.create();
    triangles.buffer.create();
    triangles.buffer.setUsagePattern(QOpenGLBuffer::DynamicDraw);
    const QOpenGLVertexArrayObject::Binder binder(&triangles.array);
    triangles.buffer.bind();
    for (int location = 0; location < 3; ++location) m_program.enableAttributeArray(location);
    constexpr int kStride = sizeof(DrawVertex);
    m_program.setAttributeBuffer(0, GL_FLOAT, offsetof(DrawVertex, position), 3, kStride);
    m_program.setAttributeBuffer(1, GL_FLOAT, offsetof(DrawVertex, normal), 3, kStride);
    m_gl->glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                                reinterpret_cast<void*>(offsetof(DrawVertex, colour)));
}

void SurfaceRenderer::release() {
    for (Triangles* triangles : {&m_surface, &m_glyphs}) {
        triangles->buffer.destroy();
        triangles->array.destroy();
    }
    m_program.removeAllShaders();
}

void SurfaceRenderer::fill(Triangles& triangles, const std::vector<DrawVertex>& vertices) {
    triangles.vertices = static_cast<int>(vertices.size());
    triangles.buffer.bind();
    triangles.buffer.allocate(vertices.data(), triangles.vertices * static_cast<int>(sizeof(DrawVertex)));
}

void SurfaceRenderer::upload(const CutSurface& surface, const Points<3>& pose,
                             const std::vector<QRgb>& vertexColours, const std::vector<QRgb>& cellColours) {
    fill(m_surface, assemble(surface, pose, vertexColours, cellColours));
}

void SurfaceRenderer::uploadGlyphs(const std::vector<DrawVertex>& triangles) {
    fill(m_glyphs, triangles);
}

void SurfaceRenderer::draw(Triangles& triangles) {
    const QOpenGLVertexArrayObject::Binder binder(&triangles.array);
    m_gl->glDrawArrays(GL_TRIANGLES, 0, triangles.vertices);
}

void SurfaceRenderer::draw(const Eigen::Matrix4d& view, const Eigen::Matrix4d& projection, bool orthographic,
                           const SurfaceStyle& style) {
    m_program.bind();
    m_program.setUniformValue("view", toQt(view));
    m_program.setUniformValue("projection", toQt(projection));
    m_program.setUniformValue("flatShading", style.flat);
    m_program.setUniformValue("orthographic", orthographic);
    m_program.setUniformValue("edgeStrength", style.edges ? 0.45F : 0.0F);
    m_program.setUniformValue("edgeColour", toVector(style.edgeColour));
    m_program.setUniformValue("backColour", toVector(style.backColour));
    m_gl->glEnable(GL_DEPTH_TEST);
    draw(m_surface);
    m_program.setUniformValue("edgeStrength", 0.0F);
    m_program.setUniformValue("flatShading", false);
    draw(m_glyphs);
    m_program.release();
    m_gl->glDisable(GL_DEPTH_TEST);
}

}  // namespace wend
