# Unity builds compile several files of a library at once, because most of the time is spent on headers that neighbours share.
# Turn them off (WEND_UNITY) to edit single files or to find missing includes. Names in anonymous namespaces must differ within
# a library.
option(WEND_UNITY "Compile several files of a library at once" OFF)
set(WEND_UNITY_BATCH 40)      # files compiled at once, at most; with 10 the widget libraries take half as long again
set(WEND_UNITY_BATCH_HOT 20)  # for heavily optimized templates, which need much memory

# wend_share_compilations(target BATCH SOURCES…): enables unity builds, except for files that Highway includes once per SIMD target.
function(wend_share_compilations target batch)
    foreach(source ${ARGN})
        file(STRINGS ${source} targets REGEX "foreach_target\\.h" LIMIT_COUNT 1)
        if(targets)
            set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
        endif()
    endforeach()
    # Every file defines its own macro to instantiate its templates for both dimensions.
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch}
        UNITY_BUILD_CODE_AFTER_INCLUDE "#undef WEND_INSTANTIATE")
endfunction()

# wend_hide_symbols(target): hides the symbols of targets without Qt, because libwend and the Python module export only their own functions.
function(wend_hide_symbols target)
    if(NOT WEND_LIBRARY)
        return()
    endif()
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# Libraries with the time-critical loops are compiled with -O3, the others with -O2, which saves a tenth of their compilation
# time, and widgets with -O1, which saves a quarter. The results are the same to the last bit.
set(WEND_HOT cages outlines mesh energy factor assembly solver motion integration warp kernels mpi shape engine style
    shape_view picture_view volume_view)
set(WEND_USUAL_core $<$<CONFIG:Release>:-O2>)
set(WEND_USUAL_qt $<$<CONFIG:Release>:-O2>)
set(WEND_USUAL_widgets $<$<CONFIG:Release>:-O1>)

# wend_library(mesh SOURCES a.cpp … PUBLIC wend::x … PRIVATE y …): a static library wend_mesh with the alias wend::mesh.
function(wend_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
    add_library(wend_${name} STATIC)
    add_library(wend::${name} ALIAS wend_${name})
    target_sources(wend_${name} PRIVATE ${ARG_SOURCES})
    if(WEND_UNITY AND name IN_LIST WEND_HOT)
        wend_share_compilations(wend_${name} ${WEND_UNITY_BATCH_HOT} ${ARG_SOURCES})
    elseif(WEND_UNITY)
        wend_share_compilations(wend_${name} ${WEND_UNITY_BATCH} ${ARG_SOURCES})
    endif()
    target_link_libraries(wend_${name} PUBLIC wend_options ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
    wend_pch_kind(kind ${ARG_PUBLIC} ${ARG_PRIVATE})
    if(kind STREQUAL "core")
        wend_hide_symbols(wend_${name})
    endif()
    if(name IN_LIST WEND_HOT)
        wend_reuse_pch(wend_${name} hot_${kind})
    else()
        target_compile_options(wend_${name} PRIVATE ${WEND_USUAL_${kind}})
        wend_reuse_pch(wend_${name} ${kind})
    endif()
endfunction()
