"""The sources' figures in kind, theirs beside burnish's: a markdown table, and a picture of curves and balls.

    python3 tests/bench/source_figures.py ../shared/data --picture source_figures.png

Regular 7 to 10 under burnish's stress light (40 spots of 2 to 10 degrees, up to 3000:1, which is what its text describes),
Walkthrough's figures 4.39 to 4.41 under a hall, a park and a studio (in this order), its tables 4.1 and 4.2 in the room that Cycles
rendered. Needs burnish, matplotlib, OpenImageIO; BURNISH_BUILD says where the build is (default build/release).
"""

import argparse
import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("BURNISH_BUILD", ROOT / "build" / "release"))
sys.path[:0] = [str(ROOT / "tests"), str(BUILD / "python")]

import burnish  # noqa: E402
from burnish.charting import benchmark  # noqa: E402

import source_balls  # noqa: E402
import source_picture  # noqa: E402
import source_rates  # noqa: E402
from source_setups import RATES  # noqa: E402

HDRS = ("st_fagans_interior_1k", "rooitou_park_1k", "studio_small_03_1k")  # a hall, a park with its sun, lamps in the dark
FACE_SIZE = 512  # texels of the cube map: twice burnish's own choice, as the sources' reference sees the same map as their estimate
HEADER = ("| source | setup | its figure | importance sampling, as many | `regular` as published | `regular`, as many | default |",
          "|---|---|---|---|---|---|---|")
PARTS = ("errors", "looks", "rates")


def parser():
    """The command line."""
    words = argparse.ArgumentParser("source_figures.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("data", type=pathlib.Path, help="folder with cycles/ and public/env/")
    words.add_argument("--picture", type=pathlib.Path, help="PNG to draw")
    words.add_argument("--parts", nargs="*", choices=PARTS, default=PARTS, help="of the table")
    words.add_argument("--size", type=int, default=80, help="pixels across a ball")
    words.add_argument("--tolerance", type=float, default=0.02, help="of the reference, relative")
    words.add_argument("--repeats", type=int, default=3, help="of each frame that is timed; the fastest counts")
    words.add_argument("--threads", type=int, default=2)
    return words


def line(*cells):
    """A row of the table."""
    return f"| {' | '.join(cells)} |"


def error_lines(ball):
    """Regular's figures 8 to 10."""
    lights = [benchmark.load_light(seed) for seed in benchmark.STRESS_LIGHTS.values()]
    for (lobe, samples), methods in source_balls.microfacets(ball, lights).items():
        cells = (f"{100 * methods[name][0]:.1f} %, {methods[name][1]:.1f} dB" for name in source_balls.METHODS)
        yield line(lobe.figure, f"{lobe.name}, n = {samples}", lobe.said, *cells)


def hdr(folder, name):
    """A light with its suns apart, for lobes, and whole, for the diffuse part."""
    file = folder / f"{name}.hdr"
    return burnish.Environment(file, env_face_size=FACE_SIZE), burnish.Environment(file, env_suns="keep")


def look_lines(ball, folder):
    """Walkthrough's PSNRs, one for each of HDRS."""
    lights, whole = zip(*(hdr(folder, name) for name in HDRS))
    for look, samples, methods in source_balls.looks(ball, lights, whole):
        cells = (", ".join(f"{db:.1f}" for db in methods[name]) + " dB" for name in source_balls.METHODS)
        theirs = dict(zip(look.samples, look.psnr_db))[samples]
        yield line(f"Walkthrough {look.figure}", f"{look.name}, n = {samples}", f"{theirs:.1f} dB", *cells)


def rate_lines(data, threads, repeats):
    """Frames a second: Regular's figure 7, Walkthrough's tables."""
    def shown(rates):
        return ", ".join(f"{one:.0f}" for one in rates)

    hall = burnish.Environment(data / "public" / "env" / f"{HDRS[0]}.hdr")
    found = source_rates.full_hd(hall, threads, repeats)
    for samples in source_rates.CURVE:
        said = "60 frames/s at about 20 samples" if samples == 19 else ""
        yield line("Regular 7", f"1920 x 1080, 100, 50, 25 % covered, n = {samples}", said, "", "", f"{shown(found[samples])} frames/s",
                   f"{shown(found['default'])} frames/s")
    found = source_rates.walkthrough(data / "cycles" / "room", threads, repeats)
    for table, figure in (("curved", "Walkthrough table 4.1, cube and planes"), ("planar", "Walkthrough table 4.2, mirror")):
        for samples, rates in RATES[table].items():
            yield line(figure, f"1680 x 1050, full, half, n = {samples}", f"{shown(rates)} frames/s", "", "",
                       f"{shown(found[table, samples])} frames/s", f"{shown(found[table, 'default'])} frames/s")


def main():
    """Print the table as it is measured, then draw."""
    options = parser().parse_args()
    ball, environments = source_balls.Ball(options.size, options.tolerance), options.data / "public" / "env"
    print("\n".join(HEADER), flush=True)
    lines = {"errors": lambda: error_lines(ball), "looks": lambda: look_lines(ball, environments),
             "rates": lambda: rate_lines(options.data, options.threads, options.repeats)}
    for part in options.parts:
        for text in lines[part]():
            print(text, flush=True)
    if options.picture:
        figure = source_picture.draw(ball, benchmark.load_light(1), *hdr(environments, HDRS[0]))
        source_picture.save(figure, options.picture)


if __name__ == "__main__":
    main()
