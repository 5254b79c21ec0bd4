#pragma once

#include <QImage>
#include <QWidget>
#include <stop_token>

#include "app/output/frame_export.h"
#include "app/style/theme.h"
#include "app/views/canvas/screen_picture.h"

namespace wend {

/// A preview of an export on paper, or on checks where it is transparent.
class ExportPreview : public QWidget {
    Q_OBJECT

  public:
    explicit ExportPreview(QWidget* parent, const QSize& least = {280, 240},
                           const QSize& wanted = {400, 320});
    void setImage(const QImage& image);
    const QImage& image() const { return m_image; }
    /// Marks the image as outdated until the next one arrives, because the request has changed.
    void setOutdated() { m_current = false; }
    bool isCurrent() const { return m_current; }
    /// Returns the available size in device pixels.
    QSize room() const;
    /// Returns the rectangle of the image: centred, and scaled down if necessary.
    QRectF place() const;
    QSize sizeHint() const override { return m_wanted; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QSize m_wanted;
    QImage m_image;
    double m_lightness = 1;
    bool m_current = false;
};

/// The parameters of a preview.
struct PreviewRequest {
    ExportKind kind = ExportKind::Picture;
    std::string extension;
    RunOptions options;
    QSize room;
    double ratio = 1;
    QColor fill, line;  // of a mesh
};

/// Draws a small version by the code that exports. Thread-safe; null if stopped. `picture`: prepared for the
/// screen. Throws InputError if it cannot be written.
QImage exportPreview(const FrameExport& shape, const std::shared_ptr<const ScreenPicture>& picture,
                     const PreviewRequest& request, std::stop_token stop);

}  // namespace wend
