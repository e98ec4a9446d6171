#compdef lacuna
# Completion of the command lacuna for zsh. Commands and options come from --help.

_lacuna() {
    local program=$words[1] command=$words[2] before=$words[CURRENT-1]
    local -a found
    if ((CURRENT == 2)); then
        found=(${(f)"$($program --help 2>/dev/null |
            sed -n '/^Subcommands:/,$s/^  \([a-z0-9-]*\)  *\(.*\)/\1:\2/p')"})
        found+=('help:Prints this help, or the help of a command.' 'version:Prints the version.')
        _describe command found
        return
    fi
    case $before in
        --backend | --backends) compadd -- auto cpu opencl vulkan reference ;;
        --mode | --start)
            case $command in
                stipple) compadd -- stratified cells exact ;;
                compare) compadd -- exact lines stratified cells ;;
                *) compadd -- exact lines stratified ;;
            esac
            ;;
        --metric) compadd -- min mean max ;;
        --paper-size) compadd -- A0 A1 A2 A3 A4 A5 A6 letter legal tabloid ;;
        --format) compadd -- txt csv npy ply json svg pdf png ;;
        *)
            if [[ $words[CURRENT] == -* ]]; then
                found=(${(f)"$($program $command --help 2>/dev/null |
                    sed -n 's/^ *\(-[a-zA-Z],\)\{0,1\}\(--[a-z0-9-]*\)\( [^ ]*\)*   *\(.*\)/\2:\4/p')"})
                _describe -o option found
            elif [[ $command == reproduce && $before != -* ]]; then
                compadd -- table1 table2 fig3 fig4 fig5 fig6 fig7 fig8 all
            elif [[ $command == help ]]; then
                compadd -- $($program --help 2>/dev/null |
                    sed -n '/^Subcommands:/,$s/^  \([a-z0-9-]*\) .*/\1/p')
            else
                _files
            fi
            ;;
    esac
}

# If zsh autoloads this file, it is the body of _lacuna; if it is sourced, it registers _lacuna.
if [[ $funcstack[1] == _lacuna ]]; then
    _lacuna "$@"
elif (($+functions[compdef])); then
    compdef _lacuna lacuna
fi
