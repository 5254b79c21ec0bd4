#pragma once

#include <QPainterPath>
#include <optional>

#include "app/project/domain.h"
#include "app/project/project_fwd.h"
#include "app/tools/key_cross.h"
#include "app/tools/outline_settings.h"
#include "app/tools/tool_kind.h"
#include "core/meshing/outline.h"
#include "warp/atlas.h"
#include "warp/outline.h"

namespace wend {

/// Draws the outline of a picture. Lasso, polygon and brush add or subtract; so does the magic wand with the
/// colour under the pointer, whose tolerance can be changed until something else happens; a cut separates
/// touching parts. With OutlineUse::MakePart the drawn area becomes a part of its own, also of a picture that
/// has parts. If the whole picture is deformed, the first drawing becomes the outline. Works on the rest
/// shape: the tool moves to its time, and back when another tool is activated.
class OutlineTool : public ShapeTool<PictureShapeView> {
  public:
    enum class Shape { Lasso, Polygon, Brush, Wand, Cut };
    OutlineTool(PictureShapeView& view, Shape shape, OutlinePen& pen);

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    void doubleClick(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    bool ownsKey(const QKeyEvent& event) const override;
    void cancel() override;
    bool showsPicture() const override { return true; }
    void choose() override { isReady(); }
    void dismiss() override;
    void leave() override {
        m_over = false;
        m_cross.hide();
    }
    void paint(QPainter& painter) const override;

  private:
    bool isReady();
    bool isFirst() const;
    void takePointer(const QMouseEvent& event);
    bool takesAway(Qt::KeyboardModifiers modifiers) const;
    bool makesPart() const;
    bool isDrawn() const { return m_shape != Shape::Wand && m_shape != Shape::Polygon; }
    QPainterPath area() const;
    Outline piece() const;
    bool isThin(const Outline& drawn) const;
    Outline slit(double tolerance) const;
    Outline inPicture(const QPainterPath& area) const;
    int part() const;
    bool isLocked(const std::string& name) const;
    Sheet sheet() const;
    std::shared_ptr<const Project> wholeOf(const Project& project) const;
    const Outline& outlineOf(const Domain& domain) const;
    Outline outlineOfColourAt(const Vec2& at) const;
    std::shared_ptr<const Project> withOutline(const Project& project, Outline outline, int& pinsGone) const;
    void finish(Qt::KeyboardModifiers modifiers);
    void takeColour(const QMouseEvent& event);
    void takeAgain();
    bool isLive() const;
    void apply(const Project& project, const Outline& piece, bool takesAway, const QString& key = {});
    void paintOutline(QPainter& painter) const;
    void scale(double factor);

    Shape m_shape;
    KeyCross m_cross;
    OutlinePen& m_pen;
    bool m_active = false, m_over = false;
    Qt::KeyboardModifiers m_modifiers;
    QPolygonF m_line;  // on the screen
    QPointF m_at;
    struct Known {  // the outline that follows from the picture
        std::shared_ptr<const Image> picture;
        Vec2 at = Vec2::Zero();
        OutlineKind kind = OutlineKind::Frame;
        AlphaOutlineOptions alpha;
        Outline outline;
    };
    mutable std::optional<Known> m_known;
    struct Left {            // to begin with
        int generation = 0;  // of the document
        double time = 0;
    };
    std::optional<Left> m_left;
    struct Taken {  // by the wand's last click
        Vec2 at;
        bool takesAway = false;
        QString key;                                   // of its step
        std::shared_ptr<const Project> before, after;  // the same if nothing came of it
    };
    std::optional<Taken> m_taken;
    QObject m_listener;  // to the pen
};

ToolKind outlineLassoTool();
ToolKind outlinePolygonTool();
ToolKind outlineBrushTool();
ToolKind outlineWandTool();
ToolKind cutStrokeTool();

}  // namespace wend
