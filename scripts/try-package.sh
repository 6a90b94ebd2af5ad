#!/usr/bin/env bash
# Proves that a package can be installed and used on a bare system: makes a minimal Debian root by debootstrap, installs the package
# there, draws a picture, opens the viewer on a screen of its own (Xvfb) until its first picture is on it, and removes the package again.
# Prints how long each took. It fails if it takes more than 60 s from the start of apt install, which brings the driver too, to both first
# pictures (without the installation of Xvfb), or if removing all of it leaves a file.
#
#   scripts/try-package.sh [--keep] SUITE PACKAGE.deb       installed by apt, removed by apt purge
#   scripts/try-package.sh [--keep] SUITE ARCHIVE.tar.gz    unpacked in a folder, with a driver and the X libraries from apt
#
#   --keep   leave the root behind and say where
#
# MIRROR, FRESH_ROOT_DIR and what is needed: see scripts/fresh-root.sh.
set -euo pipefail

say() { echo "try-package: $*" >&2; }
fail() { say "$@"; exit 1; }
source "$(dirname "${BASH_SOURCE[0]}")/fresh-root.sh"

longest=60   # s, from the start of the installation to both first pictures
read_arguments "$@"
[[ ${#words[@]} -eq 2 ]] || fail "a suite and a package are needed; see --help"
suite=${words[0]} package=${words[1]}
[[ -f $package ]] || fail "there is no file $package"

apt() { inside env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 "$@" >"$fresh/tmp/apt.log" 2>&1 || { tail -n 20 "$fresh/tmp/apt.log" >&2; return 1; }; }

# Every file of the root with its size, but for what apt and dpkg note about themselves, and the key maps that Xvfb writes when it runs.
files_of_root() {
    (cd "$fresh" && find . -xdev \( -path ./proc -o -path ./sys -o -path ./dev -o -path ./tmp -o -path ./run -o -path ./var/lib/apt -o -path ./var/cache \
        -o -path ./var/log -o -path ./var/lib/xkb \) -prune -o ! -type d ! -path './var/lib/dpkg/*-old' ! -path ./var/lib/dpkg/lock\* ! -path ./var/lib/dpkg/status \
        ! -path ./var/lib/dpkg/diversions ! -path './var/lib/dpkg/triggers/*' -printf '%p %s\n' -o -type d -printf '%p/\n' | sort)
}

install_deb() { apt install --yes --no-install-recommends "/tmp/${package##*/}"; }
install_archive() {
    mkdir -p "$fresh/opt/some where"
    tar -xzf "$package" -C "$fresh/opt/some where" --strip-components=1
}

# What a driver caches is the user's own: it goes where nobody looks.
used() { inside env XDG_CACHE_HOME=/tmp/cache "$@"; }

draw_picture() {
    used "$bin/nullscope" capture first-light -o /tmp/first-light.png >"$fresh/tmp/capture.log" 2>&1 || { cat "$fresh/tmp/capture.log" >&2; return 1; }
    [[ $(head -c 4 "$fresh/tmp/first-light.png" | tail -c 3) == PNG ]]
}

# --turns logs when a picture is first on the screen.
open_viewer() {
    # shellcheck disable=SC2016  # expanded in the root
    used sh -c 'Xvfb :7 -screen 0 1280x720x24 >/dev/null 2>&1 & exec env DISPLAY=:7 XDG_RUNTIME_DIR=/tmp \
        sh -c "while [ ! -e /tmp/.X11-unix/X7 ]; do sleep 0.1; done; exec \"\$0\" first-light --screenshot /tmp/viewer.png --turns /tmp/turns.txt" "$0"' \
        "$bin/nullscope-viewer" >"$fresh/tmp/viewer.log" 2>&1 || { cat "$fresh/tmp/viewer.log" >&2; return 1; }
    [[ $(head -c 4 "$fresh/tmp/viewer.png" | tail -c 3) == PNG ]] || return 1
    grep -q '^first .*picture=whole' "$fresh/tmp/turns.txt" || { say "the viewer logged no picture:"; head -n 5 "$fresh/tmp/turns.txt" >&2; return 1; }
}

timed "debootstrap $suite" make_root "$suite" ""
cp "$package" "$fresh/tmp/"
timed "apt-get update" apt update
inside dpkg-query --show --showformat='${Package}\n' | sort >"$fresh/tmp/packages.before"
files_of_root >"$fresh/tmp/files.before"

total=0
# step LABEL COMMAND...: counts towards $longest.
step() { timed "$@"; total=$(awk -v a="$total" -v b="$seconds" 'BEGIN { print a + b }'); }
case $package in
    *.deb)
        bin=/usr/bin
        step "apt install ./${package##*/}" install_deb ;;
    *)
        bin="/opt/some where/bin"
        step "apt install of a driver and the X libraries" apt install --yes --no-install-recommends libegl1 libgl1 libgl1-mesa-dri \
            libfreetype6 libx11-6 libxrandr2 libxinerama1 libxcursor1 libxi6 fonts-dejavu-core
        step "tar -xzf ${package##*/}" install_archive ;;
esac
step "nullscope capture first-light" draw_picture
apt install --yes --no-install-recommends xvfb   # a screen, which a person has
step "nullscope-viewer first-light, to its first picture" open_viewer
say "$(inside "$bin/nullscope" --version)"
case $package in
    *.deb)
        inside sh -c 'test -e /usr/share/man/man1/nullscope-viewer.1.gz || grep -qs usr/share/man /etc/dpkg/dpkg.cfg.d/*' || fail "there is no man page"
        timed "apt purge nullscope" apt purge --yes nullscope ;;
    *) rm -r "$fresh/opt/some where" ;;
esac
# What came with it goes with it: the other packages are the system's own.
inside dpkg-query --show --showformat='${Package}\n' | sort >"$fresh/tmp/packages.after"
mapfile -t more < <(comm -13 "$fresh/tmp/packages.before" "$fresh/tmp/packages.after")
[[ ${#more[@]} -eq 0 ]] || apt purge --yes "${more[@]}"
files_of_root >"$fresh/tmp/files.after"
left=$(comm -13 "$fresh/tmp/files.before" "$fresh/tmp/files.after")

printf '%s\n' "$suite, ${package##*/}, $(nproc) cores:" "${report[@]}"
printf '%8.1f s  from a bare system to both first pictures\n' "$total"
awk -v t="$total" -v most="$longest" 'BEGIN { exit t > most }' || fail "both first pictures took more than $longest s"
if [[ -n $left ]]; then
    printf '%s\n' "$left" >&2
    fail "these are left"
fi
echo "nothing is left of it"
