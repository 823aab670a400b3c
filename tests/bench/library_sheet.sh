#!/bin/sh
# The 100 measured materials of the library on balls, as one picture: sh tests/bench/library_sheet.sh library.jpg
# Needs burnish, python3 and oiiotool on the PATH.
set -eu
output=${1:?usage: library_sheet.sh OUTPUT}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

for name in $(burnish models --json | python3 -c 'import json, sys; print(*json.load(sys.stdin)["library"])'); do
    burnish preview "$name" --size 96 --exposure 0.5 -o "$folder/${name#merl:}.png"
done
oiiotool "$folder"/*.png --mosaic:pad=0 10x10 --compression jpeg:88 -o "$output"
