#pragma once

#include <QByteArray>

#include "app/document/edits/document.h"
#include "app/tools/mode.h"

namespace wend {

/// What a window leaves to the one that takes its place, in another language.
struct WindowState {
    OpenedFile file;  // without a project: nothing is open
    QByteArray geometry;
    Mode mode = Mode::Pins;
    std::vector<int> selected;  // handles
    double time = 0;            // that is shown
};

}  // namespace wend
