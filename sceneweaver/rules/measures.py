"""Every measure that a row of a rule may ask for, each said once.

A measure is computed twice and never by shared code: for the engine (`sceneweaver.layout.rows`, as features of
the kernels) and for the judge (`sceneweaver.verify.measures`, in float64).
"""

from __future__ import annotations

from typing import Literal, NamedTuple

Unit = Literal["m", "deg", ""]


class Measure(NamedTuple):
    """One measure.

    Attributes:
        name: what rows call it.
        unit: ``m``, ``deg``, or empty for a share or a count.
        meaning: what is measured, in words.
        arguments: the keys of a row that it reads beside its interval.
        sided: whether it depends on which side of a thing is meant, so that its rule has to name a frame.
    """

    name: str
    unit: Unit
    meaning: str
    arguments: tuple[str, ...] = ()
    sided: bool = False


_ALL = (
    Measure(
        "turned",
        "deg",
        "angle between a face of the subject and the site that it should be opposite to",
        ("face",),
        True,
    ),
    Measure("gap", "m", "how far a face of the subject lies before the site, along the site's normal", ("face",), True),
)

MEASURES: dict[str, Measure] = {measure.name: measure for measure in _ALL}
"""Every measure by name."""
