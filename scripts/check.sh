#!/usr/bin/env bash
# Builds the tree in other ways, runs what that can show, and reads the sources. scripts/test.sh --all runs all of it.
#
#   scripts/check.sh           all of them
#   scripts/check.sh NAME...   only these:
#     sanitize   clang, address and undefined-behaviour sanitizers, no precompiled headers: unit and contract tests, replay of
#                the fuzz corpora
#     headless   without a window system: nullscope is built and draws a picture
#     format     scripts/format.sh --check
#     tidy       scripts/tidy.py: clang-tidy on src/ and what of web/ this machine compiles too
#     tidy-changed   the same on what has changed since the commit NULLSCOPE_SINCE (default HEAD), not among "all of them"
#
# NULLSCOPE_TIMES=FILE adds what each took to FILE (tests/measured.py).
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
times=${NULLSCOPE_TIMES:-$root/build/check-times.tsv}
case "${1-}" in -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;; esac
[[ $# -gt 0 ]] || set -- format tidy sanitize headless

sanitize() { "$root/scripts/sanitize.sh"; }

headless() {
    cd "$root"
    cmake --preset headless >/dev/null
    cmake --build build/headless --target nullscope >&2
    env -u DISPLAY -u WAYLAND_DISPLAY build/headless/bin/nullscope capture first-light --size 64x36 -o build/headless/picture.png
}

format() { "$root/scripts/format.sh" --check; }

tidy() { "$root/scripts/tidy.py" --self-test && "$root/scripts/tidy.py"; }

tidy-changed() { "$root/scripts/tidy.py" --self-test && "$root/scripts/tidy.py" --since "${NULLSCOPE_SINCE:-HEAD}"; }

if [[ ${NULLSCOPE_CHECK-} == inside ]]; then
    "$1"
    exit
fi
"$root/scripts/install-packages.sh" --quiet --checks
status=0
for name in "$@"; do
    declare -F "$name" >/dev/null || { echo "check: no check named $name; allowed: format tidy tidy-changed sanitize headless" >&2; exit 2; }
    echo "check: $name" >&2
    if NULLSCOPE_CHECK=inside python3 -B "$root/tests/measured.py" "$times" "check: $name" "$root/scripts/check.sh" "$name"; then
        echo "check: $name passed" >&2
    else
        echo "check: $name FAILED" >&2
        status=1
    fi
done
exit "$status"
