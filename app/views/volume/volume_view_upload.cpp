// Uploads changed data to the GPU.
#include <Eigen/Geometry>
#include <map>

#include "app/views/volume/glyphs.h"
#include "app/views/volume/texture_file.h"
#include "app/views/volume/volume_view.h"

namespace wend {

void VolumeView::upload() {
    if (m_meshStale) uploadMeshes();
    if (m_style.flat == m_hasNormals) m_poseStale = true;
    if (m_poseStale) uploadPose();
    if (m_coloursStale) uploadColours();
    if (m_texturesStale) uploadTextures();
    if (m_glyphsStale) uploadGlyphs();
    m_meshStale = m_poseStale = m_coloursStale = m_texturesStale = m_glyphsStale = false;
}

/// Textures are kept while their skin is hidden, because reading them takes time.
void VolumeView::uploadTextures() {
    if (!m_picture.skin) return;
    QStringList unread;
    m_renderer.setTextures(texturesOf(m_picture.skin.get(), &unread));
    m_textured = m_picture.skin;
    if (!unread.isEmpty()) emit picturesMissing(unread);
}

/// The section of a cut detailed surface is that of the solid.
void VolumeView::uploadMeshes() {
    const Points<3>& rest = m_picture.rest->points.cols() > 0 ? m_picture.rest->points : m_picture.pose;
    const bool exact = m_cut == CutKind::Exact;
    if (showsSkin())
        m_outer = drawMesh(*m_picture.skin, *m_picture.embedding);
    else
        m_outer = drawMesh(exact ? partOf(m_surface, false) : m_surface, rest);
    m_section = exact ? drawSection(partOf(m_surface, true)) : DrawMesh();
    m_outline = borderOf(m_section.triangles);
    m_renderer.setMesh(SurfaceRenderer::Outer, m_outer);
    m_renderer.setMesh(SurfaceRenderer::Section, m_section);
    m_hasContour = false;
    m_drawnTriangles = static_cast<int>(m_outer.triangles.size() + m_section.triangles.size());
    m_poseStale = m_coloursStale = true;
}

void VolumeView::uploadPose() {
    m_hasNormals = !m_style.flat;
    Points<3> outer = showsSkin() ? skinPose() : drawnPoints(m_outer, m_picture.pose);
    m_renderer.setPose(SurfaceRenderer::Outer, m_outer, outer, m_hasNormals);
    m_contour.takePoints(std::move(outer));
    const Points<3> section = drawnPoints(m_section, m_picture.pose);
    m_renderer.setPose(SurfaceRenderer::Section, m_section, section, true);
    Points<3> ends(3, static_cast<Eigen::Index>(2 * m_outline.size()));
    Eigen::Index next = 0;
    for (const auto& edge : m_outline)
        for (const int point : edge) ends.col(next++) = section.col(point);
    m_renderer.setOutline(ends);
    m_sectionEnds = std::move(ends);
    m_glyphsStale = true;
}

/// Makes the rim for the current view, including the border of a section.
void VolumeView::uploadRim(const Sight& sight) {
    if (!std::exchange(m_hasContour, true)) m_contour.takeTriangles(m_outer.triangles);
    const bool clips = showsSkin() && m_cut == CutKind::Exact;
    const Points<3> contour =
        m_contour.ends(sight.view, sight.orthographic, clips ? std::optional(m_plane) : std::nullopt);
    Points<3> ends(3, contour.cols() + m_sectionEnds.cols());
    ends << contour, m_sectionEnds;
    m_renderer.setRim(ends);
}

std::vector<QRgb> VolumeView::coloursOf(const DrawMesh& mesh, bool skin) const {
    if (skin && m_picture.materials && !mesh.colours.empty()) return mesh.colours;
    std::vector<QRgb> colours;
    colours.reserve(mesh.cells.size());
    for (const int c : mesh.cells) colours.push_back(m_picture.cellColours[c]);
    return colours;
}

void VolumeView::uploadColours() {
    m_renderer.setColours(SurfaceRenderer::Outer, coloursOf(m_outer, showsSkin()));
    if (m_style.mapOpacity > 0) m_renderer.setMap(SurfaceRenderer::Outer, coloursOf(m_outer, false));
    m_renderer.setColours(SurfaceRenderer::Section,
                          m_picture.section
                              ? std::vector<QRgb>(m_section.triangles.size(), *m_picture.section)
                              : coloursOf(m_section, false));
    m_renderer.setRamp(m_picture.ramp);
    m_renderer.setPaint(m_picture.paint.opacity);
    uploadPlaces(SurfaceRenderer::Outer, m_outer, showsSkin());
    uploadPlaces(SurfaceRenderer::Section, m_section, false);
}

/// Interpolates linearly within the cells, so that a section matches the surface. A surface may extend beyond
/// its cells, where linear values exceed the bounds of paint.
void VolumeView::uploadPlaces(SurfaceRenderer::Layer layer, const DrawMesh& mesh, bool skin) {
    const SolidPaint& paint = m_picture.paint;
    const bool isPainted = paint.opacity > 0;
    const auto onPoints = [&](const Points<3>& values) {
        return skin ? m_picture.embedding->interpolate(*m_picture.rest, values) : drawnPoints(mesh, values);
    };
    std::vector<SurfaceRenderer::Place> places;
    if (isPainted || m_picture.places.cols() > 0) {
        const Points<3> ofPoints = onPoints(isPainted ? paint.colours : m_picture.places);
        const Points<3> opacities =
            isPainted ? onPoints(paint.opacities) : Points<3>::Zero(3, ofPoints.cols());
        for (const DrawMesh::Vertex& vertex : mesh.vertices) {
            Eigen::Vector4f place;
            place << ofPoints.col(vertex.point).cast<float>(), static_cast<float>(opacities(0, vertex.point));
            if (isPainted) place = place.cwiseMax(0).cwiseMin(1).eval();
            places.push_back({place.x(), place.y(), place.z(), place.w()});
        }
    }
    m_renderer.setPlaces(layer, places);
    if (!isPainted) return;
    std::vector<QRgb> own;
    for (const int c : mesh.cells) own.push_back(paint.own[c]);
    m_renderer.setMap(layer, own);
}

/// Uploads the glyphs. Marked triangles of one colour form a kind.
void VolumeView::uploadGlyphs() {
    m_renderer.setGlyphs(m_glyphs);
    m_renderer.setVeiled(m_veiled);
    std::map<QRgb, std::vector<DrawVertex>> marked;
    for (const int f : m_picture.marked) {
        const Facet<3>& facet = (*m_picture.facets)[static_cast<std::size_t>(f)];
        const Vec<3> a = m_picture.pose.col(facet.vertices[0]);
        const Vec<3> b = m_picture.pose.col(facet.vertices[1]), c = m_picture.pose.col(facet.vertices[2]);
        const Vec<3> normal = (b - a).cross(c - a).stableNormalized();
        const QRgb colour = m_picture.cellColours[facet.cells[0]];
        for (const Vec<3>& corner : {a, b, c}) marked[colour].push_back(drawVertex(corner, normal, colour));
    }
    std::vector<std::vector<DrawVertex>> kinds;
    for (auto& [colour, triangles] : marked) kinds.push_back(std::move(triangles));
    m_renderer.setMarked(kinds);
}

}  // namespace wend
