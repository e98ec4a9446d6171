# Completion of the command lacuna for bash. The hidden command `lacuna __words` lists what may stand
# at the end of a command line; where it lists nothing, a file may.

_lacuna() {
    local word=${COMP_WORDS[COMP_CWORD]} found
    found=$("${COMP_WORDS[0]}" __words "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null | cut -f 1)
    if [[ -n $found ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$found" -- "$word")
    else
        compopt -o filenames 2>/dev/null
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
    fi
}

complete -F _lacuna lacuna
