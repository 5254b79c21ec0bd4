#include "app/views/volume/line_renderer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>

namespace wend {

void Contour::takeTriangles(const std::vector<std::array<int, 3>>& triangles) {
    m_triangles = triangles;
    std::vector<Edge> sides;
    sides.reserve(3 * triangles.size());
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
        for (int k = 0; k < 3; ++k) {
            const auto [from, to] = std::minmax({triangles[t][k], triangles[t][(k + 1) % 3]});
            sides.push_back({from, to, t, -1});
        }
    std::ranges::sort(sides, {}, [](const Edge& edge) { return std::tuple(edge.from, edge.to, edge.one); });
    m_edges.clear();
    for (const Edge& side : sides) {
        Edge* last = m_edges.empty() ? nullptr : &m_edges.back();
        const bool isShared =
            last != nullptr && last->from == side.from && last->to == side.to && last->other < 0;
        if (isShared)
            last->other = side.one;
        else
            m_edges.push_back(side);
    }
}

Points3 Contour::ends(const Eigen::Matrix4d& view, bool orthographic,
                      const std::optional<CutPlane>& clip) const {
    const Mat3 turn = view.topLeftCorner<3, 3>();
    const Vec3 eye = -(turn.transpose() * view.topRightCorner<3, 1>()), toViewer = turn.row(2);
    std::vector<bool> faces(m_triangles.size());
    for (std::size_t t = 0; t < m_triangles.size(); ++t) {
        const Vec3 a = m_points.col(m_triangles[t][0]);
        const Vec3 normal = (m_points.col(m_triangles[t][1]) - a).cross(m_points.col(m_triangles[t][2]) - a);
        faces[t] = normal.dot(orthographic ? toViewer : Vec3(eye - a)) > 0;
    }
    std::vector<Vec3> ends;
    for (const Edge& edge : m_edges) {
        if (edge.other >= 0 && faces[edge.one] == faces[edge.other]) continue;
        Vec3 a = m_points.col(edge.from), b = m_points.col(edge.to);
        const double heightOfA = clip ? clip->height(a) : -1, heightOfB = clip ? clip->height(b) : -1;
        if (heightOfA > 0 && heightOfB > 0) continue;
        if (heightOfA > 0) a += heightOfA / (heightOfA - heightOfB) * (b - a);
        if (heightOfB > 0) b += heightOfB / (heightOfB - heightOfA) * (a - b);
        ends.push_back(a);
        ends.push_back(b);
    }
    Points3 columns(3, static_cast<Eigen::Index>(ends.size()));
    for (Eigen::Index i = 0; i < columns.cols(); ++i) columns.col(i) = ends[static_cast<std::size_t>(i)];
    return columns;
}

bool LineRenderer::initialize(QOpenGLFunctions_3_3_Core* gl) {
    using Shader = QOpenGLShader;
    m_gl = gl;
    m_program = std::make_unique<QOpenGLShaderProgram>();
    const bool ok =
        m_program->addShaderFromSourceFile(Shader::Vertex, QStringLiteral(":/shaders/line.vert")) &&
        m_program->addShaderFromSourceFile(Shader::Geometry, QStringLiteral(":/shaders/line.geom")) &&
        m_program->addShaderFromSourceFile(Shader::Fragment, QStringLiteral(":/shaders/line.frag")) &&
        m_program->link();
    if (!ok) m_error = m_program->log();
    m_array.create();
    const QOpenGLVertexArrayObject::Binder binder(&m_array);
    m_vertices.create();
    m_vertices.setUsagePattern(QOpenGLBuffer::DynamicDraw);
    m_vertices.bind();
    m_gl->glEnableVertexAttribArray(0);
    m_gl->glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    return ok;
}

void LineRenderer::release() {
    m_vertices.destroy();
    m_array.destroy();
    m_program.reset();
    m_count = 0;
}

void LineRenderer::set(const std::vector<std::array<float, 3>>& ends) {
    m_count = static_cast<int>(ends.size());
    m_vertices.bind();
    m_vertices.allocate(ends.data(), static_cast<int>(ends.size() * sizeof(ends[0])));
}

void LineRenderer::draw(const Look& look) {
    if (m_count == 0) return;
    m_program->bind();
    m_program->setUniformValue("view", look.view);
    m_program->setUniformValue("projection", look.projection);
    m_program->setUniformValue("orthographic", look.orthographic);
    m_program->setUniformValue("pixels", QSizeF(look.pixels));
    m_program->setUniformValue("width", look.width);
    m_program->setUniformValue("colour", look.colour);
    m_program->setUniformValue("behindAll", look.behindAll);
    const QOpenGLVertexArrayObject::Binder binder(&m_array);
    if (look.behindAll) {
        m_gl->glDepthFunc(GL_EQUAL);
        m_gl->glEnable(GL_BLEND);
        m_gl->glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
        m_gl->glEnable(GL_STENCIL_TEST);
        m_gl->glStencilFunc(GL_EQUAL, 0, 0xFF);
        m_gl->glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    }
    m_gl->glDrawArrays(GL_LINES, 0, m_count);
    m_gl->glDisable(GL_STENCIL_TEST);
    m_gl->glDisable(GL_BLEND);
    m_gl->glDepthFunc(GL_LESS);
}

}  // namespace wend
