#!/usr/bin/env bash
# Takes the picture of rviz with rviz/mission.rviz, without a screen (Xvfb, software
# OpenGL), of the default mission after its first plan.
#     scripts/take_screenshot.sh [PICTURE.png] [launch arguments...]
# PICTURE defaults to docs/images/mission.png. NODES=none takes it without any
# node running, for comparison. CONFIG=FILE.rviz uses another configuration (saved
# from rviz).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
if ! python3 -c "import kg_msgs" 2>/dev/null; then
  set +u
  source "$repository/devel/setup.bash"
  set -u
fi

picture=$(realpath -m "${1:-$repository/docs/images/mission.png}")
shift || true
screen=1600x960x24
west=100x850+375+70    # The map's western edge, beside rviz's splash screen.
plan_s=300             # Longest wait for a plan.
drawing_s=60           # Longest wait for rviz to draw.
drawn_colours=16       # So many colours only a map that is drawn has.

scratch=$(mktemp -d)
started=()
finish() {
  for pid in "${started[@]}"; do kill -INT "$pid" 2>/dev/null || true; done
  for pid in "${started[@]}"; do wait "$pid" 2>/dev/null || true; done
  rm -rf "$scratch"
}
trap finish EXIT

# start COMMAND...: runs it in the background until this script ends, in its own
# process group: background jobs of a shell ignore interrupts.
start() {
  set -m
  "$@" >>"$scratch/log" 2>&1 </dev/null &
  started+=($!)
  set +m
}

ROS_MASTER_URI=$("$repository/scripts/free_master.py" "$ROS_MASTER_URI")
export ROS_MASTER_URI
port=${ROS_MASTER_URI##*:}
if [ "${NODES:-}" = none ]; then
  start roscore -p "${port%/}"
else
  start roslaunch -p "${port%/}" mission bringup.launch rviz:=false sim:=false \
    "state:=$scratch/state" "$@"
  timeout "$plan_s" bash -c 'until rostopic echo -n 1 --noarr /kg/assignments
    do sleep 1; done' >/dev/null 2>&1 ||
    { tail -n 20 "$scratch/log" >&2; echo "no plan in $plan_s s" >&2; exit 1; }
fi

mkfifo "$scratch/display"
set -m
Xvfb -displayfd 3 -screen 0 "$screen" 3>"$scratch/display" >/dev/null 2>&1 &
started+=($!)
set +m
read -r display <"$scratch/display"
export DISPLAY=:$display LIBGL_ALWAYS_SOFTWARE=1
start rviz -d "${CONFIG:-$repository/rviz/mission.rviz}"

# Drawn when the map has many colours; paths and markers come with the frames
# that follow.
colours() {
  import -window root "$scratch/look.png" &&
    convert "$scratch/look.png" -crop "$west" +repage -format '%k' info:
}
deadline=$((SECONDS + drawing_s))
if [ "${NODES:-}" = none ]; then deadline=$((SECONDS + 8)); fi
until [ "$(colours)" -gt "$drawn_colours" ] || [ $SECONDS -gt $deadline ]; do
  sleep 1
done
sleep 4
mkdir -p "$(dirname "$picture")"
import -window root "$scratch/look.png"
convert "$scratch/look.png" -strip "$picture"
echo "$picture"
