#!/bin/sh
# Lights of a room from its geometry: cube maps, a mirror, and the frame of a camera. Argument: the folder that
# `burnish demo --scene room` wrote (default: room).
set -e
room=${1:-room}

burnish bake "$room/scene.glb" --up z --irradiance "$room/irradiance.exr" --cube 'ball_*' --mirror 'floor_*' \
  --camera '{"position": [0, -2.4, 1.4], "look_at": [0, 1, 0.7], "up": [0, 0, 1], "fov_x_deg": 70}' --size 640x360 -o "$room/baked"
burnish composite "$room/baked/shot.json"
