#pragma once

#include <QObject>

#include "app/base/latest.h"
#include "app/project/edits/document.h"

class QWidget;

namespace wend {

/// Asks for a detailed surface that is to be embedded in the solid, and looks at it before the project gets
/// it.
class DetailChooser : public QObject {
    Q_OBJECT

  public:
    DetailChooser(Document& document, QWidget& window);
    void ask();
    void remove();

  signals:
    void failed(QString text);
    /// The project has it from now on.
    void chosen();

  private:
    void read(const QString& path);

    Document& m_document;
    QWidget& m_window;
    Latest m_reading{this};
};

/// Asks for another project and gives the document that project's motion, in one undo step.
class MotionChooser : public QObject {
    Q_OBJECT

  public:
    MotionChooser(Document& document, QWidget& window);

    void ask();
    /// Does so in the background, because both shapes are built. A document that changes meanwhile keeps its
    /// own motion.
    void apply(const QString& path);

  signals:
    void failed(QString text);
    /// Emitted when the motion is there, with what did not fit, one line each.
    void applied(QString remarks);

  private:
    Document& m_document;
    QWidget& m_window;
    Latest m_applying{this};
};

}  // namespace wend
