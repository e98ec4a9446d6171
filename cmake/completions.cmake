# Installs the completions of the command, for bash, zsh and fish.
install(FILES ${PROJECT_SOURCE_DIR}/host/cli/terminal/completion.bash RENAME lacuna
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT command)
install(FILES ${PROJECT_SOURCE_DIR}/host/cli/terminal/completion.zsh RENAME _lacuna
    DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT command)
install(FILES ${PROJECT_SOURCE_DIR}/host/cli/terminal/completion.fish RENAME lacuna.fish
    DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT command)
