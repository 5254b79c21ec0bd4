#pragma once

#include <QObject>

class QWidget;

namespace wend {

class Document;

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
    int m_ticket = 0;  // of the newest choice
};

}  // namespace wend
