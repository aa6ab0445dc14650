#!/usr/bin/env bash
# Builds the fuzzers (libFuzzer, AddressSanitizer, UndefinedBehaviorSanitizer;
# clang) and runs each, starting from files of the tree and inputs of earlier runs.
#     scripts/fuzz.sh SECONDS [FUZZER...]         e.g. scripts/fuzz.sh 600 wkt
# 0 seconds: builds only.
# An input that breaks a fuzzer is kept in build/fuzz/found/<fuzzer>/; the exit
# status is 1 then.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"
cd "$repository"

seconds=${1:?"usage: scripts/fuzz.sh SECONDS [FUZZER...]"}
shift
fuzzers=("$@")
[ $# -gt 0 ] || fuzzers=(turtle wkt query policy_json)
build=$repository/build/fuzz
source "$repository/scripts/fuzz_seeds.sh"

# package_of FUZZER: the package that holds its source.
package_of() {
  local source
  source=$(find src/kg_* -name "$1_fuzz.cc")
  [ -n "$source" ] || fail fuzz "no source of fuzzer $1"
  cut -d/ -f2 <<<"$source"
}

targets=()
for name in "${fuzzers[@]}"; do
  targets+=("$(package_of "$name")_${name}_fuzz")
done
mapfile -t packages < <(library_packages)
"$repository/scripts/install_packages.sh" base checks
mkdir -p "$build/devel/lib/python3/dist-packages"
link_packages "$build/src" "${packages[@]}"
if ! { CC=clang CXX=clang++ cmake -G Ninja -S "$build/src" -B "$build" -DKG_FUZZ=ON \
    -DKG_SANITIZE=address,undefined -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" \
    -DCATKIN_ENABLE_TESTING=OFF -DPYTHON_EXECUTABLE=/usr/bin/python3 \
    -DCATKIN_DEVEL_PREFIX="$build/devel" &&
    ninja -C "$build" -j"${JOBS:-$(nproc)}" "${targets[@]}"
  } </dev/null >"$build/build.log" 2>&1
then
  grep -nE 'error|^FAILED' "$build/build.log" | head -n 20 >&2 || true
  fail fuzz "build failed, log: $build/build.log"
fi
stage fuzz "${#fuzzers[@]} fuzzers built"
[ "$seconds" -gt 0 ] || exit 0

# Runs one fuzzer; its log ends with the number of inputs it tried.
fuzz() {
  local name=$1 corpus=$build/corpus/$1 found=$build/found/$1 package
  package=$(package_of "$name")
  mkdir -p "$corpus" "$found"
  "seeds_of_$name" "$corpus"
  (cd "$repository/src/$package" && "$build/devel/lib/$package/${name}_fuzz" \
    -max_total_time="$seconds" -timeout=20 -rss_limit_mb=3000 -max_len=4096 \
    -print_final_stats=1 -dict="$repository/scripts/fuzz_words/$name.dict" \
    -artifact_prefix="$found/" "$corpus") >"$build/$name.log" 2>&1
}

broken=()
for name in "${fuzzers[@]}"; do
  fuzz "$name" || broken+=("$name")
  tried=$(sed -n 's/^stat::number_of_executed_units: *//p' "$build/$name.log")
  stage fuzz "$name tried ${tried:-0} inputs"
done
[ ${#broken[@]} -eq 0 ] ||
  fail fuzz "${broken[*]}: logs: build/fuzz/<name>.log, inputs: build/fuzz/found/"
