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


_ALL = (
    # ---- faces and sites: a site is a face of the target, a wall, an opening, an edge of the target's hull
    Measure("turned", "deg", "angle between a face of the subject and the way opposite to the site's normal", True),
    Measure("gap", "m", "how far the middle of a face of the subject lies beyond the site, along its normal", True),
    Measure("aside", "m", "how far that middle lies beside the middle of the site, along it", True),
    Measure("overlap", "", "share of the narrower of face and site that lies beside the other; of: face, that of the face"),
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
    Measure("part_between", "", "part of the way from the first target's centre to the second's, of the foot of the subject's"),
    Measure("off_line", "m", "distance of the subject's centre from the line through the two targets' centres"),
    Measure("spread", "deg", "how far the angle to a neighbour around the target is from the even one"),
    # ---- heights
    Measure("height", "m", "bottom of the subject over that of the target, or over the floor"),
    Measure("above", "m", "bottom of the subject over the top of the target"),
    Measure("below", "m", "bottom of the target over the top of the subject"),
    Measure("carried", "", "whether the subject rests on a surface of the target; of: inner, on one with a head room"),
    # ---- what requests ask for beside these; lengths are those of solid parts and outlines
    Measure("space", "m", "least distance of the solids, heights included", engine=False),
    Measure("plan_gap", "m", "least distance of the solids as seen from above", engine=False),
    Measure("past", "m", "how far the middle of the subject's outline lies beyond a side of the target", True, False),
    Measure("shared_width", "", "share of the narrower of outline and side, widened by `by`, that lies side by side", True, False),
    Measure("centred", "m", "how far the middle of the subject's outline lies off the target's, along an axis", True, False),
    Measure("share_over", "", "share of the subject's outline within the target's, as seen from above", engine=False),
    Measure("share_within", "", "share of the subject's height and outline within the target's", engine=False),
    Measure("held", "", "1 where the target carries the subject, with anything between; of: inner, on an inner surface", engine=False),
    Measure("top_over_top", "m", "top of the subject over the top of the target", engine=False),
    Measure("bottom_over_top", "m", "bottom of the subject over the top of the target", engine=False),
    Measure("middle_over_middle", "m", "middle of the subject's height over that of the target", engine=False),
    Measure("bottom_over_bottom", "m", "bottom of the subject over the bottom of the target", engine=False),
    Measure("looks_away", "deg", "angle of a front from the target's middle; none where the ray ahead meets the target", engine=False),
    Measure("seat_away", "deg", "angle of a seat's front from the nearest point or the middle of the target", engine=False),
    Measure("off_front", "deg", "angle between the subject's front and the way to the target's centre, in plan", engine=False),
    Measure("long_side_turned", "deg", "angle between the subject's long side and a wall", engine=False),
    Measure("off_way_in", "deg", "angle between a wall's inward normal and the way from the opening to the subject", engine=False),
)  # fmt: skip

MEASURES: dict[str, Measure] = {measure.name: measure for measure in _ALL}
"""Every measure by name."""
