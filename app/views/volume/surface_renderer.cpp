#include "app/views/volume/surface_renderer.h"

#include <Eigen/Geometry>
#include <QFile>
#include <QMatrix4x4>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "app/style/colours.h"
#include "app/style/marks.h"

namespace wend {

namespace {

const QVector4D kNoClip(0, 0, 0, -1);
constexpr int kColourWidth = 2048;      // of the texture that holds the triangles' colours
constexpr double kOutlineWidth = 1.75;  // pixels of the view

QMatrix4x4 toQt(const Eigen::Matrix4d& matrix) {
    QMatrix4x4 result;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) result(i, j) = static_cast<float>(matrix(i, j));
    return result;
}

QVector3D toVector(const QColor& c) {
    return {c.redF(), c.greenF(), c.blueF()};
}

/// Returns the shader with a definition after its first line.
QByteArray sourceOf(const char* name, bool edges) {
    QFile file(QStringLiteral(":/shaders/") + QString::fromLatin1(name));
    if (!file.open(QIODevice::ReadOnly)) return {};
    QByteArray source = file.readAll();
    if (edges) source.insert(source.indexOf('\n') + 1, "#define EDGES\n");
    return source;
}

/// Returns an offset into the bound buffer as the pointer that OpenGL asks for; it is never dereferenced, so
/// the cast is harmless.
const void* bufferOffset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr): no address
}

template <class T>
void allocate(QOpenGLBuffer& buffer, const std::vector<T>& values) {
    buffer.bind();
    buffer.allocate(values.data(), static_cast<int>(values.size() * sizeof(T)));
}

constexpr std::array<GLenum, 3> kVeils{GL_BLEND, GL_STENCIL_TEST, GL_POLYGON_OFFSET_FILL};
constexpr double kStripes = 8;   // pixels of the view
constexpr GLuint kDrawn = 0x80;  // in the stencil: a pixel that is done

}  // namespace

bool SurfaceRenderer::link(QOpenGLShaderProgram& program, bool edges) {
    using Shader = QOpenGLShader;
    bool ok = program.addShaderFromSourceCode(Shader::Vertex, sourceOf("surface.vert", edges)) &&
              program.addShaderFromSourceCode(Shader::Fragment, sourceOf("surface.frag", edges));
    if (edges) ok = ok && program.addShaderFromSourceCode(Shader::Geometry, sourceOf("surface.geom", edges));
    ok = ok && program.link();
    if (!ok) m_error = program.log();
    return ok;
}

bool SurfaceRenderer::initialize() {
    m_gl = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(QOpenGLContext::currentContext());
    if (m_gl == nullptr) {
        m_error = QStringLiteral("OpenGL 3.3 is not available");
        return false;
    }
    const QByteArray name(reinterpret_cast<const char*>(m_gl->glGetString(GL_RENDERER)));
    m_isSoftware = name.contains("llvmpipe") || name.contains("softpipe") || name.contains("Software");
    // A program belongs to the context that it was made in.
    m_plain = std::make_unique<QOpenGLShaderProgram>();
    m_edged = std::make_unique<QOpenGLShaderProgram>();
    if (!link(*m_plain, false) || !link(*m_edged, true)) return false;
    for (Triangles& layer : m_layers) create(layer);
    for (Triangles* glyphs : {&m_glyphs, &m_veiled}) createGlyphs(*glyphs);
    for (Triangles& kind : m_marked) createGlyphs(kind);
    for (LineRenderer* lines : {&m_outline, &m_rim})
        if (!lines->initialize(m_gl)) {
            m_error = lines->error();
            return false;
        }
    m_noTexture = std::make_unique<QOpenGLTexture>(QImage(1, 1, QImage::Format_RGBA8888));
    return true;
}

