#!/usr/bin/env bash
# Layout (clang-format), packages (catkin_lint) and code (clang-tidy); fails on
# any finding. Needs a build, for the compile commands.
#     scripts/lint.sh [FILE.cc...]           clang-tidy on these files only
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"

"$repository/scripts/install_packages.sh" base
"$repository/scripts/build.sh"
cd "$repository"
stage_began=$SECONDS
mapfile -t code < <(find src/kg_* -name '*.cc' -o -name '*.h' | sort)
mapfile -t units < <(printf '%s\n' "${@:-${code[@]}}" | grep '\.cc$')

clang-format --dry-run -Werror "${code[@]}" ||
  fail lint "clang-format -i would lay the files above out"
stage lint "${#code[@]} files laid out"
catkin_lint -W2 --strict --offline --quiet src || fail lint catkin_lint
stage lint "packages sound"
printf '%s\0' "${units[@]}" |
  xargs -0 -n 1 -P "$(nproc)" clang-tidy --quiet -p build ||
  fail lint clang-tidy
stage lint "${#units[@]} files read by clang-tidy"
