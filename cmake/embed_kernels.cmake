# Script: writes a C++ file OUTPUT with a function lacuna::opencl::NAME() that returns one text
# for each of GROUPS, OpenCL C files with | between them. Quoted includes are expanded, each file
# once, from its folder or INCLUDE_DIR. With #line, build logs name the original file and line.
cmake_minimum_required(VERSION 3.25)
cmake_path(GET INCLUDE_DIR PARENT_PATH root)

function(expand path result)
    file(READ ${path} rest)
    cmake_path(RELATIVE_PATH path BASE_DIRECTORY ${root} OUTPUT_VARIABLE shown)
    set(text "#line 1 \"${shown}\"\n")
    set(line 1)
    while(rest MATCHES "(^|\n)#include \"([^\"\n]+)\"[^\n]*\n")
        set(include "${CMAKE_MATCH_0}")
        set(name ${CMAKE_MATCH_2})
        string(FIND "${rest}" "${include}" at)
        string(LENGTH "${include}" length)
        string(SUBSTRING "${rest}" 0 ${at} before)
        math(EXPR at "${at} + ${length}")
        string(SUBSTRING "${rest}" ${at} -1 rest)

        string(REGEX REPLACE "[^\n]" "" line_ends "${before}${include}")
        string(LENGTH "${line_ends}" lines)
        math(EXPR line "${line} + ${lines}")

        cmake_path(GET path PARENT_PATH folder)
        set(file ${folder}/${name})
        if(NOT EXISTS ${file})
            set(file ${INCLUDE_DIR}/${name})
        endif()
        set(included "\n")
        if(NOT file IN_LIST seen)
            list(APPEND seen ${file})
            expand(${file} included)
        endif()
        string(APPEND text "${before}\n${included}#line ${line} \"${shown}\"\n")
    endwhile()
    set(${result} "${text}${rest}" PARENT_SCOPE)
    set(seen "${seen}" PARENT_SCOPE)
endfunction()

set(texts)
foreach(group IN LISTS GROUPS)
    string(REPLACE "|" ";" files ${group})
    set(seen)
    string(APPEND texts "    R\"kernels(\n")
    foreach(file IN LISTS files)
        expand(${file} text)
        string(APPEND texts "${text}")
    endforeach()
    string(APPEND texts ")kernels\",\n")
endforeach()
file(WRITE ${OUTPUT}
    "// OpenCL C sources, embedded at build time.\n"
    "#include <span>\n"
    "#include <string_view>\n"
    "namespace lacuna::opencl {\n"
    "std::span<const std::string_view> ${NAME}();\n"
    "namespace {\n"
    "const std::string_view kTexts[] = {\n${texts}};\n"
    "}  // namespace\n"
    "std::span<const std::string_view> ${NAME}() { return kTexts; }\n"
    "}  // namespace lacuna::opencl\n")
