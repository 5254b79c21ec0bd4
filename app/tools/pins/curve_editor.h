#pragma once

#include <QPainter>
#include <optional>

#include "app/project/edits/bezier_edits.h"
#include "app/project/edits/curve_edits.h"
#include "app/tools/shape_tool.h"

namespace wend {

/// Returns the hint over a point of a curve, or over the curve.
QString curveHint(bool onPoint);

/// The points of the curve that the one selected handle follows last: shown, chosen, dragged, added and
/// removed. One undo step per gesture.
class CurveEditor {
  public:
    explicit CurveEditor(ShapeView& view) : m_view(view) {}

    /// Returns the point within reach, or −1. The first point is fixed, because the handle is there when the
    /// motion begins.
    int pointAt(const QPointF& widget) const;
    /// Returns whether the curve itself is within reach.
    bool isOnCurve(const QPointF& widget) const { return placeAt(widget).piece >= 0; }
    bool isDragging() const;
    /// Chooses the point and drags it.
    void begin(int point, const QPointF& widget);
    /// Moves the point; with `freely` the other direction of the joint stays.
    void drag(const QPointF& widget, bool freely = false);
    /// Puts the points into the document.
    void finish();
    void cancel();
    /// Inserts a point under the pointer; false if it is not on the curve.
    bool insertAt(const QPointF& widget);
    void choose(int point);
    int chosen() const;
    /// Chooses the subject of the menu: the point under the pointer, or the place on the curve. Returns false
    /// if there is neither.
    bool pointAtForMenu(const QPointF& widget);

    // for the menu
    /// Returns whether there is a curve with visible points.
    bool hasCurve() const { return !points().empty(); }
    /// Returns the relation of the directions at the chosen point; nothing if it has only one direction, or
    /// if no point is chosen.
    std::optional<JointKind> chosenKind() const;
    bool canRemove() const;
    /// Inserts a point at the last pointed place of the curve; otherwise in the middle of the piece after the
    /// chosen point.
    void insertPoint();
    void removePoint();
    void setKind(JointKind kind);

    void paint(QPainter& painter, const QPointF& pointer) const;

  private:
    struct Place {
        int piece = -1;
        double v = 0;
        double distance = 0;
    };
    int handle() const;
    std::optional<CurveMotion<3>> curve() const;
    /// Returns the points as drawn; empty without a curve.
    std::vector<Vec3> points() const;
    Vec3 shift() const;
    Place placeAt(const QPointF& widget) const;
    std::vector<JointKind> kinds(const CurveMotion<3>& curve) const;
    std::vector<Vec3> moved(const CurveMotion<3>& curve) const;
    void change(const QString& name, CurveMotion<3> next);
    void insertOn(const Place& place);
    void paintMoved(QPainter& painter) const;

    ShapeView& m_view;
    int m_dragged = -1;
    bool m_freely = false;
    QPointF m_from;
    Vec3 m_by = Vec3::Zero();
    // the project whose point is dragged; any change ends the drag
    std::shared_ptr<const Project> m_draggedOf;
    // Identifies a chosen point: valid while the curve keeps its number of points and its start
    struct Chosen {
        int handle = -1, count = 0;
        Vec3 start = Vec3::Zero();
        bool operator==(const Chosen&) const = default;
    };
    Chosen identity() const;
    mutable Chosen m_of;
    mutable int m_chosen = -1;
    mutable std::vector<int> m_free;  // joints that stay free although their directions are opposite
    void forgetOthers() const;
    std::optional<Place> m_place;  // that the menu is about
};

}  // namespace wend
