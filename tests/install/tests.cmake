# Registers the tests of the installation: the example with the static and the shared library.
function(lacuna_install_test name)
    add_test(NAME install.${name} COMMAND ${CMAKE_COMMAND}
        -D SCRATCH=${PROJECT_BINARY_DIR}/install-test/${name}
        -D EXAMPLE=${PROJECT_SOURCE_DIR}/examples/first_points
        -D COMPILER=${CMAKE_CXX_COMPILER} ${ARGN}
        -P ${PROJECT_SOURCE_DIR}/tests/install/installed_example.cmake)
    # The shared library is built for it: some 85 s of processor, beside all other tests.
    set_tests_properties(install.${name} PROPERTIES TIMEOUT 1200)
endfunction()

set(example_flags)
if(LACUNA_SANITIZE)
    set(example_flags "-fsanitize=${LACUNA_SANITIZE}")
endif()
lacuna_install_test(as_built -D BUILD=${PROJECT_BINARY_DIR} -D CXX_FLAGS=${example_flags})
# Every compiler that is here must find an initialiser for each member of the public structs.
find_program(LACUNA_CLANG NAMES clang++ clang++-15 clang++-14)
set(compilers ${CMAKE_CXX_COMPILER})
if(LACUNA_CLANG)
    list(APPEND compilers ${LACUNA_CLANG})
endif()
add_test(NAME install.initialisers COMMAND ${Python3_EXECUTABLE}
    ${PROJECT_SOURCE_DIR}/tests/install/initialisers.py ${PROJECT_SOURCE_DIR}/host/include
    ${PROJECT_BINARY_DIR}/install-test/initialisers ${compilers})
# The library calls nothing that prints, ends the process or reads the clock.
if(NOT BUILD_SHARED_LIBS)
    add_test(NAME install.quiet COMMAND ${Python3_EXECUTABLE}
        ${PROJECT_SOURCE_DIR}/tests/install/quiet.py $<TARGET_FILE:lacuna>)
endif()
# Lacuna as a part of another project, and with a missing package.
add_test(NAME install.configuring COMMAND ${CMAKE_COMMAND}
    -D SCRATCH=${PROJECT_BINARY_DIR}/install-test/configuring -D SOURCE=${PROJECT_SOURCE_DIR}
    -D COMPILER=${CMAKE_CXX_COMPILER} -P ${PROJECT_SOURCE_DIR}/tests/install/configuring.cmake)
add_test(NAME install.vcpkg_port COMMAND ${CMAKE_COMMAND}
    -D SCRATCH=${PROJECT_BINARY_DIR}/install-test/vcpkg_port -D SOURCE=${PROJECT_SOURCE_DIR}
    -D COMPILER=${CMAKE_CXX_COMPILER} -D VERSION=${PROJECT_VERSION}
    -P ${PROJECT_SOURCE_DIR}/tests/install/vcpkg_port.cmake)
if(LACUNA_COMMAND)
    add_test(NAME install.conda_recipe COMMAND ${Python3_EXECUTABLE}
        ${PROJECT_SOURCE_DIR}/tests/install/conda_recipe.py ${PROJECT_SOURCE_DIR}
        ${PROJECT_BINARY_DIR}/install-test/conda_recipe ${PROJECT_VERSION} ${CMAKE_CXX_COMPILER}
        $<TARGET_FILE:lacuna_command>)
    set_tests_properties(install.conda_recipe PROPERTIES SKIP_REGULAR_EXPRESSION "SKIPPED: ")
endif()
if(LACUNA_COMMAND AND HELP2MAN)
    add_test(NAME install.man_pages COMMAND ${CMAKE_COMMAND}
        -D PROGRAM=$<TARGET_FILE:lacuna_command> -D MAN=${PROJECT_BINARY_DIR}/man
        -P ${PROJECT_SOURCE_DIR}/tests/install/man_pages.cmake)
endif()
lacuna_install_test(shared -D BUILD=${PROJECT_BINARY_DIR}/install-test/shared/library
    -D SHARED_SOURCE=${PROJECT_SOURCE_DIR})
