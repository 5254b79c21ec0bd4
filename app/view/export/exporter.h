#pragma once

#include <QImage>
#include <QObject>
#include <functional>
#include <memory>
#include <stop_token>

#include "app/document/hand_over.h"
#include "app/document/in_background.h"
#include "app/session/run/crop.h"
#include "app/session/shape/material_picture.h"
#include "app/session/shape_session.h"
#include "app/view/export/export_form.h"

class QWidget;

namespace wend {

/// Asks how and where, and writes what is shown, in the background, with progress and a way to cancel.
class Exporter : public QObject {
    Q_OBJECT

  public:
    Exporter(ShapeSession& session, QWidget& window);
    ~Exporter() override;

    /// What the screen has of the shape, for previews: a picture of the solid, and the picture of a shape in
    /// the plane, null while there is none.
    struct Looks {
        std::function<QImage(const QSize&)> solid;
        std::function<std::shared_ptr<const ScreenPicture>()> picture;
    };
    void setLooks(Looks looks) { m_looks = std::move(looks); }

    /// What is kept of a picture; of another document all of it again.
    Crop& crop() { return m_crop; }
    /// Why nothing can be written now; empty if it can be.
    QString whyNot() const;
    /// What is shown, to be asked about; only where whyNot() is empty.
    ExportSubject subject(ExportKind kind) const;
    /// Asks for the name and writes. False if it was not to be.
    bool writeAs(const ExportForm& form);
    /// What the slots write once all is chosen, by extension. Of a sequence the name has ####, which is added
    /// if it is missing, or it is one film (see isAnimation()). Tells with failed() or done(), later.
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
    /// What the preview of a solid shows is another view of it.
    void viewTurned();
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
    QString askName(const ExportForm& form);
    void run(const QString& what, const QString& path, Job job);
    void tell(const Result& result, const QString& path);
    std::shared_ptr<const FrameExport> shownShape() const;
    FramePtr shownFrame();
    bool isFree();

    ShapeSession& m_session;
    QWidget& m_window;
    Looks m_looks;
    Crop m_crop;
    std::shared_ptr<std::stop_source> m_stop;  // of what runs
    HandOver m_out;
    BackgroundWork m_running;
};

}  // namespace wend
