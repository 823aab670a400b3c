#!/bin/sh
# Anti-aliased reflections: the demo's surfaces once more at twice its size, for four samples a pixel.
# Arguments: the folder `burnish demo` wrote, and its width and height (default: demo 1280 720).
set -eu
demo=${1:-demo} width=${2:-1280} height=${3:-720}

burnish demo -o "$demo/fine" --width $((2 * width)) --height $((2 * height))
burnish composite "$demo/shot.exr" --fine-aovs "$demo/fine/shot.exr" --filter box --env "$demo/sky.exr" --up z --assign 'gold=crypto:ball_*' -o "$demo/antialiased.exr"
