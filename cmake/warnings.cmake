# An interface target with the options that all targets of the project share.
# At -O3 g++ 12's flow analyses raise false alarms inside std::string (GCC bug 105651) and Eigen's packets: those are off.
add_library(wend_options INTERFACE)
target_include_directories(wend_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(wend_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
    -Woverloaded-virtual -Wno-unknown-pragmas)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(wend_options INTERFACE -Wno-restrict
        -Wno-stringop-overread -Wno-stringop-overflow -Wno-array-bounds -Wno-maybe-uninitialized)
endif()
if(WEND_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # In unity builds every file counts as a header, and GCC warns about members from anonymous namespaces there.
    target_compile_options(wend_options INTERFACE -Wno-subobject-linkage)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Less frequent garbage collection saves the compiler a tenth of its time, for at most this many more kilobytes.
    target_compile_options(wend_options INTERFACE --param=ggc-min-heapsize=400000)
endif()
target_compile_options(wend_options INTERFACE $<$<BOOL:${WEND_WERROR}>:-Werror>)
if(WEND_SANITIZE)
    # Targets marked UNSANITIZED limit their memory, and sanitizers need more address space than that.
    set(plain $<BOOL:$<TARGET_PROPERTY:UNSANITIZED>>)
    target_compile_options(wend_options INTERFACE
        $<$<NOT:${plain}>:-fsanitize=${WEND_SANITIZE}> $<$<NOT:${plain}>:-fno-omit-frame-pointer>)
    target_link_options(wend_options INTERFACE $<$<NOT:${plain}>:-fsanitize=${WEND_SANITIZE}>)
    # Tests that limit the memory of a process are not compiled then, because a skipped test counts as failed.
    target_compile_definitions(wend_options INTERFACE $<$<NOT:${plain}>:WEND_SANITIZED>)
endif()
