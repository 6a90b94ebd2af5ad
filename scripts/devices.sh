#!/usr/bin/env bash
# Draws seven scenes by each OpenGL driver that can be had here without a GPU, measures them against the reference and against llvmpipe's
# pictures (nullscope devices --measure), and writes the tables of docs/devices.md.
#
#   scripts/devices.sh [--keep] [DRIVER...]      DRIVER: only these; the others keep what an earlier run measured (build/devices)
#
#   LIMIT=SECONDS   after which a driver is given up in a scene (240)
#
# Drivers of this system: llvmpipe of 256, 128 and 512 bits, zink, softpipe, osmesa. Those of other suites of Debian, trixie and forky, run in
# roots of their own (scripts/fresh-root.sh: needs root and debootstrap) with the archive of packaging/archive.cmake. What cannot be had is
# left out, and a line says why. Some ten minutes.
set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
say() { echo "devices: $*" >&2; }
fail() { say "$@"; exit 1; }
source "$repository/scripts/fresh-root.sh"
read_arguments "$@"

program=$repository/build/release/bin/nullscope folder=$repository/build/devices limit=${LIMIT:-240}
[[ -x $program ]] || fail "$program is not there: scripts/build.sh"
mkdir -p "$folder"
# Mesa 22.3 keeps code that llvmpipe has compiled by the processor, not by LP_NATIVE_VECTOR_WIDTH: what was kept for vectors of 256 bits would
# be run with buffers for 128, and ends the program.
export MESA_SHADER_CACHE_DISABLE=true

# Sets $number, of the first device of this kind (egl, osmesa); the program and its environment are the words behind it.
number_of() {
    local kind=$1
    shift
    number=$("$@" devices --json 2>/dev/null | python3 -c '
import json, sys
print(next((d["number"] for d in json.load(sys.stdin) if d["kind"] == sys.argv[1] and "failure" not in d), ""))' "$kind") || number=
    [[ -n $number ]]
}

# measure NAME KIND VARIABLE=VALUE...: on this system.
measure() {
    local name=$1 kind=$2
    shift 2
    [[ ${#words[@]} -eq 0 || " ${words[*]} " == *" $name "* ]] || return 0
    rm -rf "${folder:?}/$name"
    number_of "$kind" env "$@" "$program" || { say "$name is left out: no such driver here"; return 0; }
    say "$name"
    mkdir -p "$folder/$name"
    env "$@" "$program" devices --measure --device "$number" --limit "$limit" --pictures "$folder/$name" --json >"$folder/$name/devices.json"
}

# The same in a root of this suite of Debian.
measure_in() {
    local suite=$1
    [[ ${#words[@]} -eq 0 || " ${words[*]} " == *" $suite "* ]] || return 0
    rm -rf "${folder:?}/$suite"
    [[ $EUID -eq 0 ]] && command -v debootstrap patchelf >/dev/null || { say "$suite is left out: it needs root, debootstrap and patchelf"; return 0; }
    make_root "$suite" libegl1,libgl1-mesa-dri,libfreetype6,libstdc++6 || { say "$suite is left out: its packages cannot be had"; return 0; }
    cmake -DBUILD="$repository/build/release" -DOUT="$fresh" -P "$repository/packaging/archive.cmake" 2>"$fresh.log" || { cat "$fresh.log" >&2; return 1; }
    rm -f "$fresh.log"
    tar -xzf "$fresh"/nullscope-*.tar.gz -C "$fresh/opt" --strip-components 1
    mkdir "$fresh/pictures"
    number_of egl inside /opt/bin/nullscope || { say "$suite is left out: no driver in it"; remove_root; return 0; }
    say "$suite"
    mkdir -p "$folder/$suite"
    inside /opt/bin/nullscope devices --measure --device "$number" --limit "$limit" --pictures /pictures --json >"$folder/$suite/devices.json"
    cp "$fresh"/pictures/*.png "$folder/$suite/"
    remove_root
}

measure llvmpipe-256 egl LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe LP_NATIVE_VECTOR_WIDTH=256
measure llvmpipe-128 egl LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe LP_NATIVE_VECTOR_WIDTH=128
measure llvmpipe-512 egl LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe LP_NATIVE_VECTOR_WIDTH=512
measure osmesa osmesa GALLIUM_DRIVER=llvmpipe
measure zink egl LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=zink MESA_LOADER_DRIVER_OVERRIDE=zink
measure_in trixie
measure_in forky
measure softpipe egl LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=softpipe

exec python3 -B "$repository/scripts/devices_table.py" "$program" "$folder" "$repository/docs/devices.md"
