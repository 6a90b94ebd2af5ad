#!/usr/bin/env bash
# Installs what is missing, builds what the tests need, and runs them.
#
#   scripts/test.sh                  what every change must pass: each promise on the cases that show its breach; of costly cases an eighth
#   scripts/test.sh --turn           the same, and an eighth of what --all measures beyond it, with its
#                                    checks: what CI runs. tests/turn.py says which, by the number in .ci/turn; eight turns in a row are --all
#   scripts/test.sh --all            the same promises on every case and driver, the page, the Python package, scripts/check.sh
#   scripts/test.sh CTEST OPTION...  single tests of the quick depth:
#       -L unit          those of one label (unit, contract, layering, recipes, gpu, golden, proof, cli, fuzz, viewer, web, python, interop)
#       -R photon -V     those whose name matches, with all their output
#
# The first three begin with what takes seconds (format, layering, clang-tidy on changed files) and stop there if it fails. They end
# with a table of what was built and tested, in base seconds (processor seconds over the slowness of this machine, tests/machine.py),
# which fails when a sum is over its budget in tests/budget.csv, and with the command that repeats a failure.
# NULLSCOPE_TURN=n runs another turn, NULLSCOPE_RUN=n repeats the random tests of a run; those of tests/proof have a fixed seed, and others
# with NULLSCOPE_SEED=n. NULLSCOPE_TESTS=all scripts/test.sh -R NAME runs a single test at the depth of --all.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release
reports=$build/reports times=$build/reports/times.tsv
case "${1-}" in -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;; esac

# What each label's tests need; drawing tests have one executable a folder, those of programs run the program.
targets_of() {
    case $1 in
        unit | contract | gpu | golden) echo "$1_tests" ;;
        proof) echo proof_tests nullscope ;;
        cli) echo nullscope ;;
        viewer) echo viewer_tests nullscope-viewer ;;
        web) echo nullscope native_answers ;;   # and the page: scripts/web.sh
        fuzz) echo fuzz_scene fuzz_tour fuzz_picture fuzz_exr fuzz_film fuzz_texts fuzz_rays fuzz_words fuzz_formula fuzz_warp fuzz_medium fuzz_fits fuzz_stations ;;
        layering | recipes | python | interop) echo nullscope ;;   # so that the build folder exists
        *) echo all ;;
    esac
}

run_ctest() { ctest --test-dir "$build" --output-on-failure --no-tests=error -j "${CTEST_PARALLEL_LEVEL:-2}" "$@"; }

# Adds the cost of a command to the table.
measured() { python3 -B "$root/tests/measured.py" "$times" "$@"; }

if [[ $# -gt 0 && $1 != --all && $1 != --turn ]]; then
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

tier=quick tests=quick packages=() web=() checks=() since=HEAD
export NULLSCOPE_RUN=${NULLSCOPE_RUN:-$(date +%s)}   # what random tests begin from: others in each run
again="NULLSCOPE_RUN=$NULLSCOPE_RUN scripts/test.sh ${1-}"
case ${1-} in
    --all)
        tier=all tests=all packages=(--all --web --checks) web=(web) checks=(sanitize headless tidy) ;;
    --turn)
        export NULLSCOPE_TURN=${NULLSCOPE_TURN:-$(cat "$root/.ci/turn")}
        # What a submission's run found in this turn is found by the next run of this turn.
        [[ -z ${CI-} ]] || NULLSCOPE_RUN=$NULLSCOPE_TURN
        again="NULLSCOPE_TURN=$NULLSCOPE_TURN NULLSCOPE_RUN=$NULLSCOPE_RUN scripts/test.sh --turn"
        tier=turn packages=(--all --checks)
        tests=$(python3 -B "$root/tests/turn.py")
        since=$(python3 -B "$root/tests/turn.py" --base)
        [[ ,$tests != *,web/* ]] || web=(web) packages+=(--web)
        mapfile -t checks < <(tr , '\n' <<<"$tests" | sed -n 's/^check\///p') ;;
esac
failed() {
    local status=$1
    echo "test: FAILED. All of it again: $again" >&2
    if [[ -s $build/Testing/Temporary/LastTestsFailed.log && $build/Testing/Temporary/LastTestsFailed.log -nt $times.begun ]]; then
        sed 's/^[0-9]*://' "$build/Testing/Temporary/LastTestsFailed.log" |
            while read -r name; do echo "    that one: NULLSCOPE_TESTS=$tests NULLSCOPE_RUN=$NULLSCOPE_RUN scripts/test.sh -R '^$name\$'" >&2; done
    fi
    exit "$status"
}
echo "test: $again" >&2
"$root/scripts/install-packages.sh" --quiet ${packages[@]+"${packages[@]}"}
mkdir -p "$reports"
rm -f "$times" "$reports/cases.tsv"
touch "$times.begun"

# What takes seconds.
"$root/scripts/build.sh" --configure
export NULLSCOPE_TIMES=$times NULLSCOPE_SINCE=$since
early=()
command -v clang-format >/dev/null && early+=(format)
[[ $tier != turn ]] || early+=(tidy-changed)
[[ ${#early[@]} -eq 0 ]] || "$root/scripts/check.sh" "${early[@]}" || failed 1
layering=$(run_ctest -L '^layering$' 2>&1) || { echo "$layering"; failed 1; }

measured "programs: both" "$root/scripts/build.sh" nullscope nullscope-viewer || failed 1
targets=$(for label in unit contract gpu golden proof fuzz viewer ${web[@]+"${web[@]}"}; do targets_of "$label"; done)
# Without the number: doctest lists no case that is left to another run, and ctest is to know all of them.
# shellcheck disable=SC2086
measured "build: tests" env -u NULLSCOPE_RUN "$root/scripts/build.sh" $targets || failed 1
[[ ${#web[@]} -eq 0 ]] || measured "web: page" "$root/scripts/web.sh" || failed 1
[[ $tier != all ]] || export MESA_SHADER_CACHE_DISABLE=true
status=0
NULLSCOPE_TESTS=$tests run_ctest -L '^tier$' -LE '^layering$' || status=$?
if [[ ${#checks[@]} -gt 0 ]]; then "$root/scripts/check.sh" "${checks[@]}" || status=$?; fi
python3 -B "$root/tests/budget.py" "$times" "$tier" --wall "$SECONDS" || [[ $status -ne 0 ]] || status=1
[[ $status -eq 0 ]] || failed "$status"
