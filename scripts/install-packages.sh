#!/usr/bin/env bash
# Installs by apt what building, running and testing nullscope need (Debian 12 and 13, Ubuntu 24.04 and later).
# Only what is missing is installed: when nothing is, this takes a fraction of a second and touches nothing.
# Packages that are linked are those of the first table of third_party/versions.md, which says what each is for; the others are listed here.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
linked=$(awk -F'|' '/^Opened or called/ { exit } /^\| [a-z]/ && !/^\| package/ { sub(/\(.*/, "", $2); gsub(/,/, " ", $2); print $2 }' \
         "$root/third_party/versions.md")
build=(g++ cmake ninja-build pkg-config python3 $linked)
run=(libegl1 libgl1 libgl1-mesa-dri fonts-dejavu-core)
test=(xvfb xauth xdotool python3-allpairspy)
# scripts/release.sh: packages
package=(dpkg-dev file lintian patchelf)
# scripts/docs.sh: the documentation as a site
docs=(mkdocs)
# scripts/test.sh --all: the Python package, films, man pages, sequences on many machines, and the viewer under Wayland
all_tests=(python3-venv python3-dev ffmpeg man-db munge parallel slurm-client slurmctld slurmd weston)
# scripts/web.sh: the browser's build; and the browsers that test it
web=(clang-19 lld-19 libc++-19-dev-wasm32 libclang-rt-19-dev-wasm32 wasi-libc libgles-dev chromium-headless-shell firefox-esr
     webkit2gtk-driver libdeflate-tools)
checks=(clang libclang-rt-dev clang-format clang-tidy)   # scripts/check.sh
# Other programs that tests compare with, where they exist (tests/proof/test_gyoto.py)
peers=(gyoto-bin)
# Used where they exist: a faster second build; a second way to render without a window system (it left Mesa in 25.1).
optional=(ccache libosmesa6)

usage() {
    cat <<'END'
Usage: install-packages.sh [--quiet] [--all] [--checks] [--docs] [--package] [--web]
Installs the packages that nullscope needs by apt, if any are missing. Needs root or sudo for that.
  --quiet    say nothing unless something is missing or goes wrong
  --all      also what scripts/test.sh --all needs: Python's headers, ffmpeg, man, GNU parallel,
             Slurm and weston, the sets of --docs and --package, and gyoto where it is offered
  --web      also what scripts/web.sh and its tests need: clang for WebAssembly, Chromium without a window,
             Firefox and WebKitGTK
  --docs     also what scripts/docs.sh needs: mkdocs
  --package  also what packages are made with: dpkg-dev, file, lintian, patchelf
  --checks   also what scripts/check.sh needs: clang, clang-format and clang-tidy
END
}

quiet=no
for argument in "$@"; do
    case $argument in
        --quiet) quiet=yes ;;
        --all)
            test+=("${all_tests[@]}" "${docs[@]}" "${package[@]}")
            optional+=("${peers[@]}") ;;
        --docs) test+=("${docs[@]}") ;;
        --package) test+=("${package[@]}") ;;
        --web) test+=("${web[@]}") ;;
        --checks) test+=("${checks[@]}") ;;
        -h | --help) usage; exit 0 ;;
        *) usage >&2; exit 2 ;;
    esac
done

say() { echo "install-packages: $*" >&2; }
fail() { say "$@"; exit 1; }

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    fail "there is no apt here; install the counterparts of these packages by hand: ${build[*]} ${run[*]} ${test[*]}"
fi

# Prints those of the given packages that are not installed.
missing_of() {
    local installed
    installed=$(dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null |
                sed -n 's/^installed //p') || true
    printf '%s\n' "$@" | grep -vxF -e "$installed" || true
}

# Prints those of the given packages that apt can supply.
known_to_apt() {
    [[ $# -eq 0 ]] || LC_ALL=C apt-cache policy "$@" 2>/dev/null |
        awk '/^[^ ]/ { name = $1; sub(/:$/, "", name) } /^ +Candidate: [^(]/ { print name }'
}

# Package names hold no blanks, so plain word splitting serves; <(...) would need /proc, which a bare chroot may lack.
required=($(missing_of "${build[@]}" "${run[@]}" "${test[@]}"))
wished=($(missing_of "${optional[@]}"))

say_what_is_absent() {
    if [[ $quiet == no && " ${wished[*]-} " == *' libosmesa6 '* && " ${wanted[*]-} " != *' libosmesa6 '* ]]; then
        say "libosmesa6 is not offered here; EGL renders without it and the OSMesa tests skip"
    fi
}

if [[ ${#required[@]} -eq 0 ]]; then
    wanted=($(known_to_apt ${wished[@]+"${wished[@]}"}))
    if [[ ${#wanted[@]} -eq 0 ]]; then
        say_what_is_absent
        [[ $quiet == yes ]] || say "everything is installed"
        exit 0
    fi
fi

apt_environment=(env DEBIAN_FRONTEND=noninteractive LC_ALL=C)
if [[ $EUID -eq 0 ]]; then
    as_root=("${apt_environment[@]}")
elif command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [[ -t 0 ]]; }; then
    as_root=(sudo "${apt_environment[@]}")   # asks for a password only on a terminal
elif [[ ${#required[@]} -eq 0 ]]; then
    [[ $quiet == yes ]] || say "optional packages are missing and need root: apt-get install ${wanted[*]}"
    exit 0
else
    say "root is needed and sudo does not give it; run this once as root, then try again:"
    echo "apt-get update && apt-get install --yes --no-install-recommends ${required[*]}" >&2
    exit 1
fi

log=$(mktemp "${TMPDIR:-/tmp}/nullscope-apt.XXXXXX")
trap 'rm -f "$log"' EXIT

# apt-get, tried twice: mirrors and networks hiccup. Its output goes to a file; the end of it is shown when both tries fail.
apt_get() {
    local options=(-qq -o DPkg::Lock::Timeout=120 -o Dpkg::Use-Pty=0)
    if "${as_root[@]}" apt-get "${options[@]}" "$@" >"$log" 2>&1 </dev/null; then return; fi
    say "apt-get $1 failed; trying once more"
    sleep 3
    if "${as_root[@]}" apt-get "${options[@]}" "$@" >"$log" 2>&1 </dev/null; then return; fi
    tail -n 20 "$log" >&2
    say "apt-get $1 failed twice; its last lines are above"
    return 1
}

[[ $quiet == yes ]] || say "reading the package lists"
apt_get update || say "going on with the package lists that are here"   # one broken source need not matter

wanted=($(known_to_apt ${wished[@]+"${wished[@]}"}))
say_what_is_absent
known=$(known_to_apt ${required[@]+"${required[@]}"})
unknown=($(printf '%s\n' ${required[@]+"${required[@]}"} | grep -vxF -e "$known" || true))
if [[ ${#unknown[@]} -gt 0 ]]; then
    cat "$log" >&2   # why a list could not be read, if that is why
    fail "apt does not know ${unknown[*]} (nullscope needs Debian 12, Ubuntu 24.04 with 'universe', or later)"
fi

all=(${required[@]+"${required[@]}"} ${wanted[@]+"${wanted[@]}"})
say "installing ${#all[@]} packages and what they need (about a minute on a bare system)"
start=$SECONDS
apt_get install --yes --no-install-recommends "${all[@]}" || exit 1
[[ $quiet == yes ]] || say "done in $((SECONDS - start)) s"
