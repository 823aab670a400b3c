"""Errors on balls at the sources' counts of samples, each against burnish's `reference`, whose noise is taken out.

`published` is the sources' own method in burnish: Regular's circles with its border, or Walkthrough's ring or line weighted by its
eq. 4.25. It and importance sampling get the level bias that does them best, picture by picture, as Regular tweaked them.
"""

import dataclasses

import burnish
import numpy as np
from burnish.charting import benchmark
from burnish.charting.measure import Truth, truth_of

from source_setups import LOOKS, MICROFACETS, published_border

BIASES = (-1.0, -0.5)
ENOUGH = {"estimator": "reference", "max_samples": 16384}
METHODS = ("importance", "published", "regular", "default")


@dataclasses.dataclass(frozen=True)
class Shown:
    """One picture of a ball."""

    picture: np.ndarray  # shape (size, size, 3), linear, 0 around the ball
    relative_rms: float
    psnr_db: float


class Ball:
    """A ball of `size` pixels; its tangents run around the vertical."""

    def __init__(self, size, tolerance):
        self.frame, self.tolerance = benchmark.sphere(size), tolerance
        self.covered = benchmark.view_cosines(self.frame) > 0

    def shade(self, light, material, **settings):
        """The layers of one estimate."""
        return burnish.composite(self.frame, light, material, camera=benchmark.CAMERA, tangent_axis=(0, 1, 0), **settings)

    def truth(self, light, material):
        """What the reference sees where the ball is."""
        return truth_of(self.shade(light, material, tolerance=self.tolerance, **ENOUGH), self.covered)

    def shown(self, values, truth):
        """Pixels of the ball as a picture, and how far they are off."""
        picture = np.zeros(self.covered.shape + (3,))
        picture[self.covered] = values
        return Shown(picture, float(truth.relative_rms(values)), float(truth.psnr_db(values)))

    def best(self, light, material, truth, under=0.0, **settings):
        """The picture at the best of the level biases; `under` is added to the overlay."""
        tried = (self.shade(light, material, level_bias=bias, density="dense", **settings)["overlay"] for bias in BIASES)
        return min((self.shown(overlay[self.covered] + under, truth) for overlay in tried), key=lambda shown: shown.relative_rms)

    def plain(self, light, material, truth, under=0.0, **settings):
        """The picture with burnish's own settings but these."""
        return self.shown(self.shade(light, material, **settings)["overlay"][self.covered] + under, truth)


def circles(samples):
    """Settings of Regular's own pattern."""
    return dict(estimator="regular", pattern="offset_circles", border=published_border(samples), samples=samples)


def microfacet_errors(ball, light, truth, material, samples):
    """Method -> Shown at one count; `default` makes as many lookups as it likes."""
    return {
        "importance": ball.best(light, material, truth, estimator="filtered_importance", samples=samples),
        "published": ball.best(light, material, truth, **circles(samples)),
        "regular": ball.plain(light, material, truth, estimator="regular", samples=samples, density="dense"),
        "default": ball.plain(light, material, truth),
    }


def microfacets(ball, lights):
    """(Microfacets, count) -> method -> (relative RMS, dB), means over the lights."""
    found = {}
    for lobe in MICROFACETS:
        for light in lights:
            truth = ball.truth(light, lobe.material())
            for samples in lobe.samples:
                shown = microfacet_errors(ball, light, truth, lobe.material(), samples)
                for method, one in shown.items():
                    found.setdefault((lobe, samples), {}).setdefault(method, []).append((one.relative_rms, one.psnr_db))
    return {key: {method: np.mean(values, 0) for method, values in methods.items()} for key, methods in found.items()}


def diffuse(light, normals, step_deg=2.0):
    """Irradiance over pi of a light at normals of shape (n, 3): a sum over a grid of directions."""
    theta, phi = np.meshgrid(np.radians(np.arange(step_deg / 2, 180, step_deg)), np.radians(np.arange(step_deg / 2, 360, step_deg)))
    d = np.stack([np.sin(theta) * np.cos(phi), np.cos(theta), np.sin(theta) * np.sin(phi)], -1).reshape(-1, 3).astype(np.float32)
    solid_angle = np.sin(theta).reshape(-1, 1) * np.radians(step_deg) ** 2
    seen = d @ light.world_to_light
    weighted = light.lookup(seen, light.level(seen, float(np.radians(step_deg) ** 2))) * solid_angle / np.pi
    return np.concatenate([np.maximum(part @ d.T, 0) @ weighted for part in np.array_split(normals, 16)])


def look_errors(ball, light, whole_light, look):
    """Count of samples -> method -> Shown of the whole picture, diffuse part included; and the truth of it."""
    material = burnish.presets()[look.material] if isinstance(look.material, str) else look.material
    under = np.asarray(material.get("kd", 0.0)) * diffuse(whole_light, ball.frame["normal"][ball.covered])
    overlay = ball.truth(light, material)
    truth, found = Truth(overlay.radiance + under, overlay.noise), {}
    default = ball.plain(light, material, truth, under)
    for samples in look.samples:
        common = dict(samples=samples // 2 if look.is_thin else samples)
        found[samples] = {
            "importance": ball.best(light, material, truth, under, estimator="filtered_importance", **common),
            "published": ball.best(light, material, truth, under, estimator="regular", pattern=look.pattern,
                                   quadrature="energy_squared", **common),
            "regular": ball.plain(light, material, truth, under, estimator="regular", density="dense", **common),
            "default": default,
        }
    return found, truth


def looks(ball, lights, whole_lights):
    """(Look, count, method -> dB under each of the lights), one after the other."""
    for look in LOOKS:
        by_light = [look_errors(ball, light, whole, look)[0] for light, whole in zip(lights, whole_lights)]
        for samples in look.samples:
            yield look, samples, {method: [found[samples][method].psnr_db for found in by_light] for method in METHODS}
