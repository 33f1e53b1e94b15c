"""What a critic by vision changes about what is kept: little, and never against the judge."""

from __future__ import annotations

from collections.abc import Callable

from .executor import Outcome

Look = Callable[[Outcome], Outcome]
"""The outcome with what a critic by vision saw of it in its review, or as it was where that saw nothing."""

SEEN_WORSE, SEEN_BETTER = 0.75, 0.3
"""Points of the mean grade by vision that a step which is better by measure may lose, and that one which is about as
good has to gain; more than the samples differ anyway."""

NEAR = 0.4
"""Points of the mean grade by measure up to which a scene is about as good as another."""


def looked(old: Outcome | None, new: Outcome, accepted: bool, look: Look) -> tuple[Outcome, bool, str]:
    """The winner of a step once it was looked at, whether it is kept, and why, where that is by sight.

    Args:
        old: the scene before; None in the first step.
        new: the winner.
        accepted: whether it is better by measure.
        look: looks.
    """
    if not accepted and (old is None or old.review.seen is None or not about_as_good(old, new)):
        return new, False, ""
    new = look(new)
    if old is None:
        return new, True, ""
    if accepted:
        worse = seen_worse(old, new)
        return new, not worse, worse
    better = seen_better(old, new)
    return new, bool(better), better


def about_as_good(old: Outcome, new: Outcome) -> bool:
    """Whether a scene that is no better by measure is about as good: nothing more is wrong, dropped or not as asked."""
    counts = [(len(one.faults), len(one.scene.dropped), round(one.review.unmet, 6)) for one in (old, new)]
    no_worse = all(after <= before for before, after in zip(*counts, strict=True))
    return no_worse and new.report.valid >= old.report.valid and new.key[-1] <= old.key[-1] + NEAR


def seen_worse(old: Outcome, new: Outcome) -> str:
    """Why a scene that is better by measure is taken back by sight; empty where it is not."""
    if (rise := _rise(old, new, SEEN_WORSE)) is None or rise[0] >= 0:
        return ""
    return f"the critic by vision gave {rise[2]:.1f} after {rise[1]:.1f}"


def seen_better(old: Outcome, new: Outcome) -> str:
    """Why a scene that is about as good by measure is kept by sight; empty where it is not."""
    if (rise := _rise(old, new, SEEN_BETTER)) is None or rise[0] <= 0:
        return ""
    return f"about as good by measure, and the critic by vision gave {rise[2]:.1f} after {rise[1]:.1f}"


def _rise(old: Outcome, new: Outcome, margin: float) -> tuple[float, float, float] | None:
    """How much the mean by vision rises, from what and to what; None within the margin, or where one was not seen."""
    before, after = old.review.seen, new.review.seen
    if before is None or after is None:
        return None
    rise = after.mean - before.mean
    return (rise, before.mean, after.mean) if abs(rise) > max(margin, before.spread, after.spread) else None
