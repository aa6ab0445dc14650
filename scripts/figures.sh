#!/usr/bin/env bash
# Makes the pictures of README and docs: runs every scripts/figure_* program.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"

"$repository/scripts/install_packages.sh" base gui
"$repository/scripts/build.sh"
use_workspace
shopt -s nullglob
programs=("$repository"/scripts/figure_*)
for program in "${programs[@]}"; do
  "$program"
done
stage figures "${#programs[@]} programs"
