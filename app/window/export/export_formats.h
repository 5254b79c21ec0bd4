#pragma once

#include <QList>
#include <QString>

#include "app/output/frame_export.h"

namespace wend {

struct ExportFormat {
    QString name, extension;  // with its dot
    bool film = false;        // all frames in one file
};

/// Says that the program that makes films of this extension is missing, and what to do; empty if it is there
/// or none is needed.
QString missingFilmProgram(const QString& extension);

/// Returns the formats for a shape, the most suitable first.
QList<ExportFormat> exportFormats(ExportKind kind, const FrameExport& shape);

}  // namespace wend
