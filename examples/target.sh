#!/bin/sh
# A quality or a time instead of knobs, on the shot that `burnish demo` wrote to the folder (default: demo).
set -eu
demo=${1:-demo}

burnish composite "$demo/shot.json" --psnr 40 -o "$demo/at_40_db.exr"
burnish composite "$demo/shot.json" --max-error 0.1 -o "$demo/near_everywhere.exr"
burnish composite "$demo/shot.json" --time 0.5s -o "$demo/in_half_a_second.exr"
