#!/usr/bin/env bash
# Installs the Python package in a fresh environment, build/python-venv, by pip, and tests it there. Needs PyPI.
#
#   scripts/python.sh           all tests of tests/python
#   scripts/python.sh NAME...   only these: package, pickle, docs, fits, grmhd, grmhd_codes
#
# What build/release has compiled is not compiled again where ccache is installed. In ctest (--tier PROGRAM) at depth all alone.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
environment=$root/build/python-venv
program=$root/build/release/bin/nullscope
case "${1-}" in -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;; esac

if [[ ${1-} == --tier ]]; then
    if ! python3 -B "$root/tests/depth.py" "$root/tests/python/test_package.py"; then
        echo "skipped: the package is built and tested by scripts/test.sh --all"
        exit 77
    fi
    program=$2
    shift 2
else
    "$root/scripts/build.sh" nullscope
fi
[[ $# -gt 0 ]] || set -- package pickle docs fits grmhd grmhd_codes

export CC=cc CXX=c++   # the compiler's name is part of what ccache goes by
export PIP_DISABLE_PIP_VERSION_CHECK=1
rm -rf "$environment"
python3 -m venv "$environment"
"$environment/bin/pip" install --quiet "$root"
"$environment/bin/pip" install --quiet matplotlib corner nbclient ipykernel OpenEXR h5py   # of the tests
status=0
for name in "$@"; do
    "$environment/bin/python" -B "$root/tests/python/test_$name.py" "$program" || status=1
done
exit "$status"
