"""Objects that do not stand, rest or hang where their ``mount`` and ``support`` say.

- **floor**: the bottom is within 2 mm of z = 0.
- any object with a ``support`` entry: the bottom is within 2 mm of the surface, the footprint inside its polygon
  widened by 1 mm, and the top at most 1 mm above the surface's head room.
- **wall**: the back faces some wall within 5 degrees, -1 mm to 0.07 m (+1 mm) away, over at least 90 % of its width.
- **ceiling**: the top is within 2 mm of the room's height.

Bottom and top of a tilted object are those of its rotated vertices, and its footprint is the projection of them; on a
tilted supporter all three are taken in the supporter's frame.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from sceneweaver.geometry.prisms import prism_vertices
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.scene import Relation, Surface
from sceneweaver.verify.case import Case
from sceneweaver.verify.measure import Measurement, at_most, length
from sceneweaver.verify.measures import judge_ways
from sceneweaver.verify.report import Violation
from sceneweaver.verify.solids import DEPTH, Body, Placed

LEVEL = 2e-3
"""Height in metres by which a bottom may miss what it stands on."""


class Unsupported(NamedTuple):
    """What is wrong under an object: a sentence without its subject, the worst measurement, the supporter."""

    text: str
    worst: Measurement | None = None
    supporter: str | None = None


class Rest(NamedTuple):
    """How a body rests on a surface: its bottom above it, its footprint over the edge, its top above the head room [m].

    ``over`` is 0 when the footprint lies inside the polygon widened by 1 mm; ``squeeze`` is at most 0 when the object
    fits under the head room.
    """

    gap: float
    over: float
    squeeze: float

    @property
    def ok(self) -> bool:
        """Whether the body is supported."""
        return abs(self.gap) <= LEVEL and self.over == 0.0 and self.squeeze <= DEPTH

    @property
    def worst(self) -> Measurement:
        """The one of its lengths that is farthest off, when it is not ok."""
        lengths = (
            _height("height above its surface", self.gap),
            at_most("reach over the edge", self.over, 0.0),
            at_most("height beyond the head room", self.squeeze, 0.0, slack=DEPTH),
        )
        return max((m for m in lengths if not m.ok()), key=lambda m: m.excess)

    def text(self, surface: str) -> str:
        """What is wrong, as the rest of a sentence about the body; ``surface`` names what it stands on."""
        said = []
        if abs(self.gap) > LEVEL:
            said.append(f"{'floats' if self.gap > 0 else 'sinks'} {length(self.gap)} {_over(self.gap)} {surface}")
        if self.over > 0.0:
            said.append(f"reaches {length(self.over)} over the edge of {surface}")
        if self.squeeze > DEPTH:
            said.append(f"is {length(self.squeeze)} too tall for the head room of {surface}")
        return " and ".join(said)


def rest(placed: Placed, body: Body, supporter: Body, surface: Surface) -> Rest:
    """Measure how ``body`` rests on ``surface`` of ``supporter``."""
    import shapely

    board = np.asarray(surface.polygon, dtype=float)
    if body.tilted or supporter.tilted:
        origin = np.asarray(supporter.position)
        parts = [
            (body.to_world(prism_vertices(p.polygon, p.z)) - origin) @ supporter.rotation for p in body.item.solids
        ]
        heights = np.concatenate(parts)[:, 2]
        low, high = float(heights.min()) - surface.z, float(heights.max()) - surface.z
        feet = shapely.convex_hull(np.array([shapely.multipoints(p[:, :2]) for p in parts]))
    else:
        low = body.position[2] - supporter.position[2] - surface.z
        high = body.z[1] - supporter.position[2] - surface.z
        feet = placed.footprint(body)
        (c, s), (x, y) = supporter.front, supporter.centre
        board = board @ np.array([[c, s], [-s, c]]) + (x, y)
    over = _overhang(shapely.polygons(board), feet)
    return Rest(low, over, high - surface.headroom if surface.headroom is not None else -np.inf)


def find(placed: Placed) -> list[Violation]:
    """What is wrong with the support of every object, in scene order; an object appears once at most."""
    found = []
    for body in placed.bodies:
        checkpoint()
        wrong = [w for w in (_mounting(placed, body), _resting(placed, body)) if w is not None]
        if wrong:
            text = " and ".join(w.text for w in wrong)
            worst = max((w.worst for w in wrong), key=lambda m: m.excess if m is not None else 0.0)
            names = tuple(name for name in (body.id, wrong[-1].supporter) if name is not None)
            found.append(Violation.of("unsupported", names, f"{body.id} {text}", worst))
    return found


def _mounting(placed: Placed, body: Body) -> Unsupported | None:
    mount = body.item.mount
    if mount == "floor":
        z = body.bottom
        if abs(z) > LEVEL:
            verb = "floats" if z > 0 else "sinks"
            text = f"{verb} {length(z)} {_over(z)} the floor"
            return Unsupported(text, _height("height above the floor", z))
    elif mount == "ceiling":
        gap = placed.scene.room.height - body.z[1]
        if abs(gap) > LEVEL:
            where = "below" if gap > 0 else "above"
            worst = _height("height below the ceiling", gap)
            return Unsupported(f"hangs {length(gap)} {where} the ceiling", worst)
    elif mount == "wall":
        hung = judge_ways(Case.of(placed, Relation(type="against_wall", subject=body.id)))
        if not hung.holds:
            return Unsupported(f"does not hang on a wall: {hung.text}", hung.worst)
    elif body.item.support is None:
        return Unsupported("has no surface to stand on")
    return None


def _resting(placed: Placed, body: Body) -> Unsupported | None:
    support = body.item.support
    if support is None:
        return None
    supporter = placed.by_id.get(support.object)
    surface = supporter and next((s for s in supporter.item.surfaces if s.name == support.surface), None)
    name = f"{support.surface} of {support.object}"
    if supporter is None or surface is None:
        return Unsupported(f"should stand on {name}, which is not there")
    measured = rest(placed, body, supporter, surface)
    if measured.ok:
        return None
    return Unsupported(measured.text(name), measured.worst, supporter.id)


def _height(quantity: str, value: float) -> Measurement:
    """A height [m] that should be 0."""
    return Measurement(quantity, value, 0.0, 0.0, slack=LEVEL)


def _over(gap: float) -> str:
    return "above" if gap > 0 else "into"


def _overhang(board: Any, feet: Any) -> float:
    """How far ``feet`` reach out of ``board`` [m]; 0.0 when they lie inside it widened by 1 mm."""
    import shapely

    if shapely.covers(board, feet).all() or shapely.covers(shapely.buffer(board, DEPTH, quad_segs=16), feet).all():
        return 0.0
    outside = shapely.distance(board, shapely.points(shapely.get_coordinates(feet)))
    return max(float(outside.max()), DEPTH)
