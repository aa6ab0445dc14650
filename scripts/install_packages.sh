#!/usr/bin/env bash
# Installs the missing packages of apt-packages.txt.
#     scripts/install_packages.sh [SECTION...]      base if none is named
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$repository/scripts/stage.sh"

# The packages of one section of the list.
listed() {
  awk -v wanted="[$1]" '/^\[/ { inside = ($1 == wanted); next }
                        { sub(/#.*/, "") } inside && NF { print $1 }' \
      "$repository/apt-packages.txt"
}

# Runs a command as root; without root or sudo, fails with the command to run.
as_root() {
  if [ "$(id -u)" = 0 ]; then
    "$@"
  elif command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }
  then
    sudo "$@"
  else
    fail install "${#missing[@]} packages are missing and there is neither root nor" \
         "sudo; run as root: apt-get install --no-install-recommends" \
         "${missing[@]}"
  fi
}

command -v dpkg-query >/dev/null || fail install "requires Debian 12 (dpkg not found)"
# No process substitution here: a bare chroot may have no /dev/fd.
wanted=()
for section in "${@:-base}"; do
  packages=$(listed "$section")
  [ -n "$packages" ] || fail install "apt-packages.txt has no [$section]"
  mapfile -t -O "${#wanted[@]}" wanted <<<"$packages"
done
installed=$(dpkg-query -W -f='${db:Status-Abbrev} ${Package}\n' |
  awk '$1 == "ii" { print $2 }')
missing=()
for package in "${wanted[@]}"; do
  grep -qxF "$package" <<<"$installed" || missing+=("$package")
done

if [ ${#missing[@]} -gt 0 ]; then
  apt=(env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=600)
  log=$(mktemp)
  echo "install: ${#missing[@]} of ${#wanted[@]} packages missing"
  as_root true
  as_root "${apt[@]}" update </dev/null >"$log" 2>&1 &&
    as_root "${apt[@]}" install -y --no-install-recommends "${missing[@]}" \
      </dev/null >>"$log" 2>&1 ||
    { tail -n 20 "$log" >&2; fail install "apt-get, log: $log"; }
  rm -f "$log"
fi
# ROS resolves localhost by name; a bare chroot has no /etc/hosts.
if ! getent hosts localhost >/dev/null; then
  echo "install: localhost does not resolve; adding it to /etc/hosts"
  as_root sh -c 'echo "127.0.0.1 localhost" >>/etc/hosts'
fi
stage install "${#wanted[@]} packages, ${#missing[@]} newly installed"
