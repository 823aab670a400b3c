#!/bin/sh
# The quickstart on the command line. Argument: the folder `burnish demo` wrote (default: demo).
set -eu
demo=${1:-demo}

burnish composite "$demo/shot.exr" --env "$demo/sky.exr" --up z --assign 'gold=crypto:ball_*' -o "$demo/quickstart.exr"
