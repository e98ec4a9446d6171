#!/usr/bin/env bash
# Sets up, builds, tests and runs Lacuna on a bare Debian 12 or 13; untried on Ubuntu; see "help".
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$root/build

# The packages that the command needs, with every backend.
packages=(
    g++ cmake ninja-build pkg-config
    librandom123-dev libhwy-dev libcli11-dev libfmt-dev libtbb-dev libcairo2-dev nlohmann-json3-dev
    libssl-dev libeigen3-dev libnanoflann-dev
    libpng-dev libjpeg-dev libtiff-dev libwebp-dev libheif-dev libpugixml-dev libpolyclipping-dev libassimp-dev
    zlib1g-dev
    opencl-headers opencl-clhpp-headers ocl-icd-libopencl1
    libvulkan-dev glslang-tools spirv-tools
    python3-dev python3-venv
)
# The packages that tests, benchmarks, checks and man pages need too, with drivers that need no
# graphics card, and MPI for the command lacuna-mpi.
more_packages=(
    libgtest-dev libbenchmark-dev librapidcheck-dev
    pocl-opencl-icd clinfo mesa-vulkan-drivers vulkan-validationlayers
    clang-format clang-tidy valgrind help2man zsh fish
    libopenmpi-dev openmpi-bin
    librsvg2-bin python3-shapely python3-yaml
)
# Packages that some of these systems lack. Without one, the tests that need it are skipped.
optional_packages=()
more_optional_packages=(oclgrind)
# The packages that the page in web/ and its tests need too.
web_packages=(
    emscripten cmake ninja-build
    librandom123-dev libfmt-dev libnanoflann-dev libeigen3-dev
)
more_web_packages=(libgtest-dev chromium chromium-driver python3-selenium)

usage() {
    cat <<'END'
usage: ./bootstrap.sh COMMAND

  run           build the command alone, then make a first maximal set and a picture of it
  test [ARG...] build, then run the tests; arguments go to ctest, for example -R NAME
  python        build the Python module into build/python/environment, and make a first set with it
  web [tests]   build the page, Lacuna as WebAssembly, into build-web/page; with 'tests' install what
                web/check needs, and build what it runs under node
  build         install what is missing, configure and build everything into build/
  packages      install what all these commands and .ci/run need
  clean         remove build/ and build-web/
  help          print this

Each command does only the work that is still to be done. Warnings are errors when CI is set.
END
}

die() {
    echo "bootstrap: $*" >&2
    exit 1
}

bad_usage() {
    echo "bootstrap: $*" >&2
    exit 2
}

# missing_of PACKAGE...: prints the packages that are not installed, one a line.
missing_of() {
    local installed package
    # dpkg-query fails if it does not know a name: that package is then simply not listed.
    installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null) || true
    for package in "$@"; do
        grep -qxF "installed $package" <<<"$installed" || echo "$package"
    done
}

# as_root COMMAND...: runs it as root; without sudo, names the packages in the caller's `missing`.
as_root() {
    if ((EUID == 0)); then
        "$@" </dev/null
    else
        command -v sudo >/dev/null ||
            die "no sudo here: as root, run 'apt-get install ${missing[*]}', then try again"
        sudo "$@" </dev/null
    fi
}

