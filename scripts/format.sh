#!/usr/bin/env bash
# Formats the C++ sources in place by .clang-format, or with --check lists the files that differ and exits 1.
# Name files to treat only those.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
check=no
case "${1-}" in
    --check) check=yes; shift ;;
    -h | --help) echo "Usage: scripts/format.sh [--check] [FILE...]"; exit 0 ;;
esac
if ! command -v clang-format >/dev/null; then
    echo "format: clang-format is not installed (apt-get install clang-format); nothing was looked at" >&2
    exit 1
fi

if [[ $# -gt 0 ]]; then
    files=("$@")
else
    mapfile -t files < <(find "$root/src" "$root/tests" "$root/web" -name '*.h' -o -name '*.cpp' | sort)
fi

if [[ $check == no ]]; then
    clang-format -i "${files[@]}"
    exit
fi
# As many files a process as one takes: --Werror names those that differ, one warning for each.
said=$(printf '%s\0' "${files[@]}" | xargs -0 -n 40 -P 2 clang-format --dry-run --Werror 2>&1) && status=0 || status=$?
differing=$(sed -n 's/^\(.*\):[0-9]*:[0-9]*: error: code should be clang-formatted.*/\1/p' <<<"$said" | sort -u)
[[ -z $differing ]] || sed "s|^$root/||" <<<"$differing"
[[ $status -eq 0 || -n $differing ]] || { echo "format: clang-format failed: $said" >&2; exit 1; }
echo "format: $(grep -c . <<<"$differing" || true) of ${#files[@]} files differ from .clang-format" >&2
[[ -z $differing ]]
