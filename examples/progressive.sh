#!/bin/sh
# A picture at once that gets better while someone looks. Argument: the folder `burnish demo` wrote (default: demo).
# Ends when every pixel is within two percent of the exact light; Ctrl-C ends it before.
set -eu
demo=${1:-demo}

burnish composite "$demo/shot.exr" --env "$demo/sky.exr" --up z --assign 'gold=crypto:ball_*' -o "$demo/looking.exr" --preview "$demo/looking.png" --progressive --tolerance 0.02
