#include "app/views/volume/line_renderer.h"

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
