# SPDX-License-Identifier: GPL-3.0-or-later
"""How near a session's overlay comes to what Cycles itself rendered: GlossCol * (GlossDir + GlossInd)."""

import dataclasses

import numpy as np

from . import package


@dataclasses.dataclass(frozen=True)
class Comparison:
    """Display PSNR of all covered pixels and of each material's; `difference`: absolute, (height, width, 3), linear."""

    psnr_db: float
    materials: dict
    difference: np.ndarray


def measured(session, progress=None):
    """Compare the overlay as it is now.

    Parameters
    ----------
    session : session.Session
    progress : callable, optional
        As burnish calls it; returning False cancels.

    Returns
    -------
    Comparison
        A material's pixels are those that it adds light to.
    """
    burnish = package.load()
    overlay, rendered = session.pictures()[0], session.rendered()
    materials = {}
    for done, name in enumerate(session.materials):
        if progress and progress("comparing", done / len(session.materials)) is False:
            raise burnish.Cancelled("stopped while comparing")
        own = session.part(name).max(axis=2) > 0
        if own.any():
            materials[name] = burnish.compare(overlay, rendered, own.astype(np.float32))["psnr_db"]
    whole = burnish.compare(overlay, rendered, session.covered.astype(np.float32))["psnr_db"]
    return Comparison(whole, materials, np.abs(overlay - rendered))
