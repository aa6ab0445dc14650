#!/usr/bin/env bash
# Installs, builds, and runs a mission: roslaunch mission bringup.launch ARGS.
#     scripts/bringup.sh mission:=gulf once:=true rviz:=false
# With once:=true the exit status is that of the verdict: 0 only if every agent has
# a plan without violations. The exit status of roslaunch is always 0.
set -euo pipefail
given_master=${ROS_MASTER_URI:-}
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"

# argument NAME DEFAULT ARGS...: the last value given as NAME:=value.
argument() {
  local name=$1 value=$2
  for given in "${@:3}"; do
    case "$given" in "$name:="*) value=${given#*:=} ;; esac
  done
  printf '%s\n' "$value"
}

for given in "$@"; do
  [[ $given == *:=* ]] || fail bringup "expected name:=value, not '$given'"
done
sections=(base)
rviz=$(argument rviz auto "$@")
if [ "$rviz" = true ] || { [ "$rviz" = auto ] && [ -n "${DISPLAY:-}" ]; }; then
  sections+=(gui)
fi
"$repository/scripts/install_packages.sh" "${sections[@]}"
"$repository/scripts/build.sh"

state=$(argument state "$repository/state/$(argument mission gulf "$@")" "$@")
state=$(realpath -m "$state")
use_workspace
if [ -z "$given_master" ]; then
  ROS_MASTER_URI=$("$repository/scripts/free_master.py" "$ROS_MASTER_URI")
fi
echo "master:  $ROS_MASTER_URI; in another terminal, from $repository:"
echo "         export ROS_MASTER_URI=$ROS_MASTER_URI" \
     "&& . scripts/environment.sh && . devel/setup.bash"
echo "state:   $state"

# In its own process group, so that an interrupt reaches roslaunch only once.
began=$(date +%s.%N)
set -m
roslaunch mission bringup.launch "$@" "state:=$state" </dev/null &
roslaunch=$!
set +m
trap 'kill -INT "$roslaunch" 2>/dev/null || true' INT TERM HUP
status=0
wait "$roslaunch" || status=$?
while kill -0 "$roslaunch" 2>/dev/null; do
  wait "$roslaunch" && status=0 || status=$?
done
trap - INT TERM HUP

if [ "$(argument once false "$@")" = true ]; then
  "$repository/scripts/check_verdict.py" "$state/verdict.json" --since "$began"
  exit
fi
exit "$status"
