#pragma once

#include <QImage>
#include <QRgb>
#include <QStringList>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/tools/solid_shape_view.h"
#include "app/views/volume/line_renderer.h"
#include "app/views/volume/surface_renderer.h"
#include "core/mesh/cut_plane.h"
#include "core/mesh/embedding.h"
#include "core/mesh/point_locator.h"
#include "core/mesh/skin.h"
#include "core/mesh/triangle_tree.h"

namespace wend {

/// Paint over a solid's colours: a column per vertex with red, green and blue times opacity, from 0 to 1, and
/// the opacity in the first row of `opacities`. Cells may have colours of their own instead, not
/// premultiplied.
struct SolidPaint {
    Points3 colours = Points3(3, 0), opacities = Points3(3, 0);
    std::vector<QRgb> own;  // per cell; 0: as its vertices
    double opacity = 0;     // of all paint; 0: there is none

    bool operator==(const SolidPaint& other) const {
        return opacity == other.opacity && own == other.own && colours.cols() == other.colours.cols() &&
               colours == other.colours && opacities == other.opacities;
    }
};

/// The content of the view: a solid at rest, its pose, and colours.
struct VolumePicture {
    std::shared_ptr<const SimplicialMesh<3>> rest;
    std::shared_ptr<const std::vector<Facet<3>>> facets;
    Points3 pose;
    std::vector<QRgb> cellColours;  // one per cell; empty: one plain colour
    // Positions of smooth colours in the ramp, from 0 to 1, a column per vertex (first number). None: each
    // cell has its own colour.
    Points3 places = Points3(3, 0);
    std::vector<QRgb> ramp;
    // Lies over those colours, and over a skin's own.
    SolidPaint paint;
    std::optional<QRgb> section;  // of the face of a cut; none: those of its cells
    // A surface embedded in the solid and drawn instead of its border; null if there is none.
    std::shared_ptr<const Skin> skin;
    std::shared_ptr<const Embedding<3>> embedding;
    // the skin uses its materials; cell colours cover them as a map with the opacity of the style
    bool materials = false;
    std::vector<int> marked;  // facets that are faintly visible through others
    bool isOpen = false;      // not closed: its colours are meaningful from behind, too
};

/// Returns the colour halfway to grey, for outdated shapes.
QRgb dimmed(QRgb colour);

/// Returns a surface alone, without tetrahedra, with one colour per triangle.
VolumePicture pictureOfSurface(const Points3& points, const std::vector<std::array<int, 3>>& triangles,
                               std::vector<QRgb> colours);

/// Reads the pictures of the skin's materials, scaled to what every GPU supports; null if there is none or it
/// cannot be read. Empty without a skin. `unread` receives the unreadable files.
std::vector<QImage> texturesOf(const Skin* skin, QStringList* unread = nullptr);

/// Intersects rays with a cut and deformed surface: bounding boxes are built for the first ray, and refitted
/// for the first ray after a change of the pose.
class RayCasting {
  public:
    void takeSurface(CutSurface surface) {
        m_surface = std::move(surface);
        m_surfaceStale = true;
    }
    void takePose() { m_poseStale = true; }
    /// Returns the nearest triangle that the ray hits; cell −1 if there is none.
    SolidHit hit(const Ray& ray, const Points3& pose);
    /// Boxes and triangles that the last hit() looked at.
    int visited() const { return m_visited; }

  private:
    CutSurface m_surface;
    std::optional<CutPoints> m_points;
    TriangleTree m_tree;
    bool m_surfaceStale = true, m_poseStale = true;
    int m_visited = 0;
};

/// Intersects rays with a surface embedded in a solid, such as in a cage: the pointer touches the visible
/// surface, and the cells are those that contain the place. Boxes and the cell grid are built for the first
/// ray, and boxes refitted for the first ray after a change of the pose.
class SkinCasting {
  public:
    void takeSkin() { m_skinStale = true; }
    void takePose() { m_poseStale = true; }
    /// Returns the nearest point of the skin on the ray that the cut has left; cell −1 if there is none.
    SolidHit hit(const Ray& ray, const VolumePicture& solid, const Points3& skinPose,
                 const std::optional<CutPlane>& cut);
    /// Boxes and triangles that the last hit() looked at.
    int visited() const { return m_visited; }

  private:
    void update(const VolumePicture& solid, const Points3& skinPose);
    int cellOf(const VolumePicture& solid, const Vec3& point) const;
    int vertexOf(const VolumePicture& solid, int cell, const Vec3& point) const;

