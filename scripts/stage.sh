# What the commands share: one line of progress a stage, and failing clearly.
# To be sourced.

# Seconds since this file was sourced first.
stage_began=$SECONDS

# stage NAME TEXT: one line; the seconds are those since the stage began.
stage() {
  printf '%-8s %s, %d s\n' "$1:" "$2" $((SECONDS - stage_began))
  stage_began=$SECONDS
}

# fail NAME TEXT...: ends the script with one clear line.
fail() {
  printf '%-8s FAILED: %s\n' "$1:" "${*:2}" >&2
  exit 1
}

# Makes the built packages known; catkin's setup file reads unset variables.
use_workspace() {
  set +u
  source "$repository/devel/setup.bash"
  set -u
}
