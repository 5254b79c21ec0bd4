// Additional and see-through triangles.
#include "app/style/marks.h"
#include "app/views/volume/surface_renderer.h"

namespace wend {
namespace {

constexpr std::array<GLenum, 3> kVeils{GL_BLEND, GL_STENCIL_TEST, GL_POLYGON_OFFSET_FILL};
constexpr double kStripes = 8;   // pixels of the view
constexpr GLuint kDrawn = 0x80;  // in the stencil: a pixel that is done

}  // namespace

void SurfaceRenderer::setGlyphs(const std::vector<DrawVertex>& triangles) {
    fillGlyphs(m_glyphs, triangles);
}

void SurfaceRenderer::setVeiled(const std::vector<DrawVertex>& triangles) {
    fillGlyphs(m_veiled, triangles);
}

void SurfaceRenderer::setMarked(const std::vector<std::vector<DrawVertex>>& kinds) {
    for (std::size_t k = 0; k < m_marked.size(); ++k)
        fillGlyphs(m_marked[k], k < kinds.size() ? kinds[k] : std::vector<DrawVertex>());
}

void SurfaceRenderer::fillGlyphs(Triangles& glyphs, const std::vector<DrawVertex>& triangles) {
    std::vector<DrawVertex> vertices = triangles;
    glyphs.count = static_cast<int>(triangles.size() / 3);
    for (DrawVertex& vertex : vertices) {
        const auto& [x, y, z] = vertex.position;
        const Eigen::Vector3f p = normalized(Vec<3>(x, y, z));
        vertex.position = {p.x(), p.y(), p.z()};
    }
    glyphs.vertices.bind();
    glyphs.vertices.allocate(vertices.data(), static_cast<int>(vertices.size() * sizeof(DrawVertex)));
}

void SurfaceRenderer::drawGlyphs(Triangles& glyphs, QOpenGLShaderProgram& program) {
    const QOpenGLVertexArrayObject::Binder binder(&glyphs.array);
    program.bind();
    for (const uint unit : {0U, 1U, 2U, 3U}) m_noTexture->bind(unit);
    program.setUniformValue("coloursOfTriangles", false);
    program.setUniformValue("flatShading", false);
    program.setUniformValue("dimming", 0.0F);
    m_gl->glDrawArrays(GL_TRIANGLES, 0, 3 * glyphs.count);
}

/// Draws covered triangles, each pixel once. Triangles on the surface itself do not count as covered.
void SurfaceRenderer::drawVeiled() {
    m_plain->setUniformValue("opacity", static_cast<float>(kCoveredOpacity));
    m_plain->setUniformValue("ownFromBehind", 1.0F);
    m_gl->glDepthFunc(GL_GREATER);
    m_gl->glDepthMask(GL_FALSE);
    for (const GLenum capability : kVeils) m_gl->glEnable(capability);
    m_gl->glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    m_gl->glStencilFunc(GL_EQUAL, 0, 0xFF);
    m_gl->glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    m_gl->glPolygonOffset(-2, -2);
    drawGlyphs(m_veiled, *m_plain);
    for (const GLenum capability : kVeils) m_gl->glDisable(capability);
    m_gl->glDepthMask(GL_TRUE);
    m_gl->glDepthFunc(GL_LESS);
}

/// Visible triangles set their bit in the stencil: where it is 0, others are drawn through the surface, and
/// where it is that of another kind, in stripes. Of coplanar triangles the last one wins.
void SurfaceRenderer::drawMarked(QOpenGLShaderProgram& seen, const Sight& sight) {
    m_gl->glDepthMask(GL_FALSE);
    for (const GLenum capability : kVeils) m_gl->glEnable(capability);
    m_gl->glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    m_gl->glPolygonOffset(-1, -1);
    m_gl->glDepthFunc(GL_LEQUAL);
    m_gl->glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    for (int kind = 0; kind < kMostKinds; ++kind) {
        m_gl->glStencilFunc(GL_ALWAYS, 1 << kind, 0xFF);
        drawGlyphs(m_marked[kind], seen);
    }
    m_gl->glPolygonOffset(-2, -2);
    m_gl->glDepthFunc(GL_GREATER);
    m_gl->glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
    m_gl->glStencilMask(kDrawn);
    m_plain->bind();
    m_plain->setUniformValue("ownFromBehind", 1.0F);
    for (int kind = 0; kind < kMostKinds; ++kind)
        for (int before = -1; before < kMostKinds; ++before) {
            if (before == kind || m_marked[kind].count == 0) continue;
            const bool isVeiled = before < 0;
            m_plain->setUniformValue("opacity", static_cast<float>(isVeiled ? kCoveredOpacity : 1));
            m_plain->setUniformValue("stripes",
                                     static_cast<float>(isVeiled ? 0 : kStripes * sight.pixelsPer));
            m_gl->glStencilFunc(GL_EQUAL, isVeiled ? 0 : 1 << before, 0xFF);
            drawGlyphs(m_marked[kind], *m_plain);
        }
    m_gl->glStencilMask(0xFF);
    for (const GLenum capability : kVeils) m_gl->glDisable(capability);
    m_gl->glDepthMask(GL_TRUE);
    m_gl->glDepthFunc(GL_LESS);
}

}  // namespace wend
