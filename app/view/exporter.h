#pragma once

#include <QFuture>
#include <QObject>
#include <functional>
#include <memory>
#include <stop_token>

#include "app/session/shape_session.h"
#include "core/mesh/mesh_file.h"

class QWidget;

namespace wend {

/// Asks for a file name and writes what is shown, in the background, with progress and a way to cancel.
class Exporter : public QObject {
    Q_OBJECT

  public:
    Exporter(ShapeSession& session, QWidget& window);
    ~Exporter() override;

    /// What the slots write once they have a name: the shape that is shown, by extension. Tells with failed()
    /// or done(), later.
    void writeMesh(const QString& path, const MeshWriteOptions& options = {});
    /// `count` shapes or pictures from the start to the end: a sequence (#### in the name, added if it is
    /// missing), or one .glb.
    void writeFrames(QString path, int count);

  public slots:
    void exportPicture();
    void exportMesh();
    void exportFrames();
    void exportStMap();

  signals:
    void failed(QString text);
    void done(QString text);

  private:
    using Progress = std::function<void(double)>;
    /// Writes the file; throws InputError.
    using Job = std::function<void(const Progress&, std::stop_token)>;
    /// `chosen` gets the filter.
    QString askName(const QString& title, const QString& suffix, const QString& filters,
                    QString* chosen = nullptr);
    /// `remark`: what the job has to say about what it wrote.
    void run(const QString& what, const QString& path, Job job,
             const std::shared_ptr<const QString>& remark = {});
    FramePtr shownFrame();
    bool isFree();
    void writeFlat(const QString& path, const PosedPtr<2>& frame);
    void writeSolid(const QString& path, const PosedPtr<3>& frame, const MeshWriteOptions& options);

    ShapeSession& m_session;
    QWidget& m_window;
    std::shared_ptr<std::stop_source> m_stop;  // of what runs
    QFuture<QString> m_running;
};

}  // namespace wend
