#!/usr/bin/env bash
# Makes all that is given to others, from a clone of the current HEAD, in a folder: a Debian package for each suite, built on a bare
# system of that suite; the archive for other distributions, from the first suite, so that it runs on that one and on newer ones; the
# archive for Windows, where mingw-w64 is installed (scripts/windows.sh, which says what is missing); the Debian package for arm64, of this
# machine's suite, where a cross compiler and qemu are (scripts/arm64.sh, likewise); the documentation as a site; the sources; SHA256SUMS.
#
#   scripts/release.sh [--web] [--try] [--suites "bookworm trixie"] [FOLDER]      FOLDER: default out/release
#
#   --web    also the page for browsers (scripts/web.sh), built here
#   --try    installs each package on another bare system and uses it (scripts/try-package.sh; Windows' archive: scripts/windows.sh --test)
#
#   RELEASE_CCACHE=DIR   keeps each suite's compiler cache there from one call to the next
#
# Needs root and debootstrap (scripts/fresh-root.sh). With nothing cached a suite takes some 10 minutes on two cores.
set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
say() { echo "release: $*" >&2; }
fail() { say "$@"; exit 1; }
source "$repository/scripts/fresh-root.sh"

web=no try=no suites="bookworm trixie" out=$repository/out/release
while [[ $# -gt 0 ]]; do
    case $1 in
        --web) web=yes ;;
        --try) try=yes ;;
        --suites) shift; suites=${1?"--suites needs names"} ;;
        -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;;
        -*) fail "unknown option $1; see --help" ;;
        *) out=$1 ;;
    esac
    shift
done

[[ -z $(git -C "$repository" status --porcelain) ]] || fail "there are changes that are not committed"
mkdir -p "$out"
out=$(cd "$out" && pwd)
version=$(sed -n 's/^project(nullscope VERSION \([0-9.]*\).*/\1/p' "$repository/CMakeLists.txt")
commit=$(git -C "$repository" rev-parse HEAD)   # of all packages, whatever is committed meanwhile
epoch=$(git -C "$repository" log -1 --format=%ct "$commit")   # of every date in a package
rm -f "$out"/nullscope*"$version"* "$out/SHA256SUMS"
say "nullscope $version ($(git -C "$repository" rev-parse --short=12 HEAD))"

# In the root: /nullscope becomes /nullscope/out. Its tests have run elsewhere.
build='set -e
cd /nullscope
scripts/install-packages.sh --package
cmake --preset release -DNULLSCOPE_TESTS=OFF >/dev/null
cmake --build --preset release
cpack --config build/release/CPackConfig.cmake -B out
rm -r out/_CPack_Packages
lintian --allow-root -I --suppress-tags unused-override --fail-on error,warning,info out/*.deb   # one list of overrides for all suites
[ "$1" = no ] || cmake -DBUILD=build/release -DOUT=out -P packaging/archive.cmake'

clone_into() { git clone --quiet --no-hardlinks "$repository" "$1" && git -C "$1" checkout --quiet --detach "$commit"; }

build_suite() { # SUITE ARCHIVE(yes|no)
    clone_into "$fresh/nullscope"
    if [[ -n ${RELEASE_CCACHE-} && -d $RELEASE_CCACHE/$1 ]]; then cp -a "$RELEASE_CCACHE/$1" "$fresh/ccache"; fi
    local result=0
    inside env CCACHE_DIR=/ccache CCACHE_BASEDIR=/nullscope CCACHE_NOHASHDIR=1 SOURCE_DATE_EPOCH="$epoch" sh -c "$build" build "$2" \
        >"$out/$1.log" 2>&1 || result=$?
    if [[ -n ${RELEASE_CCACHE-} && -d $fresh/ccache ]]; then
        mkdir -p "$RELEASE_CCACHE"
        rm -rf "${RELEASE_CCACHE:?}/$1"
        cp -a "$fresh/ccache" "$RELEASE_CCACHE/$1"
    fi
    [[ $result -eq 0 ]] || { tail -n 30 "$out/$1.log" >&2; return 1; }
    cp "$fresh"/nullscope/out/nullscope* "$out/"
    rm -f "$out/$1.log"
}

archive=yes
for suite in $suites; do
    timed "a bare $suite" make_root "$suite" git
    timed "packages of $suite" build_suite "$suite" "$archive"
    remove_root
    archive=no
done

source_tree=$(mktemp -d "${TMPDIR:-/tmp}/nullscope-release.XXXXXX")
trap 'rm -rf "$source_tree"' EXIT
clone_into "$source_tree/nullscope"
git -C "$repository" archive --prefix="nullscope-$version/" -o "$out/nullscope-$version-source.tar.gz" "$commit"

# of_folder NAME FOLDER: as an archive
of_folder() { tar --sort=name --mtime="@$epoch" --owner=0 --group=0 --numeric-owner -czf "$out/nullscope-$version-$1.tar.gz" -C "$2" --transform "s,^\.,nullscope-$version-$1," .; }
timed "the documentation" "$source_tree/nullscope/scripts/docs.sh"
of_folder docs "$source_tree/nullscope/build/site"
if [[ $web == yes ]]; then
    timed "the page for browsers" "$source_tree/nullscope/scripts/web.sh"
    of_folder web "$source_tree/nullscope/build/web/page"
fi
timed "the archive for Windows" env SOURCE_DATE_EPOCH="$epoch" "$source_tree/nullscope/scripts/windows.sh" --libraries --build --zip
for made in "$source_tree"/nullscope/build/windows/nullscope-*.zip; do
    if [[ -e $made ]]; then cp "$made" "$out"; else say "no archive for Windows, see above"; fi
done
timed "the package for arm64" env SOURCE_DATE_EPOCH="$epoch" "$source_tree/nullscope/scripts/arm64.sh" build deb
for made in "$source_tree"/nullscope/build/arm64/package/*.deb; do
    if [[ -e $made ]]; then cp "$made" "$out"; else say "no package for arm64, see above"; fi
done
(cd "$out" && sha256sum nullscope*"$version"* >SHA256SUMS)

if [[ $try == yes ]]; then
    for suite in $suites; do
        number=$(sed -n "s/^$suite //p" <<<$'bookworm deb12\ntrixie deb13')
        "$repository/scripts/try-package.sh" "$suite" "$out"/nullscope_"$version"-*~"$number"_"$(dpkg --print-architecture)".deb
        "$repository/scripts/try-package.sh" "$suite" "$out/nullscope-$version-linux-$(uname -m).tar.gz"
    done
fi
printf '%s\n' "nullscope $version, $(nproc) cores:" "${report[@]}"
ls -l "$out"
