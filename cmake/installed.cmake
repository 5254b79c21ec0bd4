# Install rules. The program finds its files relative to its own path (core/base/child_process.cpp,
# app/base/program_files.cpp), so the installed folder can be moved and needs no sources. The components are the packages
# of cmake/packages.cmake; programs that libwend and the Python module start, too, belong to libwend.
include(GNUInstallDirs)
set(resources ${PROJECT_SOURCE_DIR}/resources)
set(helpers_component program)
if(WEND_LIBRARY)
    set(helpers_component lib)
endif()
install(TARGETS wend DESTINATION bin COMPONENT program)
install(TARGETS wend-bench DESTINATION lib/wend COMPONENT program)
install(TARGETS wend-tetgen wend-cage wend-picture wend-pictures wend-svg DESTINATION lib/wend COMPONENT ${helpers_component})
if(WEND_HAS_HDF5)
    install(TARGETS wend-hdf5 DESTINATION lib/wend COMPONENT ${helpers_component})
endif()
if(WEND_HAS_MULTIGRID)
    install(TARGETS wend-mpi DESTINATION bin COMPONENT program)
endif()
if(WEND_HAS_OPENCL)
    install(TARGETS wend-clprobe DESTINATION lib/wend COMPONENT ${helpers_component})
endif()
# libwend, its headers, and the files for find_package(wend).
if(WEND_LIBRARY)
    include(CMakePackageConfigHelpers)
    set(wend_cmake ${CMAKE_INSTALL_LIBDIR}/cmake/wend)
    install(TARGETS libwend libwend_warp EXPORT wend_targets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT lib NAMELINK_COMPONENT dev)
    install(EXPORT wend_targets NAMESPACE wend:: FILE wend-targets.cmake DESTINATION ${wend_cmake} COMPONENT dev)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/api/wend DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev
        FILES_MATCHING PATTERN "*.h")
    file(WRITE ${CMAKE_BINARY_DIR}/wend-config.cmake "include(\${CMAKE_CURRENT_LIST_DIR}/wend-targets.cmake)\n")
    write_basic_package_version_file(${CMAKE_BINARY_DIR}/wend-config-version.cmake VERSION ${PROJECT_VERSION} COMPATIBILITY SameMinorVersion)
    install(FILES ${CMAKE_BINARY_DIR}/wend-config.cmake ${CMAKE_BINARY_DIR}/wend-config-version.cmake DESTINATION ${wend_cmake} COMPONENT dev)
endif()
if(WEND_HAS_PYTHON)  # below /usr, Debian's Python searches this folder
    install(TARGETS wend_python DESTINATION lib/python3/dist-packages COMPONENT python)
    install(FILES ${PROJECT_SOURCE_DIR}/python/wend.pyi DESTINATION lib/python3/dist-packages COMPONENT python)
endif()

# Manual pages and completion, from the program's own tables.
set(words ${CMAKE_BINARY_DIR}/words)
file(MAKE_DIRECTORY ${words}/man)
add_custom_command(OUTPUT ${words}/wend.bash ${words}/_wend ${words}/wend.fish
    COMMAND wend reference --man ${words}/man
    COMMAND sh -c "gzip -9nf ${words}/man/*.1"
    COMMAND wend reference --completion bash > ${words}/wend.bash
    COMMAND wend reference --completion zsh > ${words}/_wend
    COMMAND wend reference --completion fish > ${words}/wend.fish
    DEPENDS wend VERBATIM)
add_custom_target(words ALL DEPENDS ${words}/wend.bash)
install(DIRECTORY ${words}/man/ DESTINATION share/man/man1 COMPONENT program FILES_MATCHING PATTERN "*.1.gz")
install(FILES ${words}/wend.bash DESTINATION share/bash-completion/completions RENAME wend COMPONENT program)
install(FILES ${words}/_wend DESTINATION share/zsh/vendor-completions COMPONENT program)
install(FILES ${words}/wend.fish DESTINATION share/fish/vendor_completions.d COMPONENT program)

install(DIRECTORY ${resources}/samples/ DESTINATION share/wend/samples COMPONENT program
    FILES_MATCHING PATTERN art EXCLUDE PATTERN "*.wend" PATTERN "*.png" PATTERN "*.ora" PATTERN "*.obj" PATTERN "*.mtl")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION share/wend/manual COMPONENT program
    FILES_MATCHING PATTERN "*.md" PATTERN "pictures/*.png" PATTERN "pictures/*.svg" PATTERN "pictures/*.webp")
install(FILES ${resources}/icons/wend.svg DESTINATION share/icons/hicolor/scalable/apps COMPONENT program)
install(FILES ${resources}/wend.desktop DESTINATION share/applications COMPONENT program)
install(FILES ${resources}/wend-mime.xml DESTINATION share/mime/packages RENAME wend.xml COMPONENT program)
install(FILES ${resources}/wend.metainfo.xml DESTINATION share/metainfo COMPONENT program)
install(FILES ${resources}/wend.thumbnailer DESTINATION share/thumbnailers COMPONENT program)
install(FILES LICENSE README.md CHANGELOG.md CITATION.cff DESTINATION share/doc/wend COMPONENT program)

# Plug-ins, in the folders below /usr that their programs search; ParaView gets the path of its own.
set(plugins ${PROJECT_SOURCE_DIR}/plugins)
install(FILES ${plugins}/inkscape/wend_bend.inx ${plugins}/inkscape/wend_bend.py ${plugins}/inkscape/wend_curves.py
    DESTINATION share/inkscape/extensions COMPONENT program)
install(DIRECTORY ${plugins}/krita/ DESTINATION share/krita/pykrita COMPONENT program PATTERN "__pycache__" EXCLUDE)
install(FILES ${plugins}/blender/wend_bend.py DESTINATION share/blender/scripts/addons COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/plugins/wend_project.xml DESTINATION share/wend/paraview COMPONENT program)
if(WEND_HAS_GIMP)
    install(TARGETS wend-bend DESTINATION lib/gimp/2.0/plug-ins/wend-bend COMPONENT gimp)
endif()

include(packages)
