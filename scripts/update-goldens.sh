#!/usr/bin/env bash
# Draws the golden pictures of tests/golden/cases.csv anew, with the reference tracer (never with OpenGL).
#   scripts/update-goldens.sh [BUILD]           all of them; BUILD: the build folder, by default build/release
#   scripts/update-goldens.sh BUILD SCENE...    only these: as in the first column of cases.csv
# Look at the change before committing it: git diff says which pictures changed, nullscope compare by how much.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case "${1-}" in -h | --help) sed -n '2,/^set /{/^# /s/^# //p}' "${BASH_SOURCE[0]}"; exit 0 ;; esac
build=$(cd "${1:-$root/build/release}" && pwd)
shift || true
cd "$root/tests/golden"
mkdir -p images

# Without the texts that capture writes into a picture: they name the version, and files of this machine.
without_texts() {
    python3 - "$1" <<'END'
import pathlib, struct, sys
file = pathlib.Path(sys.argv[1])
png, at = file.read_bytes(), 8
kept = png[:at]
while at < len(png):
    end = at + 12 + struct.unpack(">I", png[at:at + 4])[0]
    if png[at + 4:at + 8] not in (b"tEXt", b"zTXt", b"iTXt"):
        kept += png[at:end]
    at = end
file.write_bytes(kept)
END
}

drawn=0
while IFS=, read -r scene size _; do
    scene=${scene// /} size=${size// /}
    case "$scene" in '' | \#* | scene) continue ;; esac
    if [ $# -gt 0 ] && [[ " $* " != *" $scene "* ]]; then continue; fi
    name=$(basename "$scene" .toml)
    "$build/bin/nullscope" capture "$scene" --plain --renderer reference --samples 4 --size "$size" -o "images/$name.png"
    without_texts "images/$name.png"
    drawn=$((drawn + 1))
done < <(sed 's/\r$//' cases.csv)
[ "$drawn" -gt 0 ] || { echo "update-goldens: no case of that name in tests/golden/cases.csv" >&2; exit 2; }
