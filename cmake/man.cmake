# Man pages lacuna(1) and lacuna-COMMAND(1), made from what the command's --help prints.
set(man_pages)
find_program(HELP2MAN help2man)
if(HELP2MAN)
    # lacuna_man(COMMAND ABOUT) makes the page of `lacuna COMMAND`, or of lacuna itself.
    function(lacuna_man command about)
        string(JOIN - page lacuna ${command})
        set(file ${PROJECT_BINARY_DIR}/man/${page}.1)
        add_custom_command(OUTPUT ${file}
            COMMAND ${PROJECT_SOURCE_DIR}/cmake/man_page.sh ${HELP2MAN}
                $<TARGET_FILE:lacuna_command> "${command}" ${page} "${about}" ${PROJECT_VERSION}
                ${PROJECT_BINARY_DIR}/man
            DEPENDS lacuna_command ${PROJECT_SOURCE_DIR}/cmake/man_page.sh
            COMMENT "Man page ${page}(1)" VERBATIM)
        set(man_pages ${man_pages} ${file} PARENT_SCOPE)
    endfunction()
    lacuna_man("" "blue-noise point sets")
    lacuna_man(sample "make a blue-noise point set")
    lacuna_man(stipple "stipple a picture")
    lacuna_man(relax "move points until their shares are equal")
    lacuna_man(order "put points into a progressive order")
    lacuna_man(verify "prove or refute a point set")
    lacuna_man(analyze "spectrum and statistics of point sets")
    lacuna_man(compare "compare the backends")
    lacuna_man(reproduce "the tables and figures of the paper")
    lacuna_man(mask "make a tile of thresholds for dithering")
    lacuna_man(again "make a file again by the command that it records")
    lacuna_man(devices "list backends and devices")
    if(LACUNA_HAS_MPI)
        set(mpi_man_page ${PROJECT_BINARY_DIR}/man/lacuna-mpi.1)
        add_custom_command(OUTPUT ${mpi_man_page}
            COMMAND ${PROJECT_SOURCE_DIR}/cmake/man_page.sh ${HELP2MAN} $<TARGET_FILE:lacuna_mpi>
                sample lacuna-mpi "blue-noise point sets on many machines" ${PROJECT_VERSION}
                ${PROJECT_BINARY_DIR}/man
            DEPENDS lacuna_mpi ${PROJECT_SOURCE_DIR}/cmake/man_page.sh
            COMMENT "Man page lacuna-mpi(1)" VERBATIM)
    endif()
    add_custom_target(man ALL DEPENDS ${man_pages} ${mpi_man_page})
else()
    message(STATUS "help2man is missing: no man pages are made")
endif()
