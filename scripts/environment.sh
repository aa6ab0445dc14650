# ROS environment of all scripts; to be sourced, also by hand:
#
#     . scripts/environment.sh && . devel/setup.bash
#
# Debian's ROS is installed in /usr without a setup file. Debian's Python must come
# first in PATH. All ROS traffic stays on the loopback interface.

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

export PATH="/usr/bin:/bin:/usr/sbin:/sbin:$PATH"
export ROS_VERSION=1 ROS_PYTHON_VERSION=3 ROS_DISTRO=Debian
export ROS_HOSTNAME=localhost
export ROS_MASTER_URI=${ROS_MASTER_URI:-http://127.0.0.1:11311}
export ROS_HOME=${ROS_HOME:-$repository/state/ros_home}
export ROSCONSOLE_FORMAT='[${severity}] ${node}: ${message}'
export ROS_LANG_DISABLE=genlisp  # C++ and Python are enough.
export PYTHONDONTWRITEBYTECODE=1
unset ROS_IP ROS_NAMESPACE
