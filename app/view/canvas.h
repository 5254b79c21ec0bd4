#pragma once

#include <QTimer>
#include <QWidget>

#include "app/panels/pin_animation.h"
#include "app/session/depth.h"
#include "app/session/material_preview.h"
#include "app/session/pose_faults.h"
#include "app/tools/layer_lines.h"
#include "app/tools/onion_skin.h"
#include "app/view/drawing_pace.h"
#include "app/view/ground.h"
#include "app/view/render_thread.h"

namespace wend {

class LegendLock;
class OverlayPainter;

/// The shape on the screen: navigation, drawing and the events of the current tool. A plain widget: no OpenGL
/// is needed.
class ShapeCanvas : public QWidget, public ToolSurface {
    Q_OBJECT

  public:
    explicit ShapeCanvas(ShapeSession& session, QWidget* parent = nullptr);

    void setTool(Tool* tool);
    Tool* tool() const { return m_tool; }

    const ViewTransform& view() const { return m_view; }
    /// The same part of the domain as another canvas of that size shows.
    void takeView(const ShapeCanvas& other);
    /// The document's picture, or that of a file's mesh, as it is drawn; null where there is none, or not
    /// yet.
    const std::shared_ptr<const ScreenPicture>& screenPicture() const { return m_picture; }
    /// What was drawn last; null before.
    const std::shared_ptr<const RenderResult>& drawn() const { return m_drawn; }
    /// True if what was drawn last is what there is to show, at full quality.
    bool isSettled() const;

    // ToolSurface
    ShapeSession& session() override { return m_session; }
    Vec<2> toShape(const QPointF& widget) const override { return m_view.toShape(widget); }
    QPointF toWidget(const Vec<2>& shape) const override { return m_view.toWidget(shape); }
    double pixelSize(const Vec<2>&) const override { return 1 / m_view.zoom(); }
    std::optional<Touch<2>> touch(const QPointF& widget) const override;
    PosedPtr<2> shownFrame() const override { return m_preview.over(m_session.frame<2>()); }
    void showMaterial(std::shared_ptr<const Material<2>> painted, bool lasts) override;
    void redraw() override;

  public slots:
    void setMeshShown(bool shown);
    void setMapShown(bool shown);
    void setMap(Measure measure, const MeasureRange& range);
    /// What keeps that range, for the lock on the legend's card.
    void setRangeKeeper(QAction& keep);
    void setMapOpacity(double opacity);
    /// Of a map: without the edges of its cells.
    void setMapSmooth(bool smooth);
    void setArrowsShown(bool shown);
    /// What was before and comes after.
    void setOnionSkin(bool shown);
    void setMarksShown(bool shown);
    /// Draws the border of a layer of the material; null: of none.
    void setLayer(const QString& name);
    /// Draws the border of other regions; none: of none.
    void setDetailRegions(const std::vector<wend::MaterialRegion<2>>& regions);
    void setDepthRegions(const std::vector<wend::MaterialRegion<2>>& regions);
    void setOverlaysHidden(bool hidden);
    /// Behind a picture; invalid: checks.
    void setBackdrop(const QColor& colour);
    /// The shape as it was before it was bent.
    void setRestShown(bool shown);
    /// Another frame in the place of the session's, which does not change; null: none.
    void setStandIn(const wend::FramePtr& frame);
    void fit();
    void zoomTo(double zoom);
    void zoomBy(double factor);
    void showWorst();
    /// Brings a place into the middle.
    void showPlace(const wend::Vec<2>& at);
    /// What is marked in the map, of the session's frame; null: nothing.
    void setFaults(const std::shared_ptr<const wend::PoseFaults<2>>& faults);

  signals:
    void hintChanged(QString hint);
    void viewChanged();
    /// A menu for what is under the pointer is asked for.
    void menuWanted(QPoint global, wend::MenuPlace place);
    /// Where the pointer is in the domain; `inside` is false when it has left.
    void pointed(double x, double y, bool inside);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void tabletEvent(QTabletEvent* event) override { takePressure(*event); }
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

  private:
    void takeOpened();
    void preparePicture(const std::shared_ptr<const Image>& picture);
    void takeTexture(const PosedFrame<2>& frame);
    PosedPtr<2> drawnFrame() const;
    CellDepths::Values depths() const;
    std::shared_ptr<const PaintingPlan> plan() const;
    void takeFrame();
    void takeRendered(const std::shared_ptr<const RenderResult>& result);
    RenderRequest request(Filter filter) const;
    void render();
    QRectF frameRect() const;
    void paintShape(QPainter& painter);
    void paintHandles(QPainter& painter, OverlayPainter& overlay);
    void showView();
    bool hasLegend() const { return m_map && !m_hidden && m_session.frame<2>(); }
    void wantVelocity();
    bool pansBy(const QMouseEvent& event) const;
    void updateCursor();
    void endPan();

    ShapeSession& m_session;
    Tool* m_tool = nullptr;
    LegendLock* m_lock = nullptr;
    std::shared_ptr<const Image> m_source;  // the document's picture, or that of a file's mesh
    std::shared_ptr<const ScreenPicture> m_picture;
    FramePtr m_standIn;
    std::shared_ptr<const PoseFaults<2>> m_faults;
    PosedPtr<2> m_unbent;  // the picture as it is, before the first mesh
    MaterialPreview<2> m_preview;
    LayerLines<2> m_layer;
    RegionLines m_detailRegions, m_depthRegions;
    OnionSkin<2> m_onion;
    PinAnimation m_animation{m_session};
    bool m_marks = false;  // of stiffness
    bool m_arrows = false;
    ViewTransform m_view;
    std::shared_ptr<const RenderResult> m_drawn;
    mutable DrawingPace m_pace;
    QTimer m_refine;    // draws at full quality once nothing has moved for a while
    QTimer m_dim;       // a stale frame is dimmed after a while
    QTimer m_marksDue;  // in a drag: moves of the pointer alone are painted no more often
    mutable CellDepths m_depths;
    Ground m_ground;
    bool m_mesh = false, m_map = false, m_hidden = false, m_dimmed = false;
    QColor m_backdrop;
    bool m_rest = false;
    bool m_fitted = false;  // the view follows the window's size until the user changes it
    bool m_spaceDown = false, m_panning = false;
    bool m_menuPressed = false;  // the right button, and no other
    bool m_leads = false;        // the tool, with a button that is its own
    QPointF m_lastPan;
    Measure m_measure = Measure::Length;
    MeasureRange m_range;
    double m_opacity = kMapOpacity;
    bool m_smooth = false;
    RenderThread m_renderer;  // the last member: it stops before the others go
};

}  // namespace wend
