#include "wend/version.h"

namespace wend {

const char* version() {
    return WEND_VERSION;
}

}  // namespace wend
