# Packages that Lacuna cannot be built without: the error names the Debian package to install.
include_guard()

# lacuna_need(PACKAGE DEBIAN [find_package's ARGUMENT...])
macro(lacuna_need package debian)
    find_package(${package} ${ARGN} QUIET)
    if(NOT ${package}_FOUND)
        message(FATAL_ERROR "Lacuna: ${package} is missing (Debian: ${debian})")
    endif()
endmacro()

# lacuna_need_module(MODULE DEBIAN) finds what only pkg-config knows: the target PkgConfig::MODULE.
macro(lacuna_need_module module debian)
    pkg_check_modules(${module} QUIET IMPORTED_TARGET ${module})
    if(NOT ${module}_FOUND)
        message(FATAL_ERROR "Lacuna: ${module} is missing (Debian: ${debian})")
    endif()
endmacro()

# lacuna_need_header(VARIABLE HEADER DEBIAN) sets VARIABLE to the folder that has HEADER.
function(lacuna_need_header variable header debian)
    find_path(${variable} ${header})
    if(NOT ${variable})
        message(FATAL_ERROR "Lacuna: the header ${header} is missing (Debian: ${debian})")
    endif()
endfunction()
