"""Panes of the demo's room: few samples against the traced reference, by light.

    burnish demo --scene room -o room
    python3 tests/bench/glass_table.py room/shot.json [--materials frosted-glass clear-glass] [--samples 5]

Prints CSV: display PSNR over the pane, samples a lobe (reflection + transmission), seconds of shading by one thread. Needs burnish on
PYTHONPATH.
"""

import argparse
import json
import pathlib

import burnish
import numpy as np


def shaded(folder, shot, rule, chain, **settings):
    lights = {name: dict(shot["lights"][name]) for name in chain}
    for light in lights.values():
        for key in ("file", "scene", "irradiance", "radiance"):
            if key in light:
                light[key] = str(folder / light[key])
    layers = burnish.composite(folder / shot["aovs"], None, assign=[rule | {"light": list(chain)}], lights=lights, threads=1,
                               diagnostics=True, density="dense", **settings)
    return layers["overlay"], layers["validity"] == 0, layers["report"]["seconds"]["shading"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("shot", type=pathlib.Path)
    parser.add_argument("--materials", nargs="+", default=["frosted-glass", "clear-glass"])
    parser.add_argument("--samples", type=int, nargs="+", default=[5, 10, 16])
    parser.add_argument("--lookups", type=int, default=4096, help="of the reference, a lobe and pixel")
    options = parser.parse_args()
    shot, folder = json.loads(options.shot.read_text()), options.shot.parent
    print("material,light,estimator,samples,psnr_db,seconds")
    for rule in (rule for rule in shot["assign"] if rule["material"] in options.materials):
        exact = {"estimator": "reference", "tolerance": 0.005, "max_samples": options.lookups}
        truth, mask, seconds = shaded(folder, shot, rule, ["room"], **exact)
        print(f"{rule['material']},room,reference,{options.lookups},,{seconds:.2f}", flush=True)
        for chain in (["room"], rule["light"], [rule["light"][-1]]):
            for estimator in ("fitted", "regular"):
                for samples in options.samples:
                    overlay, _, seconds = shaded(folder, shot, rule, chain, estimator=estimator, samples=samples)
                    db = burnish.compare(overlay, truth, mask.astype(np.float32))["psnr_db"]
                    print(f"{rule['material']},{' '.join(chain)},{estimator},{samples},{db:.1f},{seconds:.3f}", flush=True)


if __name__ == "__main__":
    main()
