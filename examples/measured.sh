#!/bin/sh
# Measured materials: one of the library on a ball and in a frame, as a table, and fitted. Argument: the folder `burnish demo` wrote
# (default: demo).
set -eu
cd "${1:-demo}"

burnish preview merl:brass -o brass.png
burnish tabulate merl:gold-paint -o gold-paint.binary              # stands for a table of your own
burnish composite shot.exr --env sky.exr --up z --material gold-paint.binary -o measured.exr
burnish fit gold-paint.binary -o gold-paint.json --plots gold-paint
burnish composite shot.exr --env sky.exr --up z --material gold-paint.json -o fitted.exr
