#pragma once

#include <QString>

#include "app/window/notices/busy_note.h"

namespace wend {

class FileWorkflow;
class ShapeCanvas;

/// Names the file that is being opened until its picture is visible; later work is shown by WorkNote.
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
