#!/bin/sh
# From a fresh clone on a bare Debian 12 to a tested build: installs packages, builds, runs all tests, then those of bad input
# again on a build with sanitizers. The last lines say how it went.
set -eu
cd "$(dirname "$0")/.."

sh .ci/install_packages.sh
cmake --preset release
cmake --build --preset release
ctest --preset release

cmake --preset asan
cmake --build --preset asan --target burnish-cli
# OpenImageIO and oneTBB keep memory until the process ends; that is not what these tests look for.
ASAN_OPTIONS=detect_leaks=0 ctest --preset asan -R 'pytest\.'

echo "burnish: all tests passed, also those of bad input with address and undefined-behaviour sanitizers"
