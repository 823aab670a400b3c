"""The rows of the rivals as two markdown tables: every run, and what 40 dB cost.

Cycles' time at 40 dB is read off the line through its runs, log time over dB, drawn on beyond the last; burnish's is that of the
cheapest setting that has 40 dB or more.
"""

import numpy as np

from rival_scene import WHOLE, WITHOUT_LONG

TARGET_DB = 40
TIMES = {"a frame": ("frame_s",), "with tables": ("frame_s", "once_s"), "whole program": ("process_s",),
         "its processor time": ("cpu_s",)}


def select(rows, **fields):
    """The rows that have these values."""
    return [row for row in rows if all(row[name] == value for name, value in fields.items())]


def cycles_at(rows, times):
    """Seconds of Cycles at the target; None below two runs."""
    runs = sorted((row["db"], np.log(sum(row[name] for name in times))) for row in select(rows, rival="cycles"))
    if len(runs) < 2:
        return None
    above = next((i for i, (db, _) in enumerate(runs) if db >= TARGET_DB and i > 0), len(runs) - 1)
    (low, begin), (high, end) = runs[above - 1], runs[above]
    return float(np.exp(begin + (end - begin) * (TARGET_DB - low) / (high - low)))


def burnish_at(rows, times):
    """(seconds, setting) of the cheapest run of burnish that reaches the target; None where none does."""
    able = [(sum(row[name] for name in times), row["setting"]) for row in select(rows, rival="burnish") if row["db"] >= TARGET_DB]
    return min(able, default=None)


def run_table(rows):
    """All runs, a line each."""
    lines = ["| scene | rival | dB, whole frame | without the 1:11 spheres | objects | against Cycles' 1024 samples | "
             "a frame | once | whole program | its processor time |", "|---" * 10 + "|"]
    for row in select(rows, part=WHOLE):
        same = select(rows, scene=row["scene"], setting=row["setting"])
        objects = [other["db"] for other in same if other["part"] not in (WHOLE, WITHOUT_LONG)]
        short = select(same, part=WITHOUT_LONG)[0]["db"]
        against = "" if row["db_to_cycles"] is None else f"{row['db_to_cycles']:.1f}"
        name = row["setting"] if row["rival"] == "burnish" else f"{row['family']}, {row['setting']}"
        lines.append(f"| {row['scene']} | {name} | {row['db']:.1f} | {short:.1f} | {min(objects):.0f} to {max(objects):.0f} | {against} | "
                     f"{row['frame_s']:.3f} s | {row['once_s']:.2f} s | {row['process_s']:.2f} s | {row['cpu_s']:.2f} s |")
    return lines


def target_table(rows):
    """What the target costs, part by part."""
    lines = [f"| scene | {TARGET_DB} dB on | Cycles | burnish | a frame | Cycles over burnish: "
             + " | ".join(list(TIMES)[1:]) + " |", "|---" * (5 + len(TIMES)) + "|"]
    for scene in dict.fromkeys(row["scene"] for row in rows):
        for part in dict.fromkeys(row["part"] for row in rows):
            of_part = select(rows, scene=scene, part=part)
            whole, own = cycles_at(of_part, TIMES["a frame"]), burnish_at(of_part, TIMES["a frame"])
            if whole is None or own is None:
                continue
            ratios = [cycles_at(of_part, times) / burnish_at(of_part, times)[0] for times in TIMES.values()]
            lines.append(f"| {scene} | {part} | {whole:.1f} s | {own[1]} | {own[0]:.4f} s | "
                         + " | ".join(f"{ratio:.0f}" for ratio in ratios) + " |")
    return lines


def markdown(rows):
    """Both tables."""
    return "\n".join([*run_table(rows), "", *target_table(rows)]) + "\n"
