#!/usr/bin/env bash
# Installs what is missing, builds and runs every test. Arguments go to ctest, for example:
#   scripts/test.sh -L unit          the tests of one label (unit, contract, layering, gpu, golden, cli, fuzz, viewer)
#   scripts/test.sh -R photon -V     the tests whose name matches, with all their output
# Tests that measure time hold a ctest lock of their own, so two at once disturb nothing.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case "${1-}" in -h | --help) sed -n '2,/^set /{/^# /s/^# //p}' "${BASH_SOURCE[0]}"; exit 0 ;; esac

"$root/scripts/build.sh"

# The driver's shader cache would hide differences between two builds of the same shader.
export MESA_SHADER_CACHE_DISABLE=true
exec ctest --test-dir "$root/build/release" --output-on-failure --no-tests=error -j "${CTEST_PARALLEL_LEVEL:-2}" "$@"
