# The backend opencl: finds OpenCL's headers, and embeds the kernels into the library. OpenCL itself
# is loaded at its first use, so that the library also runs where it is not installed.
option(LACUNA_OPENCL "Build the backend opencl, where OpenCL's headers are" ON)
include(${CMAKE_CURRENT_LIST_DIR}/leave_out.cmake)

# lacuna_embed_kernels(TARGET NAME GROUP...) expands the includes of OpenCL C files. It gives TARGET
# a source file with lacuna::opencl::NAME(), which returns one text for each group A.cl|B.cl.
function(lacuna_embed_kernels target name)
    string(REPLACE "|" ";" files "${ARGN}")
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/kernels/*.h)
    list(TRANSFORM files REPLACE "[^/]+$" "*.h" OUTPUT_VARIABLE beside)
    list(REMOVE_DUPLICATES beside)
    file(GLOB beside CONFIGURE_DEPENDS ${beside})
    set(script ${PROJECT_SOURCE_DIR}/cmake/embed_kernels.cmake)
    add_custom_command(OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -D NAME=${name} -D "GROUPS=${ARGN}" -D OUTPUT=${output}
            -D INCLUDE_DIR=${PROJECT_SOURCE_DIR}/kernels -P ${script}
        DEPENDS ${files} ${headers} ${beside} ${script} VERBATIM
        COMMENT "Embedding OpenCL kernels: ${name}")
    target_sources(${target} PRIVATE ${output})
    # Each of these files has constants of the same names.
    set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# lacuna_check_kernels(TARGET FILE...) lets clang, where it is installed, look for mistakes in OpenCL C
# files before TARGET is built. Drivers would find them only when a program runs.
function(lacuna_check_kernels target)
    find_program(LACUNA_CLANG clang)
    if(NOT LACUNA_CLANG)
        return()
    endif()
    set(checked)
    foreach(file IN LISTS ARGN)
        cmake_path(GET file FILENAME name)
        set(stamp ${CMAKE_CURRENT_BINARY_DIR}/checked_kernels/${name}.checked)
        add_custom_command(OUTPUT ${stamp}
            COMMAND ${LACUNA_CLANG} -x cl -cl-std=CL1.2 -Xclang -finclude-default-header
                -Xclang -fdeclare-opencl-builtins -fsyntax-only -Wall -Wno-unused -Werror
                -I${PROJECT_SOURCE_DIR}/kernels -MD -MT ${stamp} -MF ${stamp}.d ${file}
            COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
            DEPENDS ${file} DEPFILE ${stamp}.d VERBATIM COMMENT "Checking kernel ${name}")
        list(APPEND checked ${stamp})
    endforeach()
    file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/checked_kernels)
    add_custom_target(${target}_checked_kernels DEPENDS ${checked})
    add_dependencies(${target} ${target}_checked_kernels)
endfunction()

function(lacuna_add_opencl)
    find_path(OPENCL_INCLUDE_DIR CL/opencl.h)
    find_path(OPENCL_HPP_INCLUDE_DIR CL/opencl.hpp HINTS ${OPENCL_INCLUDE_DIR})
    if(NOT OPENCL_INCLUDE_DIR OR NOT OPENCL_HPP_INCLUDE_DIR)
        lacuna_leave_out("the backend opencl" opencl "OpenCL is missing: install its C and C++ headers"
            "opencl-headers opencl-clhpp-headers")
        return()
    endif()
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/host/backends/opencl/*.cpp)
    target_sources(lacuna PRIVATE ${sources})
    # This file uses OpenCL's own names, which are macros in the other files of the folder.
    set_source_files_properties(${PROJECT_SOURCE_DIR}/host/backends/opencl/entry_points.cpp
        PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    # The kernels of a group are compiled together: for lines and exact, exact with a radius field,
    # cells, surfaces and volumes, relax, and its descent. A driver would take longer to compile each kernel as a program of its own.
    set(spans open_lines locate locate_in_boxes screen admit insert collect subtract sum_tiles grow unfold cut
        keep scan count_samples list_samples find_bin_begins)
    set(radius_field locate_with_field screen_with_field reach admit_with_field enlist split
        cut_with_field keep_with_field scan measure count_samples list_samples)
    set(cells locate_in_cells sort_columns look_up_radii screen_in_cells admit_in_cells
        subtract_in_cells scan count_samples list_samples)
    set(space locate_in_space screen_in_space admit_in_space insert_in_space split_in_space
        keep_in_space scan count_samples list_samples_in_space)
    set(relax find_hints find_rivals assign tell_owners assign_crowded limit move level_sites)
    set(descent find_cells scan sort_into_cells descend)
    set(groups)
    foreach(group IN ITEMS spans cells radius_field space relax descent)
        list(TRANSFORM ${group} REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/kernels/\\1.cl")
        list(JOIN ${group} "|" files)
        list(APPEND groups ${files})
    endforeach()
    lacuna_embed_kernels(lacuna kernel_sources ${groups})
    file(GLOB kernels CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/kernels/*.cl)
    lacuna_check_kernels(lacuna ${kernels})
    target_include_directories(lacuna SYSTEM PRIVATE
        ${OPENCL_INCLUDE_DIR} ${OPENCL_HPP_INCLUDE_DIR})
    target_compile_definitions(lacuna PRIVATE LACUNA_OPENCL)
    set(LACUNA_HAS_OPENCL ON PARENT_SCOPE)
endfunction()

if(LACUNA_OPENCL)
    lacuna_add_opencl()
endif()
