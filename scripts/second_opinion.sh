#!/usr/bin/env bash
# Random small graphs and queries, answered by our engine, by rdflib and, where npm
# can fetch it, by Oxigraph. All must give the same bags of solutions.
#     scripts/second_opinion.sh CASES
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"
cd "$repository"

cases=${1:?"usage: scripts/second_opinion.sh CASES"}
scripts/install_packages.sh base checks
scripts/build.sh kg_core_random_cases

# ask ENGINE [ARGUMENT...]
ask() {
  local log=build/second_opinion_$1.log
  devel/lib/kg_core/random_cases "$cases" |
    scripts/second_opinion.py "$@" >"$log" || fail "$1" "$(tail -n 1 "$log"): $log"
  stage "$1" "$(tail -n 1 "$log")"
}

ask rdflib
modules=$(scripts/fetch_oxigraph.sh) || { echo "$modules"; exit 0; }
ask oxigraph "$modules"
