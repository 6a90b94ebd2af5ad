#!/usr/bin/env bash
# Submits the lines of `nullscope frames SCENE ... --commands` to Slurm as one array job, a task for each line.
#
#   nullscope frames SCENE --chunk 20 -o out/f%05d.png --commands | scripts/farm/slurm.sh [SBATCH OPTION...]
#   scripts/farm/slurm.sh -f LINES.txt --gpus 1 --time 1:00:00 --array %8
#
#   -f FILE        reads the lines from FILE instead of standard input
#   --array %N     at most N tasks at a time; every other option goes to sbatch as it is
#
# The job runs in the current folder, which every node must see. The lines are in the job script. Slurm allows 1000
# tasks unless its MaxArraySize says otherwise: choose --chunk by that. A task that failed: scontrol requeue JOB_TASK,
# or submit all lines again, which draws only what is missing.
set -euo pipefail

fail() { echo "slurm.sh: $*" >&2; exit 1; }
case "${1-}" in -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;; esac
command -v sbatch >/dev/null || fail "sbatch is not installed here: run this where Slurm's commands are"

input=/dev/stdin at_once="" options=()
while [[ $# -gt 0 ]]; do
    case $1 in
        -f) input=${2?"-f: a file is missing"}; shift 2 ;;
        --array) at_once=${2?"--array: %N is missing"}; shift 2 ;;
        *) options+=("$1"); shift ;;
    esac
done
[[ -z $at_once || $at_once =~ ^%[0-9]+$ ]] || fail "--array $at_once: only %N, the lines say how many tasks there are"
[[ -r $input ]] || fail "$input: cannot be read"
lines=$(grep -v '^[[:space:]]*$' "$input") || fail "no lines: give those that nullscope frames ... --commands prints"

sbatch --job-name nullscope --array "1-$(wc -l <<<"$lines")$at_once" --requeue ${options[@]+"${options[@]}"} <<JOB
#!/usr/bin/env bash
line=\$(sed -n "\${SLURM_ARRAY_TASK_ID}p" <<'END_OF_LINES'
$lines
END_OF_LINES
)
echo "\$line"
eval "exec \$line"
JOB
