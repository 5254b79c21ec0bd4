#pragma once

#include "app/engine/motion/material_preview.h"
#include "app/engine/shape/pose_faults.h"
#include "app/tools/mesh/cut_tool.h"
#include "app/tools/paint/layer_lines.h"
#include "app/tools/pins/onion_skin.h"
#include "app/views/shape/viewport.h"
#include "app/views/volume/volume_view.h"

namespace wend {

/// The view of a session's solid: pose, colours and overlays.
class SolidCanvas : public VolumeView, public SolidShapeView, public Viewport::View {
    Q_OBJECT

  public:
    explicit SolidCanvas(ShapeSession& session, QWidget* parent = nullptr);

    /// Returns the part that handles tools and looks.
    Viewport& viewport() { return m_viewport; }
    const Viewport& viewport() const { return m_viewport; }
    CutTool& cutTool() { return m_cutTool; }
    /// Returns the plane at its default place, the middle of the shape.
    CutPlane middlePlane(const Vec<3>& normal) const;

    // SolidShapeView
    ShapeSession& session() override { return m_session; }
    Ray ray(const QPointF& widget) const override;
    QPointF onScreen(const Vec3& p) const override;
    double pixelSize(const Vec<3>& at) const override { return camera().pixelSize(size(), at); }
    Vec<3> viewDirection() const override { return camera().direction(); }
    SolidHit pick(const QPointF& widget) const override;
    std::optional<Touch> touch(const QPointF& widget) const override;
    FramePtr shownFrame() const override { return m_preview.over(m_session.motion().frame<3>()); }
    void showMaterial(const FramePtr& painted, bool lasts) override;
    std::vector<int> verticesWhere(const std::function<bool(const QPointF&)>& inside,
                                   bool visibleOnly) const override;
    bool isHidden(const Vec3& p) const;
    bool isHidden(const Place&, const Vec3& p) const override { return isHidden(p); }
    bool isCutOff(const Vec<3>& p) const override { return solid().isCutOff(p); }
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

    /// A frame as this view shows it, but without a map: for another view.
    VolumePicture plainPicture(const PosedFrame<3>& frame) const;
    SurfaceStyle plainStyle() const;
    /// Returns whether the solid has a detailed surface, or one with materials.
    bool hasDetail() const;
    /// The surface of a file while its tetrahedra are being made.
    void showPreview(const std::shared_ptr<const Skin>& skin);
    /// A surface that bounds no solid: seen along the direction at first in a document, then as the view is.
    void showRefused(VolumePicture picture, const Vec<3>& direction);
    /// Zooms to a place of such a surface, so that these points fill the view.
    void showPlace(VolumePicture picture, const Vec<3>& direction, const Points<3>& around);
    /// Returns to the solid.
    void showSolid();
    /// Zooms to a tetrahedron and marks it while the view stays there.
    void showCell(int cell);
    /// Outlines regions; none if empty.
    void setDetailRegions(const std::vector<wend::SoftRegion>& regions);
    /// Turns the view.
    void lookAlong(const Vec<3>& direction);
    /// Draws all overlays.
    void paintOver(QPainter& painter);
    /// Draws the overlays that do not belong to tools: pins, paths, the worst place, the axes.
    void paintMarks(QPainter& painter);
    bool hasLegend() const { return m_viewport.showsMap(); }
    /// Freezes the shown frame while rows of a picture are drawn.
    void setHeld(bool held);

  public slots:
    /// Copies camera, looks and cut of another canvas of the same size.
    void takeView(const SolidCanvas& other);
    void setCutKind(wend::CutKind kind);
    void setCutPlane(const wend::CutPlane& plane);
    void showWorst();
    /// Brings a place into the middle.
    void showPlace(const wend::Vec<3>& at);
    /// Sets the faults that the map marks, for the session's frame; null for none.
    void setFaults(const std::shared_ptr<const wend::PoseFaults<3>>& faults);

  signals:
    void cutChanged();
    /// Emits the cell under the pointer with its nearest corner and the point; cell −1 for none.
    void pointedAt(int cell, int vertex, const wend::Vec<3>& point);

  protected:
    Points<3> fitted() const override;
    bool isMoving() const override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void tabletEvent(QTabletEvent* event) override { takePressure(*event); }

  private:
    void takeFrame();
    void refresh();
    bool showsFrame() const;
    bool meetsNewDocument();
    void lookAtFirst();
    void takeKeptCamera();
    void takeUpAxis();
    void keepCamera();
    void showGlyphs(const PosedFrame<3>& frame);
    QRgb plainColour() const;
    QColor ground() const;
    bool isOnDark() const { return ground().lightnessF() < 0.5; }
    bool hasDetail(const PosedFrame<3>& frame) const;
    void addMap(VolumePicture& picture, const PosedFrame<3>& frame) const;
    void addPaint(VolumePicture& picture, const PosedFrame<3>& frame) const;
    void applyTheme();
    Vec<3> normalToViewer() const;
    const std::vector<int>& skinPoints() const;
    std::vector<Vec<3>> pathPoints() const;

    ShapeSession& m_session;
    std::shared_ptr<const void> m_mesh;  // of the last frame
    CutTool m_cutTool;
    MaterialPreview<3> m_preview;
    std::shared_ptr<const PoseFaults<3>> m_faults;
    int m_pointedCell = -1;                   // requested by showCell() …
    std::shared_ptr<const void> m_pointedOf;  // … of this mesh
    LayerLines m_layer;
    RegionLines m_detailRegions;
    OnionSkin<3> m_onion;
    QWidget* m_overlay;
    Viewport m_viewport;
    SurfaceStyle m_style;
    std::optional<SavedCamera> m_asOpened;  // the camera of the opened document in stored form
    int m_generation = -1;                  // of the document that the view was fitted to
    bool m_held = false, m_missed = false;
    bool m_planeChosen = false;  // the cut's, by the user in this document
    bool m_toFit = false;        // the view has not been fitted to the whole motion's end yet
    bool m_fitted = false;       // the view follows the window's size until the user changes it
    mutable std::shared_ptr<const Skin> m_marked;  // owner of m_skinPoints
    mutable std::vector<int> m_skinPoints;
};

}  // namespace wend
