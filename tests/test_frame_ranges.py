"""Frame ranges in four dialects: as oiiotool, and as OpenJD and fileseq say."""

import subprocess

import burnish
import numpy as np
import pytest
from burnish.sequence import format_frames, parse_frames

OIIO_RANGES = ["1-10x3", "1-10y3", "10-1", "10-1x3", "1-10x-2", "3-3", "-5--1x2", "10-1y3", "10-1x-3", "1-10y-3", "1-4,8,20-22"]


@pytest.mark.parametrize("text", OIIO_RANGES)
def test_ranges_of_openimageio_are_what_oiiotool_makes_of_them(text):
    told = subprocess.run(["oiiotool", "--frames", text, "--echo", "{FRAME_NUMBER}"], capture_output=True, text=True, check=True).stdout
    assert parse_frames(text, "oiio") == [int(word) for word in told.split() if word.lstrip("-").isdigit()]


@pytest.mark.parametrize("dialect, text, frames", [
    ("openjd", "1-9:4", [1, 5, 9]),
    ("fileseq", "1-9:4", [1, 5, 9, 4, 7, 3, 2, 6, 8]),
    ("burnish", "1-9:4", [1, 5, 9]),
    ("fileseq", "1-9x4", [1, 5, 9]),
    ("fileseq", "1-9y4", [2, 3, 4, 6, 7, 8]),
    ("fileseq", "5-1,3-7", [5, 4, 3, 2, 1, 6, 7]),
    ("openjd", " 7 , 1 - 3 ", [1, 2, 3, 7]),
    ("openjd", "9-1:-4", [1, 5, 9]),
    ("openjd", "-3--1", [-3, -2, -1]),
    ("openjd", "1-3,5,7-20:2", [1, 2, 3, 5, 7, 9, 11, 13, 15, 17, 19]),
])
def test_dialects_mean_what_their_programs_mean(dialect, text, frames):
    assert parse_frames(text, dialect) == frames


@pytest.mark.parametrize("dialect, text, part", [
    ("openjd", "1-9x4", "1-24:2"), ("openjd", "9-1", "step"), ("openjd", "1-5,3", "overlaps"), ("openjd", "1-9:0", "step"),
    ("fileseq", "1-9x0", "1 or more"), ("fileseq", "", "no frame"), ("fileseq", "1-9z2", "1-24y2"), ("oiio", "1-9:4", "1-24y2"),
    ("oiio", "1-9999999", "million"), ("burnish", "9-1", "backwards"), ("nuke", "1", "fileseq"),
])
def test_what_is_no_range_is_told(dialect, text, part):
    with pytest.raises(burnish.BadArgument, match=part):
        parse_frames(text, dialect)


@pytest.mark.parametrize("dialect", ["burnish", "openjd", "fileseq", "oiio"])
def test_lists_come_back_from_text(dialect):
    rng = np.random.default_rng(5)
    for _ in range(200):
        frames = list(dict.fromkeys(map(int, rng.integers(-6, 24, rng.integers(1, 20)))))
        for order in (frames, sorted(frames)):
            assert parse_frames(format_frames(order, dialect), dialect) == (sorted(order) if dialect == "openjd" else order)
    assert format_frames(range(1, 201), dialect) == "1-200"
