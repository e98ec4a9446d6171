# Registers the tests of the opencl backend alone.
if(NOT LACUNA_HAS_OPENCL)
    return()
endif()
lacuna_test(backends/opencl)
lacuna_embed_kernels(device_test arithmetic_sources
    ${CMAKE_CURRENT_LIST_DIR}/../device/arithmetic.cl)
file(GLOB kernels CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/kernels/*.cl)
lacuna_embed_kernels(device_test kernel_files ${kernels})
foreach(test IN ITEMS opencl_test device_test)
    target_include_directories(${test} SYSTEM PRIVATE ${OPENCL_HPP_INCLUDE_DIR})
endforeach()

function(lacuna_opencl_script name)
    add_test(NAME backends.opencl.${name} COMMAND ${CMAKE_COMMAND}
        -D PROGRAM=$<TARGET_FILE:lacuna_command> -D TESTS=$<TARGET_FILE:opencl_test>
        -D SCRATCH=${PROJECT_BINARY_DIR}/opencl-test -D HAS_VULKAN=${LACUNA_HAS_VULKAN}
        -P ${PROJECT_SOURCE_DIR}/tests/backends/opencl/${name}.cmake)
    set_tests_properties(backends.opencl.${name} PROPERTIES
        TIMEOUT 1200 SKIP_REGULAR_EXPRESSION "SKIPPED: ")
endfunction()

if(LACUNA_COMMAND)
    lacuna_opencl_script(oclgrind)
    lacuna_opencl_script(no_device)
    lacuna_opencl_script(no_loader)
endif()
