#!/usr/bin/env bash
# From a fresh clone to a black hole on the screen: installs, builds and starts the viewer, or renders a picture to a file
# where there is no display. See --help.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
bin=$root/build/release/bin

usage() {
    cat <<'END'
Usage: scripts/run.sh [SCENE] [VIEWER OPTION...]

Installs the packages that are missing (apt), builds nullscope and shows SCENE.
SCENE is a scene file or the name of a built-in scene (default: the gallery of all of them, or without a display first-light).

With a display a window opens. Without one the picture is written to out/SCENE.png in the source tree.

  scripts/run.sh                                the gallery
  scripts/run.sh my-scene.toml                  a scene of your own; the shortest has two lines:
                                                    [spacetime]
                                                    metric = "schwarzschild"
  scripts/run.sh first-light --size 1920x1080   viewer options follow the scene
  build/release/bin/nullscope scenes            lists the built-in scenes
  build/release/bin/nullscope-viewer --help     lists the viewer's options

The first call takes minutes, for the packages and the compiler; later calls take seconds.
END
}

fail() { echo "run: $*" >&2; exit 1; }

case "${1-}" in -h | --help) usage; exit 0 ;; esac
scene=first-light gallery=()
[[ $# -gt 0 ]] || gallery=(--gallery)
if [[ $# -gt 0 && $1 != -* ]]; then
    scene=$1
    shift
fi

"$root/scripts/build.sh" nullscope nullscope-viewer

# The way out without a display: the same renderer into a file. Of the viewer's options, size and file name carry over.
capture() {
    local name size=() picture
    name=$(basename "$scene" .toml)
    picture=$root/out/$name.png
    while [[ $# -gt 0 ]]; do
        case $1 in
            --size) size=(--size "${2-}") ;;
            --size=*) size=(--size "${1#*=}") ;;
            --screenshot) picture=${2-} ;;
            --screenshot=*) picture=${1#*=} ;;
        esac
        shift
    done
    mkdir -p "$(dirname "$picture")"
    "$bin/nullscope" capture "$scene" -o "$picture" ${size[@]+"${size[@]}"} || fail "$scene could not be rendered"
    echo "There is no display here, so the picture of $name was written to $picture."
}

if [[ -z ${DISPLAY-} && -z ${WAYLAND_DISPLAY-} ]]; then
    capture "$@"
    exit
fi

[[ -x $bin/nullscope-viewer ]] || fail "there is no viewer in build/release (it was configured with NULLSCOPE_VIEWER=OFF)"
errors=$(mktemp "${TMPDIR:-/tmp}/nullscope-run.XXXXXX")
trap 'rm -f "$errors"' EXIT
status=0
{ "$bin/nullscope-viewer" "$scene" ${gallery[@]+"${gallery[@]}"} "$@" 2>&1 1>&3 | tee "$errors" >&2; } 3>&1 || status=$?
# A DISPLAY that nobody serves (a closed remote session, say) counts as none.
if [[ $status -eq 1 ]] && grep -qi 'display' "$errors"; then
    capture "$@"
    exit
fi
exit "$status"
