# The config file that Debian 12 ships demands programs and OpenCV headers that Wend does not need.
# Defines OpenImageIO::OpenImageIO.
find_path(OpenImageIO_INCLUDE_DIR OpenImageIO/imageio.h)
find_library(OpenImageIO_LIBRARY OpenImageIO)
find_library(OpenImageIO_Util_LIBRARY OpenImageIO_Util)
if(OpenImageIO_INCLUDE_DIR)
    file(READ ${OpenImageIO_INCLUDE_DIR}/OpenImageIO/oiioversion.h _version)
    string(REGEX MATCH "OIIO_VERSION_MAJOR ([0-9]+)" _ "${_version}")
    set(OpenImageIO_VERSION ${CMAKE_MATCH_1})
    string(REGEX MATCH "OIIO_VERSION_MINOR ([0-9]+)" _ "${_version}")
    string(APPEND OpenImageIO_VERSION ".${CMAKE_MATCH_1}")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenImageIO REQUIRED_VARS OpenImageIO_LIBRARY OpenImageIO_Util_LIBRARY
    OpenImageIO_INCLUDE_DIR VERSION_VAR OpenImageIO_VERSION)
if(OpenImageIO_FOUND AND NOT TARGET OpenImageIO::OpenImageIO)
    add_library(OpenImageIO::OpenImageIO UNKNOWN IMPORTED)
    set_target_properties(OpenImageIO::OpenImageIO PROPERTIES IMPORTED_LOCATION ${OpenImageIO_LIBRARY}
        INTERFACE_INCLUDE_DIRECTORIES "${OpenImageIO_INCLUDE_DIR}"
        INTERFACE_LINK_LIBRARIES "${OpenImageIO_Util_LIBRARY};Imath::Imath")
endif()
