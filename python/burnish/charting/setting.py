"""One way to shade: what the chart varies, and the word for it in tables and pictures."""

from __future__ import annotations

import dataclasses

from .. import _core

STACK_ESTIMATORS = ("fitted", "preconvolved", "split_sum", "factored")
"""Those that look up in light blurred by Gaussians, or make maps from it; sparse shading needs it too. The others look up in the pyramid alone."""

FACES = {"full": 1, "half": 2, "quarter": 4}
"""Pyramid -> what the edge of the light's cube faces is divided by."""

OF_SETTING = {"estimator": "estimator", "samples": "samples", "density": "density", "safety": "safety", "env_suns": "suns"}
"""Setting of a job -> field of a Setting."""


@dataclasses.dataclass(frozen=True)
class Setting:
    """The initial values are burnish's own defaults, for small frames under distant light."""

    estimator: str = "fitted"
    samples: int = 0  # lookups asked for; 0: as the estimator needs
    density: str = "dense"
    safety: float = 2.0  # of sparse shading
    suns: str = "auto"  # of the light: taken out of the map, or "keep"
    face: str = "full"  # of the light's pyramid

    def __post_init__(self):
        if self.density == "dense":
            object.__setattr__(self, "safety", 0.0)  # it has none; so that equal settings are equal

    def shading(self):
        """As settings of `composite`."""
        chosen = {"estimator": self.estimator, "samples": self.samples, "density": self.density}
        return chosen | ({"safety": self.safety} if self.density == "sparse" else {})

    def light(self):
        """Key of what is made of the light for this."""
        needs_stack = self.estimator in STACK_ESTIMATORS or self.density == "sparse"
        return "stack" if needs_stack else "pyramid", self.suns, self.face

    def replace(self, **fields):
        """The same with other fields."""
        return dataclasses.replace(self, **fields)

    @property
    def label(self):
        """For people: "regular 19, sparse 2, half pyramid"."""
        words = [f"{self.estimator.replace('_', ' ')} {self.samples or 'default'}"]
        words += [f"sparse {self.safety:g}"] if self.density == "sparse" else []
        words += ["suns kept"] if self.suns == "keep" else []
        words += [f"{self.face} pyramid"] if self.face != "full" else []
        return ", ".join(words)


def own_setting(job, pixels, is_near):
    """The Setting that burnish shades a job with, settings by name: what they leave open, the size of the frame and the lights decide."""
    given = {field: job[name] for name, field in OF_SETTING.items() if name in job}
    return Setting(**given | {"density": _core.settled_density(job, pixels, is_near)})


def setting_of(fields):
    """The Setting that an object or dict with (at least) its fields is of."""
    value = fields.get if isinstance(fields, dict) else lambda name: getattr(fields, name)
    return Setting(**{field.name: value(field.name) for field in dataclasses.fields(Setting)})
