#include "app/views/volume/drawn_solid.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "app/engine/shape/picture_file.h"
#include "app/views/volume/glyphs.h"

namespace wend {

namespace {

constexpr double kOwnFromBehind = 0.7;  // saturation of back faces, distinguishable from the front
const QRgb kPlainColour = qRgb(196, 178, 150);

/// Compares points, because Eigen compares matrices of one size only.
bool isSame(const Points3& a, const Points3& b) {
    return a.cols() == b.cols() && a == b;
}

/// Adds the nearest corner of the triangle.
SolidHit solidHit(const CutSurface& surface, const Points3& pose, const Ray& ray,
                  const TriangleTree::Hit& hit) {
    SolidHit result;
    if (hit.triangle < 0) return result;
    result.cell = surface.cells[hit.triangle];
    result.point = ray.origin + hit.distance * ray.direction;
    double closest = std::numeric_limits<double>::infinity();
    for (const auto& c : surface.triangles[hit.triangle])
        for (const int v : {c.from, c.to}) {
            const double distance = (pose.col(v) - result.point).norm();
            if (distance < closest) result.vertex = v;
            closest = std::min(closest, distance);
        }
    return result;
}

constexpr double kOnBorder = 1e-9;  // barycentric tolerance for points on the border of a cell

/// Returns the interval of the ray that the cut has left.
std::pair<double, double> leftOf(const Ray& ray, const std::optional<CutPlane>& cut) {
    const double far = std::numeric_limits<double>::infinity();
    if (!cut) return {0, far};
    const double height = cut->height(ray.origin), climb = cut->normal.dot(ray.direction);
    const double crossing = -height / climb;
    if (height > 0) return {climb < 0 ? crossing : far, far};
    return {0, climb > 0 ? crossing : far};
}

}  // namespace

// --- Rays ---

SolidHit RayCasting::hit(const Ray& ray, const Points3& pose) {
    if (m_surfaceStale) {
        m_points.emplace(m_surface);
        m_tree = TriangleTree(m_points->at(pose), std::move(m_points->triangles));
    } else if (m_poseStale) {
        m_tree.refit(m_points->at(pose));
    }
    m_surfaceStale = m_poseStale = false;
    const TriangleTree::Hit hit = m_tree.firstHit(ray.origin, ray.direction);
    m_visited = hit.visited;
    return solidHit(m_surface, pose, ray, hit);
}

void SkinCasting::update(const VolumePicture& solid, const Points3& skinPose) {
    if (m_skinStale) {
        m_tree = TriangleTree(skinPose, solid.skin->triangles);
        m_locator.emplace(solid.rest->points, solid.rest->cells);
        m_isOuter.assign(solid.rest->vertexCount(), false);
        for (const Facet<3>& facet : *solid.facets)
            if (!facet.interior())
                for (const int v : facet.vertices) m_isOuter[v] = true;
    } else if (m_poseStale) {
        m_tree.refit(skinPose);
    }
    m_skinStale = m_poseStale = false;
}

/// Returns the cell at the rest place; outside all cells that of the nearest corner of its triangle.
int SkinCasting::cellOf(const VolumePicture& solid, const Vec3& point) const {
    const TriangleTree::Nearest there = m_tree.nearest(point);
    const auto& corners = solid.skin->triangles[there.triangle];
    Vec3 rest = Vec3::Zero();
    for (int k = 0; k < 3; ++k) rest += there.weights[k] * solid.skin->points.col(corners[k]);
    if (const auto inside = m_locator->find(rest, kOnBorder)) return inside->cell;
    int nearest = 0;
    there.weights.maxCoeff(&nearest);
    return solid.embedding->cell(corners[nearest]);
}

/// Returns the nearest corner of the cell, preferring vertices on the solid's border.
int SkinCasting::vertexOf(const VolumePicture& solid, int cell, const Vec3& point) const {
    int best = -1;
    std::pair<bool, double> least;
    for (const int v : solid.rest->cells[cell]) {
        const std::pair<bool, double> rank(!m_isOuter[v], (solid.pose.col(v) - point).norm());
        if (best < 0 || rank < least) {
            best = v;
            least = rank;
        }
    }
    return best;
}

SolidHit SkinCasting::hit(const Ray& ray, const VolumePicture& solid, const Points3& skinPose,
                          const std::optional<CutPlane>& cut) {
    update(solid, skinPose);
    SolidHit result;
    const auto [from, to] = leftOf(ray, cut);
    if (!(from < to)) return result;
    const TriangleTree::Hit hit = m_tree.firstHit(ray.origin + from * ray.direction, ray.direction);
    m_visited = hit.visited;
    if (hit.triangle < 0 || from + hit.distance > to) return result;
    result.point = ray.origin + (from + hit.distance) * ray.direction;
    result.cell = cellOf(solid, result.point);
    result.vertex = vertexOf(solid, result.cell, result.point);
    return result;
}

// --- The content ---

bool DrawnSolid::initialize() {
    m_meshStale = m_poseStale = m_coloursStale = m_texturesStale = m_glyphsStale = true;
    return m_renderer.initialize();
}

void DrawnSolid::release() {
    m_renderer.release();
    m_textured.reset();
}

void DrawnSolid::setPicture(VolumePicture picture) {
    const bool sameSurface = m_cut == CutKind::None && picture.facets == m_picture.facets &&
                             picture.embedding == m_picture.embedding;
    if (picture.cellColours.empty() && picture.rest)
        picture.cellColours.assign(picture.facets->size(), kPlainColour);  // more than there are cells
    const bool samePose = isSame(picture.pose, m_picture.pose);
    if (picture.skin != m_picture.skin || picture.rest != m_picture.rest) m_skinRays.takeSkin();
    if (picture.skin != m_picture.skin || !samePose) m_ridden.reset();
    if (picture.skin != m_picture.skin) m_meshStale = true;
    if (picture.skin && picture.skin != m_textured) m_texturesStale = true;
    m_coloursStale = m_coloursStale || picture.cellColours != m_picture.cellColours ||
                     picture.section != m_picture.section || picture.materials != m_picture.materials ||
                     !isSame(picture.places, m_picture.places) || picture.ramp != m_picture.ramp ||
                     picture.paint != m_picture.paint;
    m_glyphsStale = m_glyphsStale || !picture.marked.empty() || !m_picture.marked.empty();
    if (!samePose) {
        m_poseStale = true;
        m_rays.takePose();
        m_skinRays.takePose();
    }
    m_picture = std::move(picture);
    if (!sameSurface) remakeSurface();
}

void DrawnSolid::setStyle(const SurfaceStyle& style) {
    m_coloursStale = m_coloursStale || (style.mapOpacity > 0) != (m_style.mapOpacity > 0);
    m_style = style;
}

SurfaceStyle DrawnSolid::style() const {
    SurfaceStyle style = m_style;
    if (m_picture.isOpen) style.ownFromBehind = kOwnFromBehind;
    if (!m_picture.materials) style.dimming = style.mapOpacity = 0;
    return style;
}

void DrawnSolid::setCut(CutKind kind, const CutPlane& plane) {
    m_cut = kind;
    m_plane = plane;
    remakeSurface();
}

bool DrawnSolid::setGlyphs(std::vector<DrawVertex> triangles, std::vector<DrawVertex> veiled) {
    if (triangles.empty() && m_glyphs.empty() && veiled.empty() && m_veiled.empty()) return false;
    m_glyphs = std::move(triangles);
    m_veiled = std::move(veiled);
    m_glyphsStale = true;
    return true;
}

/// Remakes the surface, without a cut if there are no tetrahedra, since the inside would be empty.
void DrawnSolid::remakeSurface() {
    if (!m_picture.rest) return;
    switch (m_picture.rest->cells.empty() ? CutKind::None : m_cut) {
        case CutKind::None:
            m_surface = wholeSurface(*m_picture.facets);
            break;
        case CutKind::WholeCells:
            m_surface = wholeCellCut(*m_picture.rest, *m_picture.facets, m_picture.pose, m_plane);
            break;
        case CutKind::Exact:
            m_surface = exactCut(*m_picture.rest, *m_picture.facets, m_picture.pose, m_plane);
            break;
    }
    m_meshStale = true;
    m_rays.takeSurface(ridesInside() ? partOf(m_surface, true) : m_surface);
}

const Points3& DrawnSolid::skinPose() const {
    if (!m_ridden) m_ridden = m_picture.embedding->carry(*m_picture.rest, m_picture.pose);
    return *m_ridden;
}

/// Returns the nearest point of the embedded surface to each vertex on the solid's border at rest; −1 for
/// inner vertices. Cached per surface.
const std::vector<int>& DrawnSolid::skinPoints() const {
    if (std::exchange(m_nearestOf, m_picture.skin) == m_picture.skin) return m_nearest;
    const Points3& rest = m_picture.rest->points;
    const std::vector<Cell<3>> none;
    const PointLocator<3> search(m_picture.skin->points, none);
    m_nearest.assign(static_cast<std::size_t>(rest.cols()), -1);
    for (const Facet<3>& facet : *m_picture.facets) {
        if (facet.interior()) continue;
        for (const int v : facet.vertices)
            if (int& found = m_nearest[static_cast<std::size_t>(v)]; found < 0)
                found = search.nearestVertex(rest.col(v));
    }
    return m_nearest;
}

Vec3 DrawnSolid::placeOf(int vertex) const {
    const int point = showsSkin() ? skinPoints()[static_cast<std::size_t>(vertex)] : -1;
    return point < 0 ? m_picture.pose.col(vertex) : skinPose().col(point);
}

std::optional<CutPlane> DrawnSolid::clip() const {
    return showsSkin() && m_cut == CutKind::Exact ? std::optional(m_plane) : std::nullopt;
}

/// Returns all points that are drawn. A surface embedded in the solid hides it, unless a section is filled
/// with its cells.
Points3 DrawnSolid::points() const {
    const Points3 none(3, 0);
    const Points3& skin = showsSkin() ? skinPose() : none;
    const Points3& solid = showsSkin() && m_cut == CutKind::None ? none : m_picture.pose;
    Points3 all(3, skin.cols() + solid.cols() + static_cast<Eigen::Index>(m_glyphs.size()));
    all.leftCols(skin.cols()) = skin;
    all.middleCols(skin.cols(), solid.cols()) = solid;
    Eigen::Index next = skin.cols() + solid.cols();
    for (const DrawVertex& vertex : m_glyphs)
        all.col(next++) = Vec3(vertex.position[0], vertex.position[1], vertex.position[2]);
    return all;
}

/// Returns the hit of the visible part of the skin, or of the section behind the cut.
SolidHit DrawnSolid::hit(const Ray& ray) const {
    const SolidHit cells = m_rays.hit(ray, m_picture.pose);
    if (!ridesInside()) return cells;
    const SolidHit skin = m_skinRays.hit(ray, m_picture, skinPose(), clip());
    const bool isSkin =
        cells.cell < 0 || (skin.point - ray.origin).norm() < (cells.point - ray.origin).norm();
    return skin.cell >= 0 && isSkin ? skin : cells;
}

// --- Uploads what has changed, and draws ---

bool DrawnSolid::isStale() const {
    return m_meshStale || m_poseStale || m_coloursStale || m_texturesStale || m_glyphsStale ||
           m_style.flat == m_hasNormals;
}

QStringList DrawnSolid::upload() {
    if (!m_picture.rest) return {};
    if (m_meshStale) uploadMeshes();
    if (m_style.flat == m_hasNormals) m_poseStale = true;
    if (m_poseStale) uploadPose();
    if (m_coloursStale) uploadColours();
    const QStringList unread = m_texturesStale ? uploadTextures() : QStringList();
    if (m_glyphsStale) uploadGlyphs();
    m_meshStale = m_poseStale = m_coloursStale = m_texturesStale = m_glyphsStale = false;
    return unread;
}

/// Textures are kept while their skin is hidden, because reading them takes time.
QStringList DrawnSolid::uploadTextures() {
    if (!m_picture.skin) return {};
    QStringList unread;
    m_renderer.setTextures(texturesOf(m_picture.skin.get(), &unread));
    m_textured = m_picture.skin;
    return unread;
}

/// Uploads the surface and the section; the section of a cut detailed surface is that of the solid.
void DrawnSolid::uploadMeshes() {
    const Points3& rest = m_picture.rest->points.cols() > 0 ? m_picture.rest->points : m_picture.pose;
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
    m_poseStale = m_coloursStale = true;
}

void DrawnSolid::uploadPose() {
    m_hasNormals = !m_style.flat;
    Points3 outer = showsSkin() ? skinPose() : drawnPoints(m_outer, m_picture.pose);
    m_renderer.setPose(SurfaceRenderer::Outer, m_outer, outer, m_hasNormals);
    m_contour.takePoints(std::move(outer));
    const Points3 section = drawnPoints(m_section, m_picture.pose);
    m_renderer.setPose(SurfaceRenderer::Section, m_section, section, true);
    Points3 ends(3, static_cast<Eigen::Index>(2 * m_outline.size()));
    Eigen::Index next = 0;
    for (const auto& edge : m_outline)
        for (const int point : edge) ends.col(next++) = section.col(point);
    m_renderer.setOutline(ends);
    m_sectionEnds = std::move(ends);
    m_glyphsStale = true;
}

/// Makes the rim for the current view, including the border of a section.
void DrawnSolid::uploadRim(const Sight& sight) {
    if (!std::exchange(m_hasContour, true)) m_contour.takeTriangles(m_outer.triangles);
    const Points3 contour = m_contour.ends(sight.view, sight.orthographic, clip());
    Points3 ends(3, contour.cols() + m_sectionEnds.cols());
    ends << contour, m_sectionEnds;
    m_renderer.setRim(ends);
}

std::vector<QRgb> DrawnSolid::coloursOf(const DrawMesh& mesh, bool skin) const {
    if (skin && m_picture.materials && !mesh.colours.empty()) return mesh.colours;
    std::vector<QRgb> colours;
    colours.reserve(mesh.cells.size());
    for (const int c : mesh.cells) colours.push_back(m_picture.cellColours[c]);
    return colours;
}

void DrawnSolid::uploadColours() {
    m_renderer.setColours(SurfaceRenderer::Outer, coloursOf(m_outer, showsSkin()));
    if (style().mapOpacity > 0) m_renderer.setMap(SurfaceRenderer::Outer, coloursOf(m_outer, false));
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
void DrawnSolid::uploadPlaces(SurfaceRenderer::Layer layer, const DrawMesh& mesh, bool skin) {
    const SolidPaint& paint = m_picture.paint;
    const bool isPainted = paint.opacity > 0;
    const auto onPoints = [&](const Points3& values) {
        return skin ? m_picture.embedding->interpolate(*m_picture.rest, values) : drawnPoints(mesh, values);
    };
    std::vector<SurfaceRenderer::Place> places;
    if (isPainted || m_picture.places.cols() > 0) {
        const Points3 ofPoints = onPoints(isPainted ? paint.colours : m_picture.places);
        const Points3 opacities = isPainted ? onPoints(paint.opacities) : Points3::Zero(3, ofPoints.cols());
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
void DrawnSolid::uploadGlyphs() {
    m_renderer.setGlyphs(m_glyphs);
    m_renderer.setVeiled(m_veiled);
    std::map<QRgb, std::vector<DrawVertex>> marked;
    for (const int f : m_picture.marked) {
        const Facet<3>& facet = (*m_picture.facets)[static_cast<std::size_t>(f)];
        const Vec3 a = m_picture.pose.col(facet.vertices[0]);
        const Vec3 b = m_picture.pose.col(facet.vertices[1]), c = m_picture.pose.col(facet.vertices[2]);
        const Vec3 normal = (b - a).cross(c - a).stableNormalized();
        const QRgb colour = m_picture.cellColours[facet.cells[0]];
        for (const Vec3& corner : {a, b, c}) marked[colour].push_back(drawVertex(corner, normal, colour));
    }
    std::vector<std::vector<DrawVertex>> kinds;
    for (auto& [colour, triangles] : marked) kinds.push_back(std::move(triangles));
    m_renderer.setMarked(kinds);
}

void DrawnSolid::draw(const Sight& sight, bool hasRim) {
    if (!m_picture.rest) return;
    SurfaceStyle look = style();
    if (!hasRim) look.rim = QColor();
    if (look.rim.isValid()) uploadRim(sight);
    m_renderer.draw(sight, look, showsSkin() && m_picture.materials, clip());
}

namespace {

constexpr int kLargestTexture = 4096;  // pixels

QImage textureOf(const SkinMaterial& material) {
    if (material.texture.empty()) return {};
    const QImage image = pictureOfFile(material.texture);
    if (std::max(image.width(), image.height()) <= kLargestTexture) return image;
    return image.scaled(kLargestTexture, kLargestTexture, Qt::KeepAspectRatio, Qt::SmoothTransformation)
        .convertToFormat(QImage::Format_RGBA8888);
}

}  // namespace

QRgb dimmed(QRgb colour) {
    const auto half = [](int x) { return (x + 128) / 2; };
    return qRgb(half(qRed(colour)), half(qGreen(colour)), half(qBlue(colour)));
}

VolumePicture pictureOfSurface(const Points3& points, const std::vector<std::array<int, 3>>& triangles,
                               std::vector<QRgb> colours) {
    VolumePicture picture;
    picture.rest = std::make_shared<const SimplicialMesh<3>>();
    picture.pose = points;
    auto facets = std::make_shared<std::vector<Facet<3>>>();
    for (const auto& t : triangles) facets->push_back({t, {static_cast<int>(facets->size()), -1}});
    picture.facets = std::move(facets);
    picture.cellColours = std::move(colours);
    return picture;
}

std::vector<QImage> texturesOf(const Skin* skin, QStringList* unread) {
    std::vector<QImage> pictures;
    if (!skin) return pictures;
    for (const SkinMaterial& material : skin->materials) {
        pictures.push_back(textureOf(material));
        const QString file = QString::fromStdString(material.texture);
        if (unread && !file.isEmpty() && pictures.back().isNull() && !unread->contains(file)) *unread << file;
    }
    return pictures;
}

}  // namespace wend
