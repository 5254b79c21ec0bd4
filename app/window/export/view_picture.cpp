#include "app/window/export/view_picture.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QPainter>
#include <QPointer>
#include <QProgressDialog>
#include <cstring>
#include <exception>
#include <functional>
#include <future>
#include <new>
#include <stop_token>

#include "app/base/in_background.h"
#include "app/session/shape_session.h"
#include "app/views/volume/solid_overlay.h"
#include "core/base/error.h"
#include "core/base/safe_file.h"
#include "warp/film.h"
#include "warp/film_format.h"
#include "warp/image_formats.h"

namespace wend {

namespace {

constexpr int kStripRows = 512;

/// Draws the overlays at the window's scale relative to the solid, which depends on the height.
void paintMarks(QImage& rows, int top, SolidCanvas& canvas, const PictureChoice& choice) {
    QPainter painter(&rows);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    const double scale = choice.size.height() / static_cast<double>(canvas.height());
    painter.translate(0, -top);
    painter.scale(scale, scale);
    if (choice.legend) canvas.viewport().paintLegend(painter, (QSizeF(choice.size) / scale).toSize());
    painter.translate((choice.size.width() / scale - canvas.width()) / 2, 0);
    if (choice.marks) canvas.overlay().paintMarks(painter);
}

QImage viewRows(SolidCanvas& canvas, const PictureChoice& choice, int top, int rows) {
    QImage image = canvas.pictureRows(choice.size, top, rows, choice.transparent);
    if (!image.isNull() && (choice.marks || choice.legend)) paintMarks(image, top, canvas, choice);
    return image;
}

Image headerOf(const PictureChoice& choice) {
    Image image;
    image.width = choice.size.width();
    image.height = choice.size.height();
    image.channels = 4;
    image.alpha = image.unassociated = true;
    return image;
}

/// Throws bad_alloc for null rows.
void copyRows(QImage rows, Image& strip) {
    rows.convertTo(QImage::Format_RGBA8888);
    if (rows.width() != strip.width || rows.height() != strip.height) throw std::bad_alloc();
    for (int y = 0; y < strip.height; ++y) std::memcpy(strip.row(y), rows.constScanLine(y), strip.rowBytes());
}

/// Draws in the view's thread, which is not this one, and updates the progress.
QImage drawnByView(SolidCanvas& canvas, QProgressDialog& dialog, int progress,
                   const std::function<QImage()>& draw) {
    auto promise = std::make_shared<std::promise<QImage>>();
    auto answer = promise->get_future();
    QMetaObject::invokeMethod(&canvas, [&dialog, progress, draw, promise = std::move(promise)] {
        try {
            dialog.setValue(progress);
            promise->set_value(draw());
        } catch (...) {
            promise->set_exception(std::current_exception());
        }
    });
    return answer.get();  // throws if the view was destroyed
}

QString tooLittleMemory(const PictureChoice& choice) {
    return SolidCanvas::tr("there is not enough memory for a picture of %1 x %2 pixels")
        .arg(choice.size.width())
        .arg(choice.size.height());
}

/// Returns the exception of a job, if any. (Background work drops exceptions.)
std::exception_ptr failureOf(const std::function<void()>& job) {
    try {
        job();
        return {};
    } catch (...) {
        return std::current_exception();
    }
}

/// Runs a job in another thread while this one processes events; rethrows its exception.
void runBeside(const std::function<void()>& job) {
    QObject context;
    std::exception_ptr failure;
    bool done = false;
    inBackground(
        &context, [&job] { return failureOf(job); },
        [&](const std::exception_ptr& thrown) {
            failure = thrown;
            done = true;
        });
    while (!done) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    if (failure) std::rethrow_exception(failure);
}

/// Shows the progress of a cancellable job. It is modal from the start, so that the view cannot be changed
/// meanwhile.
class WritingProgress {
  public:
    WritingProgress(const QString& what, int steps, SolidCanvas& canvas)
        : m_dialog(what, SolidCanvas::tr("Cancel"), 0, steps, canvas.window()) {
        QObject::connect(&m_dialog, &QProgressDialog::canceled, [this] { m_stop.request_stop(); });
        QObject::connect(&canvas, &QObject::destroyed, &m_dialog, [this] { m_stop.request_stop(); });
        m_dialog.setWindowModality(Qt::WindowModal);
        m_dialog.setMinimumDuration(0);
        m_dialog.setAutoReset(false);
        m_dialog.setAutoClose(false);
        m_dialog.show();
    }
    QProgressDialog& dialog() { return m_dialog; }
    std::stop_token token() const { return m_stop.get_token(); }
    void throwIfStopped() const {
        if (m_stop.stop_requested()) throw Cancelled();
    }

