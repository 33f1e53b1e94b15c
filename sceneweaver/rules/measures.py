"""Every measure that a row of a rule may ask for, each said once.

A measure of a relation is computed twice and never by shared code (docs/decisions/0003): for the engine as features of
the kernels (`sceneweaver.layout.rows`), for the judge in float64 (`sceneweaver.verify.measures`). What only requests
ask for, the judge's side alone knows.
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
        sided: whether it depends on which side of a thing is meant, so that its rule has to name a frame.
        engine: whether the engine can pull towards it.
    """

    name: str
    unit: Unit
    meaning: str
    sided: bool = False
    engine: bool = True


def _asked(name: str, unit: Unit, meaning: str, sided: bool = False) -> Measure:
    """A measure that only what requests state is judged by."""
    return Measure(name, unit, meaning, sided, engine=False)


_ALL = (
    # ---- faces and sites: a site is a face of the target, a wall, an opening, an edge of the target's hull
    Measure("turned", "deg", "angle between a face of the subject and the way opposite to the site's normal", True),
    Measure("gap", "m", "how far the middle of a face of the subject lies beyond the site, along its normal", True),
    Measure("aside", "m", "how far that middle lies beside the middle of the site, along it", True),
    Measure("overlap", "", "share of the narrower of face and site, or of the face, that lies beside the other"),
    # ---- the target's own frame, or that of the site where it is a place
    Measure("ahead", "m", "coordinate of a point of the subject along the front of the frame", True),
    Measure("left", "m", "coordinate of a point of the subject to the left of the frame", True),
    Measure("turn", "deg", "difference of the two yaws less `by`, modulo `modulo`"),
    Measure("bearing", "deg", "angle between the subject's front and the way to the target's centre"),
    # ---- distances
    Measure("distance", "m", "least distance of the footprints, or of the footprint from the site, seen from above"),
    Measure("box_gap", "m", "least coordinate of the subject's box along the inward normal of the site's wall"),
    Measure("before", "", "share of the narrower of box and window that lies before the other, along the wall"),
    # ---- two targets, neighbours
    Measure("part_between", "", "part of the way between the two targets' centres at which the subject's lies"),
    Measure("off_line", "m", "distance of the subject's centre from the line through the two targets' centres"),
    Measure("spread", "deg", "how far the angle to a neighbour around the target is from the even one"),
    # ---- heights
    Measure("height", "m", "bottom of the subject over that of the target, or over the floor"),
    Measure("above", "m", "bottom of the subject over the top of the target"),
    Measure("below", "m", "bottom of the target over the top of the subject"),
    Measure("carried", "", "whether the subject rests on a surface of the target; of: inner, on one with a head room"),
    # ---- what requests ask for beside these; lengths are those of solid parts and outlines
    _asked("space", "m", "least distance of the solids, heights included; of a place in plan"),
    _asked("plan_gap", "m", "least distance of the solids as seen from above"),
    _asked("past", "m", "how far the middle of the outline lies beyond a side of the target", sided=True),
    _asked("shared_width", "", "share of the narrower of outline and widened side beside the other", sided=True),
    _asked("centred", "m", "how far the middle of the outline lies off the target's, along an axis or the nearer one"),
    _asked("share_over", "", "share of the subject's outline within the target's, as seen from above; of either"),
    _asked("share_within", "", "share of the subject's height and outline within the target's"),
    _asked("held", "", "1 where the target carries the subject, with anything between; of: inner, outer, hook"),
    _asked("top_over_seat", "m", "height of the target's worktop over the seat of the subject"),
    _asked("top_over_top", "m", "top of the subject over the top of the target"),
    _asked("top_over_middle", "m", "top of the subject over the middle of the target's height"),
    _asked("bottom_over_top", "m", "bottom of the subject over the top of the target"),
    _asked("middle_over_middle", "m", "middle of the subject's height over that of the target"),
    _asked("bottom_over_bottom", "m", "bottom of the subject over the bottom of the target"),
    _asked("below_ceiling", "m", "how far the top of the subject is below the ceiling"),
    _asked("looks_away", "deg", "angle of a front from the target's middle; 0 where the ray ahead meets the target"),
    _asked("end_on", "deg", "angle by which neither the subject's back nor a long side of it looks at a wall"),
    _asked("seat_away", "deg", "angle of a seat's front from the nearest point or the middle of the target"),
    _asked("off_front", "deg", "angle between the subject's front and the way to the target's centre"),
    _asked("long_side_turned", "deg", "angle between the subject's long side and a wall"),
    _asked("to_wall", "m", "least distance of the subject's outline from any wall"),
    _asked("off_way_in", "deg", "angle between a wall's inward normal and the way from the opening to the subject"),
    _asked("off_middle", "m", "how far the middle of a group is from the middle of the floor"),
    _asked("beyond_middle", "m", "how far a thing is from the middle of the floor towards a wall that is named"),
)  # fmt: skip

MEASURES: dict[str, Measure] = {measure.name: measure for measure in _ALL}
"""Every measure by name."""
