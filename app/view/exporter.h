#pragma once

#include <QFuture>
#include <QObject>
#include <functional>
#include <memory>
#include <stop_token>

#include "app/session/shape_session.h"

class QWidget;

namespace wend {

/// Asks for a file name and writes what is shown, in the background, with progress and a way to cancel.
class Exporter : public QObject {
    Q_OBJECT

  public:
    Exporter(ShapeSession& session, QWidget& window);
    ~Exporter() override;

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
    QString askName(const QString& title, const QString& suffix, const QString& filters);
    void run(const QString& what, const QString& path, Job job);
    FramePtr shownFrame();
    bool isFree();
    void exportSolid(const PosedPtr<3>& frame);

    ShapeSession& m_session;
    QWidget& m_window;
    std::shared_ptr<std::stop_source> m_stop;  // of what runs
    QFuture<QString> m_running;
};

}  // namespace wend
