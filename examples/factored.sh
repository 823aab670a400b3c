#!/bin/sh
# Gold under the sky of the demo as three small maps, in an EXR, as 8-bit pictures and with a shader (folder: that of `burnish demo`).
set -eu
demo=${1:-demo}

burnish factor --material gold --env "$demo/sky.exr" --up z -o "$demo/gold.exr" --png "$demo/gold" --glsl "$demo/gold.glsl"
