#!/usr/bin/env bash
# Installs what is missing of tools/packages.txt, and of the packages named as arguments.
set -euo pipefail
list=$(dirname "$0")/packages.txt

installed() { dpkg-query -W -f '${Status}\n' "$1" 2>/dev/null | grep -q '^install ok installed$'; }
available() { [ -n "$(apt-cache madison "$1" 2>/dev/null)" ]; }

required=("$@") optional=()
while read -r package mark _; do
  case $package in '' | '#'*) continue ;; esac
  if [ "$mark" = '?' ]; then optional+=("$package"); else required+=("$package"); fi
done <"$list"

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  echo "setup: there is no apt here; install what these Debian packages hold," \
    "then run make with SETUP=: to leave out this step:" >&2
  printf '  %s\n' "${required[@]}" >&2
  exit 1
fi

missing=()
for package in "${required[@]}"; do
  if ! installed "$package"; then missing+=("$package"); fi
done
if [ ${#missing[@]} -eq 0 ]; then exit 0; fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: neither root nor sudo here; as root, run: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
run_apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get "$@"; }

run_apt update
extra=()
for package in "${optional[@]}"; do
  if available "$package"; then
    extra+=("$package")
  else
    echo "setup: there is no $package here; going on without it" >&2
  fi
done
run_apt install --yes --no-install-recommends "${missing[@]}" "${extra[@]}"
