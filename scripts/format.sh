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
differing=0
for file in "${files[@]}"; do
    if ! clang-format "$file" | cmp -s - "$file"; then
        echo "${file#"$root"/}"
        differing=$((differing + 1))
    fi
done
echo "format: $differing of ${#files[@]} files differ from .clang-format" >&2
[[ $differing -eq 0 ]]
