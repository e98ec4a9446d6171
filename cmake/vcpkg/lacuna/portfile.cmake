# The port of this checkout: vcpkg install lacuna[extras] --overlay-ports=cmake/vcpkg
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
vcpkg_check_features(OUT_FEATURE_OPTIONS features FEATURES extras LACUNA_EXTRAS)
if("extras" IN_LIST FEATURES)
    vcpkg_find_acquire_program(PKGCONFIG)
    list(APPEND features "-DPKG_CONFIG_EXECUTABLE=${PKGCONFIG}")
endif()
# Without the command and the backends of devices, which need programs that compile shaders.
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS ${features}
    -DLACUNA_COMMAND=OFF -DLACUNA_TESTS=OFF -DLACUNA_BENCHMARKS=OFF
    -DLACUNA_OPENCL=OFF -DLACUNA_VULKAN=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/lacuna)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