    TriangleTree m_tree;                       // of the skin's pose
    std::optional<PointLocator<3>> m_locator;  // at rest
    std::vector<bool> m_isOuter;               // per vertex of the solid
    bool m_skinStale = true, m_poseStale = true;
    int m_visited = 0;
};

enum class CutKind { None, WholeCells, Exact };

/// A solid as a view draws it, cut by a plane, with additional triangles. It uploads what has changed since
/// the last drawing. Functions about drawing need the current context, all others none.
class DrawnSolid {
  public:
    /// Prepares a new context, which has no resources yet. Returns false, with the reason in error(), if it
    /// cannot draw.
    bool initialize();
    void release();
    const QString& error() const { return m_renderer.error(); }
    /// Returns whether the CPU draws.
    bool isSoftware() const { return m_renderer.isSoftware(); }

    void setPicture(VolumePicture picture);
    const VolumePicture& picture() const { return m_picture; }
    void setStyle(const SurfaceStyle& style);
    /// Returns the style as the picture is drawn.
    SurfaceStyle style() const;
    void setCut(CutKind kind, const CutPlane& plane);
    CutKind cut() const { return m_cut; }
    const CutPlane& plane() const { return m_plane; }
    bool isCutOff(const Vec3& p) const { return m_cut != CutKind::None && m_plane.height(p) > 1e-9; }
    /// Sets additional triangles; the veiled ones are faintly visible where they are covered. Returns false
    /// if there are none and there were none.
    bool setGlyphs(std::vector<DrawVertex> triangles, std::vector<DrawVertex> veiled);

    /// Returns the drawn surface, with its cut.
    const CutSurface& surface() const { return m_surface; }
    /// Returns whether an embedded surface is drawn instead of the solid's border.
    bool showsSkin() const { return m_picture.skin && m_cut != CutKind::WholeCells; }
    /// Returns the points of that surface.
    const Points3& skinPose() const;
    /// Returns where a vertex is drawn: that surface is in the place of the solid's border.
    Vec3 placeOf(int vertex) const;
    /// Returns all drawn points.
    Points3 points() const;
    /// Returns the nearest drawn point that the ray hits.
    SolidHit hit(const Ray& ray) const;
    /// Boxes and triangles that the last hit() looked at.
    int visited() const { return m_rays.visited() + m_skinRays.visited(); }
    /// Triangles that are drawn.
    int triangles() const { return static_cast<int>(m_outer.triangles.size() + m_section.triangles.size()); }

    /// Returns whether anything has changed since the last upload.
    bool isStale() const;
    /// Returns unreadable pictures of materials, once per surface.
    QStringList upload();
    /// `hasRim`: false where the background is unknown.
    void draw(const Sight& sight, bool hasRim);

  private:
    /// Returns whether the embedded surface has points of its own, which the pointer then touches.
    bool ridesInside() const { return showsSkin() && m_picture.embedding->isFree(); }
    /// Returns the plane that cuts the embedded surface.
    std::optional<CutPlane> clip() const;
    void remakeSurface();
    void uploadMeshes();
    QStringList uploadTextures();
    void uploadPose();
    void uploadColours();
    void uploadPlaces(SurfaceRenderer::Layer layer, const DrawMesh& mesh, bool skin);
    void uploadGlyphs();
    void uploadRim(const Sight& sight);
    const std::vector<int>& skinPoints() const;
    std::vector<QRgb> coloursOf(const DrawMesh& mesh, bool skin) const;

    SurfaceRenderer m_renderer;
    SurfaceStyle m_style;
    VolumePicture m_picture;
    std::shared_ptr<const Skin> m_textured;  // the skin whose pictures were uploaded
    CutSurface m_surface;
    DrawMesh m_outer, m_section;
    std::vector<std::array<int, 2>> m_outline;        // of the section: its points
    Points3 m_sectionEnds{3, 0};                      // of the lines of the outline
    Contour m_contour;                                // of m_outer, if it is asked for
    mutable std::optional<Points3> m_ridden;          // until the pose changes
    mutable std::shared_ptr<const Skin> m_nearestOf;  // owner of m_nearest
    mutable std::vector<int> m_nearest;               // points of that surface to the vertices
    mutable RayCasting m_rays;
    mutable SkinCasting m_skinRays;
    CutPlane m_plane;
    CutKind m_cut = CutKind::None;
    std::vector<DrawVertex> m_glyphs, m_veiled;
    bool m_meshStale = true, m_poseStale = true, m_coloursStale = true, m_texturesStale = true;
    bool m_glyphsStale = false, m_hasNormals = false, m_hasContour = false;
};

}  // namespace wend
