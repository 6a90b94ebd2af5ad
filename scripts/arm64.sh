#!/usr/bin/env bash
# Builds nullscope for arm64, tests it under qemu, and makes its Debian package: contract and unit tests, rays against the vectors of 50 digits, hard
# cases; rays and a dozen pictures, traced and drawn there and here (build/release), and compared; the places of llvmpipe's rays there against the
# reference there; the viewer's window on a screen of its own; the package, and what it draws in a root of the packages alone that it asks for.
#
#   scripts/arm64.sh [STEP...]      STEP: build, contract, unit, vectors, hard, rays, pictures, positions, viewer, deb; all of them by default
#
# A Debian of arm64 is put into build/arm64/root, of which nothing is run but libraries; the compiler is this machine's. It needs the packages
# mmdebstrap, qemu-user-static and crossbuild-essential-arm64, for the viewer xvfb too, for the package dpkg-dev: where one is missing, or the root
# cannot be fetched, a line says so and the status is 0. Some 25 core-minutes to build, 20 to test.
set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder=$repository/build/arm64
case "${1-}" in -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;; esac
say() { echo "arm64: $*" >&2; }
skip() { say "left out: $*"; exit 0; }
emulated() { qemu-aarch64-static -L "$folder/root" "$@"; }
wanted() { [[ ${#steps[@]} -eq 0 || " ${steps[*]} " == *" $1 "* ]]; }
steps=("$@")
for step in "${steps[@]}"; do
    [[ " build contract unit vectors hard rays pictures positions viewer deb " == *" $step "* ]] || { say "unknown step $step; see --help"; exit 2; }
done

for tool in mmdebstrap qemu-aarch64-static aarch64-linux-gnu-g++; do
    command -v "$tool" >/dev/null || skip "$tool is not installed: apt install mmdebstrap qemu-user-static crossbuild-essential-arm64"
done
mirror=${MIRROR:-http://deb.debian.org/debian}

# unpack FOLDER PACKAGES SOURCE...: a root of arm64 with these packages and what they need; they stay in its cache.
unpack() {
    local root=$1 packages=$2
    shift 2
    rm -rf --one-file-system "$root"
    mmdebstrap --variant=extract --skip=cleanup/apt/cache --architectures=arm64 --include="$packages" "$suite" "$root" "$@" >"$root.log" 2>&1 ||
        { tail -n 5 "$root.log" >&2; skip "the packages of arm64 cannot be had"; }
    mend_links "$root"
}

# Links that hold only in a system that runs, so that libz.so is not found and libz.a is; and those that update-alternatives makes, as no
# script of a package has run.
mend_links() {
    local libraries=$1/usr/lib/aarch64-linux-gnu name file
    find "$1/usr/lib" "$1/lib" -type l -lname '/*' | while read -r name; do
        file=$1$(readlink "$name")
        [[ ! -e $file ]] || ln -sfnr "$file" "$name"
    done
    for name in libblas.so libblas.so.3 liblapack.so liblapack.so.3; do
        for file in "$libraries"/*/"$name"; do [[ ! -e $file ]] || ln -sfn "${file#"$libraries/"}" "$libraries/$name"; done
    done
}

# What dpkg knows of installed packages, their files where they lie here: dpkg-shlibdeps asks it.
know_packages() {
    local known=$folder/dpkg cache=$folder/root/var/cache/apt/archives deb name
    rm -rf "$known"
    mkdir -p "$known/info" "$known/updates" "$known/triggers"
    printf '%s\n' "$(dpkg --print-architecture)" arm64 >"$known/arch"
    echo 1 >"$known/info/format"
    for deb in "$cache"/*.deb; do
        rm -rf "$folder/control"
        dpkg-deb --control "$deb" "$folder/control"
        name=$(dpkg-deb --field "$deb" Package)
        [[ $(dpkg-deb --field "$deb" Multi-Arch) != same ]] || name+=:arm64
        for part in symbols shlibs; do [[ ! -e $folder/control/$part ]] || cp "$folder/control/$part" "$known/info/$name.$part"; done
        dpkg-deb --fsys-tarfile "$deb" | tar -t | sed -n 's|/$||; s|^\.|'"$folder/root"'|p' >"$known/info/$name.list"
        { sed '/^Package:/a Status: install ok unpacked' "$folder/control/control"; echo; } >>"$known/status"
    done
    rm -rf "$folder/control" "$cache"/*.deb
}

export NULLSCOPE_ARM64_ROOT=$folder/root QEMU_LD_PREFIX=$folder/root
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
mkdir -p "$folder"
if [[ ! -e $folder/root.whole ]]; then
    # Those of the first table of versions.md, without the generator of glad, which is this machine's.
    linked=$(awk -F'|' '/^Opened or called/ { exit } /^\| [a-z]/ && !/^\| package/ { sub(/\(.*/, "", $2); gsub(/[, ]+/, " ", $2); print $2 }' \
             "$repository/third_party/versions.md" | tr ' ' '\n' | grep -v -e '^$' -e python3-glad)
    packages=$(printf '%s,' $linked)libstdc++-12-dev,libegl1,libgl1,libgl1-mesa-dri,libosmesa6,fonts-dejavu-core
    say "a root of $suite"
    unpack "$folder/root" "$packages" "$mirror"
    # Names libraries where they would lie in a system that runs.
    sed -i 's|/usr/lib/aarch64-linux-gnu/|${_IMPORT_PREFIX}/lib/aarch64-linux-gnu/|g' "$folder/root/usr/lib/aarch64-linux-gnu/cmake/Ceres/CeresTargets.cmake"
    know_packages
    touch "$folder/root.whole"
fi

if wanted build; then
    say "building"
    export PKG_CONFIG_SYSROOT_DIR=$folder/root
    export PKG_CONFIG_LIBDIR=$folder/root/usr/lib/aarch64-linux-gnu/pkgconfig:$folder/root/usr/share/pkgconfig
    cmake -G Ninja -S "$repository" -B "$folder/build" --toolchain "$repository/scripts/arm64.cmake" -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG" -DNULLSCOPE_UNITY=ON >"$folder/configure.log"
    targets=(nullscope nullscope-viewer)
    ! wanted contract || targets+=(contract_tests)
    ! wanted unit || targets+=(unit_tests)
    cmake --build "$folder/build" --target "${targets[@]}"
fi

bin=$folder/build/bin there=$folder/nullscope
printf '#!/bin/sh\nexec qemu-aarch64-static -L %s %s "$@"\n' "$folder/root" "$bin/nullscope" >"$there"
chmod +x "$there"
cd "$repository"
! wanted contract || { say "contract tests"; emulated "$bin/contract_tests"; }
# Without what a machine promises, not qemu: processor time, and that it runs programs of its kind.
! wanted unit || { say "unit tests"; emulated "$bin/unit_tests" -tce="*within the time that is promised*,*takes less than 30 core-ms*,*take less than a core-second*,*cannot be run, this one is*"; }
! wanted vectors || { say "vectors"; python3 -B tests/cli/test_trace.py "$there" Reference.test_vectors; }
! wanted hard || { say "hard cases"; "$there" bench hard --json "$folder/hard.json"; }
cases=()
! wanted rays || cases+=(Rays)
! wanted pictures || cases+=(Pictures)
if [[ ${#cases[@]} -gt 0 ]]; then
    say "rays and pictures, there and here"
    here=$repository/build/release/bin/nullscope
    [[ -x $here ]] || skip "there is no $here to compare with: scripts/build.sh"
    python3 -B tests/arm64/test_arm64.py "$here" "${cases[@]}"
fi
! wanted positions || { say "positions"; "$there" devices --measure first-light kerr wormhole zoom --size 96x54 --device 0 --limit 600; }

if wanted viewer; then
    say "the viewer"
    command -v xvfb-run >/dev/null || skip "xvfb-run is not installed: apt install xvfb"
    emulated "$bin/nullscope-viewer" --version
    LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a qemu-aarch64-static -L "$folder/root" "$bin/nullscope-viewer" first-light --size 640x360 \
        --screenshot "$folder/viewer.png"
fi

if wanted deb; then
    say "the package"
    command -v dpkg-shlibdeps >/dev/null || skip "dpkg-shlibdeps is not installed: apt install dpkg-dev"
    libraries=$folder/root/usr/lib/aarch64-linux-gnu
    rm -rf "$folder/package"
    DEB_HOST_ARCH=arm64 DPKG_ADMINDIR=$folder/dpkg cpack --config "$folder/build/CPackConfig.cmake" -B "$folder/package" \
        -D CPACK_DEBIAN_PACKAGE_ARCHITECTURE=arm64 -D "CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS=$libraries;$folder/root/lib/aarch64-linux-gnu" \
        >"$folder/package.log" 2>&1 || { tail -n 20 "$folder/package.log" >&2; exit 1; }
    rm -r "$folder/package/_CPack_Packages"
    package=$(ls "$folder"/package/*.deb)
    dpkg-deb --field "$package" Package Version Architecture Depends
    # Without -I: two of the overrides are of x86-64's programs alone, and lintian says that nothing needs them.
    ! command -v lintian >/dev/null || lintian --allow-root --fail-on error,warning "$package"
    # Where nothing is but what it asks for, as apt finds it.
    (cd "$folder/package" && dpkg-scanpackages --arch arm64 . >Packages 2>/dev/null)
    unpack "$folder/bare" nullscope "deb $mirror $suite main" "deb [trusted=yes] copy:$folder/package ./"
    export QEMU_LD_PREFIX=$folder/bare
    installed() { qemu-aarch64-static -L "$folder/bare" "$folder/bare/usr/bin/$1" "${@:2}"; }
    installed nullscope --version
    installed nullscope-viewer --version
    installed nullscope capture earth --size 160x90 -o "$folder/bare.png"   # a scene, stars and an image of those that ship
    rm -r "$folder/bare/var/cache/apt" "$folder/package/Packages"
    say "${package#"$repository/"}"
fi
