# Installs the library for find_package(lacuna), its headers, and the command.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/lacuna)
set_target_properties(${lacuna_public} PROPERTIES
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

# A shared library is for programs that were built with it; all else is for those who build them.
install(TARGETS ${lacuna_public} EXPORT lacuna-targets
    LIBRARY COMPONENT command NAMELINK_COMPONENT development
    ARCHIVE COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/host/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    COMPONENT development)
install(EXPORT lacuna-targets NAMESPACE lacuna:: DESTINATION ${package_dir} COMPONENT development)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/lacuna
    RENAME copyright COMPONENT command)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/liblacuna-dev
    RENAME copyright COMPONENT development)

# Whoever links a static library links its private packages too, so they must be found first.
set(lacuna_packages)
get_target_property(library_type ${lacuna_public} TYPE)
if(library_type STREQUAL "STATIC_LIBRARY")
    get_target_property(libraries lacuna LINK_LIBRARIES)
    foreach(library IN LISTS libraries)
        if(library MATCHES "^(Threads|TBB)::")
            list(APPEND lacuna_packages ${CMAKE_MATCH_1})
        elseif(NOT library MATCHES "^\\$<BUILD_INTERFACE:")
            message(FATAL_ERROR "cmake/install.cmake: the library links ${library}: name its package"
                " here, or wrap it in $<BUILD_INTERFACE:...> if it is needed for compiling only")
        endif()
    endforeach()
    list(REMOVE_DUPLICATES lacuna_packages)
endif()

# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lacuna-config-version.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/lacuna-config.cmake
    ${PROJECT_BINARY_DIR}/lacuna-config-version.cmake DESTINATION ${package_dir}
    COMPONENT development)

# pkg-config knows these packages by other names.
set(lacuna_pc_requires ${lacuna_packages})
list(TRANSFORM lacuna_pc_requires REPLACE "^TBB$" tbb)
set(lacuna_pc_libs)
if(Threads IN_LIST lacuna_packages)
    list(REMOVE_ITEM lacuna_pc_requires Threads)
    set(lacuna_pc_libs -pthread)
endif()
list(JOIN lacuna_pc_requires " " lacuna_pc_requires)
string(REGEX REPLACE "^.+$" "Requires: \\0" lacuna_pc_requires "${lacuna_pc_requires}")
file(RELATIVE_PATH lib_to_include ${CMAKE_INSTALL_FULL_LIBDIR} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
configure_file(${CMAKE_CURRENT_LIST_DIR}/lacuna.pc.in ${PROJECT_BINARY_DIR}/lacuna.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/lacuna.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT development)

# The targets of lacuna::extras have a file of their own: a program that uses the library alone
# needs none of these packages.
if(LACUNA_EXTRAS)
    if(library_type STREQUAL "STATIC_LIBRARY")
        set(lacuna_extras_installed ${lacuna_extras_libraries})
        set(lacuna_extras_packages fmt OpenSSL ZLIB PNG JPEG TIFF pugixml TBB)
        set(lacuna_extras_modules cairo polyclipping libwebp)
        set(lacuna_extras_pc_requires fmt tbb cairo zlib libcrypto libpng libjpeg libtiff-4 libwebp polyclipping pugixml)
        list(JOIN lacuna_extras_pc_requires " " lacuna_extras_pc_requires)
        list(TRANSFORM lacuna_extras_libraries PREPEND -l OUTPUT_VARIABLE lacuna_extras_pc_libs)
        list(APPEND lacuna_extras_pc_libs -lstdc++ -lm)  # which a C compiler does not link by itself
        list(JOIN lacuna_extras_pc_libs " " lacuna_extras_pc_libs)
    endif()
    install(TARGETS lacuna_extras ${lacuna_extras_installed} EXPORT lacuna-extras-targets
        ARCHIVE COMPONENT development)
    install(EXPORT lacuna-extras-targets NAMESPACE lacuna:: DESTINATION ${package_dir}
        COMPONENT development)
    configure_file(${CMAKE_CURRENT_LIST_DIR}/lacuna-extras.pc.in ${PROJECT_BINARY_DIR}/lacuna-extras.pc
        @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/lacuna-extras.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT development)
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/lacuna-config.cmake.in
    ${PROJECT_BINARY_DIR}/lacuna-config.cmake INSTALL_DESTINATION ${package_dir})

if(LACUNA_COMMAND)
    include(${CMAKE_CURRENT_LIST_DIR}/man.cmake)
    install(TARGETS lacuna_command COMPONENT command)
    if(LACUNA_HAS_MPI)
        install(TARGETS lacuna_mpi COMPONENT mpi)
        if(mpi_man_page)
            install(FILES ${mpi_man_page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT mpi)
        endif()
        install(FILES ${PROJECT_SOURCE_DIR}/LICENSE
            DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/lacuna-mpi RENAME copyright COMPONENT mpi)
    endif()
    if(man_pages)
        install(FILES ${man_pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT command)
    endif()
    include(${CMAKE_CURRENT_LIST_DIR}/completions.cmake)
endif()
