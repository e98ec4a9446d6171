#!/usr/bin/env bash
# bytes.sh PROGRAM BACKEND[:THREADS]...: makes the sets of tests/pinned.txt with each backend, and
# fails if one has another hash than its row. A missing backend that LACUNA_REQUIRE lacks is left out.
# bytes.sh --write PROGRAM: writes the hashes of all rows anew, as the backend cpu makes them.
set -euo pipefail
cd "$(dirname "$0")/../.."
table=tests/pinned.txt
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export POCL_CACHE_DIR=$scratch/pocl
mkdir -p "$POCL_CACHE_DIR"

# hash_of REQUEST...: the SHA-256 of the files that the program writes.
hash_of() {
    local output=set.npy
    [[ " $* " != *" --seeds "* ]] || output='{seed}.npy'
    [[ " $* " != *" mask "*" --frames "* ]] || output='{frame}.npy'
    rm -f "$scratch"/*.npy
    "$program" "$@" --quiet -o "$scratch/$output" || return
    cat "$scratch"/*.npy | sha256sum | cut -d ' ' -f 1
}

writes=
if [[ ${1-} == --write ]]; then
    writes=1
    shift
fi
(($#)) || { echo "usage: bytes.sh PROGRAM BACKEND..., or bytes.sh --write PROGRAM" >&2; exit 2; }
program=$(realpath "$1")
(($# > 1)) || set -- "$1" cpu
backends=()
for backend in "${@:2}"; do
    "$program" sample --radius 0.5 --backend "${backend%:*}" --quiet -o "$scratch/set.npy" ||
        [[ ,${LACUNA_REQUIRE-}, == *,${backend%:*},* ]] || continue
    backends+=("$backend")
done
((${#backends[@]})) || exit 77  # ctest skips it

sets=0 others=0
while read -r pinned doors request; do
    # Remarks, and rows that are not for the command.
    if [[ -z $pinned || $pinned == \#* || $doors != *[bh]* ]]; then
        echo "$pinned${doors:+ $doors}${request:+ $request}" >>"$scratch/table"
        continue
    fi
    for backend in "${backends[@]}"; do
        where=(--backend "${backend%:*}")
        [[ $backend != *:* ]] || where+=(--threads "${backend#*:}")
        [[ $doors == *b* ]] || where=()
        # shellcheck disable=SC2086  # the words of the request
        hash=$(hash_of $request "${where[@]}") || hash=none
        sets=$((sets + 1))
        if [[ $hash == "$pinned" ]]; then continue; fi
        others=$((others + 1))
        [[ -n $writes ]] || echo "bytes: $request ${where[*]}: has the hash $hash instead of $pinned" >&2
    done
    echo "$hash $doors $request" >>"$scratch/table"
done <$table
if [[ -n $writes ]]; then
    ! grep ^none "$scratch/table" >&2 || exit 1
    cp "$scratch/table" $table
    echo "bytes: $others of $sets hashes are new"
    exit 0
fi
echo "bytes: $((sets - others)) of $sets sets have the pinned bytes"
((others == 0))
