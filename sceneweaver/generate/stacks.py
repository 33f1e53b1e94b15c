"""Things that a request has stacked: each on the one before it, the first where it would stand alone."""

from __future__ import annotations

import math
from collections.abc import Sequence

from sceneweaver.assets.taxonomy import category_named
from sceneweaver.language import SceneGraph
from sceneweaver.language.model import Arrangement

from .program import Wanted

HIGHEST = 8
"""Things in a stack whose height is not said, at most."""


def rows_for(said: Arrangement, category: str, count: int) -> int:
    """How many things of a category are one on the other."""
    if said.rows is not None:
        return said.rows
    size = category_named(category).size
    if said.height is not None and size is not None:
        return max(2, math.ceil(said.height / (0.5 * (size.height[0] + size.height[1]))))
    return min(HIGHEST, max(2, math.ceil(count / (said.groups or 1))))


def stacked(wanted: Sequence[Wanted], brief: SceneGraph) -> None:
    """Gives what is stacked its support: the one below it. What nothing else is said of stands on the floor."""
    for said in brief.arrangements:
        things = [w for w in wanted if said.pattern == "stack" and w.asked == said.entity]
        if len(things) < 2:
            continue
        stated = {r.subject for r in brief.relations if r.type in ("on", "inside") and not r.implied}
        rows = rows_for(said, things[0].category, len(things))
        for k, one in enumerate(things):
            if k % rows:
                one.support, one.inside, one.share, one.held = things[k - 1], False, None, None
            elif said.entity not in stated:
                one.support, one.held = None, "floor"
