#!/usr/bin/env bash
# Builds the libraries that do not use ROS, and their tests, with AddressSanitizer and
# UndefinedBehaviorSanitizer, in build/sanitize, and runs every test. gcc's "undefined"
# leaves out the conversion of a floating point number that no integer holds.
#     scripts/sanitize.sh [PACKAGE...]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"
cd "$repository"

mapfile -t libraries < <(library_packages)
packages=("$@")
[ $# -gt 0 ] || packages=("${libraries[@]}")
build=$repository/build/sanitize
scripts/install_packages.sh base checks
mkdir -p "$build/devel/lib/python3/dist-packages"
link_packages "$build/src" "${libraries[@]}"

if ! { cmake -G Ninja -S "$build/src" -B "$build" \
    -DKG_SANITIZE=address,undefined,float-cast-overflow \
    -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" \
    -DCATKIN_DEVEL_PREFIX="$build/devel" -DPYTHON_EXECUTABLE=/usr/bin/python3 &&
    ninja -C "$build" -j"${JOBS:-$(nproc)}" all tests
  } </dev/null >"$build/build.log" 2>&1
then
  grep -nE 'error|^FAILED' "$build/build.log" | head -n 20 >&2 || true
  fail sanitize "build failed, log: $build/build.log"
fi
stage sanitize "built"

export ASAN_OPTIONS=detect_stack_use_after_return=1
export UBSAN_OPTIONS=print_stacktrace=1
shopt -s nullglob
passed=0 broken=()
for package in "${packages[@]}"; do
  for test in "$build/devel/lib/$package"/*_test; do
    name=$(basename "$test")
    if (cd "src/$package" && "$test") >"$build/$name.log" 2>&1; then
      passed=$((passed + 1))
    else
      broken+=("$name")
    fi
  done
done
stage sanitize "$passed test programs passed, ${#broken[@]} failed"
[ ${#broken[@]} -eq 0 ] || fail sanitize "${broken[*]}: logs: build/sanitize/*.log"
