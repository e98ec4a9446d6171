# Given a build of Lacuna, when it is installed, then the example builds against it and runs.
#
# cmake -D BUILD=... -D SCRATCH=... -D EXAMPLE=... -D COMPILER=... [-D CXX_FLAGS=...]
#       [-D SHARED_SOURCE=...] -P installed_example.cmake
# With SHARED_SOURCE the library is first built there, shared, into BUILD.
cmake_minimum_required(VERSION 3.25)

# run(WHAT COMMAND...) runs a command; sets `output`; fails with what it printed.
function(run what)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
    if(NOT code EQUAL 0)
        message(FATAL_ERROR "${what} failed (${code}):\n${out}${err}")
    endif()
    set(output "${out}" PARENT_SCOPE)
endfunction()

set(toolchain -G Ninja -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER=${COMPILER})

if(SHARED_SOURCE)
    run("configuring the shared library" ${CMAKE_COMMAND} ${toolchain} -S ${SHARED_SOURCE} -B ${BUILD}
        -D BUILD_SHARED_LIBS=ON -D LACUNA_EXTRAS=ON -D LACUNA_COMMAND=OFF -D LACUNA_TESTS=OFF
        -D LACUNA_BENCHMARKS=OFF
        # Without optimisation and without the headers of devices, which take most of the time: only
        # building and finding are tested.
        -D CMAKE_BUILD_TYPE=None -D LACUNA_OPENCL=OFF -D LACUNA_VULKAN=OFF)
    run("building the shared library" ${CMAKE_COMMAND} --build ${BUILD})
endif()

