# One interface target that carries what every target of the project shares.
# -Wno-restrict: g++ 12 warns of std::string's own operator+ at -O3 (GCC bug 105651).
add_library(wend_options INTERFACE)
target_include_directories(wend_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(wend_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
    -Woverloaded-virtual -Wno-unknown-pragmas -Wno-restrict $<$<BOOL:${WEND_WERROR}>:-Werror>)
if(WEND_SANITIZE)
    target_compile_options(wend_options INTERFACE -fsanitize=${WEND_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(wend_options INTERFACE -fsanitize=${WEND_SANITIZE})
endif()
