#!/usr/bin/env bash
# Runs the lines of `nullscope frames SCENE ... --commands` with GNU parallel, on this machine or on several.
#
#   nullscope frames SCENE --chunk 20 -o out/f%05d.png --commands | scripts/farm/parallel.sh [PARALLEL OPTION...]
#   scripts/farm/parallel.sh -f LINES.txt --jobs 2              # two lines at a time
#   scripts/farm/parallel.sh -f LINES.txt --sshlogin a,b,:      # on hosts a and b, and here
#
#   scripts/farm/parallel.sh -f LINES.txt --devices 4           # four lines at a time, each on a GPU of its own
#
#   -f FILE        reads the lines from FILE instead of standard input
#   --devices N    N lines at a time on this machine, each with one of --device 0 to N-1 (see: nullscope devices)
#
# One line at a time on each machine unless --jobs says otherwise: a line uses the whole GPU, or all cores. Hosts are
# reached by ssh without a password; they must see the current folder under the same name, and find nullscope. A line
# that fails is tried twice more, with several hosts on another one. Every option goes to parallel as it is.
set -euo pipefail

fail() { echo "parallel.sh: $*" >&2; exit 1; }
case "${1-}" in -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;; esac
[[ $(parallel --version 2>/dev/null </dev/null) == GNU\ parallel* ]] || fail "GNU parallel is not installed: apt install parallel"

input=/dev/stdin devices=()
while [[ ${1-} == -f || ${1-} == --devices ]]; do
    case $1 in
        -f) input=${2?"-f: a file is missing"} ;;
        --devices)
            [[ ${2-} =~ ^[1-9][0-9]*$ ]] || fail "--devices ${2-}: how many, a whole number from 1"
            devices=(--jobs "$2" 'eval {} --device $(({%} - 1))') ;;   # {%}: the number of the job's slot
    esac
    shift 2
done
[[ -r $input ]] || fail "$input: cannot be read"
lines=$(grep -v '^[[:space:]]*$' "$input") || fail "no lines: give those that nullscope frames ... --commands prints"

exec parallel --jobs 1 --retries 3 --line-buffer --workdir "$PWD" ${devices[@]+"${devices[@]::2}"} "$@" ${devices[@]+"${devices[@]:2}"} <<<"$lines"
