#pragma once

#include <QTimer>

#include "app/panels/colour_map.h"
#include "app/panels/pin_animation.h"
#include "app/session/material_preview.h"
#include "app/session/pose_faults.h"
#include "app/tools/cut_tool.h"
#include "app/tools/layer_lines.h"
#include "app/tools/onion_skin.h"
#include "app/view/volume/volume_view.h"

namespace wend {

class LegendLock;

/// The solid of a session on the screen: its pose and colours, what lies over it, and the events of the
/// current tool.
class SolidCanvas : public VolumeView, public SolidSurface {
    Q_OBJECT

  public:
    explicit SolidCanvas(ShapeSession& session, QWidget* parent = nullptr);

    void setTool(Tool* tool);
    Tool* tool() const { return m_tool; }
    CutTool& cutTool() { return m_cutTool; }
    /// The plane's default place: the middle of the shape.
    CutPlane middlePlane(const Vec<3>& normal) const;

    // SolidSurface
    ShapeSession& session() override { return m_session; }
    Ray ray(const QPointF& widget) const override;
    QPointF toWidget(const Vec<3>& p) const override;
    double pixelSize(const Vec<3>& at) const override { return camera().pixelSize(size(), at); }
    Vec<3> viewDirection() const override { return camera().direction(); }
    SolidHit pick(const QPointF& widget) const override;
    std::optional<Touch<3>> touch(const QPointF& widget) const override;
    PosedPtr<3> shownFrame() const override { return m_preview.over(m_session.frame<3>()); }
    void showMaterial(std::shared_ptr<const Material<3>> painted, bool lasts) override;
    std::vector<int> verticesWhere(const std::function<bool(const QPointF&)>& inside,
                                   bool visibleOnly) const override;
    bool isHidden(const Vec<3>& p) const override;
    std::optional<Vec<3>> placeOf(int cell) const override;
    std::vector<VertexMark> marksOf(const std::vector<int>& vertices) const override;
    void redraw() override;
    /// With what follows from the looks: colours and marks.
    void refresh();

    /// A frame as this view shows it, but without a map: for another view.
    VolumePicture plainPicture(const PosedFrame<3>& frame) const;
    SurfaceStyle plainStyle() const;
    /// True if the solid has a surface of its own to show: a detailed one, or one with materials.
    bool hasDetail() const;
    /// The surface of a file while its tetrahedra are being made.
    void showPreview(const std::shared_ptr<const Skin>& skin);
    /// A surface that bounds no solid: seen along the direction at first in a document, then as the view is.
    void showRefused(VolumePicture picture, const Vec<3>& direction);
    /// A place of such a surface, so near that these points fill the view.
    void showPlace(VolumePicture picture, const Vec<3>& direction, const Points<3>& around);
    /// The solid again.
    void showSolid();
    /// A tetrahedron from near, with a mark as long as it is there.
    void showCell(int cell);
    /// Turns the view.
    void lookAlong(const Vec<3>& direction);
    /// What lies over the view.
    void paintOver(QPainter& painter);
    /// Of that, what is not the tools': pins, paths, the worst place, the axes.
    void paintMarks(QPainter& painter);
    bool hasLegend() const { return showsMap(); }
    /// While held, what is shown stays as it is, whatever is computed: rows of one picture are drawn.
    void setHeld(bool held);
    /// The map's, at the top left.
    void paintLegend(QPainter& painter) const;

  public slots:
    void setFlat(bool flat);
    void setEdgesShown(bool shown);
    void setMapShown(bool shown);
    /// The detailed or painted surface embedded in the solid, where there is one, or the tetrahedra's
    /// border.
    void setDetailShown(bool shown);
    void setMap(Measure measure, const MeasureRange& range);
    /// What keeps that range, for the lock on the legend's card.
    void setRangeKeeper(QAction& keep);
    /// Of the map over a surface that has colours of its own.
    void setMapOpacity(double opacity);
    /// Of a map: without the edges of its cells.
    void setMapSmooth(bool smooth);
    void setArrowsShown(bool shown);
    /// What was before and comes after.
    void setOnionSkin(bool shown);
    void setGlyphsShown(bool shown);
    /// Draws the regions of a layer of the material; null: of none.
    void setLayer(const QString& name);
    void setOverlaysHidden(bool hidden);
    /// Behind the solid; invalid: the workspace.
    void setBackdrop(const QColor& colour);
    /// The solid as it was before it was bent.
    void setRestShown(bool shown);
    /// Another frame in the place of the session's, which does not change; null: none.
    void setStandIn(const wend::FramePtr& frame);
    /// The same look from the same place as another canvas of that size, cut as it is.
    void takeView(const SolidCanvas& other);
    /// Values under the pointer are shown elsewhere, the velocity among them.
    void setValuesShown(bool shown);
    void setCutKind(wend::CutKind kind);
    void setCutPlane(const wend::CutPlane& plane);
    void showWorst();
    /// Brings a place into the middle.
    void showPlace(const wend::Vec<3>& at);
    /// What is marked in the map, of the session's frame; null: nothing.
    void setFaults(const std::shared_ptr<const wend::PoseFaults<3>>& faults);

