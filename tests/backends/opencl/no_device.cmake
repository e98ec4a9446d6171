# Script: where OpenCL has no device, PROGRAM says so, with the reason, and exits with 4. Nothing
# falls back to another backend.
function(check setting expected)
    execute_process(
        COMMAND ${CMAKE_COMMAND} -E env ${setting} ${PROGRAM} sample --backend opencl --radius 0.2
        RESULT_VARIABLE code OUTPUT_VARIABLE points ERROR_VARIABLE errors)
    if(NOT code EQUAL 4 OR NOT points STREQUAL "")
        message(FATAL_ERROR "${setting}: exit code ${code}, points: ${points}")
    endif()
    if(NOT errors MATCHES "${expected}")
        message(FATAL_ERROR "${setting}: ${errors}")
    endif()
endfunction()

file(MAKE_DIRECTORY ${SCRATCH}/no_drivers)
check(OCL_ICD_VENDORS=${SCRATCH}/no_drivers "backend opencl: no device: no driver")

# PoCL silently drops its device when it cannot write its cache.
set(pocl /etc/OpenCL/vendors/pocl.icd)
if(EXISTS ${pocl})
    check("OCL_ICD_VENDORS=${pocl};POCL_CACHE_DIR=/proc/none" "lists no device.*set POCL_CACHE_DIR")
endif()
