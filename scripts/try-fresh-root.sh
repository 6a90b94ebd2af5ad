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
source "$repository/scripts/fresh-root.sh"

read_arguments "$@"
suite=${words[0]:-bookworm}

git -C "$repository" rev-parse --quiet --verify HEAD >/dev/null || fail "there is no commit yet that could be tried"
if [[ -n $(git -C "$repository" status --porcelain) ]]; then
    say "note: there are changes that are not committed; they are not tried"
fi

timed "debootstrap $suite" make_root "$suite" git
git clone --quiet --no-hardlinks "$repository" "$fresh/nullscope"

timed "scripts/run.sh, first call (packages, build, first picture)" inside /nullscope/scripts/run.sh
timed "scripts/run.sh, second call" inside /nullscope/scripts/run.sh
[[ -s $fresh/nullscope/out/first-light.png ]] || fail "run.sh said it was done, but there is no out/first-light.png"
timed "scripts/test.sh" inside /nullscope/scripts/test.sh

printf '%s\n' "$suite, $(git -C "$repository" rev-parse --short HEAD), $(nproc) cores:" "${report[@]}"
