"""Whether plans meet their targets, and what they cost against the best single setting that an exhaustive search finds.

    tests/bench/plan_targets.py DATA [--size 512] [--cases N] [-o FILE.csv]

A case is a material under a light on a sphere, none of them used to calibrate the models. The search shades it by every configuration the
planner knows, densely and sparsely; its errors and the plan's are measured against `reference` at the same two thousand pixels. Seconds are
of light filtering, tables and shading, fastest of three, and what planning and checking add to that.
"""

import argparse
import csv
import itertools
import pathlib
import sys
import time

import numpy as np

import burnish
from burnish.charting import benchmark, measure

TARGETS = (35, 40, 45, 50)
HDRS = ("studio_small_03_1k", "st_fagans_interior_1k", "dikhololo_night_1k")
DENSE = {"fitted": (1, 2, 3, 4, 6, 8, 12, 16), "regular": (4, 7, 12, 19, 30, 61),
         "filtered_importance": (16, 32, 64, 128, 256, 512, 1024, 2048)}
SAFETIES = (1, 2)


def materials():
    """Name -> material: mirrors to rough, long, layered, of measured numbers, with Fresnel."""
    ggx, beckmann = {"model": "ggx"}, {"model": "beckmann"}
    return {
        "ggx-0.03": {**ggx, "m": 0.03}, "ggx-0.15": {**ggx, "m": 0.15}, "ggx-0.35": {**ggx, "m": 0.35},
        "beckmann-0.03": {**beckmann, "m": 0.03}, "beckmann-0.15": {**beckmann, "m": 0.15}, "beckmann-0.3": {**beckmann, "m": 0.3},
        "kurt-0.08": {"model": "kurt", "m": 0.08, "r0": 0.6}, "ggx-0.25x0.08": {**ggx, "mx": 0.25, "my": 0.08},
        "beckmann-0.15x0.04": {**beckmann, "mx": 0.15, "my": 0.04}, "car-paint": "car-paint", "plastic-satin": "plastic-satin",
        "merl:gold-paint": "merl:gold-paint",
    }


def lights(data):
    """Name -> picture or file."""
    found = {f"stress-{seed}": benchmark.stress_light(seed) for seed in (1, 2)}
    found |= {name: data / f"public/env/{name}.hdr" for name in HDRS}
    found["courtyard"] = data / "cycles/spheres/env_courtyard.exr"
    return found


class Case:
    """One material under one light: how long and how exact."""

    def __init__(self, frame, every, light, material):
        self.frame, self.every, self.light, self.material = frame, every, light, material
        few = {role: array[every] for role, array in frame.items()}
        layers = self.shade(few, estimator="reference", tolerance=0.004, max_samples=16384, density="dense")
        self.covered = layers["validity"] == 0
        self.truth = measure.truth_of(layers, self.covered)

    def shade(self, frame=None, light=None, **settings):
        return burnish.composite(self.frame if frame is None else frame, self.light if light is None else light, self.material,
                                 camera=benchmark.CAMERA, **settings)

    def decibels(self, layers):
        return self.truth.psnr_db(layers["overlay"][self.every][self.covered])

    def run(self, **settings):
        """dB and seconds of tables and shading, the light being filtered already."""
        seconds = []
        while len(seconds) < 3 and sum(seconds) < 0.15:
            layers = self.shade(**settings)
            stages = layers["report"]["seconds"]
            seconds.append(stages["tables"] + stages["shading"])
        return self.decibels(layers), min(seconds)


def filter_seconds(source, case):
    """Form -> seconds that filtering the light takes."""
    found = {}
    for form, estimator in (("pyramid", "regular"), ("stack", "fitted")):
        cold, warm = [], []
        for _ in range(3):
            light = burnish.Environment(source)
            for runs in (cold, warm):
                runs.append(case.shade(light=light, estimator=estimator, samples=4, density="dense")["report"]["seconds"]["tables"])
        found[form] = min(cold) - min(warm)
    return found


def search(case, filtering):
    """(dB, seconds, settings) of every configuration."""
    rows = []
    for estimator, counts in DENSE.items():
        for samples, safety in itertools.product(counts, (0, *SAFETIES)):
            density = {"density": "sparse", "safety": safety} if safety else {"density": "dense"}
            settings = dict(estimator=estimator, samples=samples, **density)
            found, seconds = case.run(**settings)
            forms = {"stack"} if estimator == "fitted" else {"pyramid"} | ({"stack"} if safety else set())
            rows.append((found, seconds + sum(filtering[form] for form in forms), settings))
    return rows