  private:
    QProgressDialog m_dialog;
    std::stop_source m_stop;
};

void writeStrips(const std::string& path, SolidCanvas& canvas, const PictureChoice& choice) {
    WritingProgress progress(SolidCanvas::tr("Writing the picture …"), choice.size.height(), canvas);
    const MakeRows makeRows = [&](int top, Image& strip) {
        progress.throwIfStopped();
        const int rows = strip.height;
        copyRows(drawnByView(canvas, progress.dialog(), top,
                             [&, top, rows] { return viewRows(canvas, choice, top, rows); }),
                 strip);
    };
    runBeside([&] { writeImage(path, headerOf(choice), kStripRows, makeRows, choice.lossy); });
}

/// Restores the shown time.
class TimeKeeper {
  public:
    explicit TimeKeeper(Playback& playback) : m_playback(playback), m_time(playback.time()) {}
    ~TimeKeeper() { m_playback.setTime(m_time); }

  private:
    Playback& m_playback;
    double m_time;
};

/// Draws each frame in the window's thread, which processes events in between; encoding runs in the
/// background.
void writeFrames(const std::string& path, SolidCanvas& canvas, const PictureChoice& choice) {
    WritingProgress progress(SolidCanvas::tr("Writing the film …"), choice.frames, canvas);
    Playback& playback = canvas.session().playback();
    playback.setPlaying(false);
    const TimeKeeper keeper(playback);
    const FrameSpan span = choice.span.value_or(FrameSpan{0, playback.end()});
    const int intervals = choice.loop ? choice.frames : choice.frames - 1;
    const auto drawn = [&](int k) {
        return drawnByView(canvas, progress.dialog(), k, [&, k] {
            playback.setTime(span.from + (span.to - span.from) * k / intervals);
            return viewPicture(canvas, choice);
        });
    };
    runBeside([&] {
        PendingFile file(path);
        FilmOptions options{choice.framesPerSecond, choice.lossy, choice.frames, choice.sound,
                            progress.token()};
        Film film(path, file.temporary(), options);
        Image frame = headerOf(choice);
        for (int k = 0; k < choice.frames; ++k) {
            progress.throwIfStopped();
            frame.makePixels();
            copyRows(drawn(k), frame);
            file.fill([&](const std::string&) { film.add(frame); });
        }
        file.fill([&](const std::string&) { film.finish(); });
        progress.throwIfStopped();
        file.commit();
    });
}

/// Freezes the shown frame for its lifetime.
class Hold {
  public:
    explicit Hold(SolidCanvas& canvas) : m_canvas(&canvas) { canvas.setHeld(true); }
    ~Hold() {
        if (m_canvas) m_canvas->setHeld(false);
    }

  private:
    QPointer<SolidCanvas> m_canvas;
};

}  // namespace

QImage viewPicture(SolidCanvas& canvas, const PictureChoice& choice) {
    return viewRows(canvas, choice, 0, choice.size.height());
}

bool writeViewPicture(const QString& path, SolidCanvas& canvas, PictureChoice choice) {
    const QString kind = QFileInfo(path).suffix().toLower();
    const std::string name = path.toStdString();
    const FilmFormatFacts* film = choice.frames > 0 ? filmFormatOf(name) : nullptr;
    const bool isJpeg = kind == QStringLiteral("jpg") || kind == QStringLiteral("jpeg");
    if (isJpeg || (film && !film->alpha)) choice.transparent = false;
    if (const QString obstacle = canvas.obstacle(); !obstacle.isEmpty())
        throw InputError(name, obstacle.toStdString());
    try {
        if (choice.frames > 0) {
            writeFrames(name, canvas, choice);
        } else {
            const Hold hold(canvas);
            writeStrips(name, canvas, choice);
        }
        return true;
    } catch (const Cancelled&) {
        return false;
    } catch (const std::bad_alloc&) {
        throw InputError(name, tooLittleMemory(choice).toStdString());
    }
}

}  // namespace wend
