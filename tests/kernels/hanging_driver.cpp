// An OpenCL driver that never returns from loading: it sleeps, or with WEND_TEST_DRIVER=loop computes.
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace {

int hang() {
    const char* way = std::getenv("WEND_TEST_DRIVER");
    const bool loops = way && std::string_view(way) == "loop";
    volatile bool computing = loops;
    while (true)
        if (!computing) pause();
}

const int never = hang();

}  // namespace
