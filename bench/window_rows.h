#pragma once

#include <string>
#include <vector>

#include "bench/recorder.h"

namespace wend {

struct ShownSize {
    std::string name;
    int vertices = 0;
};

/// Rows of the window itself, with its real events, threads and painters: from a move of the mouse to the
/// painted frame that shows it. In the plane a picture that fills the view, in space the bar (makeBody),
/// meshed to about so many vertices; each is dragged for so many seconds. A remark in their place where there
/// is no OpenGL for solids. All sizes in one connection to the display: some end with the last one.
template <int Dim>
void addWindowRows(const std::vector<ShownSize>& sizes, BenchRecorder& recorder, double seconds = 3);

/// Does the same for a picture of twelve parts with eight megapixels in all, and about so many vertices.
void addPartRows(int vertices, BenchRecorder& recorder, double seconds = 3);

}  // namespace wend
