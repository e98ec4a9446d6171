# Script: PROGRAM starts without OpenCL's and Vulkan's loaders. Where they cannot be opened,
# `devices` says so for each, their backends exit with 4 and that reason, and the cpu backend works.
find_program(READELF readelf REQUIRED)
execute_process(COMMAND ${READELF} -d ${PROGRAM} OUTPUT_VARIABLE needed COMMAND_ERROR_IS_FATAL ANY)
if(NOT needed MATCHES "NEEDED.*libc\\.so" OR needed MATCHES "lib(OpenCL|vulkan)")
    message(FATAL_ERROR "a loader is among what the program needs to start:\n${needed}")
endif()

# Empty files with the loaders' names: the system finds them first, and cannot open them.
set(hidden ${SCRATCH}/no_loaders)
foreach(library IN ITEMS libOpenCL.so.1 libvulkan.so libvulkan.so.1)
    file(WRITE ${hidden}/${library} "")
endforeach()
set(ENV{LD_LIBRARY_PATH} ${hidden})

# check(CODE EXPECTED ARGUMENT...) runs the program, which exits with CODE and prints EXPECTED.
function(check expected_code expected)
    execute_process(COMMAND ${PROGRAM} ${ARGN}
        RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
    if(NOT code EQUAL expected_code OR NOT "${out}${err}" MATCHES "${expected}")
        message(FATAL_ERROR "${ARGN} (${code}), expected ${expected_code} and ${expected}:\n${out}${err}")
    endif()
endfunction()

check(0 "OpenCL loader cannot be opened: [^\n]*libOpenCL.so.1" devices)
check(4 "backend opencl: [^\n]*loader cannot be opened" sample --backend opencl --radius 0.2)
if(HAS_VULKAN)
    check(0 "Vulkan loader libvulkan.so.1 is not installed" devices)
    check(4 "backend vulkan: [^\n]*loader libvulkan.so.1" sample --backend vulkan --radius 0.2)
endif()
check(0 "^[0-9. \n]+$" sample --radius 0.2 --quiet)
