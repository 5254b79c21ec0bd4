#pragma once

#include <QTimer>
#include <memory>
#include <optional>

#include "app/engine/shape/depth.h"
#include "app/views/canvas/moving_shape.h"
#include "app/views/canvas/render_thread.h"
#include "app/views/shape/viewport.h"

namespace wend {

class Document;
class ShapeMotion;

/// The picture that a view draws: that of the document, of a file's mesh or of parts, with the view's frame
/// and looks. It is drawn in a thread: quickly while anything changes, in full quality soon after.
class DrawnShape : public QObject {
    Q_OBJECT

  public:
    DrawnShape(const Viewport& viewport, const ViewTransform& view);

    /// Forgets the last document's picture and prepares that of the new one.
    void takeOpened();
    /// Prepares the picture of a frame.
    void takeFrame(const PosedFrame<2>& frame);
    /// Draws the shape again.
    void render();
    /// Paints the last drawing, moved and scaled until there is a new one.
    void paint(QPainter& painter) const;

    /// Returns the drawn picture of the document or of a file's mesh; null if there is none, or not yet.
    const std::shared_ptr<const ScreenPicture>& screenPicture() const { return m_picture; }
    /// Returns whether the document's picture is not ready to be drawn yet, which takes a while for large
    /// ones.
    bool isPreparing() const { return m_source && !m_picture; }
    /// Returns the colours of the window, with checks from which the picture stands out.
    Theme theme() const;
    /// Returns the last drawing; null before.
    const std::shared_ptr<const RenderResult>& drawn() const { return m_drawn; }
    /// Returns whether the last drawing is current and of full quality.
    bool isSettled() const;
    /// Returns the frame that is drawn, that of the original picture before the first mesh.
    PosedPtr<2> frame() const;
    /// Returns whether a map covers the shape.
    bool showsMap() const { return m_viewport.showsMap() && frame() && frame() != m_unbent; }
    /// Returns the depths of the drawn frame; null before the first mesh.
    CellDepths::Values depths() const;
    /// Returns the whole shape as large as fits, without overlays; null before there is one.
    QImage smallView(const QSize& size) const;
    /// Returns how another frame is drawn like this; nothing before there is a picture for it.
    std::optional<RenderRequest> smallRequest(const PosedPtr<2>& frame, const QSize& size) const;

  signals:
    /// Emitted when the picture is prepared.
    void prepared();

  private:
    const Document& document() const;
    const ShapeMotion& motion() const;
    void prepare(const std::shared_ptr<const Image>& picture);
    std::shared_ptr<const ScreenPicture> pictureOf(const PosedPtr<2>& frame) const;
    bool isReady() const;
    bool showsAll() const;
    std::shared_ptr<const PaintingPlan> plan() const;
    std::shared_ptr<const PaintingPlan> cellPlan() const;
    RenderRequest request(Filter filter) const;
    void takeRendered(const std::shared_ptr<const RenderResult>& result);

    const Viewport& m_viewport;
    const ViewTransform& m_view;
    std::shared_ptr<const Image> m_source;     // the document's picture, or that of a file's mesh or of parts
    std::shared_ptr<const Image> m_pictureOf;  // the image of m_picture
    std::shared_ptr<const ScreenPicture> m_picture;
    std::shared_ptr<const ScreenPicture> m_flat;  // the document's picture
    PosedPtr<2> m_unbent;                         // the original picture, before the first mesh
    std::shared_ptr<const RenderResult> m_drawn;
    mutable DrawingPace m_pace;
    QTimer m_refine;  // starts a drawing of full quality once nothing has moved for a while
    mutable CellDepths m_depths, m_cellDepths;  // of what is drawn, and of the mesh alone
    RenderThread m_renderer;  // last, so that the thread stops before the other members are destroyed
};

}  // namespace wend
