#!/usr/bin/env bash
# Installs, builds, runs every test there is and counts: the last line is
# "N passed, N failed", the exit status is true to it.
#     scripts/test.sh
# TEST_LIMIT_S in the environment: the longest that C++ and ROS tests may take.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"
exec </dev/null
cd "$repository"

# Runs a step without which there is nothing to count.
step() {
  "$@" && return
  echo "FAILED  $*"
  echo "0 passed, 1 failed"
  exit 1
}

# How many result files match a pattern.
written() { find "$results" -name "$1" | wc -l; }

results=$repository/build/test_results
rm -rf "$results"
step scripts/install_packages.sh base gui
step scripts/build.sh all tests
step scripts/fuzz.sh 0
stage_began=$SECONDS

mkdir -p "$results/scripts"
for test in scripts/*_test.py; do
  name=$(basename "$test" .py)
  timeout -k 10 300 scripts/run_unittest.py "$test" \
    "$results/scripts/$name.xml" >"build/$name.log" 2>&1 || true
done
stage guards "$(written '*.xml') files of Python tests"

# catkin ends with 0 whatever the tests said; the files they wrote count.
use_workspace
timeout -k 30 "${TEST_LIMIT_S:-840}" make -C build -k -j1 run_tests \
  >build/tests.log 2>&1 || echo "tests:   cut off or broken; see build/tests.log"
cpp=$(written 'gtest-*.xml') ros=$(written 'rosunit-*.xml')
stage tests "results of $cpp C++ and $ros ROS test programs"

scripts/test_results.py "$repository" "$results"
