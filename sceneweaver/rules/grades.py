"""How grades follow from what is wrong with a room and from how much is known of its kind: a few fitted weights.

``grade_weights.yaml`` has them; ``python -m benchmarks.critic_fit --write`` fits them to the grades that strict eyes
gave rooms of many kinds.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import cache
from importlib import resources

from .design import read_yaml


@dataclass(frozen=True)
class Traits:
    """What tells strict eyes a finished room from a bare one, beside its faults.

    Eyes grade a room by what they miss in it, too, and no rule says what is missing where little is known of a kind of
    room. Over rooms of sixty kinds these four went with their grades, and so they did over twenty other kinds
    (docs/design_rules.md).

    Attributes:
        groups: composed groups (``knowledge/groups``) in what is known of the kind of room.
        ties: hard relations of an item there, in the mean.
        categories: natural logarithm of one more than the categories of things in the room.
        supports: the same of the pieces of furniture that should carry something.
    """

    groups: float
    ties: float
    categories: float
    supports: float


TRAITS = tuple(field.name for field in fields(Traits))


@dataclass(frozen=True)
class CriterionWeights:
    """How one grade follows: ``10 exp(-lost / 10)``, where ``lost`` is the sum of what these say.

    Attributes:
        baseline: points lost to what only eyes can tell.
        own_checks: points lost for a point of a check of this criterion.
        other_checks: the same for a check of another criterion: who sees one thing wrong marks down the rest.
        own_rules: points lost for a point of a breach of a design rule of this criterion.
        other_rules: the same for a design rule of another criterion.
        short: by trait, points lost for each unit that the room has less of it than `GradeWeights.enough`.
    """

    baseline: float
    own_checks: float
    other_checks: float
    own_rules: float
    other_rules: float
    short: Mapping[str, float]


@dataclass(frozen=True)
class GradeWeights:
    """What the fit found.

    Attributes:
        lid: share of the points that a lid stands for.
        enough: by trait, how much of it is as good as more.
        criteria: weights by criterion.
    """

    lid: float
    enough: Mapping[str, float]
    criteria: Mapping[str, CriterionWeights]


@cache
def grade_weights() -> GradeWeights:
    """The fitted numbers."""
    data = read_yaml(resources.files(__package__ or "") / "grade_weights.yaml")
    criteria = {name: CriterionWeights(**row) for name, row in data.pop("criteria").items()}
    return GradeWeights(**data, criteria=criteria)
