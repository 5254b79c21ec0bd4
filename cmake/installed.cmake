# What `cmake --install` puts where. The program finds all of it from its own place (core/mesh/child_process.cpp,
# app/session/program_files.cpp): the folder can be moved, and the sources may go.
set(resources ${PROJECT_SOURCE_DIR}/resources)
install(TARGETS wend DESTINATION bin)
install(TARGETS wend-tetgen wend-cage wend-pictures DESTINATION lib/wend)
if(WEND_HAS_OPENCL)
    install(TARGETS wend-clprobe DESTINATION lib/wend)
endif()
install(DIRECTORY ${resources}/samples/ DESTINATION share/wend/samples
    FILES_MATCHING PATTERN art EXCLUDE PATTERN "*.wend" PATTERN "*.png" PATTERN "*.obj" PATTERN "*.mtl")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION share/wend/manual
    FILES_MATCHING PATTERN "*.md" PATTERN "pictures/*.png" PATTERN "pictures/*.svg")
install(FILES ${resources}/icons/wend.svg DESTINATION share/icons/hicolor/scalable/apps)
install(FILES ${resources}/wend.desktop DESTINATION share/applications)
install(FILES ${resources}/wend-mime.xml DESTINATION share/mime/packages RENAME wend.xml)
install(FILES ${resources}/wend.metainfo.xml DESTINATION share/metainfo)
install(FILES LICENSE README.md CHANGELOG.md CITATION.cff DESTINATION share/doc/wend)

# cpack: a Debian package of that.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME wend)
set(CPACK_PACKAGE_CONTACT "The authors of Wend")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Warps pictures and bends solid shapes by letting them flow")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libopenblas0-pthread, libqt6svg6")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "pocl-opencl-icd, qt6-translations-l10n")
include(CPack)
