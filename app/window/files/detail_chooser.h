#pragma once

#include <QObject>

#include "app/project/edits/document.h"

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
    int m_ticket = 0;  // of the file that is being read
};

}  // namespace wend
