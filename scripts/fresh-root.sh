# For scripts that try something on a bare system: source it. A root is a minimal Debian or Ubuntu in a folder (debootstrap, variant
# minbase), with nothing of this machine but its name servers and its proxy settings.
#
#   MIRROR=URL          another mirror than the distribution's own
#   FRESH_ROOT_DIR=DIR  where roots are made (default /tmp)
#
# Needs root and debootstrap, for Ubuntu suites also ubuntu-keyring.

# read_arguments ARGUMENT...: sets $keep by --keep and $words by the others; --help prints the comment that the script begins with.
read_arguments() {
    local argument
    keep=no words=()
    for argument in "$@"; do
        case $argument in
            --keep) keep=yes ;;
            -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "$0"; exit 0 ;;
            -*) fail "unknown option $argument; see --help" ;;
            *) words+=("$argument") ;;
        esac
    done
}

# make_root SUITE PACKAGES: sets $fresh, the root's folder, which is removed when the script ends unless $keep is yes. PACKAGES: comma-separated.
make_root() {
    local suite=$1 packages=$2 mirror options=() scheme scripts=()
    [[ $EUID -eq 0 ]] || fail "needs root, for debootstrap and chroot"
    command -v debootstrap >/dev/null || fail "debootstrap is not installed (apt-get install debootstrap)"
    case $suite in
        bookworm | trixie | forky | sid)
            mirror=${MIRROR:-http://deb.debian.org/debian} scheme=sid ;;
        *)
            mirror=${MIRROR:-http://archive.ubuntu.com/ubuntu}
            options=(--components=main,universe --keyring=/usr/share/keyrings/ubuntu-archive-keyring.gpg) scheme=gutsy ;;
    esac
    [[ -e /usr/share/debootstrap/scripts/$suite ]] || scripts=("$scheme")   # a suite younger than debootstrap is made as those before it
    [[ -z $packages ]] || options+=("--include=$packages")
    fresh=$(mktemp -d "${FRESH_ROOT_DIR:-/tmp}/nullscope-$suite.XXXXXX")
    trap remove_root EXIT
    debootstrap --variant=minbase ${options[@]+"${options[@]}"} "$suite" "$fresh" "$mirror" ${scripts[@]+"${scripts[@]}"} \
        >"$fresh.log" 2>&1 || { tail -n 20 "$fresh.log" >&2; return 1; }
    rm -f "$fresh.log"
    cp -L /etc/resolv.conf "$fresh/etc/resolv.conf"
}

remove_root() {
    if [[ ${keep-no} == yes ]]; then
        say "the root is left in $fresh"
    else
        rm -rf --one-file-system "$fresh"
    fi
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

report=()
# timed LABEL COMMAND...: runs it and notes how long it took, in $report and $seconds.
timed() {
    local label=$1 start=$EPOCHREALTIME
    shift
    say "$label"
    "$@" || fail "$label: failed with status $?"
    seconds=$(awk -v a="$start" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.1f", b - a }')
    report+=("$(printf '%8s s  %s' "$seconds" "$label")")
}
