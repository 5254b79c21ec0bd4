# wend_embed_kernels(target file.cl …): makes kernel_sources.cpp with every file as a string, so that the kernels stay pure .cl files.
function(wend_embed_kernels target)
    set(entries "")
    foreach(file ${ARGN})
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
        file(READ ${file} text)
        string(APPEND entries "    if (name == \"${file}\") return R\"CL(${text})CL\";\n")
    endforeach()
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/kernel_sources.cpp @ONLY CONTENT
"#include \"kernels/kernel_sources.h\"

namespace wend {

std::string_view kernelSource(std::string_view name) {
@entries@    return {};
}

}  // namespace wend
")
    target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/kernel_sources.cpp)
endfunction()
