#include "app/window/files/opening_note.h"

#include "app/views/canvas/canvas.h"
#include "app/window/files/file_workflow.h"

namespace wend {

/// The file is opened in the same turn of the event loop, so the note stays visible in between.
OpeningNote::OpeningNote(FileWorkflow& files, ShapeCanvas& canvas, QWidget& over)
    : BusyNote(over), m_canvas(canvas) {
    connect(&files, &FileWorkflow::openingChanged, this, [this](const QString& name) {
        m_reads = !name.isEmpty();
        if (m_reads) m_name = name;
    });
    connect(&files, &FileWorkflow::openingChanged, this, &OpeningNote::refresh, Qt::QueuedConnection);
    connect(&m_canvas, &ShapeCanvas::prepared, this, &OpeningNote::refresh);
}

void OpeningNote::refresh() {
    showText(m_reads || m_canvas.isPreparing() ? tr("Opening %1 …").arg(m_name) : QString());
}

}  // namespace wend
