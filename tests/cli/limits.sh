#!/usr/bin/env bash
# Lowers what the system grants, step by step, and looks at how the program ends.
#
#     tests/cli/limits.sh [--short] PROGRAM BACKEND...
#
# Address space (ulimit -v, KiB), threads and processes (-u), open files (-n), the stack (-s, KiB).
# In the end `compare` with all backends gets the steps of the address space. Prints a line for each
# step that gives no points, and how many steps ended with which code. Fails for a code other than
# 0, 2, 3 and 4 (docs/design.md, section 7), for a step that takes over a minute, and for words of
# the C++ library about an exception. Limits under which even `PROGRAM --version` does not start are
# named and do not count. If a driver ends the program, by exit(), abort(), a crash or an exception,
# the program reports it with code 4. Code 134 is allowed if the driver calls abort() while devices
# are first listed.
set -u

steps_v="15000 20000 22000 24000 26000 28000 30000 32000 34000 36000 38000 40000 45000 50000 60000
    80000 100000 150000 200000 250000 300000 320000 340000 360000 380000 400000 420000 450000 500000
    600000 800000 1000000 1500000 2000000 3000000"
steps_u="1 2 3 4 5 6 8 10 12"
steps_n="3 4 5 6 7 8 9 10 12 14 16 20 24 32"
steps_s="16 24 32 48 64 80 100 128 160 200 256 384 512 1024 2048"
if [[ $1 == --short ]]; then
    shift
    steps_v="24000 28000 32000 36000 40000"
    steps_u="1 2"
    steps_n="4 6"
    steps_s="64 256"
fi
program=$(realpath "$1")
shift

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
chmod 777 "$folder"
export POCL_CACHE_DIR=$folder
# The limit on processes counts a user's processes, and root has none.
as_nobody=()
if ((EUID == 0)); then
    as_nobody=(setpriv --reuid=65534 --regid=65534 --clear-groups --inh-caps=-all)
fi

# run LETTER VALUE WORD...: prints the program's code; its messages are in $folder/err.
run() {
    local letter=$1 value=$2
    shift 2
    local user=()
    if [[ $letter == u ]]; then user=("${as_nobody[@]}"); fi
    (
        exec >/dev/null 2>"$folder/err"
        ulimit -c 0
        ulimit "-$letter" "$value" && exec "${user[@]}" "$program" "$@"
    ) &
    local child=$! waited=0
    while kill -0 $child 2>/dev/null && ((waited++ < 600)); do sleep 0.1; done
    if kill -KILL $child 2>/dev/null; then
        wait $child 2>/dev/null
        return 124
    fi
    wait $child 2>/dev/null
}
# The shell itself prints a message for a child that crashed.
exec 3>&2 2>/dev/null

declare -A seen
failed=0
# step NAME LETTER VALUE WORD...: NAME is a backend, or compare for several.
step() {
    local name=$1 letter=$2 value=$3 code said
    shift 3
    run "$letter" "$value" "$@"
    code=$?
    said=$(tail -n 1 "$folder/err" | cut -c 1-160)
    local verdict=$code
    case $code in
        0 | 2 | 3 | 4) if [[ $said == *"its driver ended"* ]]; then verdict="4, by its driver"; fi ;;
        134) if [[ $name != cpu && -n $said && $said != lacuna:* && $said != *what\(\)* ]]; then
            # PoCL's abort while devices are first listed: see host/cli/terminal/driver.h.
            verdict="134, by its driver's own abort"
        else
            verdict="$code, NOT ALLOWED"
            failed=1
        fi ;;
        *)
            if ! run "$letter" "$value" --version; then
                verdict="does not start"
            else
                verdict="$code, NOT ALLOWED"
                failed=1
            fi
            ;;
    esac
    if grep -q "^terminate called" "$folder/err"; then
        verdict="$code, with words of the C++ library, NOT ALLOWED"
        failed=1
    fi
    seen["$name: $verdict"]=$((${seen["$name: $verdict"]:-0} + 1))
    if [[ $code != 0 ]]; then echo "$name -$letter $value: $verdict: $said"; fi
}

for backend in "$@"; do
    sample=(sample --radius 0.01 --quiet --threads 4 --backend "$backend")
    for value in $steps_v; do step "$backend" v "$value" "${sample[@]}"; done
    for value in $steps_u; do step "$backend" u "$value" "${sample[@]}"; done
    for value in $steps_n; do step "$backend" n "$value" "${sample[@]}"; done
    for value in $steps_s; do step "$backend" s "$value" "${sample[@]}"; done
done
all=$(IFS=,; echo "$*")
for value in $steps_v; do
    step compare v "$value" compare --radius 0.05 --runs 1 --quiet --backends "$all"
done
for verdict in "${!seen[@]}"; do echo "${seen[$verdict]} steps of $verdict"; done | sort -k 4
exit $failed
