#!/usr/bin/env bash
# Opens what nullscope writes with the real programs that people use next, each in an environment of its own, build/interop/NAME, with the
# versions of tests/interop/programs.csv, or as Debian has them. Needs PyPI, for some npm's registry; run by hand, before a release.
#
#   scripts/interop.sh              all of them: some minutes, 2.5 GB
#   scripts/interop.sh NAME...      only these: blender blender-5.2 openimageio openexr ehtim astropy ds9 casacore pandas joblib aart samplers ffmpeg imagemagick gimp panorama
#
# In ctest: -L interop (--program PROGRAM NAME), and at depth all the light ones, openexr and openimageio (--tier PROGRAM NAME...).
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
table=$root/tests/interop/programs.csv
program=$root/build/release/bin/nullscope
export PIP_DISABLE_PIP_VERSION_CHECK=1 CC=cc CXX=c++   # the compiler's name is part of what ccache goes by

# An interpreter of this version, "3.11", or the usual one, "-".
interpreter() {
    local candidate folders=()
    mapfile -t folders < <(ls -d "$(pyenv root 2>/dev/null)"/versions/"$1".*/bin 2>/dev/null)
    for candidate in "python$1" python3 "${folders[@]/%//python3}"; do
        if "$candidate" -c "import sys; sys.exit('$1' not in ('-', '%d.%d' % sys.version_info[:2]))" 2>/dev/null; then
            echo "$candidate"
            return
        fi
    done
    echo "interop: Python $1 is not installed" >&2
    return 1
}

# Makes the environment where it is missing or has other versions.
environment() {
    local folder=$root/build/interop/$1 python=$2 packages=$3 npm=$4 found
    [[ $(cat "$folder/made" 2>/dev/null) != "$packages$npm" ]] || return 0
    found=$(interpreter "$python")
    rm -rf "$folder"
    "$found" -m venv "$folder"
    # shellcheck disable=SC2086   # several packages
    "$folder/bin/python" -m pip install --quiet $packages
    # shellcheck disable=SC2086
    [[ -z $npm ]] || npm install --silent --prefix "$folder" $npm
    echo "$packages$npm" >"$folder/made"
}

run() {
    local name=$1 row python packages npm debian package
    row=$(grep "^$name," "$table") || { echo "interop: no program $name; allowed: ${all[*]}" >&2; exit 2; }
    IFS=, read -r _ python packages npm debian <<<"$row"
    for package in $debian; do
        [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] ||
            { echo "interop: $name needs apt-get install $debian" >&2; return 1; }
    done
    environment "$name" "$python" "$packages" "$npm" || return 1
    # The package nullscope, as it is now.
    [[ ! $name =~ ^(ehtim|joblib|aart|samplers)$ ]] || "$root/build/interop/$name/bin/python" -m pip install --quiet "$root"
    "$root/build/interop/$name/bin/python" -B "$root/tests/interop/test_${name%%-*}.py" "$program"
}

mapfile -t all < <(sed -n '/^[a-z]/s/,.*//p' "$table" | tail -n +2)
case "${1-}" in
    -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;;
    --tier | --program)
        if [[ $1 == --tier ]] && ! python3 -B "$root/tests/depth.py" "$root/tests/interop/test_openexr.py"; then
            echo "skipped: other programs are run by scripts/test.sh --all"
            exit 77
        fi
        program=$2
        shift 2 ;;
    *) "$root/scripts/build.sh" nullscope ;;
esac
[[ $# -gt 0 ]] || set -- "${all[@]}"
status=0
for name in "$@"; do run "$name" || status=1; done
exit "$status"
