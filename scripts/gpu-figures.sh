#!/usr/bin/env bash
# Measures a GPU and writes docs/gpu/NAME.md: time of a frame by timer queries, by fragment and by compute shaders, at 720p, 4K and 8K, rays a
# second, what comes before the first frame, a film, errors against the reference.
#
#   scripts/gpu-figures.sh NAME           this machine's, in eight minutes; variables: scripts/gpu_measure.sh --help
#   scripts/gpu-figures.sh NAME FOLDER    of what was measured on another machine, by what this made:
#   scripts/gpu-figures.sh --pack FOLDER  nullscope with its libraries, at most 64 MiB. There: FOLDER/measure.sh RESULTS
#
#   SIZES=320x180 SCENES="sky-only first-light" LARGE_SCENES= PICTURES= ONLY=horizon FILM_FRAMES=2 FILM_SIZE=320x180 scripts/gpu-figures.sh trial
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
fail() { echo "gpu-figures: $*" >&2; exit 1; }
most_mib=64
case "${1-}" in
    "" | -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;;
    --pack)
        folder=${2?"--pack needs a folder"}
        [[ ! -e $folder ]] || fail "$folder: is there already"
        "$root/scripts/build.sh" nullscope nullscope-viewer
        made=$(mktemp -d)
        trap 'rm -rf "$made"' EXIT
        cmake -DBUILD="$root/build/release" -DOUT="$made" -P "$root/packaging/archive.cmake"
        mkdir -p "$folder"
        tar -xzf "$made"/nullscope-*.tar.gz -C "$folder" --strip-components=1
        rm -f "$folder/bin/nullscope-viewer"
        cp "$root/scripts/gpu_measure.sh" "$folder/measure.sh"
        size=$(du -sm --apparent-size "$folder" | cut -f1)
        [[ $size -le $most_mib ]] || fail "$folder: $size MiB, allowed: $most_mib"
        echo "$folder: $size MiB" >&2
        exit ;;
esac
[[ $1 =~ ^[A-Za-z0-9_-]+$ ]] || fail "NAME: $1; letters, digits, - and _ only"   # before minutes of measuring
results=${2-}
if [[ -z $results ]]; then
    "$root/scripts/build.sh" nullscope golden_tests
    results=$root/build/gpu-$1
    PROGRAMS=$root/build/release/bin "$root/scripts/gpu_measure.sh" "$results"
fi
exec python3 -B "$root/scripts/gpu_figures.py" "$1" "$results"
