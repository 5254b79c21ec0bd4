#pragma once

#include "app/engine/motion/material_preview.h"
#include "app/tools/mesh/cut_tool.h"
#include "app/views/volume/solid_look.h"
#include "app/views/volume/volume_view.h"

namespace wend {

class SolidOverlay;

/// The camera of a view and of its document. It fits the view to a new solid, and again whenever its size
/// changes, until the user moves it; the document keeps it.
class SolidViewpoint {
  public:
    SolidViewpoint(VolumeView& view, Document& document) : m_view(view), m_document(document) {}

    /// Returns true once per document, and looks at its solid as at first then.
    bool begin();
    /// Looks as at documents without a camera.
    void lookAtFirst();
    /// Restores the document's camera after fitting, which sets the depth range.
    void restore();
    /// Takes the axis of the document that points up.
    void takeUpAxis();
    /// Keeps the camera in the document, unless the user has not moved it.
    void keep();
    /// Turns the view.
    void lookAlong(const Vec3& direction);
    /// Shows these points as large as they fit.
    void zoomTo(const Points3& points);

    bool isFitted() const { return m_isFitted; }
    /// Sets whether the view fits the shape when its size changes.
    void setFitted(bool fitted) { m_isFitted = fitted; }

  private:
    bool isOfDocument() const { return m_document.generation() == m_generation; }

    VolumeView& m_view;
    Document& m_document;
    std::optional<SavedCamera> m_asOpened;  // the camera of the opened document in stored form
    int m_generation = -1;                  // of the document that the view was fitted to
    bool m_isFitted = false;
};

/// The view of a session's solid, as tools and users see it.
class SolidCanvas : public VolumeView, public SolidShapeView, public Viewport::View {
    Q_OBJECT

  public:
    explicit SolidCanvas(ShapeSession& session, QWidget* parent = nullptr);

    /// Returns the part that handles tools and looks.
    Viewport& viewport() { return m_viewport; }
    CutTool& cutTool() { return m_cutTool; }
    const SolidLook& solidLook() const { return m_look; }
    SolidViewpoint& viewpoint() { return m_viewpoint; }
    SolidOverlay& overlay() { return *m_overlay; }

    // SolidShapeView
    ShapeSession& session() override { return m_session; }
    Ray ray(const QPointF& widget) const override { return camera().ray({widget.x(), widget.y()}, size()); }
    QPointF onScreen(const Vec3& p) const override;
    double pixelSize(const Vec3& at) const override { return camera().pixelSize(size(), at); }
    Vec3 viewDirection() const override { return camera().direction(); }
    SolidHit pick(const QPointF& widget) const override;
    std::optional<Touch> touch(const QPointF& widget) const override;
    FramePtr shownFrame() const override;
    void showMaterial(const FramePtr& painted, bool lasts) override;
    std::vector<int> verticesWhere(const std::function<bool(const QPointF&)>& inside,
                                   bool visibleOnly) const override;
    bool isHidden(const Place& place, const Vec3& p) const override;
    bool isCutOff(const Vec3& p) const override { return solid().isCutOff(p); }
    std::optional<Vec3> placeOf(const ShapeFrame& frame, int cell) const override;
    std::vector<VertexMark> marksOf(const std::vector<int>& vertices) const override;
    void redraw() override;
    bool showsManipulators() const override { return !m_cutTool.comesFirst(); }

    // Viewport::View
    void showLooks() override;
    bool navigatesBy(const QMouseEvent& event) const override {
        return navigation().dragFor(event) != Navigation::Drag::None;
    }
    bool isNavigating() const override { return navigation().isGoingOn(); }
    bool isPanning() const override { return navigation().drag() == Navigation::Drag::Pan; }
    void navigate(QMouseEvent& event, bool pans) override;
    void endNavigation() override { navigation().end(); }
    QString pointerText(const QPointF& at) override;
    void showPlace(const Vec3& at) override;

    /// Shows the surface of a file while its tetrahedra are being made.
    void showPreview(const Skin& skin);
    /// Shows a surface that bounds no solid: at first along the direction, later as the view is.
    void showRefused(VolumePicture picture, const Vec3& direction);
    /// Zooms to a tetrahedron and marks it while the view stays there.
    void showCell(int cell);
    /// Freezes the shown frame while rows of a picture are drawn.
    void setHeld(bool held);

  public slots:
    /// Copies camera, looks and cut of another canvas of the same size.
    void takeView(const SolidCanvas& other);
    void setCutKind(wend::CutKind kind);
    void setCutPlane(const wend::CutPlane& plane);
    /// Sets the faults that the map marks, for the session's frame; null for none.
    void setFaults(const std::shared_ptr<const wend::PoseFaults<3>>& faults);

  signals:
    void cutChanged();
    /// Emits the cell under the pointer with its nearest corner and the point; cell −1 for none.
    void pointedAt(int cell, int vertex, const wend::Vec3& point);

  protected:
    Points3 fitted() const override;
    bool isMoving() const override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

  private:
    bool showsFrame() const;

    ShapeSession& m_session;
    std::shared_ptr<const void> m_mesh;  // of the last frame
    CutTool m_cutTool;
    MaterialPreview<3> m_preview;
    SolidOverlay* m_overlay;
    Viewport m_viewport;
    SolidLook m_look;
    SolidViewpoint m_viewpoint;
    bool m_held = false, m_missed = false;
    bool m_toFit = false;  // the view has not been fitted to the whole motion's end yet
};

}  // namespace wend
