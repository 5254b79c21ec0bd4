#include "app/view/volume/line_renderer.h"

namespace wend {

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
    m_program->setUniformValue("colour",
                               QVector3D(look.colour.redF(), look.colour.greenF(), look.colour.blueF()));
    const QOpenGLVertexArrayObject::Binder binder(&m_array);
    m_gl->glDrawArrays(GL_LINES, 0, m_count);
}

}  // namespace wend