install_packages() {
    local missing optional package
    if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
        die "no apt-get here: install what these Debian packages hold, then use 'cmake --preset release': ${packages[*]}"
    fi
    mapfile -t missing < <(missing_of "${packages[@]}")
    mapfile -t optional < <(missing_of "${optional_packages[@]}")
    ((${#missing[@]} == 0)) || as_root apt-get update -q ||
        die "apt-get update failed: no package lists, so these cannot be installed: ${missing[*]}"
    for package in "${optional[@]}"; do
        if [[ -n $(apt-cache show --no-all-versions "$package" 2>/dev/null) ]]; then
            missing+=("$package")
        else
            echo "bootstrap: this system has no package $package: the tests that need it are skipped"
        fi
    done
    ((${#missing[@]})) || return 0
    echo "bootstrap: installing ${missing[*]}"
    as_root env DEBIAN_FRONTEND=noninteractive \
        apt-get install -q -y --no-install-recommends "${missing[@]}" ||
        die "apt-get install failed; it was asked for: ${missing[*]}"
}

# The value of a variable in CMake's cache, or nothing.
cached() {
    sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt" 2>/dev/null || true
}

# configure TESTS: configures build/, with the tests and benchmarks if TESTS is ON. A build/ that
# has tests keeps them. So nothing is compiled again, whichever command came first.
configure() {
    local options=("-DLACUNA_TESTS=$1" "-DLACUNA_BENCHMARKS=$1") source tests
    source=$(cached CMAKE_HOME_DIRECTORY)
    [[ -z $source || $source == "$root" ]] ||
        die "build/ was configured for $source, not for $root: run './bootstrap.sh clean' first"
    tests=$(cached LACUNA_TESTS)
    # build.ninja is written last, so it stands for a configuration that succeeded.
    if [[ -f $build/build.ninja && (-z ${CI:-} || $(cached LACUNA_WERROR) == ON) &&
        ($1 == OFF || $tests == ON) ]]; then
        return 0
    fi
    [[ $1 == ON || $tests != ON ]] || options=()
    # .ci/timed notes the time of each test program.
    [[ -z ${CI:-} ]] ||
        options+=(-DLACUNA_WERROR=ON "-DCMAKE_CROSSCOMPILING_EMULATOR=$root/.ci/timed")
    (cd "$root" && cmake --preset release "${options[@]}") ||
        die "configuring failed: the first 'CMake Error' above says why"
}

# build_targets [OPTION...]: passes options to cmake; builds all targets if none is named.
build_targets() {
    cmake --build "$build" "$@" || die "building failed: the first 'error:' above says why"
}

build() {
    packages+=("${more_packages[@]}")
    optional_packages+=("${more_optional_packages[@]}")
    install_packages
    configure ON
    build_targets
}

# With debootstrap, which makes the root of tests/systems/debian.
all_packages() {
    packages+=("${more_packages[@]}" "${web_packages[@]}" "${more_web_packages[@]}" debootstrap)
    optional_packages+=("${more_optional_packages[@]}")
    install_packages
}

run() {
    local picture
    install_packages
    configure OFF
    build_targets --target lacuna_command
    for picture in "$build/first.png" "$build/first.svg"; do
        "$build/lacuna" sample --radius 0.02 --torus -o "$picture" </dev/null ||
            die "the program could not make $picture: its message stands above"
    done
    echo "$picture"
}

# The Python module, as `pip install .` makes it, in an environment of its own.
python_module() {
    local environment=$build/python/environment options=()
    install_packages
    python3 -m venv "$environment" ||
        die "python3 -m venv failed: the module needs Python 3.11 or later with venv"
    [[ -z ${CI:-} ]] || options+=(--config-settings=cmake.define.LACUNA_WERROR=ON)
    if [[ -n ${LACUNA_PREBUILT:-} ]]; then
        options+=("--config-settings=cmake.define.LACUNA_PREBUILT=$LACUNA_PREBUILT"
            "--config-settings=build-dir=$build/python/prebuilt")
    else
        echo "bootstrap: pip compiles the module and the command, which takes 2 minutes on two cores"
    fi
    "$environment/bin/pip" install -q "${options[@]}" "$root[scipy]" </dev/null ||
        die "pip could not install the module: the first error above says why"
    "$environment/bin/python" -c '
import lacuna
made = lacuna.sample(0.02, torus=True, seed=0)
print(f"import lacuna: {len(made)} points, maximal: {lacuna.verify(made).maximal}")' ||
        die "the module does not run: its message stands above"
    echo "$environment/bin/python"
}

# The page: static files, for any server of static files.
web_page() {
    local folder=$root/build-web targets=(page npm)
    packages=("${web_packages[@]}")
    if [[ ${1:-} == tests ]]; then
        packages+=("${more_web_packages[@]}")
        targets+=(same_bytes)
    fi
    install_packages
    # Debian keeps the modules that emscripten's JavaScript optimiser needs here.
    export NODE_PATH=/usr/share/nodejs
    local options=(-DCMAKE_BUILD_TYPE=Release)
    [[ -z ${CI:-} ]] || options+=(-DLACUNA_WERROR=ON)
    emcmake cmake -S "$root/web" -B "$folder" -G Ninja "${options[@]}" >/dev/null ||
        die "configuring failed: the first 'CMake Error' above says why"
    cmake --build "$folder" --target "${targets[@]}" ||
        die "building failed: the first 'error:' above says why"
    echo "$folder/page: to see it, run 'python3 -m http.server --directory $folder/page' and open" \
        "http://localhost:8000"
}

# Installs vpype and pypdfium2, with which tests read our .svg and .pdf, in a Python environment of
# their own. If this fails, the tests that need them are skipped.
install_viewers() {
    local viewers=$build/viewers
    [[ -f $viewers/complete ]] && return 0
    if python3 -m venv "$viewers" &&
        "$viewers/bin/pip" install -q vpype==1.15.0 pypdfium2==5.15.2 numpy </dev/null; then
        touch "$viewers/complete"
    else
        rm -rf "$viewers"
        [[ -z ${CI:-} ]] || die "vpype and pypdfium2 could not be installed from PyPI"
        echo "bootstrap: vpype and pypdfium2 could not be installed from PyPI: their tests are skipped"
    fi
}

run_tests() {
    build
    install_viewers
    # PoCL silently lists no device when it cannot write its cache.
    export POCL_CACHE_DIR=$build/pocl-cache
    mkdir -p "$POCL_CACHE_DIR"
    # One more than the cores, because some tests wait.
    exec ctest --test-dir "$build" --output-on-failure --no-tests=error -j "$(($(nproc) + 1))" "$@"
}

main() {
    local command=${1:-}
    shift || true
    [[ $command == test || $# -eq 0 || "$command $*" == 'web tests' ]] ||
        bad_usage "$command $1: only 'test' takes further arguments, and 'web' the word 'tests'"
    case $command in
        run) run ;;
        test) run_tests "$@" ;;
        python) python_module ;;
        web) web_page "$@" ;;
        build) build ;;
        packages) all_packages ;;
        clean) rm -rf "$build" "$root/build-web" ;;
        help | -h | --help) usage ;;
        '')
            usage >&2
            exit 2
            ;;
        *) bad_usage "$command: must be run, test, python, web, build, packages, clean or help" ;;
    esac
}

main "$@"
