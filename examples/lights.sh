#!/bin/sh
# Lights near the objects: a softbox and a strip beside the sky, all in one shot file that is laid beside the demo's frame.
# Argument: the folder `burnish demo` wrote (default: demo).
set -eu
demo=${1:-demo}

cp "$(dirname "$0")/lights.json" "$demo/lights.json"
burnish composite "$demo/lights.json"
