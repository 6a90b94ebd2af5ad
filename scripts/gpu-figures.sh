#!/usr/bin/env bash
# Measures this machine's GPU and writes docs/gpu/NAME.md: time of a frame of every built-in scene at 720p, 1080p, 4K and 8K by timer
# queries, rays a second, tables and upload, errors against the reference, golden pictures. Some minutes on a GPU.
#
#   scripts/gpu-figures.sh NAME [OPTION...]      scripts/gpu-figures.sh --help lists the options
#   scripts/gpu-figures.sh h200
#   scripts/gpu-figures.sh trial --sizes 320x180 --scenes sky-only first-light --only horizon
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case "${1-}" in
    "") sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
    -h | --help) exec python3 -B "$root/scripts/gpu_figures.py" --help ;;
esac
"$root/scripts/build.sh" nullscope golden_tests
exec python3 -B "$root/scripts/gpu_figures.py" "$@"
