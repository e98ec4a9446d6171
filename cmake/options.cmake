# Compiler options of every target, in one interface target: lacuna_options.
add_library(lacuna_options INTERFACE)
# Nothing that decides is a float, yet what is reported should not differ between compilers either.
target_compile_options(lacuna_options INTERFACE -ffp-contract=off -fno-math-errno
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor
    -Wold-style-cast -Woverloaded-virtual -Wimplicit-fallthrough
    $<$<BOOL:${LACUNA_WERROR}>:-Werror>)
if(LACUNA_SANITIZE)
    target_compile_options(lacuna_options INTERFACE
        -fsanitize=${LACUNA_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(lacuna_options INTERFACE -fsanitize=${LACUNA_SANITIZE})
endif()
