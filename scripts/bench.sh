#!/usr/bin/env bash
# Builds and runs every benchmark program (devel/lib/*/*_bench).
#     scripts/bench.sh [--only=NAME] [ARGUMENT OF EVERY PROGRAM...]
# NAME is part of a program's name: --only=store runs store_bench only;
# --triples=100000,1000000,3000000 sets its sizes. store_bench also measures rdflib,
# and Oxigraph if npm can fetch it. --quick is a short check that the programs run:
# small sizes, few rounds.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"

only=
arguments=()
for argument in "$@"; do
  case $argument in
    --only=*) only=${argument#--only=} ;;
    *) arguments+=("$argument") ;;
  esac
done

"$repository/scripts/install_packages.sh" base checks
"$repository/scripts/build.sh" all benches
use_workspace
shopt -s nullglob
export KG_SHARED_DATA=${KG_SHARED_DATA:-$repository/../shared/data}
programs=("$repository"/devel/lib/*/*"$only"*_bench)

# find_peers: sets KG_STORE_BENCH_PEERS; prints which stores are not compared.
find_peers() {
  local peers
  local rdflib="$repository/scripts/bench_store_rdflib.py"
  local oxigraph="$repository/scripts/bench_store_oxigraph.mjs"
  KG_STORE_BENCH_PEERS=
  if /usr/bin/python3 -c 'import rdflib' 2>/dev/null; then
    KG_STORE_BENCH_PEERS="rdflib=100000=/usr/bin/python3 $rdflib"
  else
    echo "bench:   no rdflib (python3-rdflib), not compared"
  fi
  if peers=$("$repository/scripts/fetch_oxigraph.sh"); then
    KG_STORE_BENCH_PEERS+=";oxigraph=10000000=cd '$peers' && node $oxigraph"
  else
    echo "bench:   $peers"
  fi
  export KG_STORE_BENCH_PEERS=${KG_STORE_BENCH_PEERS#;}
}

# find_numpy: sets KG_TENSOR_BENCH_NUMPY if numpy is installed.
find_numpy() {
  if /usr/bin/python3 -c 'import numpy' 2>/dev/null; then
    KG_TENSOR_BENCH_NUMPY="/usr/bin/python3 '$repository/scripts/bench_tensor_numpy.py'"
    export KG_TENSOR_BENCH_NUMPY
  else
    echo "bench:   no numpy (python3-numpy), not compared"
  fi
}

processor=$(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -n 1)
for program in "${programs[@]}"; do
  [[ $program == */store_bench ]] && find_peers
  [[ $program == */tensor_bench ]] && find_numpy
  echo "bench:   $(basename "$program") on $(nproc) cores, $processor"
  "$program" "${arguments[@]}"
done
stage bench "${#programs[@]} benchmark programs"
