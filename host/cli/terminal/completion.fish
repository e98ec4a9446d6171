# Completion of the command lacuna for fish. The hidden command `lacuna __words` lists what may stand
# at the end of a command line; where it lists nothing, a file may.

function __lacuna_words
    set -l words (commandline --tokenize --current-process --cut-at-cursor)
    set -l current (commandline --current-token --cut-at-cursor)
    $words[1] __words $words[2..-1] "$current" 2>/dev/null
end

function __lacuna_has_words
    test -n "$(__lacuna_words)"
end

complete -c lacuna -n __lacuna_has_words -f -a '(__lacuna_words)'
