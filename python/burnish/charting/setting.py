"""One way to shade: what the chart varies, and the word for it in tables and pictures."""

from __future__ import annotations

import dataclasses

STACK_ESTIMATORS = ("fitted", "preconvolved", "split_sum")
"""Those that look up in light blurred by Gaussians; sparse shading needs it too. The others look up in the pyramid alone."""

FACES = {"full": 1, "half": 2, "quarter": 4}
"""Pyramid -> what the edge of the light's cube faces is divided by."""


@dataclasses.dataclass(frozen=True)
class Setting:
    """The initial values are burnish's own defaults."""

    estimator: str = "fitted"
    samples: int = 0  # lookups asked for; 0: as the estimator needs
    density: str = "sparse"
    safety: float = 2.0  # of sparse shading
    suns: str = "auto"  # of the light: taken out of the map, or "keep"
    face: str = "full"  # of the light's pyramid

    def __post_init__(self):
        if self.density == "auto":
            object.__setattr__(self, "density", "dense" if self.estimator == "reference" else "sparse")
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


def setting_of(fields):
    """The Setting that an object or dict with (at least) its fields is of."""
    value = fields.get if isinstance(fields, dict) else lambda name: getattr(fields, name)
    return Setting(**{field.name: value(field.name) for field in dataclasses.fields(Setting)})
