#!/usr/bin/env bash
# The long form of the test that kills the KG node at random moments.
#     scripts/kill_rounds.sh ROUNDS
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"
cd "$repository"

rounds=${1:?"usage: scripts/kill_rounds.sh ROUNDS"}
scripts/install_packages.sh base checks
scripts/build.sh
use_workspace
log=build/kill_rounds.log
KILL_ROUNDS=$rounds KILL_LIMIT_S=$((120 + 20 * rounds)) \
  rostest --text mission kill_rounds.test >"$log" 2>&1 || true
grep -q ' \* RESULT: SUCCESS' "$log" || fail kill "log: $log"
stage kill "$(grep -oE '[0-9]+ rounds, .*' "$log")"
