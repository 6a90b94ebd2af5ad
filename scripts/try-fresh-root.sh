#!/usr/bin/env bash
# Proves that a fresh clone builds, runs and passes its tests on a bare system: makes a minimal Debian or Ubuntu root by
# debootstrap (variant minbase, plus git), clones the current HEAD into it and calls scripts/run.sh (twice) and scripts/test.sh
# there by chroot. Prints how long each took. Nothing of this machine is in it but its name servers and its proxy settings.
#
#   scripts/try-fresh-root.sh [--keep] [SUITE]      SUITE: bookworm (default), trixie, noble, ...
#
#   --keep              leave the root behind and say where
#   MIRROR=URL          another mirror than the distribution's own
#   FRESH_ROOT_DIR=DIR  where the root is made (default /tmp; needs about 3 GB)
#
# Needs root and debootstrap, for Ubuntu suites also ubuntu-keyring. Changes that are not committed are not tried.
set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
say() { echo "try-fresh-root: $*" >&2; }
fail() { say "$@"; exit 1; }

keep=no
suite=
for argument in "$@"; do
    case $argument in
        --keep) keep=yes ;;
        -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;;
        -*) fail "unknown option $argument; see --help" ;;
        *) suite=$argument ;;
    esac
done
suite=${suite:-bookworm}
[[ $EUID -eq 0 ]] || fail "needs root, for debootstrap and chroot"
command -v debootstrap >/dev/null || fail "debootstrap is not installed (apt-get install debootstrap)"

case $suite in
    bookworm | trixie | forky | sid)
        mirror=${MIRROR:-http://deb.debian.org/debian}
        options=() scheme=sid ;;
    *)
        mirror=${MIRROR:-http://archive.ubuntu.com/ubuntu}
        options=(--components=main,universe --keyring=/usr/share/keyrings/ubuntu-archive-keyring.gpg) scheme=gutsy ;;
esac

git -C "$repository" rev-parse --quiet --verify HEAD >/dev/null || fail "there is no commit yet that could be tried"
if [[ -n $(git -C "$repository" status --porcelain) ]]; then
    say "note: there are changes that are not committed; they are not tried"
fi

fresh=$(mktemp -d "${FRESH_ROOT_DIR:-/tmp}/nullscope-$suite.XXXXXX")
finish() {
    if [[ $keep == yes ]]; then
        say "the root is left in $fresh"
    else
        rm -rf --one-file-system "$fresh"
    fi
}
trap finish EXIT

report=()
# timed LABEL COMMAND...: runs it and notes how long it took.
timed() {
    local label=$1 start=$EPOCHREALTIME end
    shift
    say "$label"
    "$@" || fail "$label: failed with status $?"
    end=$EPOCHREALTIME
    report+=("$(awk -v a="$start" -v b="$end" -v l="$label" 'BEGIN { printf "%8.1f s  %s", b - a, l }')")
}

bootstrap() {
    local scripts=()    # a suite younger than debootstrap is made as those before it
    [[ -e /usr/share/debootstrap/scripts/$suite ]] || scripts=("$scheme")
    debootstrap --variant=minbase --include=git ${options[@]+"${options[@]}"} "$suite" "$fresh" "$mirror" ${scripts[@]+"${scripts[@]}"} \
        >"$fresh.log" 2>&1 || { tail -n 20 "$fresh.log" >&2; return 1; }
    rm -f "$fresh.log"
}

# Runs a command in the root: its own mounts and processes (gone when it ends), an empty environment but for the proxies.
inside() {
    local network=() name
    for name in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY; do
        [[ -z ${!name-} ]] || network+=("$name=${!name}")
    done
    # shellcheck disable=SC2016  # $0 and $@ are the inner shell's
    unshare --mount --pid --fork --kill-child sh -c '
        mount -t proc proc "$0/proc"
        mkdir -p "$0/dev/shm"
        mount -t tmpfs tmpfs "$0/dev/shm"
        exec chroot "$0" "$@"' "$fresh" \
        env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp LANG=C.UTF-8 TERM=dumb ${network[@]+"${network[@]}"} "$@" \
        </dev/null
}

timed "debootstrap $suite" bootstrap
cp -L /etc/resolv.conf "$fresh/etc/resolv.conf"
git clone --quiet --no-hardlinks "$repository" "$fresh/nullscope"

timed "scripts/run.sh, first call (packages, build, first picture)" inside /nullscope/scripts/run.sh
timed "scripts/run.sh, second call" inside /nullscope/scripts/run.sh
[[ -s $fresh/nullscope/out/first-light.png ]] || fail "run.sh said it was done, but there is no out/first-light.png"
timed "scripts/test.sh" inside /nullscope/scripts/test.sh

printf '%s\n' "$suite, $(git -C "$repository" rev-parse --short HEAD), $(nproc) cores:" "${report[@]}"
