#!/usr/bin/env bash
# Builds nullscope for arm64 and tests it under qemu: contract and unit tests, rays against the vectors of 50 digits, hard cases; a dozen pictures,
# drawn there and here (build/release), and compared; the places of llvmpipe's rays there against the reference there.
#
#   scripts/arm64.sh [STEP...]      STEP: build, contract, unit, vectors, hard, pictures, positions; all of them by default
#
# Without `nullscope fit`: LAPACK, which Ceres Solver needs, is found by links that hold in a system that runs alone.
# A Debian of arm64 is put into build/arm64/root, of which nothing is run but libraries; the compiler is this machine's. It needs the packages
# mmdebstrap, qemu-user-static and crossbuild-essential-arm64: where one is missing, or the root cannot be fetched, a line says so and the
# status is 0. Some 25 core-minutes to build, 20 to test.
set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder=$repository/build/arm64
case "${1-}" in -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;; esac
say() { echo "arm64: $*" >&2; }
skip() { say "left out: $*"; exit 0; }
wanted() { [[ ${#steps[@]} -eq 0 || " ${steps[*]} " == *" $1 "* ]]; }
steps=("$@")

for tool in mmdebstrap qemu-aarch64-static aarch64-linux-gnu-g++; do
    command -v "$tool" >/dev/null || skip "$tool is not installed: apt install mmdebstrap qemu-user-static crossbuild-essential-arm64"
done
export NULLSCOPE_ARM64_ROOT=$folder/root QEMU_LD_PREFIX=$folder/root
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
mkdir -p "$folder"
if [[ ! -e $folder/root.whole ]]; then
    # Those of the first table of versions.md, without the viewer's and the generator of glad, which is this machine's.
    linked=$(awk -F'|' '/^Opened or called/ { exit } /^\| [a-z]/ && !/^\| package/ { sub(/\(.*/, "", $2); gsub(/[, ]+/, " ", $2); print $2 }' \
             "$repository/third_party/versions.md" | tr ' ' '\n' | grep -v -e '^$' -e python3-glad -e libglfw3 -e libimgui)
    packages=$(printf '%s,' $linked)libstdc++-12-dev,libegl1,libgl1,libgl1-mesa-dri,libosmesa6,fonts-dejavu-core
    say "a root of $suite"
    rm -rf --one-file-system "$folder/root"
    mmdebstrap --variant=extract --architectures=arm64 --include="$packages" "$suite" "$folder/root" "${MIRROR:-http://deb.debian.org/debian}" \
        >"$folder/root.log" 2>&1 || { tail -n 5 "$folder/root.log" >&2; skip "the packages of arm64 cannot be had"; }
    touch "$folder/root.whole"
fi

if wanted build; then
    say "building"
    export PKG_CONFIG_SYSROOT_DIR=$folder/root
    export PKG_CONFIG_LIBDIR=$folder/root/usr/lib/aarch64-linux-gnu/pkgconfig:$folder/root/usr/share/pkgconfig
    cmake -G Ninja -S "$repository" -B "$folder/build" --toolchain "$repository/scripts/arm64.cmake" -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG" -DNULLSCOPE_UNITY=ON -DNULLSCOPE_VIEWER=OFF -DNULLSCOPE_FIT=OFF >"$folder/configure.log"
    cmake --build "$folder/build" --target nullscope contract_tests unit_tests
fi

bin=$folder/build/bin there=$folder/nullscope
printf '#!/bin/sh\nexec qemu-aarch64-static -L %s %s "$@"\n' "$folder/root" "$bin/nullscope" >"$there"
chmod +x "$there"
cd "$repository"
! wanted contract || { say "contract tests"; qemu-aarch64-static "$bin/contract_tests"; }
! wanted unit || { say "unit tests"; qemu-aarch64-static "$bin/unit_tests" -tce="*within the time that is promised*"; }   # of a machine, not of qemu
! wanted vectors || { say "vectors"; python3 -B tests/cli/test_trace.py "$there" Reference.test_vectors; }
! wanted hard || { say "hard cases"; "$there" bench hard --json "$folder/hard.json"; }
if wanted pictures; then
    here=$repository/build/release/bin/nullscope
    mkdir -p "$folder/there" "$folder/here"
    for scene in first-light kerr accretion soft-disc wormhole zoom hot-spot luminet m87 sky-grid plunge saturn; do
        "$there" capture "$scene" --size 160x90 -o "$folder/there/$scene.png" >/dev/null
        "$here" capture "$scene" --size 160x90 -o "$folder/here/$scene.png" >/dev/null
        printf '%-12s ' "$scene"
        "$here" compare "$folder/there/$scene.png" "$folder/here/$scene.png" | grep '^difference'
    done
fi
! wanted positions || { say "positions"; "$there" devices --measure first-light kerr wormhole zoom --size 96x54 --device 0 --limit 600; }
