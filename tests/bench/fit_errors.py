"""Errors of fits to the MERL stand-ins, sorted, as Bandwidth's figure V.12 has them, and their counts.

    burnish_slice_fit_table --data FOLDER --models sgd2,beckmann,ggx > fits.csv; fit_errors.py fits.csv fit_errors.png
"""
import csv
import statistics
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

MODELS = {"sgd2": "SGD, a second lobe where it pays", "sgd": "SGD, one lobe", "ggx": "GGX", "beckmann": "Beckmann"}
COLORS = {"sgd2": "tab:blue", "sgd": "tab:cyan", "ggx": "tab:orange", "beckmann": "tab:red"}


def read(path):
    errors, seconds = {}, []
    for row in csv.DictReader(open(path)):
        of = errors.setdefault(row["material"], {})
        of[row["model"]] = float(row["error"])
        if row["model"] == "sgd2":
            of["sgd"], of["lobes"] = float(row["one_lobe_error"]), int(row["lobes"])
            seconds.append(float(row["seconds"]))
    return errors, seconds


def print_counts(errors, seconds):
    for model in ("sgd", "sgd2"):
        for rival in ("beckmann", "ggx"):
            below = [name for name, of in errors.items() if of[model] < of[rival]]
            print(f"{model} below {rival}: {len(below)} of {len(errors)}; not:", ", ".join(sorted(set(errors) - set(below))))
    for name, of in sorted(errors.items(), key=lambda item: item[1]["sgd2"] / item[1]["sgd"]):
        if of["lobes"] == 2:
            print(f"second lobe: {name} {of['sgd']:.3g} to {of['sgd2']:.3g}")
    print(f"seconds: median {statistics.median(seconds):.2f}, worst {max(seconds):.2f}")


def plot(errors, path):
    names = sorted(errors, key=lambda name: errors[name]["sgd"])
    figure, axes = plt.subplots(figsize=(14, 5.5), layout="constrained")
    for model, label in MODELS.items():
        axes.plot([errors[name][model] for name in names], label=label, color=COLORS[model], lw=1, marker="o", ms=3)
    axes.set_yscale("log")
    axes.set_ylabel("error of V.5.3 over the greatest albedo")
    axes.set_xticks(range(len(names)), names, rotation=90, fontsize=7)
    axes.margins(x=0.01)
    axes.grid(axis="y", alpha=0.3)
    axes.legend()
    figure.savefig(path, dpi=100)


if __name__ == "__main__":
    table, times = read(sys.argv[1])
    print_counts(table, times)
    plot(table, sys.argv[2])
