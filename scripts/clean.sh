#!/usr/bin/env bash
# Removes everything that these commands have written, including the facts in state/.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

cd "$repository"
rm -rf build devel install state .catkin_workspace
rm -f src/CMakeLists.txt config/missions/gulf/*.nc config/missions/gulf/*.part \
  config/missions/wildfire/*.nc config/missions/wildfire/*.part
find . -name __pycache__ -not -path './.git/*' -prune -exec rm -rf {} +
