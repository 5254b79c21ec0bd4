#include "app/view/volume/surface_renderer.h"

#include <Eigen/Geometry>
#include <QMatrix4x4>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <array>
#include <cstddef>

namespace wend {
namespace {

struct GpuVertex {
    std::array<float, 3> position, normal;
    std::array<unsigned char, 4> colour;
};

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

/// Sum of the triangles' area vectors per vertex: smooth normals of the outer surface.
Points<3> vertexNormals(const CutSurface& surface, const Points<3>& pose) {
    Points<3> normals = Points<3>::Zero(3, pose.cols());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        if (surface.onCut[t]) continue;
        const auto& corners = surface.triangles[t];
        const Vec<3> a = place(corners[0], pose);
        const Vec<3> area = (place(corners[1], pose) - a).cross(place(corners[2], pose) - a);
        for (const auto& c : corners) normals.col(c.weight < 0.5 ? c.from : c.to) += area;
    }
    return normals;
}

QRgb mixed(QRgb a, QRgb b, double t) {
    const auto mix = [t](int x, int y) { return static_cast<int>(x + t * (y - x) + 0.5); };
    return qRgba(mix(qRed(a), qRed(b)), mix(qGreen(a), qGreen(b)), mix(qBlue(a), qBlue(b)),
                 mix(qAlpha(a), qAlpha(b)));
}

std::vector<GpuVertex> assemble(const CutSurface& surface, const Points<3>& pose,
                                const std::vector<QRgb>& vertexColours,
                                const std::vector<QRgb>& cellColours) {
    const Points<3> normals = vertexNormals(surface, pose);
    std::vector<GpuVertex> vertices;
    vertices.reserve(3 * surface.triangles.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto& corners = surface.triangles[t];
        const Vec<3> a = place(corners[0], pose), b = place(corners[1], pose), c = place(corners[2], pose);
        const Vec<3> flat = (b - a).cross(c - a).normalized();
        for (const auto& corner : corners) {
            Vec<3> normal = flat;
            if (!surface.onCut[t])
                normal = normals.col(corner.weight < 0.5 ? corner.from : corner.to).normalized();
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
    m_array.create();
    m_buffer.create();
    m_buffer.setUsagePattern(QOpenGLBuffer::DynamicDraw);
    const QOpenGLVertexArrayObject::Binder binder(&m_array);
    m_buffer.bind();
    for (int location = 0; location < 3; ++location) m_program.enableAttributeArray(location);
    constexpr int kStride = sizeof(GpuVertex);
    m_program.setAttributeBuffer(0, GL_FLOAT, offsetof(GpuVertex, position), 3, kStride);
    m_program.setAttributeBuffer(1, GL_FLOAT, offsetof(GpuVertex, normal), 3, kStride);
    m_gl->glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                                reinterpret_cast<void*>(offsetof(GpuVertex, colour)));
    return true;
}

void SurfaceRenderer::release() {
    m_buffer.destroy();
    m_array.destroy();
    m_program.removeAllShaders();
}

void SurfaceRenderer::upload(const CutSurface& surface, const Points<3>& pose,
                             const std::vector<QRgb>& vertexColours, const std::vector<QRgb>& cellColours) {
    const auto vertices = assemble(surface, pose, vertexColours, cellColours);
    m_vertices = static_cast<int>(vertices.size());
    m_buffer.bind();
    m_buffer.allocate(vertices.data(), m_vertices * static_cast<int>(sizeof(GpuVertex)));
}

void SurfaceRenderer::draw(const Eigen::Matrix4d& view, const Eigen::Matrix4d& projection, bool orthographic,
                           const SurfaceStyle& style) {
    const QOpenGLVertexArrayObject::Binder binder(&m_array);
    m_program.bind();
    m_program.setUniformValue("view", toQt(view));
    m_program.setUniformValue("projection", toQt(projection));
    m_program.setUniformValue("flatShading", style.flat);
    m_program.setUniformValue("orthographic", orthographic);
    m_program.setUniformValue("edgeStrength", style.edges ? 0.55F : 0.0F);
    m_program.setUniformValue("edgeColour", toVector(style.edgeColour));
    m_program.setUniformValue("backColour", toVector(style.backColour));
    m_gl->glEnable(GL_DEPTH_TEST);
    m_gl->glDrawArrays(GL_TRIANGLES, 0, m_vertices);
    m_program.release();
}

}  // namespace wend
