// Made only so that the headers are compiled; see precompiled.cmake.
