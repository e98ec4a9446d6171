# Completion of the command lacuna for bash. Commands and options come from --help.

# The names of the commands, as `lacuna --help` lists them.
_lacuna_commands() {
    "$1" --help 2>/dev/null | sed -n '/^Subcommands:/,$s/^  \([a-z0-9-]*\) .*/\1/p'
}

_lacuna() {
    local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        mapfile -t COMPREPLY < <(compgen -W "$(_lacuna_commands "$program") help version --help --version" -- "$word")
        return
    fi
    local command=${COMP_WORDS[1]}
    case $before in
        --backend | --backends) mapfile -t COMPREPLY < <(compgen -W "auto cpu opencl vulkan reference" -- "$word") ;;
        --mode | --start)
            local modes="exact lines stratified"
            [[ $command != stipple ]] || modes="stratified cells exact"
            [[ $command != compare ]] || modes+=" cells"
            mapfile -t COMPREPLY < <(compgen -W "$modes" -- "$word")
            ;;
        --paper-size) mapfile -t COMPREPLY < <(compgen -W "A0 A1 A2 A3 A4 A5 A6 letter legal tabloid" -- "$word") ;;
        --format) mapfile -t COMPREPLY < <(compgen -W "txt csv npy ply json svg pdf png" -- "$word") ;;
        --metric) mapfile -t COMPREPLY < <(compgen -W "min mean max" -- "$word") ;;
        *)
            if [[ $word == -* ]]; then
                mapfile -t COMPREPLY < <(compgen -W "$("$program" "$command" --help 2>/dev/null |
                    grep -oE -- '^ +(-[a-z],)?--[a-z0-9-]+' | grep -oE -- '--[a-z0-9-]+')" -- "$word")
            elif [[ $command == help ]]; then
                mapfile -t COMPREPLY < <(compgen -W "$(_lacuna_commands "$program")" -- "$word")
            elif [[ $command == reproduce && $before != -* ]]; then
                mapfile -t COMPREPLY < <(compgen -W "table1 table2 fig3 fig4 fig5 fig6 fig7 fig8 all" -- "$word")
            else
                compopt -o filenames 2>/dev/null
                mapfile -t COMPREPLY < <(compgen -f -- "$word")
            fi
            ;;
    esac
}

complete -F _lacuna lacuna