void SurfaceRenderer::create(Triangles& triangles) {
    triangles.array.create();
    const QOpenGLVertexArrayObject::Binder binder(&triangles.array);
    for (QOpenGLBuffer* buffer : triangles.buffers()) buffer->create();
    triangles.vertices.setUsagePattern(QOpenGLBuffer::DynamicDraw);
    triangles.indices.bind();
    triangles.vertices.bind();
    m_gl->glEnableVertexAttribArray(0);
    m_gl->glEnableVertexAttribArray(1);
    m_gl->glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Corner),
                                bufferOffset(offsetof(Corner, position)));
    m_gl->glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Corner),
                                bufferOffset(offsetof(Corner, normal)));
    triangles.uv.bind();
    m_gl->glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    triangles.tints.bind();  // QRgb: blue, green, red and alpha in memory
    m_gl->glVertexAttribPointer(3, GL_BGRA, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
    triangles.places.bind();
    m_gl->glVertexAttribPointer(4, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void SurfaceRenderer::createGlyphs(Triangles& glyphs) {
    glyphs.array.create();
    const QOpenGLVertexArrayObject::Binder binder(&glyphs.array);
    glyphs.vertices.create();
    glyphs.vertices.bind();
    for (const int location : {0, 1, 3}) m_gl->glEnableVertexAttribArray(location);
    constexpr int kStride = sizeof(DrawVertex);
    m_gl->glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride,
                                bufferOffset(offsetof(DrawVertex, position)));
    m_gl->glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, kStride,
                                bufferOffset(offsetof(DrawVertex, normal)));
    m_gl->glVertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                                bufferOffset(offsetof(DrawVertex, colour)));
}

void SurfaceRenderer::release() {
    std::vector<Triangles*> all{&m_layers[Outer], &m_layers[Section], &m_glyphs, &m_veiled};
    for (Triangles& kind : m_marked) all.push_back(&kind);
    for (Triangles* triangles : all) {
        for (QOpenGLBuffer* buffer : triangles->buffers()) buffer->destroy();
        triangles->colours.reset();
        triangles->map.reset();
        triangles->array.destroy();
    }
    m_textures.clear();
    m_noTexture.reset();
    m_ramp.reset();
    m_outline.release();
    m_rim.release();
    m_plain.reset();
    m_edged.reset();
}

template <class T>
bool SurfaceRenderer::setOptional(GLuint location, QOpenGLBuffer& buffer, const std::vector<T>& values) {
    if (values.empty())
        m_gl->glDisableVertexAttribArray(location);
    else
        m_gl->glEnableVertexAttribArray(location);
    if (!values.empty()) allocate(buffer, values);
    return !values.empty();
}

void SurfaceRenderer::setMesh(Layer layer, const DrawMesh& mesh) {
    Triangles& triangles = m_layers[layer];
    const QOpenGLVertexArrayObject::Binder binder(&triangles.array);
    triangles.count = static_cast<int>(mesh.corners.size());
    triangles.parts = mesh.parts;
    allocate(triangles.indices, mesh.corners);
    triangles.isTinted = setOptional(3, triangles.tints, mesh.tints);
    setOptional(2, triangles.uv, mesh.uv);
}

void SurfaceRenderer::setPose(Layer layer, const DrawMesh& mesh, const Points3& points, bool withNormals) {
    if (layer == Outer && points.cols() > 0) {
        const Vec3 low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
        m_centre = (low + high) / 2;
        m_scale = (high - low).norm();
        if (!m_centre.allFinite()) m_centre.setZero();
        if (!(m_scale > 0 && std::isfinite(m_scale))) m_scale = 1;
    }
    Eigen::Matrix3Xf places(3, points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i) places.col(i) = normalized(points.col(i));
    std::vector<Eigen::Vector3f> normals;
    if (withNormals) normals = drawnNormals(mesh, places);
    std::vector<Corner> corners(mesh.vertices.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto [point, normal] = mesh.vertices[i];
        const Eigen::Vector3f p = places.col(point);
        corners[i].position = {p.x(), p.y(), p.z()};
        if (withNormals) corners[i].normal = {normals[normal].x(), normals[normal].y(), normals[normal].z()};
    }
    allocate(m_layers[layer].vertices, corners);
}

void SurfaceRenderer::setPlaces(Layer layer, const std::vector<Place>& places) {
    Triangles& triangles = m_layers[layer];
    const QOpenGLVertexArrayObject::Binder binder(&triangles.array);
    triangles.isSmooth = setOptional(4, triangles.places, places);
}

void SurfaceRenderer::setRamp(const std::vector<QRgb>& colours) {
    m_ramp.reset();
    if (colours.empty()) return;
    QImage row(static_cast<int>(colours.size()), 1, QImage::Format_RGB32);
    std::ranges::copy(colours, reinterpret_cast<QRgb*>(row.bits()));
    m_ramp = std::make_unique<QOpenGLTexture>(row, QOpenGLTexture::DontGenerateMipMaps);
    m_ramp->setMinMagFilters(QOpenGLTexture::Linear, QOpenGLTexture::Linear);
    m_ramp->setWrapMode(QOpenGLTexture::ClampToEdge);
}

