#!/usr/bin/env bash
# Builds with clang and the address, undefined-behaviour and leak sanitizers (preset sanitize) and runs tests under them.
#
#   scripts/sanitize.sh                  the short check: unit, contract and fuzz
#   scripts/sanitize.sh CTEST OPTION...  a full build and other tests: scripts/sanitize.sh -L 'unit|cli|gpu'
#
# Leaks inside drivers are passed over by tests/leaks.supp, which says why.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case "${1-}" in -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;; esac

"$root/scripts/install-packages.sh" --quiet --checks
cd "$root"
[[ -e build/sanitize/build.ninja ]] || cmake --preset sanitize >&2
targets=()
if [[ $# -eq 0 ]]; then
    targets=(--target unit_tests contract_tests fuzz_scene fuzz_tour fuzz_picture fuzz_exr fuzz_film fuzz_texts fuzz_rays fuzz_words fuzz_formula fuzz_warp fuzz_medium fuzz_fits fuzz_stations)
    set -- -R '^(whole: (unit|contract)$|fuzz:)'
fi
cmake --build build/sanitize ${targets[@]+"${targets[@]}"} >&2
export MESA_SHADER_CACHE_DISABLE=true
exec ctest --preset sanitize --no-tests=error -j "${CTEST_PARALLEL_LEVEL:-2}" "$@"
