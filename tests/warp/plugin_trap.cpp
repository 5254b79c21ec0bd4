// Stands where OpenImageIO looks for plug-ins: whoever loads it gives itself away.
#include <cstdlib>

namespace {

const int sprung = setenv("WEND_TEST_PLUGIN", "loaded", 1);

}  // namespace