std::vector<std::array<float, 3>> SurfaceRenderer::placesOf(const Points3& points) const {
    std::vector<std::array<float, 3>> places;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const Eigen::Vector3f p = normalized(points.col(i));
        places.push_back({p.x(), p.y(), p.z()});
    }
    return places;
}

void SurfaceRenderer::fill(std::unique_ptr<QOpenGLTexture>& texture, const std::vector<QRgb>& colours) {
    const int height = static_cast<int>((colours.size() + kColourWidth - 1) / kColourWidth);
    if (!texture || texture->height() != std::max(1, height)) {
        texture = std::make_unique<QOpenGLTexture>(QOpenGLTexture::Target2D);
        texture->setFormat(QOpenGLTexture::RGBA8_UNorm);
        texture->setSize(kColourWidth, std::max(1, height));
        texture->setMinMagFilters(QOpenGLTexture::Nearest, QOpenGLTexture::Nearest);
        texture->allocateStorage();
    }
    std::vector<QRgb> rows(colours);
    rows.resize(static_cast<std::size_t>(texture->height()) * kColourWidth, 0);
    texture->setData(QOpenGLTexture::BGRA, QOpenGLTexture::UInt32_RGBA8_Rev, rows.data());
}

void SurfaceRenderer::setTextures(const std::vector<QImage>& pictures) {
    m_textures.clear();
    for (const QImage& picture : pictures) {
        auto& texture = m_textures.emplace_back();
        if (picture.isNull()) continue;
        texture = std::make_unique<QOpenGLTexture>(picture.mirrored());  // texture points count from below
        texture->setWrapMode(QOpenGLTexture::Repeat);
        texture->setMinMagFilters(QOpenGLTexture::LinearMipMapLinear, QOpenGLTexture::Linear);
    }
}

/// Normalizes coordinates so that huge and tiny solids stay within the range of floats: view' = view (x
/// m_scale + m_centre) / m_scale, which the projection reverts.
std::pair<Eigen::Matrix4d, Eigen::Matrix4d> SurfaceRenderer::matricesOf(const Sight& sight) const {
    Eigen::Matrix4d view = sight.view, projection = sight.projection;
    const Mat3 turn = view.topLeftCorner<3, 3>();
    const Vec3 shift = view.topRightCorner<3, 1>();
    view.topRightCorner<3, 1>() = (turn * m_centre + shift) / m_scale;
    projection.leftCols<3>() *= m_scale;
    return {view, projection};
}

void SurfaceRenderer::setUniforms(QOpenGLShaderProgram& program, const Sight& sight,
                                  const SurfaceStyle& style, const std::optional<CutPlane>& clip) {
    const auto [view, projection] = matricesOf(sight);
    program.bind();
    program.setUniformValue("view", toQt(view));
    program.setUniformValue("projection", toQt(projection));
    program.setUniformValue("flatShading", style.flat);
    program.setUniformValue("orthographic", sight.orthographic);
    program.setUniformValue("backColour", toVector(style.backColour));
    program.setUniformValue("ownFromBehind", static_cast<float>(style.ownFromBehind));
    program.setUniformValue("edgeColour", toVector(style.edgeColour));
    program.setUniformValue("lightEdgeColour", toVector(style.lightEdgeColour));
    program.setUniformValue("dimming", static_cast<float>(style.dimming));
    program.setUniformValue("colours", 0);
    program.setUniformValue("picture", 1);
    program.setUniformValue("map", 2);
    program.setUniformValue("ramp", 3);
    program.setUniformValue("opacity", 1.0F);
    program.setUniformValue("stripes", 0.0F);
    program.setUniformValue("clipPlane", kNoClip);
    if (!clip) return;
    const Vec3 normal = view.topLeftCorner<3, 3>() * clip->normal;
    const Vec3 point = (view * ((clip->point - m_centre) / m_scale).homogeneous()).head<3>();
    program.setUniformValue(
        "clipPlane", QVector4D(QVector3D(static_cast<float>(normal.x()), static_cast<float>(normal.y()),
                                         static_cast<float>(normal.z())),
                               static_cast<float>(-normal.dot(point))));
}

