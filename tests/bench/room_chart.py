"""Representations of the light in a room: accuracy against Cycles' glossy passes, beside the time they take.

    python3 tests/bench/room_chart.py DATA/cycles/room [--chart chart.png] [--repeats 3]

Prints CSV: display PSNR per object, seconds of one thread for light, tables and shading. `floor in vase`: pixels of the vase that
mirror the floor; `inside it`: those whose neighbours two pixels around do, too. Needs burnish, OpenImageIO and matplotlib on PYTHONPATH.
"""

import argparse
import pathlib
import sys

import burnish

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import cycles
import room

CHAINS = {"infinite cube": ["infinite"], "two planes": ["planes"], "box": ["box"], "depth impostor": ["depth"], "mesh": ["mesh"],
          "mirror, one step": ["one_step", "box"], "mirror": ["mirror", "box"], "traced": ["traced"]}
SHOWN = {"floor": "s", "vase": "o", "floor in vase": "^"}
REFERENCE = {"estimator": "reference", "tolerance": 0.01, "max_samples": 4096}


def masks_of(folder):
    channels = room.layers(folder)
    index = channels["ViewLayer.IndexMA.X"]
    floor, vase = (cycles.interior(index, number, margin=1) for number in (1, 2))
    mirrored = vase & room.sees_floor(folder, channels)
    return {"floor": floor, "vase": vase, "floor in vase": mirrored,
            "inside it": cycles.interior(mirrored, True, margin=2)}, room.glossy(channels)


def measured(job, repeats):
    """The overlay, and the least seconds of each stage of the repeats."""
    runs = [burnish.composite(**job, threads=1) for _ in range(repeats)]
    stages = {}
    for run in runs:
        for stage, seconds in run["report"]["seconds"].items():
            stages[stage] = min(stages.get(stage, seconds), seconds)
    return runs[0]["overlay"], stages


def rows(folder, repeats):
    masks, truth = masks_of(folder)
    runs = [(name, chain, {"density": "dense"}, repeats) for name, chain in CHAINS.items()]
    runs += [(f"{name}, sparse", CHAINS[name], {"density": "sparse"}, repeats) for name in ("box", "mesh", "mirror", "traced")]
    runs += [(f"{name}, reference", CHAINS[name], REFERENCE, 1) for name in ("mirror", "traced")]
    for name, chain, settings, count in runs:
        overlay, stages = measured(room.job_of(folder, chain) | settings, count)
        yield name, {key: burnish.compare(overlay, truth, mask)["psnr_db"] for key, mask in masks.items()}, stages


def draw(table, path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(8, 5), layout="constrained")
    for key, marker in SHOWN.items():
        axes.plot([stages["shading"] for _, _, stages in table], [db[key] for _, db, _ in table], marker, label=key, alpha=0.8)
    for name, db, stages in table:
        axes.annotate(name, (stages["shading"], max(db[key] for key in SHOWN)), fontsize=7, rotation=65, xytext=(-2, 5),
                      textcoords="offset points")
    axes.set(xscale="log", ylim=(14, 56), xlabel="shading of the frame, seconds of one core", ylabel="display PSNR against Cycles, dB")
    axes.grid(alpha=0.3), axes.legend(loc="lower right")
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--chart", type=pathlib.Path)
    parser.add_argument("--repeats", type=int, default=3)
    options = parser.parse_args()
    table = []
    print("light,floor_db,vase_db,floor_in_vase_db,inside_it_db,light_s,tables_s,shading_s")
    for name, db, stages in rows(options.folder, options.repeats):
        table.append((name, db, stages))
        numbers = [f"{db[key]:.1f}" for key in ("floor", "vase", "floor in vase", "inside it")]
        numbers += [f"{stages.get(stage, 0):.3f}" for stage in ("light", "tables", "shading")]
        print(",".join([name, *numbers]), flush=True)
    if options.chart:
        draw(table, options.chart)


if __name__ == "__main__":
    main()
