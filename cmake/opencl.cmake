# The backend opencl: finds OpenCL, and embeds the kernels into the library.
option(LACUNA_OPENCL "Build the backend opencl, where OpenCL is installed" ON)
include(${CMAKE_CURRENT_LIST_DIR}/leave_out.cmake)

# lacuna_embed_kernels(TARGET NAME FILE...) expands the includes of the OpenCL C files, joins them,
# and gives TARGET a source file that defines lacuna::opencl::NAME() with the text.
function(lacuna_embed_kernels target name)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/kernels/*.h)
    set(script ${PROJECT_SOURCE_DIR}/cmake/embed_kernels.cmake)
    add_custom_command(OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -D NAME=${name} -D "FILES=${ARGN}" -D OUTPUT=${output}
            -D INCLUDE_DIR=${PROJECT_SOURCE_DIR}/kernels -P ${script}
        DEPENDS ${ARGN} ${headers} ${script} VERBATIM
        COMMENT "Embedding OpenCL kernels: ${name}")
    target_sources(${target} PRIVATE ${output})
endfunction()

function(lacuna_add_opencl)
    find_package(OpenCL)
    find_path(OPENCL_HPP_INCLUDE_DIR CL/opencl.hpp HINTS ${OpenCL_INCLUDE_DIRS})
    if(NOT OpenCL_FOUND OR NOT OPENCL_HPP_INCLUDE_DIR)
        lacuna_leave_out(opencl "OpenCL is missing: install its loader and its C and C++ headers"
            "ocl-icd-opencl-dev opencl-clhpp-headers")
        return()
    endif()
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/host/backends/opencl/*.cpp)
    file(GLOB kernels CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/kernels/*.cl)
    target_sources(lacuna PRIVATE ${sources})
    # Mode cells has kernels of its own, and shares sort_columns; relax shares none: each compiles
    # what it needs.
    set(cells_kernels ${kernels})
    list(FILTER cells_kernels INCLUDE REGEX "/(locate|[a-z]+_cells)\\.cl$")
    set(relax_kernels ${kernels})
    list(FILTER relax_kernels INCLUDE REGEX "_relax\\.cl$")
    list(FILTER kernels EXCLUDE REGEX "_(cells|relax)\\.cl$")
    lacuna_embed_kernels(lacuna kernel_source ${kernels})
    lacuna_embed_kernels(lacuna cells_kernel_source ${cells_kernels})
    lacuna_embed_kernels(lacuna relax_kernel_source ${relax_kernels})
    target_include_directories(lacuna SYSTEM PRIVATE ${OPENCL_HPP_INCLUDE_DIR})
    target_compile_definitions(lacuna PRIVATE LACUNA_OPENCL)
    target_link_libraries(lacuna PRIVATE OpenCL::OpenCL)
endfunction()

if(LACUNA_OPENCL)
    lacuna_add_opencl()
endif()
