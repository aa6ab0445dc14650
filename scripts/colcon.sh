#!/usr/bin/env bash
# Builds and installs the workspace with colcon, each package by itself, into
# build/colcon/, and runs the program `kg` from there. `make bringup` does not need
# it: it is for workspaces that are built with colcon.
#     scripts/colcon.sh [PACKAGE...]      these packages and those they depend on
# Afterwards: . build/colcon/install/setup.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"
cd "$repository"

scripts/install_packages.sh base colcon
folder=$repository/build/colcon
log=$folder/build.log
mkdir -p "$folder"
use_ccache
export MAKEFLAGS=-j${JOBS:-$(nproc)}
selected=()
[ $# -eq 0 ] || selected=(--packages-up-to "$@")
echo "colcon:  log: build/colcon/build.log"
# The packages one by one: src/ itself is a workspace of catkin_make.
if ! colcon --log-base "$folder/log" build --base-paths src/*/ \
    --build-base "$folder/build" --install-base "$folder/install" \
    --executor sequential --catkin-skip-building-tests "${selected[@]}" \
    --cmake-args -DCMAKE_BUILD_TYPE=Release -DCATKIN_ENABLE_TESTING=OFF \
    -DPYTHON_EXECUTABLE=/usr/bin/python3 </dev/null >"$log" 2>&1
then
  grep -nE 'error|Error|\*\*\*' "$log" | head -n 40 >&2 || true
  fail colcon "log: $log"
fi
installed=("$folder"/install/*/share/*/package.xml)
stage colcon "${#installed[@]} packages installed in build/colcon/install"

# The installed program finds its libraries and the ontology there.
set +u
source "$folder/install/setup.sh"
set -u
program=$(find "$folder/install" -path '*/lib/kg_*/kg' -type f)
[ -n "$program" ] || exit 0
"$program" --help >"$folder/help.log" || fail colcon "kg --help, log: $folder/help.log"
stage colcon "kg --help runs from build/colcon/install"
