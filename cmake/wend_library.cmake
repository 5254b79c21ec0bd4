# Unity builds: a compiler gets several files of a library at once, since most of the time that one takes goes into the headers that
# it shares with its neighbours. Off where single files are edited, and where missing includes are to be found. Names in anonymous
# namespaces differ within a library.
option(WEND_UNITY "Compile several files of a library at once" OFF)
set(WEND_UNITY_BATCH 40)      # files that are compiled at once, at most: with 10 the rooms of widgets take half as long again
set(WEND_UNITY_BATCH_HOT 20)  # where templates are optimized most, for which a compiler needs much memory

# wend_share_compilations(target BATCH SOURCES…): all but those that Highway includes once for every SIMD target.
function(wend_share_compilations target batch)
    foreach(source ${ARGN})
        file(STRINGS ${source} targets REGEX "foreach_target\\.h" LIMIT_COUNT 1)
        if(targets)
            set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
        endif()
    endforeach()
    # The macro that instantiates a file's templates for both dimensions is the file's own.
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch}
        UNITY_BUILD_CODE_AFTER_INCLUDE "#undef WEND_INSTANTIATE")
endfunction()

# wend_hide_symbols(target): what knows no Qt may become part of libwend and of the Python module, which show their own functions only.
function(wend_hide_symbols target)
    if(NOT WEND_LIBRARY)
        return()
    endif()
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# The rooms of the program whose loops take its time are optimized as far as the compiler can. The others, which wait for these, for files or
# for a hand, are optimized as is usual, which takes a tenth less of the time to compile them; those of widgets less, which takes a quarter
# less. The results are the same, to the last bit.
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
