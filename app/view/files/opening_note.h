#pragma once

#include <QString>

#include "app/view/notices/busy_note.h"

namespace wend {

class FileWorkflow;
class ShapeCanvas;

/// Says which file is being opened, until its picture can be seen; what is computed then is told by the work
/// note.
class OpeningNote : public BusyNote {
    Q_OBJECT

  public:
    OpeningNote(FileWorkflow& files, ShapeCanvas& canvas, QWidget& over);

  private:
    void refresh();

    ShapeCanvas& m_canvas;
    bool m_reads = false;
    QString m_name;
};

}  // namespace wend
