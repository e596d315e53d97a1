# Shared by the scripts of this folder: source it. Sets `top`, the top of the repository, `preset`, `build`, its folder, and
# `jobs`.
# shellcheck shell=bash

top="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
preset=release
build="$top/build/$preset"

# Compilations at once: one per processor, but each may take 2 GB (CGAL and ITK are templates all the way down).
count_jobs()
{
    local processors memory_kb
    processors="$(nproc 2>/dev/null || echo 1)"
    memory_kb="$(awk '/^MemAvailable:/ { print $2 }' /proc/meminfo 2>/dev/null || true)"
    local by_memory=$(( ${memory_kb:-2000000} / 2000000 ))
    local count=$(( processors < by_memory ? processors : by_memory ))
    echo $(( count > 0 ? count : 1 ))
}
jobs="$(count_jobs)"

# quietly WHAT COMMAND...: runs the command and shows what it printed only where it fails.
quietly()
{
    local what="$1" log
    shift
    log="$(mktemp)"
    if "$@" </dev/null >"$log" 2>&1; then
        rm -f -- "$log"
        return 0
    else
        local status=$?
        cat -- "$log" >&2
        rm -f -- "$log"
        echo "$what failed with status $status: $*" >&2
        return "$status"
    fi
}

# configure [CMAKE ARGUMENTS...]: the preset, with ccache where there is one.
configure()
{
    local arguments=(--preset "$preset" -S "$top" -B "$build" "$@")
    if [ ! -e "$build/CMakeCache.txt" ]; then
        echo "Building in $build: the first time takes ten to twenty minutes on two cores."
    fi
    if command -v ccache >/dev/null; then
        arguments+=(-D CMAKE_C_COMPILER_LAUNCHER=ccache -D CMAKE_CXX_COMPILER_LAUNCHER=ccache)
    fi
    (cd -- "$top" && quietly "configuring" cmake "${arguments[@]}")
}

# compile [TARGET...]: everything unless targets are named.
compile()
{
    local arguments=(--build "$build" --parallel "$jobs")
    if [ "$#" -gt 0 ]; then
        arguments+=(--target "$@")
    fi
    quietly "building" cmake "${arguments[@]}"
}

# run_tests [ARGUMENTS OF CTEST...]: shows ctest's count, and of tests that failed what they printed. A run without tests fails.
run_tests()
{
    local log status=0
    log="$(mktemp)"
    (cd -- "$top" && ctest --no-tests=error --no-label-summary --parallel 2 --output-on-failure --label-exclude nightly "$@") \
        </dev/null >"$log" 2>&1 || status=1
    if [ "$status" -eq 0 ]; then
        sed -n '/tests passed/,$p' "$log" # the count, the time, and which tests were skipped
    else
        grep --invert-match --extended-regexp '^ +Start +[0-9]+:| Passed +[0-9.]+ sec$' -- "$log" >&2
    fi
    rm -f -- "$log"
    return "$status"
}

# require_clang_tool NAME: ends with 77, which ctest counts as skipped, unless the version is there that the tree is kept
# with. Other versions format otherwise and find other things.
require_clang_tool()
{
    local wanted=14
    if ! command -v "$1" >/dev/null; then
        echo "skipped: $1 is not installed"
        exit 77
    fi
    if ! "$1" --version | grep --quiet "version $wanted\."; then
        echo "skipped: $1 is not version $wanted"
        exit 77
    fi
}
