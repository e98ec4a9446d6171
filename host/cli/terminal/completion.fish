# Completion of the command lacuna for fish. Commands and options come from --help.

# The words of the command line before the one that is being written.
function __lacuna_words
    commandline --tokenize --current-process --cut-at-cursor
end

function __lacuna_commands
    set -l program (__lacuna_words)[1]
    $program --help 2>/dev/null |
        sed -n '/^Subcommands:/,$s/^  \([a-z0-9-]*\)  *\(.*\)/\1\t\2/p'
end

function __lacuna_options
    set -l words (__lacuna_words)
    $words[1] $words[2] --help 2>/dev/null |
        sed -n 's/^ *\(-[a-zA-Z],\)\{0,1\}\(--[a-z0-9-]*\)\( [^ ]*\)*   *\(.*\)/\2\t\4/p'
end

function __lacuna_has_command
    test (count (__lacuna_words)) -ge 2
end

# Whether the last complete word is one of these options.
function __lacuna_after
    contains -- (__lacuna_words)[-1] $argv
end

function __lacuna_command_is
    set -l words (__lacuna_words)
    test (count $words) -ge 2; and contains -- $words[2] $argv
end

complete -c lacuna -n 'not __lacuna_has_command' -f -a '(__lacuna_commands)'
complete -c lacuna -n 'not __lacuna_has_command' -f -a 'help\t"Prints this help, or the help of a command"
    version\t"The version"'
complete -c lacuna -n __lacuna_has_command -a '(string match -q -- "-*" (commandline -ct); and __lacuna_options)'
complete -c lacuna -n '__lacuna_after --backend --backends' -f -a 'auto cpu opencl vulkan reference'
complete -c lacuna -n '__lacuna_after --mode --start; and not __lacuna_command_is stipple' -f -a 'exact lines stratified'
complete -c lacuna -n '__lacuna_after --mode --start; and __lacuna_command_is stipple' -f -a 'stratified cells exact'
complete -c lacuna -n '__lacuna_after --mode --start; and __lacuna_command_is compare' -f -a cells
complete -c lacuna -n '__lacuna_after --metric' -f -a 'min mean max'
complete -c lacuna -n '__lacuna_after --paper-size' -f -a 'A0 A1 A2 A3 A4 A5 A6 letter legal tabloid'
complete -c lacuna -n '__lacuna_after --format' -f -a 'txt csv npy ply json svg pdf png'
complete -c lacuna -n '__lacuna_command_is reproduce' -f -a 'table1 table2 fig3 fig4 fig5 fig6 fig7 fig8 all'
complete -c lacuna -n '__lacuna_command_is help' -f -a '(__lacuna_commands)'
