#!/usr/bin/env bash
# Builds the fuzzers (preset fuzz; needs clang with its compiler-rt) and lets them look for inputs that break a reader.
#
#   scripts/fuzz.sh [--keep] [TARGET] [SECONDS]
#
#   TARGET    scene, tour, picture, exr, film, texts, rays, words, formula, warp, medium, fits, stations (tests/fuzz/TARGET.cpp), or all (the default), one after the other
#   SECONDS   how long each target runs (default 60)
#   --keep    afterwards add what reached new code to tests/fuzz/corpus/TARGET, the least files that do
#
# Ends with 0 if nothing broke. What broke is in build/fuzz/findings/TARGET: a crash-..., timeout-... or oom-... file.
# Run it again with build/fuzz/bin/fuzz_TARGET FILE; make it smaller with -minimize_crash=1 -runs=10000; once mended, put it
# into tests/fuzz/corpus/TARGET under a name that says what it was: ctest -L fuzz replays that folder in every build.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
targets=(scene tour picture exr film texts rays words formula warp medium fits stations)
fail() { echo "fuzz: $*" >&2; exit 2; }

keep=no
case "${1-}" in
    -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;;
    --keep) keep=yes; shift ;;
esac
[[ $# -le 2 ]] || fail "too many arguments; see --help"
target=${1:-all} seconds=${2:-60}
[[ $seconds =~ ^[1-9][0-9]*$ ]] || fail "$seconds: not a number of seconds"
if [[ $target != all ]]; then
    [[ " ${targets[*]} " == *" $target "* ]] || fail "$target: no such target; allowed: all ${targets[*]}"
    targets=("$target")
fi
command -v clang++ >/dev/null || fail "clang++ is not installed (Debian and Ubuntu: apt install clang libclang-rt-dev)"

"$root/scripts/install-packages.sh" --quiet
build=$root/build/fuzz
[[ -e $build/build.ninja ]] || (cd "$root" && cmake --preset fuzz >&2)
cmake --build "$build" --target "${targets[@]/#/fuzz_}" >&2

export ASAN_OPTIONS=quarantine_size_mb=64${ASAN_OPTIONS:+:$ASAN_OPTIONS}   # freed pictures would count against the limit
broken=0
for target in "${targets[@]}"; do
    corpus=$root/tests/fuzz/corpus/$target grown=$build/corpus/$target findings=$build/findings/$target
    mkdir -p "$grown" "$findings"
    options=(-rss_limit_mb=2048 -timeout=10 -artifact_prefix="$findings/")
    dictionary=$root/tests/fuzz/$target.dict
    [[ ! -e $dictionary ]] || options+=(-dict="$dictionary")
    echo "fuzz: $target for $seconds s" >&2
    "$build/bin/fuzz_$target" "${options[@]}" -max_total_time="$seconds" -print_final_stats=1 "$grown" "$corpus" \
        >"$findings/log" 2>&1 || broken=$((broken + 1))
    awk -v t="$target" '/^stat::number_of_executed_units/ { n = $2 } / cov: / { c = $4 }
        END { printf "%-8s %12d executions, %d edges covered\n", t, n, c }' "$findings/log"
    find "$findings" -type f ! -name log -printf "$target: broken by %p\n"
    if [[ $keep == yes ]]; then "$build/bin/fuzz_$target" -set_cover_merge=1 -use_counters=0 "$corpus" "$grown" >>"$findings/log" 2>&1; fi
done
[[ $broken -eq 0 ]]
