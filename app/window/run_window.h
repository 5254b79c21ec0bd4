#pragma once

namespace wend {

/// Opens the window, with the file that the first argument names, if any; returns the program's exit code.
int runWindow(int argc, char** argv);

}  // namespace wend
