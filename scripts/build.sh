#!/usr/bin/env bash
# Installs what is missing, configures once and builds build/release. run.sh and test.sh begin with this.
#
#   scripts/build.sh             builds everything
#   scripts/build.sh TARGET...   only these: scripts/build.sh nullscope nullscope-viewer
#   scripts/build.sh --configure builds nothing
#
# When nothing has changed it takes about a second. CMAKE_BUILD_PARALLEL_LEVEL limits the number of compilers.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release
fail() { echo "build: $*" >&2; exit 1; }
case "${1-}" in -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;; esac

"$root/scripts/install-packages.sh" --quiet

# A build folder remembers where its sources were: one that came along with a moved or copied tree starts afresh.
if [[ ! -e $build/build.ninja ]] || ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; then
    echo "build: configuring in build/release; the first build takes minutes, and one that is stopped goes on with the next call" >&2
    mkdir -p "$build"
    if ! (cd "$root" && cmake --fresh --preset release) >"$build/configure.log" 2>&1; then
        tail -n 30 "$build/configure.log" >&2
        fail "configuring failed; its last lines are above, all of them in build/release/configure.log"
    fi
fi

if [[ ${1-} == --configure ]]; then exec cmake --build "$build" --target build.ninja >&2; fi
targets=()
[[ $# -eq 0 ]] || targets=(--target "$@")
cmake --build "$build" ${targets[@]+"${targets[@]}"} >&2 || fail "the build failed; the compiler's message is above"
