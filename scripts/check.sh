#!/usr/bin/env bash
# Builds the tree in other ways, runs what that can show, and reads the sources. scripts/test.sh --all ends with it.
#
#   scripts/check.sh           all of them
#   scripts/check.sh NAME...   only these:
#     sanitize   clang, address and undefined-behaviour sanitizers, no precompiled headers: both programs, unit and contract
#                tests, replay of the fuzz corpora
#     headless   without a window system: nullscope is built and draws a picture
#     format     scripts/format.sh --check
#     tidy       clang-tidy on src/ and what of web/ this machine compiles too, by the commands of the sanitizers' build
#
# NULLSCOPE_TIMES=FILE adds what each took to FILE (tests/measured.py).
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
times=${NULLSCOPE_TIMES:-$root/build/check-times.tsv}
case "${1-}" in -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;; esac
[[ $# -gt 0 ]] || set -- sanitize headless format tidy

sanitize() { "$root/scripts/sanitize.sh" --build-programs; }

headless() {
    cd "$root"
    cmake --preset headless >/dev/null
    cmake --build build/headless --target nullscope >&2
    env -u DISPLAY -u WAYLAND_DISPLAY build/headless/bin/nullscope capture first-light --size 64x36 -o build/headless/picture.png
}

format() { "$root/scripts/format.sh" --check; }

# The sanitizers' build has clang's own commands, without precompiled headers.
tidy() {
    cd "$root"
    [[ -e build/sanitize/compile_commands.json ]] || cmake --preset sanitize >/dev/null
    cmake --build build/sanitize --target nullscope_shaderlib nullscope_core_texts >&2   # makes the embedded shaders and the core's text
    run-clang-tidy -quiet -p build/sanitize "$root/(src|web)/.*" 2>/dev/null | sed 's/\x1b\[[0-9;]*m//g' >build/tidy.log || true
    [[ -s build/tidy.log ]] || { echo "check: clang-tidy said nothing at all" >&2; return 1; }   # not even what it looks at
    ! grep -E '(warning|error):' build/tidy.log | sort -u >&2
}

if [[ ${NULLSCOPE_CHECK-} == inside ]]; then
    "$1"
    exit
fi
"$root/scripts/install-packages.sh" --quiet --checks
status=0
for name in "$@"; do
    declare -F "$name" >/dev/null || { echo "check: no check named $name; allowed: sanitize headless format tidy" >&2; exit 2; }
    echo "check: $name" >&2
    if NULLSCOPE_CHECK=inside python3 -B "$root/tests/measured.py" "$times" "check: $name" "$root/scripts/check.sh" "$name"; then
        echo "check: $name passed" >&2
    else
        echo "check: $name FAILED" >&2
        status=1
    fi
done
exit "$status"