  signals:
    void hintChanged(QString hint);
    /// A menu for what is under the pointer is asked for.
    void menuWanted(QPoint global, wend::MenuPlace place);
    /// What is under the pointer, in words; empty when it has left.
    void pointed(QString text);
    void cutChanged();
    /// The cell under the pointer, its nearest corner and the point; cell −1 if there is none.
    void pointedAt(int cell, int vertex, const wend::Vec<3>& point);

  protected:
    Points<3> fitted() const override;
    bool isMoving() const override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void tabletEvent(QTabletEvent* event) override { takePressure(*event); }
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

  private:
    void takeFrame();
    void endGestureOnOtherMesh();
    bool showsFrame() const;
    bool meetsNewDocument();
    void lookAtFirst();
    void takeKeptCamera();
    void takeUpAxis();
    void keepCamera();
    void showGlyphs(const PosedFrame<3>& frame);
    void wantVelocity();
    void tellPointed(const QPointF& at);
    void setSpaceDown(bool down);
    bool pansBy(const QMouseEvent& event, const Tool* tool) const;
    void updateCursor();
    bool showsMap() const { return m_map && !m_hidden; }
    QRgb plainColour() const;
    bool hasDetail(const PosedFrame<3>& frame) const;
    void addMap(VolumePicture& picture, const PosedFrame<3>& frame) const;
    Tool* toolAt(const QPointF& at);
    bool isForTool(const QMouseEvent& event, const Tool& tool);
    void useTool(Tool* tool);
    void tellHint(const Tool& tool);
    void applyTheme();
    Vec<3> normalToViewer() const;
    bool isCutOff(const Vec<3>& p) const { return cut() != CutKind::None && plane().height(p) > 1e-9; }
    const std::vector<int>& skinPoints() const;

    ShapeSession& m_session;
    Tool* m_tool = nullptr;
    bool m_spaceDown = false;                         // the left button moves the view
    Tool* m_active = nullptr;                         // the one that has the pointer …
    Qt::MouseButton m_activeButton = Qt::LeftButton;  // … as long as this is down
    std::shared_ptr<const void> m_mesh;               // of the last frame
    CutTool m_cutTool;
    MaterialPreview<3> m_preview;
    FramePtr m_standIn;
    std::shared_ptr<const PoseFaults<3>> m_faults;
    int m_pointedCell = -1;                   // that was to be seen …
    std::shared_ptr<const void> m_pointedOf;  // … of this mesh
    LayerLines<3> m_layer;
    OnionSkin<3> m_onion;
    PinAnimation m_animation{m_session};
    QWidget* m_overlay;
    LegendLock* m_lock = nullptr;
    SurfaceStyle m_style;
    QTimer m_dim, m_marksDue;               // in a drag: moves of the pointer alone are painted no more often
    std::optional<SavedCamera> m_asOpened;  // the camera that the document brought, as it is kept
    int m_generation = -1;                  // of the document that the view was fitted to
    QColor m_backdrop;                      // invalid: the workspace
    bool m_map = false, m_arrows = false, m_values = false, m_glyphs = false, m_hidden = false,
         m_rest = false, m_dimmed = false, m_held = false, m_missed = false, m_hasSolid = false;
    bool m_detail = true, m_smooth = false;
    bool m_planeChosen = false;  // the cut's, by the user in this document
    bool m_toFit = false;        // the view has not been fitted to the whole motion's end yet
    bool m_fitted = false;       // the view follows the window's size until the user changes it
    double m_opacity = kMapOpacity;
    Measure m_measure = Measure::Length;
    MeasureRange m_range;
    mutable std::shared_ptr<const Skin> m_marked;  // whose points m_skinPoints are
    mutable std::vector<int> m_skinPoints;
};

}  // namespace wend
