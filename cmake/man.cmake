# Man pages lacuna(1) and lacuna-COMMAND(1), made from what the command's --help prints; and the
# completion for bash, which asks --help too.
find_program(HELP2MAN help2man)
if(HELP2MAN)
    # lacuna_man(PAGE ABOUT HELP) makes PAGE.1 from `lacuna HELP`.
    set(man_pages)
    function(lacuna_man page about help)
        set(file ${PROJECT_BINARY_DIR}/man/${page}.1)
        string(TOUPPER ${page} title)
        add_custom_command(OUTPUT ${file}
            COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/man
            COMMAND ${HELP2MAN} --no-info "--help-option=${help}" "--version-string=${PROJECT_VERSION}"
                "--name=${about}" --source=Lacuna --output=${file} $<TARGET_FILE:lacuna_command>
            COMMAND sed -i "1,3s/^\\.TH LACUNA /.TH ${title} /" ${file}
            DEPENDS lacuna_command COMMENT "Man page ${page}(1)" VERBATIM)
        set(man_pages ${man_pages} ${file} PARENT_SCOPE)
    endfunction()
    lacuna_man(lacuna "blue-noise point sets" "--help")
    lacuna_man(lacuna-sample "make a blue-noise point set" "sample --help")
    lacuna_man(lacuna-stipple "stipple a picture" "stipple --help")
    lacuna_man(lacuna-verify "prove or refute a point set" "verify --help")
    lacuna_man(lacuna-analyze "spectrum and statistics of point sets" "analyze --help")
    lacuna_man(lacuna-compare "compare the backends" "compare --help")
    lacuna_man(lacuna-reproduce "the tables and figures of the paper" "reproduce --help")
    lacuna_man(lacuna-devices "list backends and devices" "devices --help")
    add_custom_target(man ALL DEPENDS ${man_pages})
    install(FILES ${man_pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
else()
    message(STATUS "help2man is missing: no man pages are made")
endif()
install(FILES ${PROJECT_SOURCE_DIR}/host/cli/completion.bash RENAME lacuna
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
