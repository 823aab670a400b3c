#!/bin/sh
# Speed against accuracy, on the shot that `burnish demo` wrote to the folder (default: demo): small charts, and where the overlay varies.
set -eu
demo=${1:-demo}

burnish chart "$demo/shot.json" --quick --materials gold -o "$demo/chart"
burnish chart --estimators --quick --materials ggx-0.1 --lights stress-1 -o "$demo/estimators"
burnish bandwidth "$demo/shot.exr" --env "$demo/sky.exr" --up z --material chrome -o "$demo/bandwidth.exr" --preview "$demo/levels.png"
