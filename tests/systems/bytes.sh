#!/usr/bin/env bash
# bytes.sh PROGRAM BACKEND...: makes 17 sets with each backend, and prints SHA-256 and request
# for each. Two systems that keep Lacuna's promise print the same lines.
set -euo pipefail
program=$1
shift
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export POCL_CACHE_DIR=$scratch/pocl
mkdir -p "$POCL_CACHE_DIR"
examples=$(cd "$(dirname "$0")/../.." && pwd)/examples
picture=$examples/raccoon.png
printf '0.1 0.1\n0.9 0.2\n0.4 0.95\n' >"$scratch/triangle.txt"

requests=(
    "sample --radius 0.01 --torus"
    "sample --radius 0.002 --seed 7"
    "sample --count 5000 --domain 3x1"
    "sample --radius 0.02 --mode lines --torus"
    "sample --radius 0.02 --mode lines --snap --seed 3"
    "sample --radius 0.05 --mode lines --uniform-x"
    "sample --field $picture --count 3000"
    "sample --field $picture --scale 0.02 --torus"
    "sample --radius 0.01 --inside $scratch/triangle.txt --border 0.01"
    "sample --on-pixels 90x60 --count 1500 --field $picture"
    "sample --stretch 0.04:0.01@30 --torus --seed 5"
    "stipple $picture --count 4000 --relax 0"
    "stipple $picture --count 4000 --relax 0 --metric max --seed 2"
    "stipple $picture --count 2000 --relax 5"
    "stipple $picture --count 2000 --mode exact --relax 3 --seed 4"
    "stipple $picture --count 1000 --along 4"
    "stipple $examples/hopper.jpg --inks cmyk --count 2000 --relax 4"
)
for backend in "$@"; do
    for request in "${requests[@]}"; do
        where="--backend $backend"
        [[ $request == *--on-pixels* ]] && where=  # the host alone places these samples
        # shellcheck disable=SC2086
        "$program" $request $where --quiet -o "$scratch/set.npy"
        shown=${request//"$examples/"/}
        shown=${shown//"$scratch/"/}
        echo "$(sha256sum <"$scratch/set.npy" | cut -d ' ' -f 1) $shown --backend $backend"
    done
done
