#!/bin/sh
# Makes the man page PAGE.1 in FOLDER from what `PROGRAM [COMMAND] --help` prints.
#   man_page.sh HELP2MAN PROGRAM "[COMMAND]" PAGE ABOUT VERSION FOLDER
# help2man reformats the text before the usage. So examples and prose are given to it as sections of
# their own, which come after the options.
set -eu
help2man=$1 program=$2 command=$3 page=$4 about=$5 version=$6 folder=$7

scratch=$folder/$page.parts
mkdir -p "$scratch"
# $command is unquoted because it may be empty.
"$program" $command --help${command:+-all} >"$scratch/all"
awk -v folder="$scratch" '
    NR == 1 { print > (folder "/help"); next }
    /^Usage:/ { part = "help" }
    part == "help" { print > (folder "/help"); next }
    /^Examples:/ { part = "examples"; next }
    /^$/ { if (part == "prose") print > (folder "/prose"); else part = "prose"; next }
    { print > (folder "/" part) }
' "$scratch/all"

# Escapes a text for roff.
as_roff() {
    sed 's/\\/\\e/g; s/-/\\-/g; s/^[.'\'']/\\\&&/; s/^$/.PP/' "$1"
}
{
    [ ! -f "$scratch/prose" ] || { echo '[notes]' && as_roff "$scratch/prose"; }
    [ ! -f "$scratch/examples" ] || {
        echo '[examples]' && echo .nf && as_roff "$scratch/examples" | sed 's/^  //' && echo .fi
    }
    [ "$page" != lacuna ] && ! grep -q -e '--backend ' "$scratch/help" || cat <<'END'
[environment]
.TP
.B LACUNA_BACKEND
The backend of runs whose \-\-backend is auto: cpu, opencl, vulkan or reference.
END
    if [ "$page" = lacuna ]; then
        sed -n '/^Subcommands:/,$s/^  \([a-z]*\) .*/\1/p' "$scratch/help" |
            sed '1i [see also]
                s/.*/.BR lacuna\\-& (1)/'
    else
        printf '[see also]\n.BR lacuna (1)\n'
    fi
} >"$scratch/include"

# help2man names the page after the program that it runs, so it runs a script of the right name.
printf '#!/bin/sh\ncat "%s"\n' "$scratch/help" >"$scratch/$page"
chmod +x "$scratch/$page"
"$help2man" --no-info --version-string="$version" --name="$about" --source=Lacuna \
    --include="$scratch/include" --output="$folder/$page.1" "$scratch/$page"
