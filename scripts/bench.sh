#!/usr/bin/env bash
# Builds and runs every benchmark program (devel/lib/*/*_bench).
#     scripts/bench.sh [ARGUMENT OF EVERY PROGRAM...]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"

"$repository/scripts/install_packages.sh" base
"$repository/scripts/build.sh"
use_workspace
shopt -s nullglob
programs=("$repository"/devel/lib/*/*_bench)
processor=$(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -n 1)
for program in "${programs[@]}"; do
  echo "bench:   $(basename "$program") on $(nproc) cores, $processor"
  "$program" "$@"
done
stage bench "${#programs[@]} benchmark programs"
