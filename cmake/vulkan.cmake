# The backend vulkan: compiles the shaders and embeds them. Vulkan itself is loaded when a program
# asks for it, so that the library also runs where there is none.
option(LACUNA_VULKAN "Build the backend vulkan, where Vulkan's headers and glslang are" ON)
include(${CMAKE_CURRENT_LIST_DIR}/leave_out.cmake)

# lacuna_embed_shader(TARGET FILE ENTRY) compiles the entry of a GLSL file and gives TARGET a header
# ENTRY.spv.h with the words ENTRY_spirv. A file may hold several entries, each behind its
# #ifdef ENTRY_...: GLSL allows one main.
function(lacuna_embed_shader target file entry)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_shaders)
    set(header ${folder}/${entry}.spv.h)
    set(compile $<TARGET_FILE:Vulkan::glslangValidator> -V --target-env vulkan1.2 --quiet
        -I${PROJECT_SOURCE_DIR}/kernels -DENTRY_${entry})
    set(validate)
    if(SPIRV_VAL)
        set(validate COMMAND ${SPIRV_VAL} --target-env vulkan1.2 ${folder}/${entry}.spv)
    endif()
    file(MAKE_DIRECTORY ${folder})
    add_custom_command(OUTPUT ${header}
        COMMAND ${compile} -o ${folder}/${entry}.spv ${file}
        ${validate}
        COMMAND ${compile} --depfile ${header}.d --vn ${entry}_spirv -o ${header} ${file}
        DEPENDS ${file} DEPFILE ${header}.d VERBATIM
        COMMENT "Compiling shader ${entry}")
    target_sources(${target} PRIVATE ${header})
    target_include_directories(${target} PRIVATE ${folder})
endfunction()

function(lacuna_add_vulkan)
    find_package(Vulkan COMPONENTS glslangValidator)
    find_path(VULKAN_RAII_INCLUDE_DIR vulkan/vulkan_raii.hpp HINTS ${Vulkan_INCLUDE_DIRS})
    if(NOT TARGET Vulkan::Headers OR NOT VULKAN_RAII_INCLUDE_DIR
        OR NOT TARGET Vulkan::glslangValidator)
        lacuna_leave_out(vulkan "Vulkan is missing: install its C++ headers and glslangValidator"
            "libvulkan-dev glslang-tools")
        return()
    endif()
    find_program(SPIRV_VAL spirv-val)
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/host/backends/vulkan/*.cpp)
    target_sources(lacuna PRIVATE ${sources})
    set(shaders ${PROJECT_SOURCE_DIR}/shaders)
    lacuna_embed_shader(lacuna ${shaders}/locate.comp locate)
    lacuna_embed_shader(lacuna ${shaders}/locate.comp locate_in_boxes)
    lacuna_embed_shader(lacuna ${shaders}/locate.comp sort_columns)
    lacuna_embed_shader(lacuna ${shaders}/admit.comp screen)
    lacuna_embed_shader(lacuna ${shaders}/admit.comp admit)
    lacuna_embed_shader(lacuna ${shaders}/subtract.comp gather)
    lacuna_embed_shader(lacuna ${shaders}/subtract.comp subtract)
    lacuna_embed_shader(lacuna ${shaders}/subtract.comp grow)
    lacuna_embed_shader(lacuna ${shaders}/refine.comp insert)
    lacuna_embed_shader(lacuna ${shaders}/refine.comp unfold)
    lacuna_embed_shader(lacuna ${shaders}/refine.comp cut)
    lacuna_embed_shader(lacuna ${shaders}/refine.comp keep)
    lacuna_embed_shader(lacuna ${shaders}/refine.comp scan)
    lacuna_embed_shader(lacuna ${shaders}/refine.comp find_place_begins)
    lacuna_embed_shader(lacuna ${shaders}/locate_cells.comp locate_in_cells)
    lacuna_embed_shader(lacuna ${shaders}/locate_cells.comp look_up_radii)
    lacuna_embed_shader(lacuna ${shaders}/admit_cells.comp admit_in_cells)
    lacuna_embed_shader(lacuna ${shaders}/subtract_cells.comp subtract_in_cells)
    lacuna_embed_shader(lacuna ${shaders}/own_relax.comp find_rivals)
    lacuna_embed_shader(lacuna ${shaders}/own_relax.comp own)
    lacuna_embed_shader(lacuna ${shaders}/own_relax.comp own_crowded)
    lacuna_embed_shader(lacuna ${shaders}/own_relax.comp gather_shares)
    lacuna_embed_shader(lacuna ${shaders}/settle_relax.comp settle)
    lacuna_embed_shader(lacuna ${shaders}/settle_relax.comp find_least)
    lacuna_embed_shader(lacuna ${shaders}/settle_relax.comp level_sites)
    target_include_directories(lacuna SYSTEM PRIVATE ${VULKAN_RAII_INCLUDE_DIR})
    target_compile_definitions(lacuna PRIVATE LACUNA_VULKAN)
    set(LACUNA_HAS_VULKAN ON PARENT_SCOPE)
endfunction()

if(LACUNA_VULKAN)
    lacuna_add_vulkan()
endif()
