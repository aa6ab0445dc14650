#!/usr/bin/env bash
# Layout (clang-format), packages (catkin_lint) and code (clang-tidy); fails on
# any finding. clang-tidy takes the compile commands of a configure without batches
# of sources, in build/lint; of the code only the messages are built there.
#     scripts/lint.sh [FILE.cc...]           clang-tidy on these files only
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"

"$repository/scripts/install_packages.sh" base checks
cd "$repository"
lint=$repository/build/lint
mkdir -p "$lint/devel/lib/python3/dist-packages"
mapfile -t packages < <(find src -mindepth 2 -name package.xml -printf '%h\n' |
  xargs -n 1 basename)
link_packages "$lint/src" "${packages[@]}"
if ! { cmake -G Ninja -S "$lint/src" -B "$lint" -DKG_UNITY=OFF -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DPYTHON_EXECUTABLE=/usr/bin/python3 \
    -DCATKIN_DEVEL_PREFIX="$lint/devel" &&
    ninja -C "$lint" kg_msgs_generate_messages_cpp
  } </dev/null >"$lint/configure.log" 2>&1
then
  fail lint "configure failed, log: $lint/configure.log"
fi
stage lint "compile commands of ${#packages[@]} packages"
mapfile -t code < <(find src/kg_* -name '*.cc' -o -name '*.h' | sort)
mapfile -t units < <(printf '%s\n' "${@:-${code[@]}}" | grep '\.cc$')

clang-format --dry-run -Werror "${code[@]}" ||
  fail lint "run clang-format -i on the files above"
stage lint "${#code[@]} files formatted"
catkin_lint -W2 --strict --offline --quiet src || fail lint catkin_lint
stage lint "packages checked by catkin_lint"
printf '%s\0' "${units[@]}" |
  xargs -0 -n 1 -P "$(nproc)" clang-tidy --quiet -p "$lint" ||
  fail lint clang-tidy
stage lint "${#units[@]} files checked by clang-tidy"
