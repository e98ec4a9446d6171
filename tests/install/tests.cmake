# Registers the tests of what is installed: the example against the static and the shared library.
function(lacuna_install_test name)
    add_test(NAME install.${name} COMMAND ${CMAKE_COMMAND}
        -D SCRATCH=${PROJECT_BINARY_DIR}/install-test/${name}
        -D EXAMPLE=${PROJECT_SOURCE_DIR}/examples/first_points
        -D COMPILER=${CMAKE_CXX_COMPILER} ${ARGN}
        -P ${PROJECT_SOURCE_DIR}/tests/install/installed_example.cmake)
    set_tests_properties(install.${name} PROPERTIES TIMEOUT 600)
endfunction()

set(example_flags)
if(LACUNA_SANITIZE)
    set(example_flags "-fsanitize=${LACUNA_SANITIZE}")
endif()
lacuna_install_test(as_built -D BUILD=${PROJECT_BINARY_DIR} -D CXX_FLAGS=${example_flags})
lacuna_install_test(shared -D BUILD=${PROJECT_BINARY_DIR}/install-test/shared/library
    -D SHARED_SOURCE=${PROJECT_SOURCE_DIR})
