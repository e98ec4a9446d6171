#compdef lacuna
# Completion of the command lacuna for zsh. The hidden command `lacuna __words` lists what may stand
# at the end of a command line; where it lists nothing, a file may.

_lacuna() {
    local -a found
    found=(${(f)"$($words[1] __words "${(@)words[2,CURRENT]}" 2>/dev/null)"})
    found=("${(@)found/$'\t'/:}")
    if ((! $#found)); then
        _files
    elif [[ $words[CURRENT] == -* ]]; then
        _describe -o option found
    else
        _describe word found
    fi
}

# If zsh autoloads this file, it is the body of _lacuna; if it is sourced, it registers _lacuna.
if [[ $funcstack[1] == _lacuna ]]; then
    _lacuna "$@"
elif (($+functions[compdef])); then
    compdef _lacuna lacuna
fi
