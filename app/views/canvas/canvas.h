#pragma once

#include "app/engine/motion/material_preview.h"
#include "app/engine/shape/depth.h"
#include "app/engine/shape/pose_faults.h"
#include "app/tools/paint/layer_lines.h"
#include "app/tools/pins/onion_skin.h"
#include "app/views/canvas/ground.h"
#include "app/views/canvas/moving_shape.h"
#include "app/views/canvas/render_thread.h"
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
    /// Returns the drawn picture of the document or of a file's mesh; null if there is none, or not yet.
    const std::shared_ptr<const ScreenPicture>& screenPicture() const { return m_picture; }
    /// Returns whether the document's picture is not ready to be drawn yet, which takes a while for large
    /// ones.
    bool isPreparing() const { return m_source && !m_picture; }
    /// Returns the last drawing; null before.
    const std::shared_ptr<const RenderResult>& drawn() const { return m_drawn; }
    /// Returns whether the last drawing is current and of full quality.
    bool isSettled() const;
    /// Returns the whole shape as large as fits, without overlays; null before there is one.
    QImage smallView(const QSize& size) const;
    /// Returns how another frame is drawn like this; nothing before there is a picture for it.
    std::optional<RenderRequest> smallRequest(const PosedPtr<2>& frame, const QSize& size) const;

    // PictureShapeView
    ShapeSession& session() override { return m_session; }
    Vec<2> toShape(const QPointF& widget) const override { return m_view.toShape(widget); }
    QPointF toWidget(const Vec<2>& shape) const override { return m_view.toWidget(shape); }
    double pixelSize(const Vec3&) const override { return 1 / m_view.zoom(); }
    std::optional<Touch> touch(const QPointF& widget) const override;
    bool isHidden(const Place& place, const Vec3& p) const override;
    std::vector<VertexMark> marksOf(const std::vector<int>& vertices) const override;
    FramePtr shownFrame() const override { return m_preview.over(m_session.motion().frame<2>()); }
    void showMaterial(const FramePtr& painted, bool lasts) override;
    void redraw() override;

    // Viewport::View
    void showLooks() override { render(); }
    bool navigatesBy(const QMouseEvent& event) const override { return event.button() == Qt::MiddleButton; }
    bool isNavigating() const override { return m_panning; }
    bool isPanning() const override { return m_panning; }
    void navigate(QMouseEvent& event, bool pans) override;
    void endNavigation() override { m_panning = false; }
    QString pointerText(const QPointF& at) override;

  public slots:
    /// Draws the border of other regions; none: of none.
    void setDetailRegions(const std::vector<wend::SoftRegion>& regions);
    void setDepthRegions(const std::vector<wend::SoftRegion>& regions);
    /// Fits the view to the shape, and again whenever the window's size changes, until the user moves the
    /// view.
    void fit() { fitTo(Fitted::Pose); }
    void zoomTo(double zoom);
    void zoomBy(double factor);
    void showWorst();
    /// Brings a place into the middle.
    void showPlace(const wend::Vec<2>& at);
    /// Sets the faults that the map marks, for the session's frame; null for none.
    void setFaults(const std::shared_ptr<const wend::PoseFaults<2>>& faults);

  signals:
    void viewChanged();
    /// Emitted when the picture is prepared.
    void prepared();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void tabletEvent(QTabletEvent* event) override { takePressure(*event); }

  private:
    std::vector<bool> untouchable(const SimplicialMesh<2>& rest) const;
    enum class Fitted { No, Picture, Pose };
    void takeOpened();
    void fitTo(Fitted what);
    void fitView();
    void preparePicture(const std::shared_ptr<const Image>& picture);
    void takeTexture(const PosedFrame<2>& frame);
    void takeParts(const PosedFrame<2>& frame);
    std::shared_ptr<const ScreenPicture> pictureOf(const PosedPtr<2>& frame) const;
    PosedPtr<2> drawnFrame() const;
    CellDepths::Values depths() const;
    std::shared_ptr<const PaintingPlan> plan() const;
    std::shared_ptr<const PaintingPlan> cellPlan() const;
    void takeFrame();
    void takeRendered(const std::shared_ptr<const RenderResult>& result);
    RenderRequest request(Filter filter) const;
    void render();
    QRectF frameRect() const;
    QRectF fittedRect() const;
    void paintShape(QPainter& painter);
    void paintOver(QPainter& painter);
    void showView();
    bool showsPicture() const;

    ShapeSession& m_session;
    Viewport m_viewport;
    std::shared_ptr<const Image> m_source;     // the document's picture, or that of a file's mesh or of parts
    std::shared_ptr<const Image> m_pictureOf;  // the image of m_picture
    std::shared_ptr<const ScreenPicture> m_picture;
    std::shared_ptr<const ScreenPicture> m_flat;  // the document's picture
    std::shared_ptr<const PoseFaults<2>> m_faults;
    PosedPtr<2> m_unbent;  // the original picture, before the first mesh
    MaterialPreview<2> m_preview;
    LayerLines m_layer;
    RegionLines m_detailRegions, m_depthRegions;
    OnionSkin<2> m_onion;
    ViewTransform m_view;
    std::shared_ptr<const RenderResult> m_drawn;
    mutable DrawingPace m_pace;
    QTimer m_refine;  // starts a drawing of full quality once nothing has moved for a while
    mutable CellDepths m_depths, m_cellDepths;  // of what is drawn, and of the mesh alone
    Ground m_ground;
    Fitted m_fitted = Fitted::No;  // the view follows the window's size until the user changes it
    bool m_follows = false;
    bool m_panning = false;
    QPointF m_lastPan;
    RenderThread m_renderer;  // last, so that the thread stops before the other members are destroyed
};

}  // namespace wend
