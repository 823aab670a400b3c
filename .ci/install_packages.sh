#!/bin/sh
# Installs what burnish needs on Debian 12 (.ci/packages.txt): by apt-get, with sudo when not root, and only what is missing.
set -eu

list=$(sed 's/#.*//' "$(dirname "$0")/packages.txt")
missing=
for package in $list; do
    case $(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true) in
        *" installed") ;;
        *) missing="$missing $package" ;;
    esac
done
[ -n "$missing" ] || exit 0

as_root=
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "install_packages.sh: run as root, or install sudo; missing:$missing" >&2; exit 1; }
    as_root=sudo
fi
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get update -qq
# shellcheck disable=SC2086
$as_root apt-get install -y -qq --no-install-recommends $missing
