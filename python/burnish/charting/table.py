"""The estimators' rows as CSV, and as the few lines that say what a good picture costs."""

from __future__ import annotations

import csv
import dataclasses
import statistics

TARGET_DB = 40


@dataclasses.dataclass(frozen=True)
class EstimatorRow:
    """One line of estimators.csv; the fields are its columns."""

    light: str
    material: str
    kind: str  # the row of the picture it belongs to
    estimator: str
    samples: int  # lookups asked for
    lookups: float  # lookups made, per pixel
    relative_rms: float
    relative_rms_beyond_75_deg: float
    psnr_db: float  # both pictures scaled to a mean of 0.18, clamped, sRGB-encoded
    reference_relative_rms: float  # the reference's standard error, already taken out of the figures
    reference_lookups: float  # per pixel
    shading_ns_per_pixel: float  # of one thread
    tables_s: float  # once for each light and material, one thread


def estimator_row(row, kind):
    """Of a Row (bench.py)."""
    same = {field.name: getattr(row, field.name) for field in dataclasses.fields(EstimatorRow) if hasattr(row, field.name)}
    return EstimatorRow(**same, kind=kind, shading_ns_per_pixel=1e9 * row.shading_s / max(row.pixels, 1))


def write_csv(rows, file):
    """One line a row, a column for each field, floats with six digits."""
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(field.name for field in dataclasses.fields(rows[0]))
    for row in rows:
        writer.writerow(f"{value:.6g}" if isinstance(value, float) else value for value in dataclasses.astuple(row))


def by_estimator(rows):
    """Estimator -> its rows, in the order they were measured."""
    groups = {}
    for row in rows:
        groups.setdefault(row.estimator, []).append(row)
    return groups


def cheapest(rows):
    """The row with the fewest lookups that reaches the target, for each material and light; None where none does."""
    found = {}
    for row in sorted(rows, key=lambda row: row.lookups):
        key = (row.material, row.light)
        if found.get(key) is None:
            found[key] = row if row.psnr_db >= TARGET_DB else None
    return list(found.values())


def summary(rows):
    """Lines of text: for each estimator how often it reaches the target, and what that takes."""
    lines = [f"{f'to reach {TARGET_DB} dB':20} {'reached':>10} {'lookups':>8} {'ns/pixel':>9} {'tables ms':>10}"]
    for estimator, group in by_estimator(rows).items():
        pairs = cheapest(group)
        done = [row for row in pairs if row]
        cost = "       -         -          -"
        if done:
            lookups, shading, tables = (statistics.median(getattr(row, name) for row in done)
                                        for name in ("lookups", "shading_ns_per_pixel", "tables_s"))
            cost = f"{lookups:8.0f} {shading:9.0f} {1000 * tables:10.1f}"
        lines.append(f"{estimator:20} {f'{len(done)} of {len(pairs)}':>10} {cost}")
    lines.append("reached: pairs of a material and a light; the costs are medians over those, times of one thread")
    return lines
