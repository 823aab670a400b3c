"""How far pictures are from what they should be, as a display shows them: both brought to a mean of middle grey, encoded."""

from __future__ import annotations

import numpy as np

from .. import compare
from ..charting.measure import encode
from .panels import exposure_of

CODES = 255
"""Steps of a display with 8 bits from black to white."""


def difference(result, reference, exposure=None):
    """result - reference, encoded, in steps of a display; `exposure` by default that of the reference's own mean."""
    exposure = exposure_of(reference) if exposure is None else exposure
    return CODES * (encode(exposure * result) - encode(exposure * reference))


def psnr(result, reference, mask=None):
    """dB of the pixels in a mask, by default of all."""
    return compare(result, reference, None if mask is None else np.asarray(mask, np.float32))["psnr_db"]


def flicker(results, references, masks):
    """RMS of the temporal second difference of (result - reference), in steps of a display, over pixels in the mask of three
    frames running."""
    exposure = exposure_of(np.concatenate([reference[mask] for reference, mask in zip(references, masks)]))
    errors = [difference(result, reference, exposure) for result, reference in zip(results, references)]
    bends = [(before - 2 * now + after)[a & b & c] for before, now, after, a, b, c in
             zip(errors, errors[1:], errors[2:], masks, masks[1:], masks[2:])]
    return float(np.sqrt(np.mean(np.concatenate(bends) ** 2)))
