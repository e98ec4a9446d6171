#!/usr/bin/env bash
# Builds the package: the command, and the shared library with the extras.
set -euo pipefail
beside=$SRC_DIR/beside
# Clipper, static, which becomes a part of the library. Its file for CMake is too old for CMake 4.
cmake -S "$beside/polyclipping/cpp" -B "$beside/build" -G Ninja -D CMAKE_BUILD_TYPE=Release \
    -D CMAKE_POLICY_VERSION_MINIMUM=3.5 -D BUILD_SHARED_LIBS=OFF \
    -D CMAKE_POSITION_INDEPENDENT_CODE=ON -D CMAKE_INSTALL_PREFIX="$beside/prefix"
cmake --build "$beside/build" --target install
export PKG_CONFIG_PATH=$beside/prefix/share/pkgconfig:$PREFIX/lib/pkgconfig:$PREFIX/share/pkgconfig
# Without the backends of devices, which need programs that compile shaders.
# shellcheck disable=SC2086  # conda's options, one after the other
cmake -S "$SRC_DIR" -B "$SRC_DIR/build-conda" -G Ninja ${CMAKE_ARGS:-} \
    -D CMAKE_INSTALL_PREFIX="$PREFIX" -D CMAKE_INSTALL_LIBDIR=lib -D BUILD_SHARED_LIBS=ON \
    -D RANDOM123_INCLUDE_DIR="$beside/random123/include" -D LACUNA_TESTS=OFF \
    -D LACUNA_BENCHMARKS=OFF -D LACUNA_OPENCL=OFF -D LACUNA_VULKAN=OFF -D LACUNA_MPI=OFF
cmake --build "$SRC_DIR/build-conda" --target install
