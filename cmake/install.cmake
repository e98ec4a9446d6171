# Installs the library for find_package(lacuna), its headers, and the command.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/lacuna)
set_target_properties(lacuna PROPERTIES
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

install(TARGETS lacuna EXPORT lacuna-targets)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/host/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT lacuna-targets NAMESPACE lacuna:: DESTINATION ${package_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# Whoever links a static library links what it uses privately too, and so must find it first.
set(lacuna_packages)
get_target_property(library_type lacuna TYPE)
if(library_type STREQUAL "STATIC_LIBRARY")
    get_target_property(libraries lacuna LINK_LIBRARIES)
    foreach(library IN LISTS libraries)
        if(library MATCHES "^(Threads|TBB|OpenCL|Vulkan)::")
            list(APPEND lacuna_packages ${CMAKE_MATCH_1})
        elseif(NOT library MATCHES "^\\$<BUILD_INTERFACE:")
            message(FATAL_ERROR "cmake/install.cmake: the library links ${library}: name its package"
                " here, or wrap it in $<BUILD_INTERFACE:...> if it is needed for compiling only")
        endif()
    endforeach()
    list(REMOVE_DUPLICATES lacuna_packages)
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/lacuna-config.cmake.in
    ${PROJECT_BINARY_DIR}/lacuna-config.cmake INSTALL_DESTINATION ${package_dir})
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lacuna-config-version.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/lacuna-config.cmake
    ${PROJECT_BINARY_DIR}/lacuna-config-version.cmake DESTINATION ${package_dir})

if(LACUNA_COMMAND)
    # So that the command finds a shared library wherever the whole tree was installed to.
    file(RELATIVE_PATH bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
    set_target_properties(lacuna_command PROPERTIES INSTALL_RPATH "$ORIGIN/${bin_to_lib}")
    install(TARGETS lacuna_command)
endif()
