#!/bin/sh
# A material of one's own: on a ball, and in the frame that `burnish demo` wrote to the folder (default: demo).
set -eu
demo=${1:-demo}
here=$(dirname "$0")

burnish preview "$here/lacquered_copper.json" -o "$demo/lacquered_copper.png"
burnish composite "$demo/shot.exr" --env "$demo/sky.exr" --up z --material "$here/lacquered_copper.json" -o "$demo/lacquered_copper.exr"
burnish models "$here/varnished_brass.gltf"
burnish composite "$demo/shot.exr" --env "$demo/sky.exr" --up z --material "$here/varnished_brass.gltf#varnished_brass" -o "$demo/varnished_brass.exr"
