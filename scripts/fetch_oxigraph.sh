#!/usr/bin/env bash
# Fetches Oxigraph from the npm registry into build/peers, once, and prints the
# folder that require() starts from. Without npm or
# a connection it prints one line and exits with 1.
set -euo pipefail
folder=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/build/peers
if [ ! -e "$folder/node_modules/oxigraph" ]; then
  if ! command -v npm >/dev/null ||
    ! npm install --prefix "$folder" --no-audit --no-fund oxigraph@0.5 >/dev/null 2>&1
  then
    echo "oxigraph: not compared, npm cannot fetch it here"
    exit 1
  fi
fi
echo "$folder"
