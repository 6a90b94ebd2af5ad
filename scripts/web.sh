#!/usr/bin/env bash
# Builds the page that shows nullscope in a browser: build/web/page, a folder that any web server can serve.
#
#   scripts/web.sh                builds it; installs the packages that it needs by apt
#   scripts/web.sh --serve [PORT] and serves it to this machine, port 8000
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/web
port=
case "${1-}" in
    "") ;;
    --serve) port=${2-8000} ;;
    -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;;
    *) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
esac

"$root/scripts/install-packages.sh" --quiet --web
mkdir -p "$root/build"
cmake -S "$root/web" -B "$build" -G Ninja --toolchain "$root/web/wasm32.cmake" >"$build.log" || { cat "$build.log" >&2; exit 1; }
cmake --build "$build"
python3 -B "$root/web/assemble.py" "$build" "$build/page"
echo "the page: $build/page ($(du -sh "$build/page" | cut -f1))"
[[ -z $port ]] || exec python3 -m http.server --bind 127.0.0.1 --directory "$build/page" "$port"