void SurfaceRenderer::drawLayer(QOpenGLShaderProgram& program, Triangles& triangles, bool materials,
                                double mapOpacity) {
    if (triangles.count == 0 || !triangles.colours) return;
    const QOpenGLVertexArrayObject::Binder binder(&triangles.array);
    triangles.colours->bind(0);
    (triangles.map ? triangles.map : m_noTexture)->bind(2);
    (m_ramp ? m_ramp : m_noTexture)->bind(3);
    program.setUniformValue("coloursOfTriangles", true);
    program.setUniformValue("isTinted", materials && triangles.isTinted);
    program.setUniformValue("isSmooth", triangles.isSmooth);
    program.setUniformValue("hasRamp", m_ramp != nullptr);
    program.setUniformValue("isPaint", m_paint > 0);
    const double opacity = m_paint > 0 ? m_paint : triangles.map ? mapOpacity : 0;
    program.setUniformValue("mapOpacity", static_cast<float>(opacity));
    for (const DrawMesh::Part& part : triangles.parts) {
        const bool textured = materials && part.material >= 0 &&
                              part.material < static_cast<int>(m_textures.size()) &&
                              m_textures[part.material];
        (textured ? *m_textures[part.material] : *m_noTexture).bind(1);
        program.setUniformValue("textured", textured);
        program.setUniformValue("firstTriangle", part.first);
        m_gl->glDrawElements(GL_TRIANGLES, 3 * part.count, GL_UNSIGNED_INT,
                             bufferOffset(3 * sizeof(int) * static_cast<std::size_t>(part.first)));
    }
}

LineRenderer::Look SurfaceRenderer::lineLook(const Sight& sight, double width, const QColor& colour) const {
    const auto [view, projection] = matricesOf(sight);
    return {toQt(view),
            toQt(projection),
            sight.orthographic,
            sight.pixels,
            static_cast<float>(width * sight.pixelsPer),
            colour,
            false};
}

void SurfaceRenderer::draw(const Sight& sight, const SurfaceStyle& style, bool materials,
                           const std::optional<CutPlane>& clip) {
    m_gl->glEnable(GL_DEPTH_TEST);
    QOpenGLShaderProgram& program = style.edges ? *m_edged : *m_plain;
    setUniforms(program, sight, style, clip);
    if (clip) m_gl->glEnable(GL_CLIP_DISTANCE0);
    drawLayer(program, m_layers[Outer], materials, materials ? style.mapOpacity : 0);
    m_gl->glDisable(GL_CLIP_DISTANCE0);
    program.setUniformValue("clipPlane", kNoClip);   // the section is in the plane
    program.setUniformValue("ownFromBehind", 1.0F);  // slivers of it may have either orientation,
    program.setUniformValue("flatShading", false);   // and any normal
    m_gl->glEnable(
        GL_POLYGON_OFFSET_FILL);  // a detailed surface ends on the section: it does not show through
    m_gl->glPolygonOffset(-1, -1);
    drawLayer(program, m_layers[Section], false, 0);
    m_gl->glDisable(GL_POLYGON_OFFSET_FILL);
    const bool isMarked = std::ranges::any_of(m_marked, [](const Triangles& kind) { return kind.count > 0; });
    if (isMarked) {
        setUniforms(program, sight, style, {});
        setUniforms(*m_plain, sight, style, {});
        drawMarked(program, sight);
    }
    if (m_veiled.count > 0) {
        setUniforms(*m_plain, sight, style, {});
        drawVeiled();
    }
    if (m_layers[Section].count > 0) m_outline.draw(lineLook(sight, kOutlineWidth, style.edgeColour));
    if (m_glyphs.count > 0) {
        setUniforms(*m_plain, sight, style, {});
        drawGlyphs(m_glyphs, *m_plain);
    }
    if (style.rim.isValid()) {
        LineRenderer::Look look = lineLook(sight, kRimWidth, style.rim);
        look.behindAll = true;
        m_rim.draw(look);
    }
    m_gl->glUseProgram(0);
    m_gl->glActiveTexture(GL_TEXTURE0);
    m_gl->glDisable(GL_DEPTH_TEST);
}

// --- Additional and see-through triangles ---

void SurfaceRenderer::setMarked(const std::vector<std::vector<DrawVertex>>& kinds) {
    for (std::size_t k = 0; k < m_marked.size(); ++k)
        fillGlyphs(m_marked[k], k < kinds.size() ? kinds[k] : std::vector<DrawVertex>());
}

void SurfaceRenderer::fillGlyphs(Triangles& glyphs, const std::vector<DrawVertex>& triangles) {
    std::vector<DrawVertex> vertices = triangles;
    glyphs.count = static_cast<int>(triangles.size() / 3);
    for (DrawVertex& vertex : vertices) {
        const auto& [x, y, z] = vertex.position;
        const Eigen::Vector3f p = normalized(Vec3(x, y, z));
        vertex.position = {p.x(), p.y(), p.z()};
    }
    allocate(glyphs.vertices, vertices);
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
