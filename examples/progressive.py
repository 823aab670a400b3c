"""Pictures that get better while someone looks. Argument: the folder `burnish demo` wrote (default: demo)."""

import sys

import burnish

demo = sys.argv[1] if len(sys.argv) > 1 else "demo"


def show(label, beauty):
    print(label, beauty.mean(axis=(0, 1)))


looks = iter(range(4))


def changed():
    """Whether there is something else to look at by now."""
    return next(looks) == 3


light = burnish.Environment(f"{demo}/sky.exr", up="z")
for layers in burnish.refine(f"{demo}/shot.exr", light, assign=[{"material": "gold", "cryptomatte": "ball_*"}]):
    show(layers["label"], layers["beauty"])
    if changed():
        break  # and begin anew: the light is loaded
