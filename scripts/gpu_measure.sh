#!/usr/bin/env bash
# Measures this machine's GPU by the programs in bin beside it, and writes what they say into a folder, for gpu-figures.sh NAME FOLDER.
# Within a limit of time: what is wanted most comes first, and what no longer fits is listed. Needs bash, and a driver with EGL.
#
#   measure.sh FOLDER
#
# Variables: LIMIT_S (480; seconds for all), SCENES, SIZES (1280x720 3840x2160), LARGE_SCENES, LARGE_SIZE (7680x4320), PICTURES (scenes compared with
# the reference), ONLY (hard cases with this text in their names), FILM (a scene), FILM_FRAMES (24), FILM_SIZE (3840x2160), FRAMES (9; of each time),
# CONTEXT (egl), PROGRAMS (bin beside this file).
set -uo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
case "${1-}" in "" | -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 2 ;; esac
mkdir -p "$1"
out=$(cd "$1" && pwd)
programs=${PROGRAMS-$here/bin} nullscope=$programs/nullscope context=${CONTEXT-egl}
scenes=${SCENES-flat sky-only first-light accretion gargantua kerr m87 hot-spot kerr-plunge wormhole saturn thick-disc soft-disc hot-flow}
sizes=${SIZES-1280x720 3840x2160} large=${LARGE_SCENES-sky-only first-light kerr} large_size=${LARGE_SIZE-7680x4320}
pictures=${PICTURES-sky-only first-light accretion gargantua kerr m87 hot-spot wormhole thick-disc hot-flow}
film=${FILM-kerr} film_frames=${FILM_FRAMES-24} film_size=${FILM_SIZE-3840x2160} frames=${FRAMES-9} limit=${LIMIT_S-480}
rm -f "$out"/*.json "$out"/*.tsv
: >"$out/log.txt"

# NAME COMMAND...: in what is left of the time; its exit status (124: the time was over) and seconds go to steps.tsv.
step() {
    local name=$1 left=$((limit - SECONDS)) begun=$SECONDS status=0
    shift
    if ((left < 5)); then
        printf '%s\t-\t0\n' "$name" >>"$out/steps.tsv"
        return
    fi
    echo "measure: $name, $left s left" >&2
    timeout "$left" "$@" >>"$out/log.txt" 2>&1 || status=$?
    printf '%s\t%s\t%s\n' "$name" "$status" "$((SECONDS - begun))" >>"$out/steps.tsv"
}

# A process for each: a driver that ends one takes no other's figures with it.
frames_of() { # SIZE SCENE...
    local size=$1 scene stage
    shift
    for scene in "$@"; do
        for stage in fragment compute; do
            step "frames $stage $size $scene" "$nullscope" bench frames "$scene" --size "$size" --frames "$frames" --context "$context" \
                --stage "$stage" --json "$out/frames-$stage-$size-$scene.json"
        done
    done
}

# Wall seconds of a sequence of pictures, PNG files: by one process, which draws the next picture while the last is read and
# written, and by several.
draw_film() { # STAGE WORKERS
    local folder begun
    folder=$(mktemp -d) begun=$(date +%s.%N)
    "$nullscope" capture "$film" --size "$film_size" --context "$context" --stage "$1" --workers "$2" --time-step 0.5 \
        --frames "0:$film_frames" -o "$folder/%04d.png" || { rm -rf "$folder"; return 1; }
    printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$film" "$1" "$2" "$film_size" "$film_frames" "$begun" "$(date +%s.%N)" >>"$out/film.tsv"
    rm -rf "$folder"
}

export -f draw_film
export nullscope out film film_size film_frames context
step info "$nullscope" info
step arithmetic "$nullscope" bench arithmetic --size "${sizes%% *}" --frames "$frames" --context "$context" --json "$out/arithmetic.json"
for size in $sizes; do
    # shellcheck disable=SC2086   # several scenes
    frames_of "$size" $scenes
done
step hard "$nullscope" bench hard --only "${ONLY-}" --json "$out/hard.json"
for workers in 1 4; do
    for stage in fragment compute; do step "film $stage $workers" bash -c "draw_film $stage $workers"; done
done
# shellcheck disable=SC2086
frames_of "$large_size" $large
for scene in $pictures; do
    step "picture $scene" "$nullscope" bench pictures "$scene" --pixels 2000 --seconds 10 --context "$context" --json "$out/pictures-$scene.json"
done
[[ ! -x $programs/golden_tests ]] || step golden "$programs/golden_tests" --no-version
awk -F: '/^model name/ {name = $2; ++n} END {printf "%d x%s\n", n, name}' /proc/cpuinfo >"$out/processor.txt"
echo "measure: $SECONDS s" >&2
