#!/usr/bin/env bash
# Builds the workspace into build/ and devel/.
#     scripts/build.sh [TARGET...]             e.g. scripts/build.sh tests
# BUILD_TYPE=Debug and JOBS=1 in the environment change the defaults.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"

cd "$repository"
# Before the first configure: it remembers which Python folders there are.
mkdir -p devel/lib/python3/dist-packages build
log=build/build.log
packages=(src/*/package.xml)
jobs=${JOBS:-$(nproc)}

echo "build:   ${#packages[@]} packages with $jobs jobs, told in $log ..."
if ! catkin_make --no-color -j"$jobs" -DPYTHON_EXECUTABLE=/usr/bin/python3 \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCMAKE_BUILD_TYPE="${BUILD_TYPE:-Release}" \
    "$@" </dev/null >"$log" 2>&1
then
  grep -nE 'error|Error|\*\*\*' "$log" | head -n 40 >&2 || true
  tail -n 15 "$log" >&2
  fail build "everything that was said: $repository/$log"
fi
compiled=$(grep -c 'Building C' "$log" || true)
stage build "${#packages[@]} packages${*:+ ($*)}, $compiled files compiled"
