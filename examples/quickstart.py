"""The quickstart in Python. Argument: the folder `burnish demo` wrote (default: demo)."""

import sys

import burnish

demo = sys.argv[1] if len(sys.argv) > 1 else "demo"

layers = burnish.composite(f"{demo}/shot.exr", f"{demo}/sky.exr", up="z", assign=[{"material": "gold", "cryptomatte": "ball_*"}])

overlay = layers["overlay"]  # ndarray, shape (height, width, 3), float32, linear
print("overlay", overlay.shape, "mean", overlay.mean(axis=(0, 1)))
