#pragma once

#include <QImage>
#include <QMenu>
#include <functional>
#include <map>
#include <memory>
#include <stop_token>

#include "app/base/hand_over.h"
#include "app/base/in_background.h"
#include "app/engine/shape/material_picture.h"
#include "app/session/crop.h"
#include "app/window/actions/action_maker.h"
#include "app/window/export/export_form.h"

class QWidget;

namespace wend {

class Document;
class Playback;
class ShapeMotion;

/// Asks for options and file, and exports what is shown in the background, with progress and cancellation.
class Exporter : public QObject {
    Q_OBJECT

  public:
    Exporter(const Playback& playback, const ShapeMotion& motion, QWidget& window);
    ~Exporter() override;

    /// Pictures for previews: of the solid, and of the picture's screen version; null if there is none.
    struct Looks {
        std::function<QImage(const QSize&)> solid;
        std::function<std::shared_ptr<const ScreenPicture>()> picture;
    };
    void setLooks(Looks looks) { m_looks = std::move(looks); }

    /// Returns the crop of the picture, which is reset for another document.
    Crop& crop() { return m_crop; }
    /// Returns the choices of the last exports, which panel and dialogs share.
    ExportChoices& choices() { return m_choices; }
    /// Returns why nothing can be written now; empty if it can be.
    QString whyNot() const;
    /// Returns the current subject; requires whyNot() to be empty.
    ExportSubject subject(ExportKind kind) const;
    /// Asks for the name and writes. False if it was not to be.
    bool writeAs(const ExportForm& form);
    /// Writes what the slots have asked for, by extension. A sequence needs #### in its name, which is added
    /// if it is missing, or is a film (see isAnimation()). Reports with failed() or done() later.
    void write(ExportKind kind, QString path, const RunOptions& options = {});
    /// Asks before one of the document's files or existing frames are replaced.
    bool mayReplace(ExportKind kind, const QString& path, int count);
    void writeMaterial(MaterialPart part, const QString& path);

  public slots:
    void exportPicture() { ask(ExportKind::Picture); }
    void exportMesh() { ask(ExportKind::Mesh); }
    void exportFilm() { ask(ExportKind::Film); }
    void exportFrames() { ask(ExportKind::Frames); }
    void exportStMap() { ask(ExportKind::StMap); }
    /// Exports the material at rest as a grey picture.
    void exportMaterial(MaterialPart part);

  signals:
    /// Emitted when the preview of a solid shows another view.
    void viewTurned();
    void failed(QString text);
    /// Emitted when another export starts, so that an earlier failure no longer matters.
    void begun();
    void done(QString text);

  private:
    /// Throws InputError.
    using Job = std::function<void(const RunWatch&, std::string& remark)>;
    struct Result {
        QString error, remark;
        bool stopped = false;
        QStringList notices = {};
    };
    void ask(ExportKind kind);
    QString askName(const ExportForm& form);
    void run(const QString& what, const QString& path, double deforming, Job job);
    void tell(const Result& result, const QString& path);
    std::shared_ptr<const FrameExport> shownShape() const;
    FramePtr shownFrame();
    bool isFree();

    const Playback& m_playback;
    const ShapeMotion& m_motion;
    const Document& m_document;
    QWidget& m_window;
    Looks m_looks;
    Crop m_crop;
    ExportChoices m_choices;
    std::shared_ptr<std::stop_source> m_stop;  // of the running export
    HandOver m_out;
    BackgroundWork m_running;
};

/// The material as pictures of a paint program, brought in as a layer and written out; of a solid, values of
/// its cells from a mesh file.
class MaterialActions : public ActionMaker {
    Q_OBJECT

  public:
    MaterialActions(Document& document, const ShapeMotion& motion, Exporter& exporter, QObject* parent);

    std::map<MaterialPart, QAction*> bringIn, write;
    QAction* cells;

    QMenu* menu() const { return m_menu.get(); }

    /// Adds a picture of a part of the material as the topmost layer.
    void take(MaterialPart part, const QString& path);
    void takeCells(const QString& path);

  signals:
    void failed(QString text);

  private:
    void refresh();
    void ask(MaterialPart part);
    void askCells();

    Document& m_document;
    const ShapeMotion& m_motion;
    std::unique_ptr<QMenu> m_menu;
};

}  // namespace wend
