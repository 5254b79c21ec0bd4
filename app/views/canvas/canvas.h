#pragma once

#include "app/engine/motion/material_preview.h"
#include "app/engine/shape/pose_faults.h"
#include "app/tools/paint/layer_lines.h"
#include "app/tools/pins/onion_skin.h"
#include "app/views/canvas/drawn_shape.h"
#include "app/views/canvas/ground.h"
#include "app/views/shape/viewport.h"

namespace wend {

/// The shape on the screen: navigation and drawing. A plain widget: no OpenGL is needed.
class ShapeCanvas : public QWidget, public PictureShapeView, public Viewport::View {
    Q_OBJECT

  public:
    explicit ShapeCanvas(ShapeSession& session, QWidget* parent = nullptr);

    /// Returns the part that handles tools and looks.
    Viewport& viewport() { return m_viewport; }
    const ViewTransform& view() const { return m_view; }
    /// Shows the same part of the domain as another canvas of that size.
    void takeView(const ShapeCanvas& other);
    /// Shows the view of another canvas, without adapting to its own size.
    void followOther() { m_follows = true; }
    /// Returns what is drawn.
    const DrawnShape& shape() const { return m_shape; }
    /// Returns whether the last drawing is current and of full quality.
    bool isSettled() const { return m_shape.isSettled(); }

    // PictureShapeView
    ShapeSession& session() override { return m_session; }
    Vec2 toShape(const QPointF& widget) const override { return m_view.toShape(widget); }
    QPointF toWidget(const Vec2& shape) const override { return m_view.toWidget(shape); }
    double pixelSize(const Vec3&) const override { return 1 / m_view.zoom(); }
    std::optional<Touch> touch(const QPointF& widget) const override;
    bool isHidden(const Place& place, const Vec3& p) const override;
    std::vector<VertexMark> marksOf(const std::vector<int>& vertices) const override;
    FramePtr shownFrame() const override;
    void showMaterial(const FramePtr& painted, bool lasts) override;
    void redraw() override;

    // Viewport::View
    void showLooks() override;
    bool navigatesBy(const QMouseEvent& event) const override { return event.button() == Qt::MiddleButton; }
    bool isNavigating() const override { return m_panning; }
    bool isPanning() const override { return m_panning; }
    void navigate(QMouseEvent& event, bool pans) override;
    void endNavigation() override { m_panning = false; }
    QString pointerText(const QPointF& at) override;
    void showPlace(const Vec3& at) override;

  public slots:
    /// Draws the border of other regions; none: of none.
    void setDetailRegions(const std::vector<wend::SoftRegion>& regions);
    void setDepthRegions(const std::vector<wend::SoftRegion>& regions);
    /// Fits the view to the shape, and again whenever the window's size changes, until the user moves the
    /// view.
    void fit() { fitTo(Fitted::Pose); }
    void zoomTo(double zoom) { zoomTo(zoom, rect().center()); }
    void zoomBy(double factor) { zoomTo(m_view.zoom() * factor); }
    /// Sets the faults that the map marks, for the session's frame; null for none.
    void setFaults(const std::shared_ptr<const wend::PoseFaults<2>>& faults);

  signals:
    void viewChanged();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

  private:
    enum class Fitted { No, Picture, Pose };
    void takeOpened();
    void fitTo(Fitted what);
    void fitView();
    void zoomTo(double zoom, const QPointF& at);
    void takeFrame();
    QRectF frameRect() const;
    QRectF fittedRect() const;
    void paintOver(QPainter& painter);
    void showView();

    ShapeSession& m_session;
    Viewport m_viewport;
    std::shared_ptr<const PoseFaults<2>> m_faults;
    MaterialPreview<2> m_preview;
    LayerLines m_layer;
    RegionLines m_detailRegions, m_depthRegions;
    OnionSkin<2> m_onion;
    ViewTransform m_view;
    Ground m_ground;
    Fitted m_fitted = Fitted::No;  // the view follows the window's size until the user changes it
    bool m_follows = false;
    bool m_panning = false;
    QPointF m_lastPan;
    DrawnShape m_shape;
};

}  // namespace wend
