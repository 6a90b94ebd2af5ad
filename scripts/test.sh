#!/usr/bin/env bash
# Installs what is missing, builds what the tests need, and runs them.
#
#   scripts/test.sh                  what every change must pass: each promise on the cases that show its breach
#   scripts/test.sh --all            the same promises on every case and driver, then scripts/check.sh: what CI runs
#   scripts/test.sh CTEST OPTION...  single tests of the quick depth:
#       -L unit          those of one label (unit, contract, layering, recipes, gpu, golden, proof, cli, fuzz, viewer, web, python)
#       -R photon -V     those whose name matches, with all their output
#
# The first two end with a table of what was built and tested, in processor seconds, and fail when a sum is over its
# budget in tests/budget.csv (times the slowness of this machine, tests/machine.py).
# NULLSCOPE_TESTS=all scripts/test.sh -R NAME runs a single test at the depth of --all.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release
times=$build/reports/times.tsv
case "${1-}" in -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;; esac

# What each label's tests need; drawing tests have one executable a folder, those of programs run the program.
targets_of() {
    case $1 in
        unit | contract | gpu | golden) echo "$1_tests" ;;
        proof) echo proof_tests nullscope ;;
        cli) echo nullscope ;;
        viewer) echo viewer_tests nullscope-viewer ;;
        web) echo nullscope native_answers ;;   # and the page: scripts/web.sh
        fuzz) echo fuzz_scene fuzz_tour fuzz_picture fuzz_exr fuzz_rays fuzz_words fuzz_formula fuzz_warp fuzz_medium ;;
        layering | recipes | python) echo nullscope ;;   # so that the build folder exists
        *) echo all ;;
    esac
}

run_ctest() { ctest --test-dir "$build" --output-on-failure --no-tests=error -j "${CTEST_PARALLEL_LEVEL:-2}" "$@"; }

# Adds the cost of a command to the table.
measured() { python3 -B "$root/tests/measured.py" "$times" "$@"; }

if [[ $# -gt 0 && $1 != --all ]]; then
    label=all
    for ((i = 1; i < $#; ++i)); do
        next=$((i + 1))
        [[ ${!i} != -L ]] || label=${!next}
    done
    # shellcheck disable=SC2046   # several targets
    "$root/scripts/build.sh" $(targets_of "$label")
    run_ctest "$@"
    exit
fi

tier=quick packages=() web=()
[[ $# -eq 0 ]] || tier=all packages=(--all --web) web=(web)
rm -f "$times" "$build/reports/cases.tsv"
"$root/scripts/install-packages.sh" --quiet ${packages[@]+"${packages[@]}"}
measured "programs: both" "$root/scripts/build.sh" nullscope nullscope-viewer
targets=$(for label in unit contract gpu golden proof fuzz viewer ${web[@]+"${web[@]}"}; do targets_of "$label"; done)
# shellcheck disable=SC2086
measured "build: tests" "$root/scripts/build.sh" $targets
if [[ $tier == all ]]; then
    measured "web: page" "$root/scripts/web.sh"
    export MESA_SHADER_CACHE_DISABLE=true
fi
status=0
NULLSCOPE_TESTS=$tier run_ctest -L '^tier$' || status=$?
if [[ $tier == all && $status -eq 0 ]]; then
    NULLSCOPE_TIMES=$times "$root/scripts/check.sh" || status=$?
fi
python3 -B "$root/tests/budget.py" "$times" "$tier" || [[ $status -ne 0 ]] || status=1
exit "$status"
