# Compiler options of every target, in one interface target: lacuna_options.
add_library(lacuna_options INTERFACE)
# No float decides anything, but the reported numbers should not differ between compilers either.
# Nothing replaces the library's own functions, so those of one file may be inlined in a shared library.
target_compile_options(lacuna_options INTERFACE -ffp-contract=off -fno-math-errno
    -fno-semantic-interposition
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wimplicit-fallthrough
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor> $<$<COMPILE_LANGUAGE:CXX>:-Wold-style-cast>
    $<$<COMPILE_LANGUAGE:CXX>:-Woverloaded-virtual>
    $<$<BOOL:${LACUNA_WERROR}>:-Werror>)
if(LACUNA_SANITIZE)
    target_compile_options(lacuna_options INTERFACE
        -fsanitize=${LACUNA_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(lacuna_options INTERFACE -fsanitize=${LACUNA_SANITIZE})
endif()
if(LACUNA_FUZZ)
    if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
        message(FATAL_ERROR "LACUNA_FUZZ needs clang++ (Debian's clang and libclang-rt-14-dev), as"
            " the preset fuzz chooses it; the compiler is ${CMAKE_CXX_COMPILER}")
    endif()
    # Instruments the code for libFuzzer; only the fuzzers themselves get its main.
    target_compile_options(lacuna_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
