#!/bin/sh
# From a fresh clone on a bare Debian 12 to the first pictures: installs packages, builds the command line, runs the demo.
#   examples/demo.sh [folder for the pictures, default: demo]
set -eu

out=${1:-demo}
case $out in /*) ;; *) out=$PWD/$out ;; esac
cd "$(dirname "$0")/.."

sh .ci/install_packages.sh
cmake --preset release
cmake --build --preset release --target burnish-cli
build/release/bin/burnish demo -o "$out"
