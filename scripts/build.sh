#!/usr/bin/env bash
# Builds the workspace into build/ and devel/.
#     scripts/build.sh [TARGET...]     e.g. scripts/build.sh all benches tests
# In the environment: BUILD_TYPE=Debug, JOBS=1, and PLAIN=1 to compile each source
# alone, not in batches: slower as a whole, faster after a small change. A later
# call without PLAIN=1 goes back to batches.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"

cd "$repository"
# Needed before the first configure, which caches the existing Python folders.
mkdir -p devel/lib/python3/dist-packages build
log=build/build.log
packages=(src/*/package.xml)
jobs=${JOBS:-$(nproc)}
# Tests are configured when they are first asked for, and from then on.
testing=OFF
if [[ " $* " == *" tests "* ]] ||
    grep -qs '^CATKIN_ENABLE_TESTING:.*=ON$' build/CMakeCache.txt; then
  testing=ON
fi
use_ccache

echo "build:   ${#packages[@]} packages with $jobs jobs, log: $log"
# A folder that another generator has configured is configured again.
if ! grep -qs '^CMAKE_GENERATOR:INTERNAL=Ninja$' build/CMakeCache.txt; then
  rm -rf build/CMakeCache.txt build/CMakeFiles
fi
if ! catkin_make --use-ninja --no-color -j"$jobs" \
    -DPYTHON_EXECUTABLE=/usr/bin/python3 -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
    -DCMAKE_BUILD_TYPE="${BUILD_TYPE:-Release}" -DCATKIN_ENABLE_TESTING=$testing \
    -DKG_UNITY="$([ -n "${PLAIN:-}" ] && echo OFF || echo ON)" \
    "$@" </dev/null >"$log" 2>&1
then
  grep -nE 'error|Error|^FAILED' "$log" | head -n 40 >&2 || true
  tail -n 15 "$log" >&2
  fail build "log: $repository/$log"
fi
compiled=$(grep -c 'Building C' "$log" || true)
stage build "${#packages[@]} packages${*:+ ($*)}, $compiled files compiled"
