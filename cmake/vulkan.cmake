# The backend vulkan: compiles the shaders and embeds them. Vulkan itself is loaded at its first
# use, so that the library also runs where it is not installed.
option(LACUNA_VULKAN "Build the backend vulkan, where Vulkan's headers and glslang are" ON)
include(${CMAKE_CURRENT_LIST_DIR}/leave_out.cmake)

# lacuna_embed_shader(TARGET FILE ENTRY) compiles a GLSL file and gives TARGET a header ENTRY.spv.h
# with the words ENTRY_spirv.
function(lacuna_embed_shader target file entry)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_shaders)
    set(header ${folder}/${entry}.spv.h)
    set(compile $<TARGET_FILE:Vulkan::glslangValidator> -V --target-env vulkan1.2 --quiet
        -I${PROJECT_SOURCE_DIR}/kernels)
    set(validate)
    if(SPIRV_VAL)
        set(validate COMMAND ${compile} -o ${folder}/${entry}.spv ${file}
            COMMAND ${SPIRV_VAL} --target-env vulkan1.2 ${folder}/${entry}.spv)
    endif()
    file(MAKE_DIRECTORY ${folder})
    add_custom_command(OUTPUT ${header}
        ${validate}
        COMMAND ${compile} --depfile ${header}.d --vn ${entry}_spirv -o ${header} ${file}
        DEPENDS ${file} DEPFILE ${header}.d VERBATIM
        COMMENT "Compiling shader ${entry}")
    target_sources(${target} PRIVATE ${header})
    target_include_directories(${target} PRIVATE ${folder})
endfunction()

# lacuna_embed_kernels_as_shaders(TARGET FILE...) writes for each kernel NAME.cl, which is GLSL as well,
# a compute shader NAME.comp, and embeds it in this way. TARGET is given a header all_shaders.h that
# includes the headers of all.
function(lacuna_embed_kernels_as_shaders target)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_shaders)
    set(headers)
    foreach(file IN LISTS ARGN)
        cmake_path(GET file STEM name)
        configure_file(${PROJECT_SOURCE_DIR}/shaders/kernel.comp.in ${folder}/${name}.comp @ONLY)
        lacuna_embed_shader(${target} ${folder}/${name}.comp ${name})
        string(APPEND headers "#include \"${name}.spv.h\"\n")
    endforeach()
    file(CONFIGURE OUTPUT ${folder}/all_shaders.h CONTENT "${headers}")
endfunction()

function(lacuna_add_vulkan)
    find_package(Vulkan COMPONENTS glslangValidator)
    find_path(VULKAN_RAII_INCLUDE_DIR vulkan/vulkan_raii.hpp HINTS ${Vulkan_INCLUDE_DIRS})
    if(NOT TARGET Vulkan::Headers OR NOT VULKAN_RAII_INCLUDE_DIR
        OR NOT TARGET Vulkan::glslangValidator)
        lacuna_leave_out("the backend vulkan" vulkan "Vulkan is missing: install its C++ headers and glslangValidator"
            "libvulkan-dev glslang-tools")
        return()
    endif()
    find_program(SPIRV_VAL spirv-val)
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/host/backends/vulkan/*.cpp)
    target_sources(lacuna PRIVATE ${sources})
    file(GLOB kernels CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/kernels/*.cl)
    lacuna_embed_kernels_as_shaders(lacuna ${kernels})
    target_include_directories(lacuna SYSTEM PRIVATE ${VULKAN_RAII_INCLUDE_DIR})
    target_compile_definitions(lacuna PRIVATE LACUNA_VULKAN)
    set(LACUNA_HAS_VULKAN ON PARENT_SCOPE)
endfunction()

if(LACUNA_VULKAN)
    lacuna_add_vulkan()
endif()
