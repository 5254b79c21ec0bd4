#pragma once

#include <QImage>
#include <QObject>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "app/base/hand_over.h"
#include "app/engine/motion/frame.h"
#include "app/engine/shape/shape.h"
#include "app/views/canvas/moving_shape.h"
#include "app/views/canvas/screen_picture.h"
#include "app/views/canvas/view_transform.h"
#include "app/views/shape/looks.h"
#include "warp/coverage.h"
#include "warp/sampling.h"

namespace wend {

/// A drawing request of the canvas: the picture with a frame, and the layers over it.
struct RenderRequest {
    int document = 0;                              // its generation: drawings of another one are outdated
    std::shared_ptr<const ScreenPicture> picture;  // may be null
    std::shared_ptr<const Texture>
        texture;  // of a file's mesh, or of parts: its placement in the picture; or null
    PosedPtr<2> frame;
    std::shared_ptr<const PaintingPlan> plan;      // of what is drawn; null: all cells are equally deep
    std::shared_ptr<const PaintingPlan> cellPlan;  // of the frame's mesh: the same, without attached parts
    MovingCells::DrawnPtr cells;                   // of that mesh, in the place of its own; or null
    ViewTransform view;
    QSize size;          // of the widget
    double ratio = 1;    // device pixels per widget pixel
    int coarseness = 1;  // device pixels per side of a drawn one
    Filter filter = Filter::Bilinear;
    bool allOfPicture = false;  // also outside the outline
    bool cutOut = false;        // the outline is that of the picture: a map covers what the picture shows
    bool mesh = false;
    bool map = false;
    MapLook colours;
    Eigen::MatrixXd velocity;     // of the vertices, for the map of their speed; or none
    std::optional<double> plain;  // of the map: where it has this value the picture is not coloured
    QColor fill, line;            // of the mesh and, without a picture, of the shape
    QColor lightLine = QColor(236, 238, 244);  // mesh lines over dark places …
    QColor ground = Qt::white;                 // … including this background below transparent places

    /// Drawn pixels per widget pixel.
    double scale() const { return ratio / coarseness; }
};

struct RenderResult {
    RenderRequest request;
    QImage image;             // transparent where the shape is not
    double milliseconds = 0;  // that it took
};

/// Draws in a thread of its own, so that the pointer never waits. The newest request wins.
class RenderThread : public QObject {
    Q_OBJECT

  public:
    explicit RenderThread(QObject* parent = nullptr);
    ~RenderThread() override;

    void post(RenderRequest request);

    /// Draws in the caller's thread; returns a null image if stopped.
    static QImage render(const RenderRequest& request, std::stop_token stop = {});

  signals:
    void rendered(std::shared_ptr<const wend::RenderResult> result);

  private:
    void loop(std::stop_token stop);
    void chooseCells(RenderRequest& request);

    HandOver m_out;
    std::mutex m_mutex;
    std::condition_variable_any m_arrived;
    std::optional<RenderRequest> m_next;
    std::stop_source m_current;
    MovingCells m_moving;
    std::jthread m_thread;  // last, so that the thread stops before the other members are destroyed
};

}  // namespace wend