def planned(case, source, target):
    """The plan for a target: what it reached, cost as settings, and took with planning."""
    totals = []
    while len(totals) < 2 and sum(totals) < 2:
        light = burnish.Environment(source)
        begin = time.perf_counter()
        layers = case.shade(light=light, psnr=target)
        totals.append(time.perf_counter() - begin)
    plan, = layers["report"]["plan"]
    settings = {name: plan[name] for name in ("estimator", "samples", "density", "safety", "tolerance") if name in plan}
    if settings["estimator"] == "reference":  # slow, and next to nothing of it is planning
        return case.decibels(layers), plan, settings, min(totals), min(totals)
    plain = []
    while len(plain) < 2 and sum(plain) < 2:
        light = burnish.Environment(source)
        begin = time.perf_counter()
        case.shade(light=light, **settings)
        plain.append(time.perf_counter() - begin)
    return case.decibels(layers), plan, settings, min(totals), min(plain)


def rows_of(name, source, material, frame, every):
    """One row a target."""
    light = burnish.Environment(source)
    case = Case(frame, every, light, material)
    filtering = filter_seconds(source, case)
    found = search(case, filtering)
    for target in TARGETS:
        db, plan, settings, total, plain = planned(case, source, target)
        best = min((row for row in found if row[0] >= target - 0.5), key=lambda row: row[1], default=None)
        forms = set() if settings["estimator"] == "reference" else {"stack"} if settings["estimator"] == "fitted" else {"pyramid"}
        forms |= {"stack"} if settings["density"] == "sparse" else set()
        cost = case.run(**settings)[1] if forms else total
        cost += sum(filtering[form] for form in forms)
        yield {"light": name, "target": target, "db": db, "told_db": plan["found_db"], "least_db": plan["least_db"], "pixels": plan["checked_pixels"],
               "corrected": plan["corrected"], "plan": plan["plan"], "cost_s": cost, "best_s": best[1] if best else None,
               "best": " ".join(map(str, best[2].values())) if best else None, "total_s": total, "plain_s": plain}


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("data", type=pathlib.Path)
    words.add_argument("--size", type=int, default=512, help="pixels of the sphere's diameter [512]")
    words.add_argument("--cases", type=int, help="only so many materials and lights, every k-th")
    words.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("plan_targets.csv"))
    options = words.parse_args()
    frame = benchmark.sphere(options.size)
    step = max(1, options.size // 48)
    every = (slice(step // 2, None, step),) * 2
    pairs = list(itertools.product(lights(options.data).items(), materials().items()))
    if options.cases:
        pairs = pairs[:: max(1, len(pairs) // options.cases)]
    rows = []
    for (name, source), (label, material) in pairs:
        source = str(source) if isinstance(source, pathlib.Path) else source
        for row in rows_of(name, source, {"lobes": [material]} if isinstance(material, dict) else material, frame, every):
            rows.append({"material": label, **row})
            print({key: round(value, 4) if isinstance(value, float) else value for key, value in rows[-1].items()}, file=sys.stderr)
        with open(options.output, "w", encoding="utf-8", newline="") as file:
            table = csv.DictWriter(file, rows[0].keys())
            table.writeheader(), table.writerows(rows)
    print(summary(rows))


def summary(rows):
    """What the rows come to, target by target."""
    lines = ["| target | cases | within 0.5 dB | median dB over | cost within 1.3 of the best | median cost ratio | worst | planning adds, median |",
             "|---|---|---|---|---|---|---|---|"]
    for target in TARGETS:
        own = [row for row in rows if row["target"] == target]
        met = [row for row in own if row["db"] >= target - 0.5]
        ratios = [row["cost_s"] / row["best_s"] for row in own if row["best_s"]]
        added = np.median([row["total_s"] / row["plain_s"] - 1 for row in own])
        lines.append(f"| {target} | {len(own)} | {len(met)} ({100 * len(met) / len(own):.0f} %) | {np.median([row['db'] for row in own]) - target:+.1f} | "
                     f"{sum(ratio <= 1.3 for ratio in ratios)} of {len(ratios)} | {np.median(ratios):.2f} | {max(ratios):.1f} | {100 * added:.0f} % |")
    return "\n".join(lines)


if __name__ == "__main__":
    main()
