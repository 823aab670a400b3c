"""The chart as one page: what a picture of some quality costs, what the default loses, fronts and error images."""

from __future__ import annotations

import json
import os
import platform
import statistics

from .. import __version__
from . import front_picture
from .front import TARGETS_DB, cheapest, regret_of
from .images import EQUAL_DB, EQUAL_TIME, SHOWN_ERROR
from .page import Page
from .scene import WHOLE

GROUPS = {"equal time": f"In the time of the default (up to {EQUAL_TIME:g} times it), the best of each estimator:",
          "equal error": f"At {EQUAL_DB} dB, the cheapest of each estimator that gets there:"}


def page_of(rows, effort, kept):
    """The Page; `kept`: scene -> what the store keeps of it."""
    page = Page("burnish: speed against accuracy")
    page.text(f"{len(rows)} settings measured on {len(cases(rows))} pairs of a scene and a material in it. Times are milliseconds "
              f"of {effort.cores} threads; dB is display PSNR against the converged reference. \"Each further frame\" is surfaces, "
              "shading and compositing; \"alone\" adds what is made once: light, tables.")
    add_summary(page, rows)
    for scene in dict.fromkeys(row.scene for row in rows):
        add_scene(page, scene, [row for row in rows if row.scene == scene], kept.get(scene, {}))
    add_method(page, rows, effort)
    return page


def cases(rows):
    """(scene, material) -> rows."""
    found = {}
    for row in rows:
        found.setdefault((row.scene, row.material), []).append(row)
    return found


def add_summary(page, rows):
    """Over all scenes: how each estimator fares at each target, and the regret of the default."""
    page.heading("What a picture of some quality costs")
    page.text("Of all pairs: in how many an estimator reaches the target, its median time there for each further frame, and in how "
              "many it is the cheapest of all that do.")
    lines = []
    for estimator in dict.fromkeys(row.estimator for row in rows):
        cells = [estimator.replace("_", " ")]
        for target in TARGETS_DB:
            pairs = [(cheapest([row for row in case if row.estimator == estimator], target), cheapest(case, target))
                     for case in cases(rows).values()]
            reached = [own for own, _ in pairs if own]
            wins = sum(own is not None and own is best for own, best in pairs)
            time = f"{1e3 * statistics.median(row.frame_s for row in reached):.2f} ms" if reached else "-"
            cells.append(f"{len(reached)} of {len(pairs)}, {time}, best in {wins}")
        lines.append(cells)
    page.table(["estimator", *(f"{target} dB" for target in TARGETS_DB)], lines)
    page.heading("The regret of the default")
    for cost, words in front_picture.COSTS.items():
        regrets = [regret for case in cases(rows).values() if (regret := regret_of(case, cost))]
        if regrets:
            slower, lost = sorted(r.slower for r in regrets), sorted(r.lost_db for r in regrets)
            page.text(f"By {words}: the fastest setting with no more error is {statistics.median(slower):.2f} times as fast in the "
                      f"median and {slower[-1]:.2f} times at the most; in no more time {statistics.median(lost):.1f} dB more are to be "
                      f"had in the median and {lost[-1]:.1f} dB at the most.")


def add_scene(page, scene, rows, kept):
    """Fronts, costs, regret and error images of one scene."""
    first = rows[0]
    page.heading(f"{scene}: light {first.light}, {first.width} x {first.height} pixels")
    by_material = {material: case for (_, material), case in cases(rows).items()}
    panels = {material: (case, "frame_s") for material, case in by_material.items()}
    if WHOLE in by_material:
        panels |= {f"{WHOLE}, alone": (by_material[WHOLE], "alone_s")}
    page.picture(front_picture.draw(panels), "Time of each further frame against dB; up and left is better.")
    page.table(["material", *(f"{target} dB costs" for target in TARGETS_DB)],
               [[named(case[0]), *(cost_text(cheapest(case, target)) for target in TARGETS_DB)] for case in by_material.values()])
    regrets = {material: regret_of(case) for material, case in by_material.items()}
    page.table(["default", "dB", "ms", "times as slow as", "the fastest as good", "dB below", "the best as fast"],
               [[material, f"{r.default.psnr_db:.1f}", f"{1e3 * r.default.frame_s:.2f}", f"{r.slower:.2f}",
                 r.faster_row.setting.label, f"{r.lost_db:.1f}", r.better_row.setting.label] for material, r in regrets.items() if r])
    add_images(page, kept)


def named(row):
    """The material and its lobes."""
    return row.material if row.parameters in (row.material, "") else f"{row.material} ({row.parameters})"


def cost_text(row):
    """The setting and its time, or a dash."""
    return f"{1e3 * row.frame_s:.2f} ms: {row.setting.label}" if row else "-"


def add_images(page, kept):
    """Error images that were kept, in groups."""
    pictures = json.loads(str(kept["pictures"])) if "pictures" in kept else []
    for part in dict.fromkeys(picture["part"] for picture in pictures):
        page.text(f"{part}: errors on a display, from black (none) to pale yellow ({100 * SHOWN_ERROR:g} % of white and more); a dot "
                  "is a pixel that the reference has seen.")
        last = ""
        for index, picture in enumerate(pictures):
            if picture["part"] != part:
                continue
            if picture["group"] in GROUPS and picture["group"] != last:
                page.text(GROUPS[picture["group"]])
            last = picture["group"]
            page.picture(kept[f"picture_{index}"], picture["text"])


def add_method(page, rows, effort):
    """How each figure was measured."""
    page.heading("How it was measured")
    noise = sorted(row.reference_relative_rms for row in rows)
    ceiling = sorted(row.reference_ceiling_db for row in rows)
    page.text(f"burnish {__version__}, {platform.system()} {platform.machine()}, {effort.cores} threads on {os.cpu_count()} cores. Times "
              f"are medians of up to {effort.runs} runs, stage by stage, as long as these take less than {effort.seconds:g} s.")
    page.text(f"The reference is the estimator `reference`, until its standard error is {100 * effort.tolerance:g} % of each pixel, "
              f"{effort.most_lookups} lookups at the most, at about {effort.pixels} pixels of each material, one drawn in each of equal "
              f"blocks of the frame. Its own error, {100 * noise[0]:.2f} to {100 * noise[-1]:.2f} % RMS, is taken out of every figure; what "
              f"is better than its ceiling ({ceiling[0]:.0f} to {ceiling[-1]:.0f} dB) is shown as the ceiling.")
    page.text("Display PSNR: both pictures scaled so that the reference's mean is 0.18, clamped to [0, 1], sRGB-encoded. Materials of a "
              "frame are shaded apart by their masks, so that each has times of its own; the whole frame is measured as one.")
