"""What the sources show: their materials, counts of samples and figures. Short names as in docs/sources.md.

Regular's figures 8 to 10 are pictures without printed RMS; what its text says of them stands in their place. Walkthrough gives no
numbers for chrome, lacquer, plastic, porcelain and glasses: those here are burnish's presets, and a wide metal for its
chrome, which it calls very glossy. Its copy at hand was scanned; figures that this program prints were checked against their
neighbours (PSNR rises with n, frame rates fall).
"""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Microfacets:
    """A lobe of Regular's evaluation: Kurt's model, F = 1 and alpha = 0, at the counts of one figure."""

    figure: str
    mx: float
    my: float
    samples: tuple
    said: str

    @property
    def name(self):
        """Its widths."""
        return f"m {self.mx:g}" + (f" x {self.my:g}" if self.mx != self.my else "")

    def material(self):
        """As burnish.composite takes it."""
        return {"model": "kurt", "mx": self.mx, "my": self.my, "alpha": 0.0}


MICROFACETS = (
    Microfacets("Regular 8, 10", 0.1, 0.1, (14, 270), "as good as importance sampling, by eye"),
    Microfacets("Regular 9", 0.15, 0.15, (14, 30, 270), "lower mean error than importance sampling"),
    Microfacets("Regular 8, 10", 0.2, 0.075, (17, 270), "well-defined highlights; importance: irregular"),
)
CURVE = (7, 14, 30, 61, 127, 270)


def published_border(samples):
    """xi0 of Regular: 0.2, 0.1 and 0.01 at 14, 30 and 270 lookups, and between them on their line."""
    return min(2.8 / samples, 0.4)


@dataclasses.dataclass(frozen=True)
class Look:
    """A material of Walkthrough's figures 4.39 to 4.41, with its PSNR at two counts of samples."""

    figure: str
    name: str
    material: object  # a preset or a description
    samples: tuple  # of all lobes
    psnr_db: tuple
    pattern: str = "ring"  # of the source

    @property
    def is_thin(self):
        """Half of the samples go through the sheet."""
        return self.figure == "4.41"


def kurt(ks, mx, my, r0, alpha):
    """One reflection lobe."""
    return {"model": "kurt", "ks": ks, "mx": mx, "my": my, "r0": r0, "alpha": alpha}


FOIL = {"kd": 0.76, "lobes": [kurt(0.78, 0.124, 0.136, 0.029, 0.5),
                              {"model": "kurt", "kt": 0.67, "mx": 0.25, "my": 0.17, "r0": 0.75, "alpha": 0.6}]}
SCATTERGLOSS = {"kd": 0.003, **kurt(0.9, 0.11, 0.072, 0.89, 0.43)}
LOOKS = (
    Look("4.39", "scattergloss (its table 3.1)", SCATTERGLOSS, (7, 15), (41.08, 43.49)),
    Look("4.39", "Miro (its table 3.3)", {"kd": 0.003, **kurt(0.98, 0.0068, 0.0297, 0.84, 0.49)}, (7, 15), (47.22, 48.84), "line"),
    Look("4.39", "chrome (here m 0.2)", kurt(1.0, 0.2, 0.2, 0.9, 0.4), (7, 15), (38.04, 40.87)),
    Look("4.40", "lacquer (preset)", "lacquer", (3, 7), (55.05, 57.48)),
    Look("4.40", "plastic (preset plastic-gloss)", "plastic-gloss", (3, 7), (56.30, 59.03)),
    Look("4.40", "porcelain (preset)", "porcelain", (3, 7), (68.95, 71.70)),
    Look("4.41", "white foil (its table 3.2)", FOIL, (8, 16), (39.44, 45.41)),
    Look("4.41", "frosted glass (preset)", "frosted-glass", (8, 16), (47.20, 48.22)),
    Look("4.41", "glass (preset clear-glass)", "clear-glass", (4, 8), (62.60, 65.65)),
)

RATES = {
    "curved": {3: (70, 95), 7: (41, 60), 11: (30, 43), 15: (24, 35), 19: (20, 28)},
    "planar": {3: (47, 80), 7: (33, 58), 11: (25, 45), 15: (20, 36), 19: (17, 31)},
}
"""Walkthrough's tables 4.1 and 4.2: samples -> frames a second, screen full and half full."""
