#pragma once

#include <QImage>
#include <QWidget>
#include <stop_token>

#include "app/panels/look/theme.h"
#include "app/session/run/frame_export.h"
#include "app/view/canvas/screen_picture.h"

namespace wend {

/// A small picture of what an export will write, on paper or, where it is transparent, on squares.
class ExportPreview : public QWidget {
    Q_OBJECT

  public:
    explicit ExportPreview(QWidget* parent, const QSize& least = {280, 240},
                           const QSize& wanted = {400, 320});
    void setImage(const QImage& image);
    const QImage& image() const { return m_image; }
    /// The image answers another question than the one that is asked now; the next image answers it.
    void setOutdated() { m_current = false; }
    bool isCurrent() const { return m_current; }
    /// In pixels of the screen.
    QSize room() const;
    /// Where the image is seen: in the middle, smaller if it is larger than the room.
    QRectF place() const;
    QSize sizeHint() const override { return m_wanted; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QSize m_wanted;
    QImage m_image;
    bool m_current = false;
};

/// What that picture is made of.
struct PreviewRequest {
    ExportKind kind = ExportKind::Picture;
    std::string extension;
    RunOptions options;
    QSize room;
    double ratio = 1;
    QColor fill, line;  // of a mesh
};

/// Drawn by the code that exports, smaller. For any thread; null if stopped. `picture`: as
/// the screen shows it. Throws InputError for what cannot be written.
QImage exportPreview(const FrameExport& shape, const std::shared_ptr<const ScreenPicture>& picture,
                     const PreviewRequest& request, std::stop_token stop);

}  // namespace wend
