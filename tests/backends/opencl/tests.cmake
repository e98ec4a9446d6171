# Registers the tests of the opencl backend alone.
if(NOT TARGET OpenCL::OpenCL OR NOT LACUNA_OPENCL)
    return()
endif()
lacuna_test(backends/opencl OpenCL::OpenCL)
target_include_directories(opencl_test SYSTEM PRIVATE ${OPENCL_HPP_INCLUDE_DIR})
lacuna_embed_kernels(opencl_test portable_test_source ${CMAKE_CURRENT_LIST_DIR}/portable.cl)

function(lacuna_opencl_script name)
    add_test(NAME opencl.${name} COMMAND ${CMAKE_COMMAND}
        -D PROGRAM=$<TARGET_FILE:lacuna_command> -D TESTS=$<TARGET_FILE:opencl_test>
        -D SCRATCH=${PROJECT_BINARY_DIR}/opencl-test
        -P ${PROJECT_SOURCE_DIR}/tests/backends/opencl/${name}.cmake)
    set_tests_properties(opencl.${name} PROPERTIES
        TIMEOUT 300 SKIP_REGULAR_EXPRESSION "SKIPPED: ")
endfunction()

if(LACUNA_COMMAND)
    lacuna_opencl_script(oclgrind)
    lacuna_opencl_script(no_device)
endif()
