# Given a project that has Lacuna as a part, when it is configured, then it gets the library alone;
# and given that a package is missing, then the message names the Debian package that has it.
#
# cmake -D SCRATCH=... -D SOURCE=... -D COMPILER=... -P configuring.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${SCRATCH})
set(toolchain -G Ninja -D CMAKE_CXX_COMPILER=${COMPILER})

file(WRITE ${SCRATCH}/whole/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(whole LANGUAGES C CXX)
add_subdirectory(${SOURCE} lacuna)
file(WRITE \${CMAKE_BINARY_DIR}/main.cpp \"int main() {}\")
add_executable(whole \${CMAKE_BINARY_DIR}/main.cpp)
target_link_libraries(whole PRIVATE lacuna::lacuna)
foreach(name IN ITEMS lacuna lacuna_command lacuna_files portable_test sample_bench)
    if(TARGET \${name})
        message(STATUS \"target \${name}\")
    endif()
endforeach()
")
execute_process(COMMAND ${CMAKE_COMMAND} ${toolchain} -S ${SCRATCH}/whole -B ${SCRATCH}/whole/build
    OUTPUT_VARIABLE out ERROR_VARIABLE err RESULT_VARIABLE code)
string(REGEX MATCHALL "-- target [a-z_]+" targets "${out}")
if(NOT code EQUAL 0 OR NOT targets STREQUAL "-- target lacuna")
    message(FATAL_ERROR "as a part (${code}): got ${targets}, expected the target lacuna alone\n${out}${err}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --install ${SCRATCH}/whole/build --prefix ${SCRATCH}/prefix
    OUTPUT_QUIET)
if(EXISTS ${SCRATCH}/prefix)
    message(FATAL_ERROR "as a part Lacuna installs what the whole did not ask for")
endif()

# With the parts that read pictures and write files, if the project asks for them.
execute_process(COMMAND ${CMAKE_COMMAND} ${toolchain} -D LACUNA_EXTRAS=ON -S ${SCRATCH}/whole
    -B ${SCRATCH}/whole/extras OUTPUT_VARIABLE out ERROR_VARIABLE err RESULT_VARIABLE code)
string(REGEX MATCHALL "-- target [a-z_]+" targets "${out}")
if(NOT code EQUAL 0 OR NOT targets STREQUAL "-- target lacuna;-- target lacuna_files")
    message(FATAL_ERROR "with LACUNA_EXTRAS (${code}): got ${targets}\n${out}${err}")
endif()

# A static library of the project's own is exported: it needs Lacuna's target, so Lacuna's too is.
file(WRITE ${SCRATCH}/exported/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(exported LANGUAGES C CXX)
set(LACUNA_INSTALL ON)
add_subdirectory(${SOURCE} lacuna)
file(WRITE \${CMAKE_BINARY_DIR}/own.cpp \"int own() { return 0; }\")
add_library(own STATIC \${CMAKE_BINARY_DIR}/own.cpp)
target_link_libraries(own PUBLIC lacuna::lacuna)
install(TARGETS own EXPORT own-targets)
install(EXPORT own-targets DESTINATION lib/cmake/own)
")
execute_process(COMMAND ${CMAKE_COMMAND} ${toolchain} -S ${SCRATCH}/exported
    -B ${SCRATCH}/exported/build OUTPUT_VARIABLE out ERROR_VARIABLE err RESULT_VARIABLE code)
if(NOT code EQUAL 0)
    message(FATAL_ERROR "with a static library that is exported (${code}):\n${out}${err}")
endif()

# expect(MISSING DEBIAN OPTION...)
function(expect missing debian)
    execute_process(COMMAND ${CMAKE_COMMAND} ${toolchain} -S ${SOURCE} -B ${SCRATCH}/${missing} ${ARGN}
        OUTPUT_QUIET ERROR_VARIABLE err RESULT_VARIABLE code)
    string(REGEX REPLACE "[ \n]+" " " err "${err}")
    if(code EQUAL 0 OR NOT err MATCHES "${missing} is missing \\(Debian: ${debian}\\)")
        message(FATAL_ERROR "without ${missing} (${code}): expected the name ${debian}, got: ${err}")
    endif()
endfunction()
expect(fmt libfmt-dev -D CMAKE_DISABLE_FIND_PACKAGE_fmt=ON)
expect(TBB libtbb-dev -D CMAKE_DISABLE_FIND_PACKAGE_TBB=ON)
expect(GTest libgtest-dev -D CMAKE_DISABLE_FIND_PACKAGE_GTest=ON -D LACUNA_COMMAND=OFF)
