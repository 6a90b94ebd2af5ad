#!/usr/bin/env bash
# Draws the figures of the documentation, docs/figures and those of the pages about accuracy, with the programs of build/release. The
# gallery's pictures: scripts/gallery.py. Diagrams of measurements, docs/accuracy*.svg: nullscope bench accuracy (docs/accuracy.md).
#
#   scripts/figures.sh            all of them (some 40 core-seconds)
#   scripts/figures.sh NAME...    only these: scripts/figures.sh size ring
#
# Needs ffmpeg, which puts pictures side by side.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case "${1-}" in -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;; esac
wanted=" $* "
nullscope=$root/build/release/bin/nullscope
docs=$root/docs
work=$(mktemp -d "${TMPDIR:-/tmp}/nullscope-figures.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work"

is_wanted() { [[ $wanted == "  " || $wanted == *" $1 "* ]]; }
# drawn FILE COMMAND...: a figure, if it is asked for
drawn() {
    local name=${1##*/}
    is_wanted "${name%.*}" || return 0
    echo "figures: $1" >&2
    "${@:2}" >/dev/null
}
picture() { "$nullscope" capture "$2" --size "$3" --samples 2 --quality 88 "${@:4}" -o "$docs/$1"; }
# One above or beside the other
joined() { ffmpeg -loglevel error -y "${@:3}" -filter_complex "$2" "$docs/$1" </dev/null; }
# block PAGE FILE: the scene that a page writes into that file
block() { sed -n "/^cat > $2 <<'END'\$/,/^END\$/p" "$docs/$1" | sed '1d;$d' >"$2"; }

drawn accretion.png "$nullscope" capture accretion --size 1280x720 -o "$docs/accretion.png"
gallery() {
    local scene
    for scene in kerr luminet sky-grid both-sides; do "$nullscope" capture "$scene" --size 320x180 --samples 2 -o "$scene.png"; done
    joined gallery.png hstack=4 -i kerr.png -i luminet.png -i sky-grid.png -i both-sides.png
}
drawn gallery.png gallery
# The edge of first-light's shadow from 20 degrees, one ray a pixel and by coverage, enlarged twice.
thin_ring() {
    "$nullscope" scenes first-light | sed -e 's/^theta = .*/theta = 20/' -e 's/^fov = .*/fov = 6\nyaw = -4.6\npitch = 4.6/' -e '/^roll/d' >ring.toml
    "$nullscope" capture ring.toml --size 200x150 --renderer reference --samples 1 -o centres.png
    "$nullscope" capture ring.toml --size 200x150 -o coverage.png
    joined thin-ring.png "hstack=2,scale=iw*2:ih*2:flags=neighbor" -i centres.png -i coverage.png
}
drawn thin-ring.png thin_ring
drawn bending.svg "$nullscope" figure bending -o "$docs/bending.svg"
drawn ray-types.svg "$nullscope" figure ray-types -o "$docs/ray-types.svg"

# docs/tutorial.md
drawn figures/first-light.jpg picture figures/first-light.jpg first-light 960x540
mine() {
    "$nullscope" scenes first-light | sed -e 's/^theta = .*/theta = 60/' -e 's/^r = .*/r = 15/' >mine.toml
    picture figures/mine.jpg mine.toml 960x540
}
drawn figures/mine.jpg mine
# docs/lesson.md
size() {
    "$nullscope" scenes sky-grid >grid.toml
    { cat grid.toml; printf '\n[light]\nlensing = "off"\n'; } >straight.toml
    picture figures/size.jpg straight.toml 960x360 --split grid.toml
}
drawn figures/size.jpg size
drawn figures/ring.jpg picture figures/ring.jpg einstein-ring 960x540
drawn figures/isoradials.svg "$nullscope" figure isoradials -o "$docs/figures/isoradials.svg"
doppler() {
    "$nullscope" scenes luminet | sed 's/^\[light\]/[light]\ndoppler = "off"/' >still.toml
    picture figures/doppler.jpg luminet 960x360 --split still.toml
}
drawn figures/doppler.jpg doppler
drawn figures/inside.jpg picture figures/inside.jpg inside-the-hole 960x540
drawn figures/swirl.jpg picture figures/swirl.jpg m87-swirl 960x540
flare() {
    "$nullscope" lightcurve sgr-a-flare --size 128x72 -o flare
    sed '/^<metadata/,/^<\/metadata>/d' flare.svg >"$docs/figures/flare.svg"   # what it was made from is above
}
drawn figures/flare.svg flare
# docs/paper.md, dome.md, own-metric.md, own-effect.md
drawn figures/m87.jpg picture figures/m87.jpg m87 960x540
drawn figures/dome.jpg picture figures/dome.jpg dome 640x640
own_metric() { block own-metric.md bardeen.toml; picture figures/own-metric.jpg bardeen.toml 960x540; }
drawn figures/own-metric.jpg own_metric
own_effect() { block own-effect.md rings.toml; picture figures/own-effect.jpg rings.toml 960x540; }
drawn figures/own-effect.jpg own_effect