# An empty prefix each time, so that an earlier installation cannot help.
set(prefix ${SCRATCH}/prefix)
file(REMOVE_RECURSE ${prefix} ${SCRATCH}/example)
run("installing" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
run("configuring the example" ${CMAKE_COMMAND} ${toolchain} -S ${EXAMPLE} -B ${SCRATCH}/example
    -D CMAKE_PREFIX_PATH=${prefix} "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}")
run("building the example" ${CMAKE_COMMAND} --build ${SCRATCH}/example)

if(SHARED_SOURCE)
    find_package(Python3 REQUIRED COMPONENTS Interpreter)
    file(GLOB_RECURSE shared ${prefix}/liblacuna.so)
    run("looking at what the shared library exports" ${Python3_EXECUTABLE}
        ${CMAKE_CURRENT_LIST_DIR}/exported.py ${shared} ${prefix}/include/lacuna)
    run("calling it from another language" ${Python3_EXECUTABLE}
        ${CMAKE_CURRENT_LIST_DIR}/by_ctypes.py ${shared} ${EXAMPLE}/../raccoon.png)
endif()

file(STRINGS ${SCRATCH}/example/CMakeCache.txt found REGEX "^lacuna_DIR:")
if(NOT found MATCHES "=${prefix}/")
    message(FATAL_ERROR "the example found another Lacuna: ${found}; expected one in ${prefix}")
endif()

# With this radius 278 points fit on average, with a standard deviation of 4.
run("running the example" ${SCRATCH}/example/first_points)
if(NOT output MATCHES "^2[5-9][0-9] points\n([0-9.e-]+ [0-9.e-]+)\n$")
    message(FATAL_ERROR "the example printed:\n${output}expected 250 to 299 points, and the first")
endif()
set(first "${CMAKE_MATCH_1}")

# pkg-config builds the same program.
find_program(PKG_CONFIG pkg-config REQUIRED)
file(GLOB_RECURSE pc ${prefix}/lacuna.pc)
cmake_path(GET pc PARENT_PATH pc_folder)
set(ENV{PKG_CONFIG_PATH} ${pc_folder})
run("asking pkg-config" ${PKG_CONFIG} --cflags --libs lacuna)
separate_arguments(flags UNIX_COMMAND "${output} -Wl,-rpath,${pc_folder}/.. ${CXX_FLAGS}")
run("building by pkg-config" ${COMPILER} -std=c++20 ${EXAMPLE}/main.cpp -o ${SCRATCH}/by_pkg_config ${flags})
run("running what pkg-config led to" ${SCRATCH}/by_pkg_config)
if(NOT output MATCHES "^2[5-9][0-9] points\n${first}\n$")
    message(FATAL_ERROR "built by pkg-config the example printed:\n${output}")
endif()

# Libraries of one's own that use Lacuna, and are installed too.
set(own ${CMAKE_CURRENT_LIST_DIR}/own)
file(REMOVE_RECURSE ${SCRATCH}/own ${SCRATCH}/program)
run("configuring libraries that use it" ${CMAKE_COMMAND} ${toolchain} -S ${own} -B ${SCRATCH}/own
    -D CMAKE_PREFIX_PATH=${prefix} "-DCMAKE_CXX_FLAGS=${CXX_FLAGS} -Wall -Wextra -Werror")
run("building them" ${CMAKE_COMMAND} --build ${SCRATCH}/own)
run("installing them" ${CMAKE_COMMAND} --install ${SCRATCH}/own --prefix ${prefix})
run("configuring a program that uses them" ${CMAKE_COMMAND} ${toolchain} -S ${own}
    -B ${SCRATCH}/program -D OWN_PROGRAM=ON -D CMAKE_PREFIX_PATH=${prefix}
    "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}")
run("building it" ${CMAKE_COMMAND} --build ${SCRATCH}/program)
run("running it" ${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${prefix}/lib:${pc_folder}/.. ${SCRATCH}/program/program)

# find_missing(COMPONENT REASON) fails unless find_package says REASON of a component that is missing.
function(find_missing component reason)
    file(WRITE ${SCRATCH}/missing/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(missing LANGUAGES C CXX)
find_package(lacuna REQUIRED COMPONENTS ${component})
")
    execute_process(COMMAND ${CMAKE_COMMAND} ${toolchain} -S ${SCRATCH}/missing
        -B ${SCRATCH}/missing/build -D CMAKE_PREFIX_PATH=${prefix}
        OUTPUT_QUIET ERROR_VARIABLE err RESULT_VARIABLE code)
    string(REGEX REPLACE "[ \n]+" " " err "${err}")
    if(code EQUAL 0 OR NOT err MATCHES "${reason}")
        message(FATAL_ERROR "COMPONENTS ${component} (${code}): expected '${reason}', got:\n${err}")
    endif()
endfunction()
find_missing(picture "component picture: the only one is extras")

# The example that uses everything beside the library alone, by CMake and pkg-config.
file(GLOB_RECURSE extras ${prefix}/lacuna-extras.pc)
if(NOT extras)
    find_missing(extras "component extras is not installed .*LACUNA_EXTRAS=ON")
endif()
if(extras)
    set(example ${EXAMPLE}/../stippled_picture)
    set(picture ${EXAMPLE}/../raccoon.png)
    file(REMOVE_RECURSE ${SCRATCH}/extras)
    run("configuring the example of the extras" ${CMAKE_COMMAND} ${toolchain} -S ${example}
        -B ${SCRATCH}/extras -D CMAKE_PREFIX_PATH=${prefix} "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}")
    run("building the example of the extras" ${CMAKE_COMMAND} --build ${SCRATCH}/extras)
    run("running the example of the extras" ${SCRATCH}/extras/stippled_picture ${picture}
        ${SCRATCH}/extras/dots.svg)
    file(READ ${SCRATCH}/extras/dots.svg dots)
    if(NOT dots MATCHES "inkscape:label=\"4 black\"")
        message(FATAL_ERROR "the example of the extras wrote no dots in inks")
    endif()
    execute_process(COMMAND ${SCRATCH}/extras/stippled_picture RESULT_VARIABLE code ERROR_VARIABLE err)
    if(NOT code EQUAL 1 OR NOT err STREQUAL "usage: stippled_picture PICTURE DOTS.svg\n")
        message(FATAL_ERROR "without arguments the example of the extras ended with ${code}:\n${err}")
    endif()
    run("asking pkg-config for the extras" ${PKG_CONFIG} --cflags --libs lacuna-extras)
    separate_arguments(flags UNIX_COMMAND "${output} -Wl,-rpath,${pc_folder}/.. ${CXX_FLAGS}")
    run("building the extras by pkg-config" ${COMPILER} -std=c++20 ${example}/main.cpp
        -o ${SCRATCH}/extras/by_pkg_config ${flags})
    run("running the extras by pkg-config" ${SCRATCH}/extras/by_pkg_config ${picture}
        ${SCRATCH}/extras/again.svg)
    file(READ ${SCRATCH}/extras/again.svg again)
    if(NOT again STREQUAL dots)
        message(FATAL_ERROR "built by pkg-config the example of the extras made other dots")
    endif()

    # A C program needs no more than these flags.
    find_program(C_COMPILER cc REQUIRED)
    run("building the C example by pkg-config" ${C_COMPILER} ${EXAMPLE}/../places/main.c
        -o ${SCRATCH}/extras/places ${flags})
    run("running the C example" ${SCRATCH}/extras/places)
    string(SHA256 hash "${output}")
    file(READ ${EXAMPLE}/../places/expected.sha256 expected)
    if(NOT expected MATCHES "^${hash} ")
        message(FATAL_ERROR "the C example built by pkg-config made other points")
    endif()
endif()

# The installed command, asked for the same, starts with the same point.
if(EXISTS ${prefix}/bin/lacuna)
    run("running the installed command" ${prefix}/bin/lacuna sample --radius 0.05 --torus -o -)
    if(NOT output MATCHES "^([^\n]+)\n" OR NOT CMAKE_MATCH_1 STREQUAL first)
        message(FATAL_ERROR "the command's first point is ${CMAKE_MATCH_1}, the example's ${first}")
    endif()
endif()
