#pragma once

#include "app/bench/recorder.h"

namespace wend {

/// Rows of the window itself, with its real events, threads and painters: from a move of the mouse to the
/// painted frame that shows it. In the plane a picture that fills the view, in space the bar (makeBody),
/// meshed to about so many vertices; each is dragged for so many seconds. A remark in their place where there
/// is no OpenGL for solids.
template <int Dim>
void addWindowRows(const std::string& name, int vertices, BenchRecorder& recorder, double seconds = 3);

}  // namespace wend
