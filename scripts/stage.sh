# Functions that the commands share: progress, failure, environment. To be sourced.

# Seconds since this file was sourced first.
stage_began=$SECONDS

# stage NAME TEXT: one line; the seconds are those since the stage began.
stage() {
  printf '%-8s %s, %d s\n' "$1:" "$2" $((SECONDS - stage_began))
  stage_began=$SECONDS
}

# fail NAME TEXT...: ends the script with one line.
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

# Compiles through ccache where it is installed, unless another launcher is set.
# Paths below the repository are hashed relative to it.
use_ccache() {
  command -v ccache >/dev/null || return 0
  export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER:-ccache}
  export CCACHE_BASEDIR=${CCACHE_BASEDIR:-$repository} CCACHE_NOHASHDIR=1
}

# library_packages: names of the C++ packages without ROS, one a line.
library_packages() {
  grep -LE '<depend>(roscpp|kg_msgs)</depend>|message_generation' \
    "$repository"/src/kg_*/package.xml | xargs -n 1 dirname | xargs -n 1 basename
}

# link_packages FOLDER PACKAGE...: makes FOLDER a workspace of these packages.
link_packages() {
  rm -rf "$1" && mkdir -p "$1"
  ln -s /usr/share/catkin/cmake/toplevel.cmake "$1/CMakeLists.txt"
  for package in "${@:2}"; do
    ln -s "$repository/src/$package" "$1/$package"
  done
}
