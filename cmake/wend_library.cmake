# wend_library(mesh SOURCES a.cpp … PUBLIC wend::x … PRIVATE y …): a static library wend_mesh with the alias wend::mesh.
function(wend_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
    add_library(wend_${name} STATIC)
    add_library(wend::${name} ALIAS wend_${name})
    target_sources(wend_${name} PRIVATE ${ARG_SOURCES})
    target_link_libraries(wend_${name} PUBLIC wend_options ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
    wend_use_pch(wend_${name} ${ARG_PUBLIC} ${ARG_PRIVATE})
endfunction()
