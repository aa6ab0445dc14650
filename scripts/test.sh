#!/usr/bin/env bash
# Installs, builds, runs every test and counts: the last line is "N passed, N
# failed"; the exit status is 0 only if none failed.
#     scripts/test.sh
# The C++ tests run JOBS at a time (default: all cores), then so do the Python
# tests, then the ROS tests two at a time: each starts a whole system with a master
# of its own.
# TEST_LIMIT_S in the environment: time limit of the C++ tests and of the ROS tests.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"
exec </dev/null
cd "$repository"

# Runs a step that all tests need; if it fails, the run ends here.
step() {
  "$@" && return
  echo "FAILED  $*"
  echo "0 passed, 1 failed"
  exit 1
}

# Number of result files that match a pattern.
written() { find "$results" -name "$1" | wc -l; }

results=$repository/build/test_results
jobs=${JOBS:-$(nproc)}
rm -rf "$results"
step scripts/install_packages.sh base checks gui
step scripts/build.sh all benches tests
step scripts/fuzz.sh 0
stage_began=$SECONDS

# run_group KIND JOBS PATTERN...: runs the catkin tests of one kind (gtest,
# rostest) of the packages with a file of these patterns. The exit
# status of catkin is always 0; the result files are evaluated instead.
run_group() {
  local kind=$1 group_jobs=$2 folder targets=()
  for folder in src/*/; do
    if [ -n "$(find "$folder" -name "$3" -print -quit)" ]; then
      targets+=("_run_tests_$(basename "$folder")_$kind")
    fi
  done
  timeout -k 30 "${TEST_LIMIT_S:-840}" ninja -C build -k 0 -j"$group_jobs" \
    "${targets[@]}" >"build/$kind.log" 2>&1 ||
    echo "tests:   timed out or failed, log: build/$kind.log"
}

use_workspace
run_group gtest "$jobs" '*_test.cc'
stage tests "results of $(written 'gtest-*.xml') C++ test programs"

# run_guard FILE: one Python test, with a time limit.
run_guard() {
  local name
  name=$(basename "$1" .py)
  timeout -k 10 300 scripts/run_unittest.py "$1" "$results/scripts/$name.xml" \
    >"build/$name.log" 2>&1 || true
}
export -f run_guard
export results
mkdir -p "$results/scripts"
printf '%s\0' scripts/*_test.py |
  xargs -0 -n 1 -P "$jobs" bash -c 'run_guard "$0"'
stage guards "results of $(find "$results/scripts" -name '*.xml' | wc -l) Python tests"

run_group rostest $((jobs < 2 ? jobs : 2)) '*.test'
stage tests "results of $(written 'rosunit-*.xml') ROS test programs"

scripts/test_results.py "$repository" "$results"
