#!/bin/sh
# The command line's quick start: what a frame holds, a sequence, and how far two pictures are apart. Argument: the folder that
# `burnish demo` wrote (default: demo).
set -eu
demo=${1:-demo}
for frame in 0001 0002; do cp "$demo/shot.exr" "$demo/shot.$frame.exr"; done

burnish info "$demo/shot.exr"
burnish composite "$demo/shot.####.exr" --frames 1-2 --env "$demo/sky.exr" --up z --material chrome -o "$demo/sequence.####.exr" --skip-existing
burnish compare "$demo/quickstart.exr" "$demo/out.exr"
