#pragma once

#include <QPainter>

#include "app/engine/shape/pose_faults.h"
#include "app/panels/group_list.h"
#include "app/style/colour_map.h"
#include "app/style/marks.h"
#include "app/style/theme.h"
#include "app/tools/shape_view.h"

namespace wend {

struct PinView;

/// Returns the name of a handle that does not hold at a time, and since or until when.
QString ghostName(const Pin& handle, const QString& name, double time);

/// Colours of the world's axes x, y, z in the usual order, distinguishable by lightness, too.
inline const QColor kSpaceAxes[] = {QColor(214, 69, 65), QColor(72, 148, 60), QColor(58, 104, 214)};

/// Draws the overlays of a shape at any zoom: pins, paths and the worst place.
class ShapePainter {
  public:
    ShapePainter(QPainter& painter, ShapeView& view, const Theme& theme)
        : m_painter(painter), m_marks(painter), m_view(view), m_theme(theme) {}

    void paths(int hovered);
    /// Draws the pins, and faintly the handles that do not hold at the shown time. `named`: the one with its
    /// name.
    void pins(int hovered, int named);
    /// Draws the vertices of groups in their colours, those of a chosen one larger.
    void groups(const std::vector<GroupMark>& groups);
    /// Draws points that are carried along, such as a cloud.
    void dots(const Points3& points);
    /// Draws the points at which parts of a picture are joined.
    void joints(const PosedFrame<2>& frame);
    /// Draws a cross in the middle of a cell; in a solid at its visible place, or a faint ring if it is
    /// hidden. Adds a label unless it is empty.
    void worst(const ShapeFrame& frame, int cell, const QString& words = {});
    /// Marks the worst place of a measure, with a warning if it is extreme; nothing at rest.
    void worst(const ShapeFrame& frame, Measure measure) {
        if (!isDistorted(*frame.distortion, measure)) return;
        worst(frame, worstOf(*frame.distortion, measure).cell, worstWarning(*frame.distortion, measure));
    }

  private:
    bool isFlat() const { return m_view.dimension() == 2; }
    bool isOfDocument() const;
    QPolygonF onScreen(const std::vector<Vec3>& points) const;
    template <int Dim>
    void frames(const Pin& handle, const Vec<Dim>& start);
    void frame(const Vec3& at, const Mat3& axes);
    void spots(const PinView& pin);
    void seenSpots(const PinView& pin);
    void area(const PinView& pin, bool hovered);
    void carriedRegion(const PinView& pin);
    Marks::Pin lookOf(const PinView& pin, int hovered) const;
    void paintGhosts(int hovered, int named);
    void paintLinks(const std::vector<PinView>& pins, int hovered);

    QPainter& m_painter;
    Marks m_marks;
    ShapeView& m_view;
    const Theme& m_theme;
};

/// Draws the edges of a picture that cross, and its triangles that have blown up.
void paintFaults(QPainter& painter, ShapeView& view, const PosedFrame<2>& frame, const PoseFaults<2>& faults);

}  // namespace wend
