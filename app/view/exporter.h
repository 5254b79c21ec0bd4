#pragma once

#include <QImage>
#include <QObject>
#include <functional>
#include <memory>
#include <stop_token>

#include "app/document/hand_over.h"
#include "app/document/in_background.h"
#include "app/session/frame_export.h"
#include "app/session/material_picture.h"
#include "app/session/shape_session.h"

class QWidget;

namespace wend {

/// Asks how and where, and writes what is shown, in the background, with progress and a way to cancel.
class Exporter : public QObject {
    Q_OBJECT

  public:
    Exporter(ShapeSession& session, QWidget& window);
    ~Exporter() override;

    /// A picture of the solid that is shown, for previews.
    void setSolidView(std::function<QImage(const QSize&)> view) { m_solidView = std::move(view); }

    /// What the slots write once all is chosen, by extension. Of a sequence the name has ####, which is added
    /// if it is missing, or it is one .glb. Tells with failed() or done(), later.
    void write(ExportKind kind, QString path, const RunOptions& options = {});
    /// Whether this may be written there: asks if it would replace one of the document's own files, or frames
    /// that are there.
    bool mayReplace(ExportKind kind, const QString& path, int count);
    void writeMaterial(MaterialPart part, const QString& path);

  public slots:
    void exportPicture() { ask(ExportKind::Picture); }
    void exportMesh() { ask(ExportKind::Mesh); }
    void exportFrames() { ask(ExportKind::Frames); }
    void exportStMap() { ask(ExportKind::StMap); }
    /// The material at rest as a gray picture.
    void exportMaterial(MaterialPart part);

  signals:
    void failed(QString text);
    /// Something else is to be done, or has been: what failed before no longer counts.
    void begun();
    void done(QString text);

  private:
    /// Throws InputError.
    using Job = std::function<void(const RunWatch&, std::string& remark)>;
    struct Result {
        QString error, remark;
        bool stopped = false;
    };
    void ask(ExportKind kind);
    QString askName(ExportKind kind, const QString& extension, const QString& filter);
    void run(const QString& what, const QString& path, Job job);
    void tell(const Result& result, const QString& path);
    std::shared_ptr<const FrameExport> shownShape();
    FramePtr shownFrame();
    bool isFree();

    ShapeSession& m_session;
    QWidget& m_window;
    std::function<QImage(const QSize&)> m_solidView;
    std::shared_ptr<std::stop_source> m_stop;  // of what runs
    HandOver m_out;
    BackgroundWork m_running;
};

}  // namespace wend
